// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/cloud_registration.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "rigidformer/tracking/slide.hpp"

namespace rigidformer {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// Thresholds, as in the table of docs/tracking.md ("All thresholds"): D is the object's size, h the voxel, d_in the
// inlier distance. "By eye": chosen by eye, without derivation. Letters below are those of "What is minimised" there.
constexpr double kNoiseBound = 3.0;       // [sigma] part of d_in; derived: 99.7 % of Gaussian noise lies within
constexpr double kSurfaceError = 0.02;    // [D] part of d_in, for rounded edges and bends between points; by eye
constexpr double kOverlap = 1.5;          // [h] along the surface to a reference point: still known; by eye
constexpr double kPointWeight = 0.02;     // in the metric of a point without a normal, against a plane's 1; by eye
constexpr double kNarrowing = 0.7;        // factor on the kernel k per step; by eye
constexpr double kConverged = 3e-4;       // [D] length of a step that ends the search; by eye
constexpr double kPrior = 0.003;          // pull of the start over the mean information on moves, in lambda; by eye
constexpr double kBorderWeight = 0.2;     // in the metric, along the outward direction of an end; by eye
constexpr double kWeak = 0.03;            // information per point below which a direction is weak; by eye
constexpr double kInPlane = 0.95;         // cosine between normals of one plane, at least; by eye
constexpr double kClearlyBetter = 0.8;    // misfit of the shifted start over the predicted one's, at most; by eye
constexpr double kRandomResiduals = 0.6;  // [d_in] largest RMSE; derived: points anywhere within have 1/sqrt(3)

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

// Turns the two weak directions, the first columns, within their plane, whose normal is the third column, until they
// are square to the ends of its faces: a face ends most sharply there.
Eigen::Matrix3d square_to_borders(const ReferenceCloud& reference, const Eigen::Matrix3d& directions) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int row = 0; row < reference.points().rows(); ++row) {
    if (std::abs(reference.normals().row(row).cast<double>().dot(directions.col(2))) < kInPlane) {
      continue;
    }
    const Eigen::Vector3d border = directions.transpose() * reference.border(row).cast<double>();
    if (!border.isZero()) {
      const double angle = 4.0 * std::atan2(border.y(), border.x());  // directions a quarter turn apart are alike
      sum += Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
  }
  const double angle = 0.25 * std::atan2(sum.y(), sum.x());
  return directions * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

/// How one cloud point lies to the reference, in the object frame.
struct Residual {
  Eigen::Vector3d vector;  ///< v_i, from the reference point to the cloud point
  Eigen::Vector3d normal;  ///< m_j, the reference point's normal; zero = it has none
  int row;                 ///< Number j of the reference point
  double distance;         ///< From the plane of the reference point, or from the point itself where it has no normal
  bool is_known_face;      ///< Cloud point and reference point may belong to one face
  bool overlaps;           ///< The cloud point lies where that face is known
};

class Registration {
 public:
  Registration(const ReferenceCloud& reference, const SurfaceCloud& cloud_world,
               const CorrespondenceOptions& parameters)
      : reference_(reference),
        cloud_world_(cloud_world),
        points_world_(thin(cloud_world.points, parameters.max_registered_points).cast<double>()),
        normals_world_(thin(cloud_world.normals, parameters.max_registered_points).cast<double>()),
        noise_m_(parameters.noise),
        inlier_distance_m_(kNoiseBound * parameters.noise + kSurfaceError * reference.size_m()),
        capture_distance_m_(std::max(parameters.max_correspondence_distance * reference.size_m(), inlier_distance_m_)),
        max_iterations_(parameters.max_iterations) {}

  double inlier_distance_m() const { return inlier_distance_m_; }
  RegistrationQuality quality(const RigidTransform& T_world_object) const;
  /// Sum of |v_i| over the points, each at most d_cap: how badly a start fits.
  double misfit(const RigidTransform& T_world_object) const;
  /// Pose after the robust steps of "What is minimised".
  RigidTransform align(const RigidTransform& T_world_start) const;
  /// The pose without the slides that "Slides along faces" measures; sets `may_have_slid` where the ends disagree.
  RigidTransform without_slides(const RigidTransform& T_world_object, bool& may_have_slid) const;

 private:
  /// One step's A and gradient in delta, which turns about `centre` in units of r = D / 2.
  struct System {
    Matrix6d information = Matrix6d::Zero();
    Vector6d gradient = Vector6d::Zero();
  };
  Residual residual(const RigidTransform& T_object_world, Eigen::Index i) const;  // of row `i` of the points
  System linearize(const RigidTransform& T_object_world, const Eigen::Vector3d& centre, double kernel_m,
                   bool with_borders = true) const;
  Vector6d solve(const System& system, const Vector6d& to_start) const;
  RigidTransform motion(const Vector6d& step, const Eigen::Vector3d& centre) const;
  /// Eigenvectors of A_tautau as columns: first the `count` weak ones, along which the cloud may slide.
  Eigen::Matrix3d weak_directions(const Eigen::Matrix3d& information, int& count) const;
  double radius() const { return std::max(0.5 * reference_.size_m(), 1e-6); }  // r [m]

  const ReferenceCloud& reference_;
  const SurfaceCloud& cloud_world_;
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> points_world_;
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> normals_world_;
  double noise_m_;
  double inlier_distance_m_;
  double capture_distance_m_;
  int max_iterations_;
};

Residual Registration::residual(const RigidTransform& T_object_world, Eigen::Index i) const {
  const Eigen::Vector3d point_object = T_object_world * points_world_.row(i).transpose();
  const Eigen::Vector3d normal_object = T_object_world.rotation * normals_world_.row(i).transpose();
  const int row = reference_.nearest(point_object.cast<float>(), normal_object.cast<float>());
  Residual r;
  r.vector = point_object - reference_.points().row(row).transpose().cast<double>();
  r.normal = reference_.normals().row(row).transpose().cast<double>();
  r.row = row;
  r.is_known_face =
      r.normal.isZero() || normal_object.isZero() || on_same_face(r.normal.cast<float>(), normal_object.cast<float>());
  const double voxel = reference_.voxel_size_m();
  if (r.normal.isZero()) {
    const double length = r.vector.norm();
    r.distance = std::max(length - 0.5 * voxel, 0.0);  // the point stands for h / 2 around it
    r.overlaps = length < kOverlap * voxel + inlier_distance_m_;
    return r;
  }
  const double offset = r.normal.dot(r.vector);
  r.distance = std::abs(offset);
  r.overlaps = r.is_known_face && (r.vector - offset * r.normal).norm() < kOverlap * voxel;
  return r;
}

RegistrationQuality Registration::quality(const RigidTransform& T_world_object) const {
  const RigidTransform T_object_world = T_world_object.inverse();
  double squares = 0.0;
  int inliers = 0;
  for (Eigen::Index i = 0; i < points_world_.rows(); ++i) {
    const Residual r = residual(T_object_world, i);
    if (r.overlaps && r.distance <= inlier_distance_m_) {
      squares += r.distance * r.distance;
      ++inliers;
    }
  }
  return {std::sqrt(squares / std::max(inliers, 1)),
          static_cast<double>(inliers) / static_cast<double>(std::max<Eigen::Index>(points_world_.rows(), 1))};
}

double Registration::misfit(const RigidTransform& T_world_object) const {
  const RigidTransform T_object_world = T_world_object.inverse();
  double sum = 0.0;
  for (Eigen::Index i = 0; i < points_world_.rows(); ++i) {
    const Residual r = residual(T_object_world, i);
    sum += std::min(r.vector.norm(), capture_distance_m_);
  }
  return sum;
}

Registration::System Registration::linearize(const RigidTransform& T_object_world, const Eigen::Vector3d& centre,
                                             double kernel_m, bool with_borders) const {
  System system;
  for (Eigen::Index i = 0; i < points_world_.rows(); ++i) {
    const Eigen::Vector3d point = T_object_world * points_world_.row(i).transpose();
    const Residual r = residual(T_object_world, i);
    const bool is_coarse = kernel_m > inlier_distance_m_;  // the kernel has not shrunk to d_in yet
    if (!r.is_known_face || (!r.overlaps && !is_coarse)) {
      continue;
    }
    const double outlyingness = (r.overlaps ? r.distance : r.vector.norm()) / kernel_m;
    const double root = 1.0 / (1.0 + outlyingness * outlyingness);
    const double weight = root * root;  // w_i of Geman and McClure
    Eigen::Matrix3d metric = (r.normal.isZero() ? kPointWeight : 0.0) * Eigen::Matrix3d::Identity();
    metric += r.normal * r.normal.transpose();  // M_i
    if (!is_coarse && with_borders) {
      // Points near an end lie on average where the reference's do. If more lie outward, the face has slid that way.
      const Eigen::Vector3d border = reference_.border(r.row).cast<double>();
      metric += kBorderWeight * border * border.transpose();
    }
    Eigen::Matrix<double, 3, 6> jacobian;  // J_i
    jacobian.leftCols<3>() = -cross_matrix(point - centre) / radius();
    jacobian.rightCols<3>().setIdentity();
    const Eigen::Matrix<double, 6, 3> weighted = weight * jacobian.transpose() * metric;
    system.information += weighted * jacobian;
    system.gradient += weighted * r.vector;
  }
  return system;
}

// Solves (A + lambda I) delta = lambda delta_0 - gradient. The weak pull decides what the cloud does not.
Vector6d Registration::solve(const System& system, const Vector6d& to_start) const {
  const double pull = kPrior * system.information.bottomRightCorner<3, 3>().trace() / 3.0 + 1e-12;  // lambda
  const Matrix6d information = system.information + pull * Matrix6d::Identity();
  return information.ldlt().solve(pull * to_start - system.gradient);
}

RigidTransform Registration::motion(const Vector6d& step, const Eigen::Vector3d& centre) const {
  const Eigen::Quaterniond turn = rotation_about(step.head<3>() / radius());
  return {turn, centre + step.tail<3>() - turn * centre};
}

RigidTransform Registration::align(const RigidTransform& T_world_start) const {
  const RigidTransform T_object_start = T_world_start.inverse();
  RigidTransform T_object_world = T_object_start;
  const Eigen::Vector3d centre_world = points_world_.colwise().mean().transpose();
  double kernel_m = capture_distance_m_;  // k, which starts at d_cap ...
  for (int i = 0; i < max_iterations_; ++i) {
    const Eigen::Vector3d centre = T_object_world * centre_world;
    const RigidTransform back = T_object_start * T_object_world.inverse();
    Vector6d to_start;  // delta_0, the step back to the start
    to_start << radius() * rotation_vector(back.rotation), back * centre - centre;
    const Vector6d step = solve(linearize(T_object_world, centre, kernel_m), to_start);
    T_object_world = motion(step, centre) * T_object_world;
    const bool narrow = kernel_m <= inlier_distance_m_;
    kernel_m = std::max(kNarrowing * kernel_m, inlier_distance_m_);  // ... and ends at d_in
    if (narrow && step.norm() < kConverged * reference_.size_m()) {
      break;
    }
  }
  return T_object_world.inverse();
}

Eigen::Matrix3d Registration::weak_directions(const Eigen::Matrix3d& information, int& count) const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(information);
  count = static_cast<int>((solver.eigenvalues().array() < kWeak * static_cast<double>(points_world_.rows())).count());
  return count == 2 ? square_to_borders(reference_, solver.eigenvectors()) : solver.eigenvectors();
}

