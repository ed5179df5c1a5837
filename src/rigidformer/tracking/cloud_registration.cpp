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

constexpr double kNoiseBound = 3.0;       // standard deviations of a point on the surface
constexpr double kSurfaceError = 0.02;    // [size] of the reference, on top: rounded edges, bends between its points
constexpr double kOverlap = 1.5;          // [voxel] along the surface from its nearest point: beyond the known surface
constexpr double kPointWeight = 0.02;     // of a distance from a point without a normal, against one from a plane
constexpr double kNarrowing = 0.7;        // of the kernel, per iteration
constexpr double kConverged = 3e-4;       // [size] of a step
constexpr double kPrior = 0.003;          // pull of the start, relative to the cloud's mean pull on a translation
constexpr double kBorderWeight = 0.2;     // of a distance along the surface where it ends, against one from a plane
constexpr double kWeak = 0.03;            // of the information per point along a direction that the planes leave open
constexpr double kInPlane = 0.95;         // cosine between normals of one plane
constexpr double kClearlyBetter = 0.8;    // misfit of the shifted start against the predicted one
constexpr double kRandomResiduals = 0.6;  // [inlier distance] RMSE of points that lie anywhere within it

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

// Of two directions along a plane (the third column is its normal), the two that its borders are square to: a face ends
// most sharply there.
Eigen::Matrix3d square_to_borders(const ReferenceCloud& reference, const Eigen::Matrix3d& directions) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int row = 0; row < reference.points().rows(); ++row) {
    if (std::abs(reference.normals().row(row).cast<double>().dot(directions.col(2))) < kInPlane) {
      continue;
    }
    const Eigen::Vector3d border = directions.transpose() * reference.border(row).cast<double>();
    if (!border.isZero()) {
      const double angle = 4.0 * std::atan2(border.y(), border.x());  // a quarter turn makes no difference
      sum += Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
  }
  const double angle = 0.25 * std::atan2(sum.y(), sum.x());
  return directions * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

/// A cloud point against the reference, in the object frame.
struct Residual {
  Eigen::Vector3d vector;  ///< From the nearest reference point of its face
  Eigen::Vector3d normal;  ///< Zero = none
  int row;                 ///< Of that reference point
  double distance;         ///< From the surface, or from the point where there is no normal
  bool is_known_face;      ///< The reference point may be of the cloud point's face
  bool overlaps;           ///< Lies where that face is known
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

  /// Sum over the points of how far they are from the reference, each at most the capture distance.
  double misfit(const RigidTransform& T_world_object) const;

  RigidTransform align(const RigidTransform& T_world_start) const;

  /// `T_world_object` without the slides along faces that the ends of these show; `may_have_slid` where these disagree.
  RigidTransform without_slides(const RigidTransform& T_world_object, bool& may_have_slid) const;

 private:
  /// Gauss-Newton system of a step, rotations about `centre` in units of half the object's size.
  struct System {
    Matrix6d information = Matrix6d::Zero();
    Vector6d gradient = Vector6d::Zero();
  };

  /// Of row `i` of the points.
  Residual residual(const RigidTransform& T_object_world, Eigen::Index i) const;
  System linearize(const RigidTransform& T_object_world, const Eigen::Vector3d& centre, double kernel_m,
                   bool with_borders = true) const;
  Vector6d solve(const System& system, const Vector6d& to_start) const;
  RigidTransform motion(const Vector6d& step, const Eigen::Vector3d& centre) const;
  /// Columns: first the `count` directions in which the cloud may slide along its faces, then the others.
  Eigen::Matrix3d weak_directions(const Eigen::Matrix3d& information, int& count) const;
  double radius() const { return std::max(0.5 * reference_.size_m(), 1e-6); }

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
    r.distance = std::max(length - 0.5 * voxel, 0.0);  // the point stands for its surroundings
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
    const bool is_coarse = kernel_m > inlier_distance_m_;
    if (!r.is_known_face || (!r.overlaps && !is_coarse)) {
      continue;
    }
    const double outlyingness = (r.overlaps ? r.distance : r.vector.norm()) / kernel_m;
    const double root = 1.0 / (1.0 + outlyingness * outlyingness);
    const double weight = root * root;  // Geman-McClure
    Eigen::Matrix3d metric = (r.normal.isZero() ? kPointWeight : 0.0) * Eigen::Matrix3d::Identity();
    metric += r.normal * r.normal.transpose();
    if (!is_coarse && with_borders) {
      // Points near a border lie on average where the reference's do; if more lie outward, the face has slid that way.
      const Eigen::Vector3d border = reference_.border(r.row).cast<double>();
      metric += kBorderWeight * border * border.transpose();
    }
    Eigen::Matrix<double, 3, 6> jacobian;
    jacobian.leftCols<3>() = -cross_matrix(point - centre) / radius();
    jacobian.rightCols<3>().setIdentity();
    const Eigen::Matrix<double, 6, 3> weighted = weight * jacobian.transpose() * metric;
    system.information += weighted * jacobian;
    system.gradient += weighted * r.vector;
  }
  return system;
}

// Gauss-Newton with a weak pull back to the start, which decides where the cloud does not.
Vector6d Registration::solve(const System& system, const Vector6d& to_start) const {
  const double pull = kPrior * system.information.bottomRightCorner<3, 3>().trace() / 3.0 + 1e-12;
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
  double kernel_m = capture_distance_m_;
  for (int i = 0; i < max_iterations_; ++i) {
    const Eigen::Vector3d centre = T_object_world * centre_world;
    const RigidTransform back = T_object_start * T_object_world.inverse();
    Vector6d to_start;
    to_start << radius() * rotation_vector(back.rotation), back * centre - centre;
    const Vector6d step = solve(linearize(T_object_world, centre, kernel_m), to_start);
    T_object_world = motion(step, centre) * T_object_world;
    const bool narrow = kernel_m <= inlier_distance_m_;
    kernel_m = std::max(kNarrowing * kernel_m, inlier_distance_m_);
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
  // Without the borders: the ends of whole faces say the same more precisely.
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
      // Against a point on its plane, whose error is the noise.
      const double weight = std::pow(noise_m_ / slide->standard_deviation_m, 2);
      system.information.bottomRightCorner<3, 3>() += weight * direction * direction.transpose();
      system.gradient.tail<3>() += weight * slide->distance_m * direction;
      is_measured = true;
    }
  }
  return is_measured ? (motion(solve(system, Vector6d::Zero()), centre) * T_object_world).inverse() : T_world_object;
}

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
  if (cloud_world.points.rows() < kMinRegisteredPoints) {
    return {T_world_predicted, registration.quality(T_world_predicted),
            std::to_string(cloud_world.points.rows()) + " points are too few to register"};
  }
  const bool shift = registration.misfit(T_world_shifted) < kClearlyBetter * registration.misfit(T_world_predicted);
  CloudRegistration result;
  const RigidTransform T_world_aligned = registration.align(shift ? T_world_shifted : T_world_predicted);
  result.T_world_object = registration.without_slides(T_world_aligned, result.may_have_slid);
  result.quality = registration.quality(result.T_world_object);
  result.objection = objection_to(result.quality, registration.inlier_distance_m(), parameters);
  const double turn = rotation_angle(result.T_world_object.rotation, T_world_predicted.rotation);
  if (result.objection.empty() && turn > parameters.max_rotation) {
    result.objection = "turned " + std::to_string(turn) + " rad from the prediction";
  }
  return result;
}

}  // namespace rigidformer
