// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "contact_scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "rigidformer/simulation/hull_distance.hpp"
#include "rigidformer/simulation/mesh_volume.hpp"

namespace rigidformer {
namespace {

constexpr double kReach_m = 0.05;         // gap at the end of a step up to which a contact is told; as the contact gate
constexpr double kTouching_m = 0.001;     // the margin that Bullet keeps around hulls in the MOVi scenes
constexpr int kMaxAdvances = 20;          // of the search for the moment of contact; three to six are usual
constexpr int kMaxGroundContacts = 4;     // corners of a face on the floor
constexpr double kApart = 0.2;            // least distance of two contacts of a pair, in radii; chosen by eye
constexpr double kSmallestStep_m = 1e-9;  // approach during a step below which nothing comes closer

/// Smallest distance from the origin to the segment from `start` along `step`.
double nearest_pass(const Eigen::Vector3d& start, const Eigen::Vector3d& step) {
  const double u = std::clamp(-start.dot(step) / std::max(step.squaredNorm(), 1e-12), 0.0, 1.0);
  return (start + u * step).norm();
}

}  // namespace

/// Free motion of a body during a step: constant velocity and spin.
struct ContactScene::Motion {
  const ObservedSolid* body;
  Eigen::Quaterniond rotation;         ///< Now
  Eigen::Vector3d centre, step, turn;  ///< Where the centre is, how far it goes [m], and the rotation vector [rad]

  Motion(const ObservedSolid& moved, const RigidTransform& from, const RigidTransform& to)
      : body(&moved),
        rotation(from.rotation),
        centre(from * moved.centre_reference),
        step(to * moved.centre_reference - centre),
        turn(rotation_vector(to.rotation * from.rotation.conjugate())) {}