RigidTransform Registration::without_slides(const RigidTransform& T_world_object, bool& may_have_slid) const {
  const RigidTransform T_object_world = T_world_object.inverse();
  const Eigen::Vector3d centre = T_object_world * points_world_.colwise().mean().transpose();
  // Ends of single points are left out: the ends of whole faces say the same more precisely.
  System system = linearize(T_object_world, centre, inlier_distance_m_, false);
  int num_weak = 0;
  const Eigen::Matrix3d directions = weak_directions(system.information.bottomRightCorner<3, 3>(), num_weak);
  const SurfaceCloud cloud_object = num_weak > 0 ? transform(T_object_world, cloud_world_) : SurfaceCloud();
  bool is_measured = false;
  for (int i = 0; i < num_weak; ++i) {
    const Eigen::Vector3d direction = directions.col(i);
    const std::optional<Slide> slide = measure_slide(reference_, cloud_object, direction, noise_m_);
    may_have_slid |= slide && !slide->is_certain;
    if (slide && slide->is_certain) {
      // The unit of weight is a point on its plane, whose error is sigma: this is (sigma / sigma_s)^2.
      const double weight = std::pow(noise_m_ / slide->standard_deviation_m, 2);
      system.information.bottomRightCorner<3, 3>() += weight * direction * direction.transpose();
      system.gradient.tail<3>() += weight * slide->distance_m * direction;
      is_measured = true;
    }
  }
  return is_measured ? (motion(solve(system, Vector6d::Zero()), centre) * T_object_world).inverse() : T_world_object;
}