  RigidTransform at(double fraction) const {
    return {(rotation_about(fraction * turn) * rotation).normalized(), centre + fraction * step};
  }
  /// How far any of its points can come from its centre's path [m].
  double sweep() const { return turn.norm() * body->radius_m; }
};

ContactScene::ContactScene(std::vector<ObservedSolid> solids, std::int64_t scene, double ground_height_m)
    : scene_(scene), ground_height_m_(ground_height_m), bodies_(std::move(solids)) {}

void ContactScene::describe_bodies(Tensor& mass, Tensor& inverse_inertia) const {
  for (const ObservedSolid& body : bodies_) {
    const std::int64_t row = scene_ * mass.size(1) + body.object;
    mass.data_ptr<double>()[row] = *body.properties.mass_kg;
    const Eigen::Matrix3d inverse = inertia_per_mass(*body.hull).inverse();  // symmetric
    std::copy(inverse.data(), inverse.data() + 9, inverse_inertia.data_ptr<double>() + 9 * row);
  }
}

std::vector<FoundContact> ContactScene::search(const PoseTable& from, const PoseTable& to) const {
  std::vector<Motion> motions;
  for (const ObservedSolid& body : bodies_) {
    const RigidTransform start = from.get(scene_, body.object), end = to.get(scene_, body.object);
    if (is_valid(start) && is_valid(end)) motions.emplace_back(body, start, end);  // a lost body meets nothing
  }
  std::vector<FoundContact> found;
  for (std::size_t a = 0; a < motions.size(); ++a) {
    const bool moves = motions[a].body->dynamic;
    if (moves) meet_ground(motions[a], found);
    for (std::size_t b = 0; b < a; ++b) {
      if (moves || motions[b].body->dynamic) meet_each_other(motions[a], motions[b], found);
    }
  }
  return found;
}

/// Conservative advancement (Mirtich 1996): from each moment on by the time in which nothing can close the gap. Beside
/// the first contact, the overlap at the end of the step tells where the bodies meet otherwise.
void ContactScene::meet_each_other(const Motion& a, const Motion& b, std::vector<FoundContact>& found) const {
  const double reach = a.body->radius_m + b.body->radius_m + kReach_m;
  if (nearest_pass(a.centre - b.centre, a.step - b.step) > reach) return;
  const auto closest_at = [&](double fraction) {
    return closest_points(*a.body->distances, a.at(fraction), *b.body->distances, b.at(fraction));
  };
  const auto tell = [&](const ClosestPoints& closest, double fraction) {
    const Eigen::Vector3d on_a = closest.on_a - a.at(fraction).translation;
    const Eigen::Vector3d on_b = closest.on_b - b.at(fraction).translation;
    const std::int64_t k_a = a.body->object, k_b = b.body->object;
    if (a.body->dynamic) found.push_back({k_a, k_b, on_a, on_b, closest.normal, fraction, closest.gap_m});
    if (b.body->dynamic) found.push_back({k_b, k_a, on_b, on_a, -closest.normal, fraction, closest.gap_m});
  };

  double fraction = 0.0;
  std::optional<ClosestPoints> first = closest_at(fraction);
  for (int i = 0; i < kMaxAdvances && first && first->gap_m > kTouching_m; ++i) {
    const double approach = (b.step - a.step).dot(first->normal) + a.sweep() + b.sweep();
    if (approach < kSmallestStep_m) return;
    fraction += first->gap_m / approach;
    if (fraction >= 1.0) break;
    first = closest_at(fraction);
  }
  const std::optional<ClosestPoints> last = closest_at(1.0);
  if (!first || !last) return;
  if (fraction < 1.0) tell(*first, fraction);
  const Eigen::Vector3d first_point = a.at(fraction).rotation.conjugate() * (first->on_a - a.at(fraction).translation);
  const Eigen::Vector3d last_point = a.at(1.0).rotation.conjugate() * (last->on_a - a.at(1.0).translation);
  const double apart = kApart * std::min(a.body->radius_m, b.body->radius_m);
  const bool is_another = fraction < 1.0 && last->gap_m < 0.0 && (last_point - first_point).norm() > apart;
  const bool is_near = fraction >= 1.0 && last->gap_m < kReach_m;
  if (is_another || is_near) tell(*last, 1.0);
}

/// The corner that free motion takes to the ground first, and others far from it that come down too.
void ContactScene::meet_ground(const Motion& motion, std::vector<FoundContact>& found) const {
  const double lowest_centre = motion.centre.z() + std::min(motion.step.z(), 0.0) - ground_height_m_;
  if (lowest_centre > motion.body->radius_m + kReach_m) return;
  const Points& corners = motion.body->hull->vertices;
  const Points before = motion.at(0.0).apply(corners), after = motion.at(1.0).apply(corners);
  const auto ground = static_cast<float>(ground_height_m_);
  const Eigen::VectorXf h0 = before.col(2).array() - ground, h1 = after.col(2).array() - ground;
  const auto when = [&](Eigen::Index i) {
    if (h0[i] <= 0.0F) return 0.0;
    return h1[i] < 0.0F ? static_cast<double>(h0[i] / (h0[i] - h1[i])) : 1.0;
  };
  const auto order = [&](Eigen::Index i) { return std::make_pair(when(i), std::min(h0[i], h1[i])); };
  Eigen::Index next = 0;
  for (Eigen::Index i = 1; i < corners.rows(); ++i) next = order(i) < order(next) ? i : next;
  const float reach = h1.minCoeff() < 0.0F || h0.minCoeff() <= 0.0F ? 0.0F : static_cast<float>(kReach_m);
  Eigen::VectorXf apart = Eigen::VectorXf::Constant(corners.rows(), 1e9F);  // from the nearest one told
  for (int count = 0; count < kMaxGroundContacts; ++count) {
    if (std::min(h0[next], h1[next]) > reach) return;
    const double fraction = when(next);
    const RigidTransform T = motion.at(fraction);
    const Eigen::Vector3d point = T.rotation * corners.row(next).transpose().cast<double>();
    const double gap_m = T.translation.z() + point.z() - ground_height_m_;
    found.push_back(
        {motion.body->object, -1, point, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), fraction, gap_m});
    apart = apart.cwiseMin((corners.rowwise() - corners.row(next)).rowwise().norm());
    float farthest = static_cast<float>(kApart * motion.body->radius_m);
    bool more = false;
    for (Eigen::Index i = 0; i < corners.rows(); ++i) {
      if (apart[i] <= farthest || std::min(h0[i], h1[i]) > reach) continue;
      farthest = apart[i];
      next = i;
      more = true;
    }
    if (!more) return;
  }
}

}  // namespace rigidformer