// Rules 2 and 3 of "When a pose is believed"; empty = they hold.
std::string objection_to(const RegistrationQuality& quality, double inlier_distance_m,
                         const CorrespondenceOptions& parameters) {
  if (quality.inlier_ratio < parameters.min_inlier_ratio) {
    return "only " + std::to_string(quality.inlier_ratio) + " of its points lie on the reference";
  }
  const double max_rmse_m = std::min(parameters.max_rmse, kRandomResiduals * inlier_distance_m);
  if (quality.rmse_m > max_rmse_m) {
    return "RMSE " + std::to_string(quality.rmse_m) + " m exceeds " + std::to_string(max_rmse_m) + " m";
  }
  return "";
}

}  // namespace

CloudRegistration measure_pose(const ReferenceCloud& reference, const SurfaceCloud& cloud_world,
                               const RigidTransform& T_world_object, const CorrespondenceOptions& parameters) {
  const Registration registration(reference, cloud_world, parameters);
  const RegistrationQuality quality = registration.quality(T_world_object);
  return {T_world_object, quality, objection_to(quality, registration.inlier_distance_m(), parameters)};
}

CloudRegistration register_cloud(const ReferenceCloud& reference, const SurfaceCloud& cloud_world,
                                 const RigidTransform& T_world_predicted, const RigidTransform& T_world_shifted,
                                 const CorrespondenceOptions& parameters) {
  const Registration registration(reference, cloud_world, parameters);
  if (cloud_world.points.rows() < kMinRegisteredPoints) {  // rule 1
    return {T_world_predicted, registration.quality(T_world_predicted),
            std::to_string(cloud_world.points.rows()) + " points are too few to register"};
  }
  // Steps 3 to 6 of "One cloud, step by step": choose a start, align, take slides out, judge.
  const bool shift = registration.misfit(T_world_shifted) < kClearlyBetter * registration.misfit(T_world_predicted);
  CloudRegistration result;
  const RigidTransform T_world_aligned = registration.align(shift ? T_world_shifted : T_world_predicted);
  result.T_world_object = registration.without_slides(T_world_aligned, result.may_have_slid);
  result.quality = registration.quality(result.T_world_object);
  result.objection = objection_to(result.quality, registration.inlier_distance_m(), parameters);
  const double turn = rotation_angle(result.T_world_object.rotation, T_world_predicted.rotation);
  if (result.objection.empty() && turn > parameters.max_rotation) {  // rule 4
    result.objection = "turned " + std::to_string(turn) + " rad from the prediction";
  }
  return result;
}

}  // namespace rigidformer
