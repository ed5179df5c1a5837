// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/step_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rigidformer {
namespace {

// Gap between hulls [m] up to which a contact is told at the end of a step (contact_scene.cpp): beyond it, nothing in
// the input says that two objects may touch.
constexpr double kContactHorizon_m = 0.05;
// How far the network sees what does not touch [m]: the longer of the two lengths with which the vector to the nearest
// vertex of another object is squashed (features.cpp). From there on it says little more than that something is there.
constexpr double kSight_m = 0.5;
constexpr double kAtRest = -1.0;  // reach of what nothing comes to; a reach is never negative

Tensor is_same(const Pose& a, const Pose& b) {
  return (a.rotation == b.rotation).flatten(-2).all(-1).logical_and((a.translation == b.translation).all(-1));
}

/// The farthest that any point of a body goes between two poses.
double way_m(const ObservedSolid& body, const RigidTransform& from, const RigidTransform& to) {
  return (to.translation - from.translation).norm() + body.radius_m * rotation_angle(from.rotation, to.rotation);
}

/// How far each body may come within the step: as far as in the last one or as its given motion says, and a fall.
std::vector<double> reaches(const SolidScene& scene, const BodyPoses& poses, const std::vector<RigidTransform>& coming,
                            const std::vector<bool>& asleep) {
  const double fall_m = std::abs(poses.gravity) * poses.time_step_s * poses.time_step_s;
  std::vector<double> reach_m(asleep.size(), kAtRest);
  for (std::size_t k = 0; k < asleep.size(); ++k) {
    const ObservedSolid& body = scene.solids()[k];
    if (asleep[k]) continue;
    reach_m[k] = fall_m + std::max(way_m(body, poses.before[k], poses.now[k]), way_m(body, poses.now[k], coming[k]));
  }
  return reach_m;
}

/// What is hit may come as far as what hits it. Given motion is not passed on by what stands still by itself.
void pass_on(const SolidScene& scene, const std::vector<SolidGap>& gaps, std::vector<double>& reach_m) {
  for (bool changed = true; changed;) {
    changed = false;
    const auto pass = [&](int from, int to) {
      const double reach = reach_m[static_cast<std::size_t>(from)];
      double& other = reach_m[static_cast<std::size_t>(to)];
      if (reach <= other || !scene.solids()[static_cast<std::size_t>(to)].dynamic) return;
      other = reach;
      changed = true;
    };
    for (const SolidGap& gap : gaps) {
      if (gap.partner < 0) continue;
      const double farther =
          std::max(reach_m[static_cast<std::size_t>(gap.body)], reach_m[static_cast<std::size_t>(gap.partner)]);
      if (farther == kAtRest || gap.gap_m >= farther + kContactHorizon_m) continue;
      pass(gap.body, gap.partner);
      pass(gap.partner, gap.body);
    }
  }
}

}  // namespace

bool StepParts::is_everybody() const { return std::find(may_move.begin(), may_move.end(), false) == may_move.end(); }

StepParts everybody(std::size_t num_objects) {
  StepParts parts{std::vector<bool>(num_objects, true), std::vector<std::int64_t>(num_objects)};
  std::iota(parts.seen.begin(), parts.seen.end(), 0);
  return parts;
}

std::vector<bool> Sleepers::find(const SceneBatch& batch, const SceneState& state) {
  std::vector<bool> asleep(static_cast<std::size_t>(batch.max_objects()), false);
  if (stepped_.rotation.defined()) {
    const Tensor put_back = is_same(state.current, stepped_).logical_and(is_same(state.current, state.previous));
    const Tensor sleeps = put_back.logical_or(batch.dynamic_mask.logical_not()).to(torch::kCPU).contiguous();
    std::copy_n(sleeps.data_ptr<bool>(), asleep.size(), asleep.begin());
  }
  stepped_ = state.current;
  return asleep;
}

StepParts find_parts(const SolidScene& scene, const BodyPoses& poses, const std::vector<RigidTransform>& coming,
                     const std::vector<bool>& asleep) {
  std::vector<double> reach_m = reaches(scene, poses, coming, asleep);
  const double farthest_m = *std::max_element(reach_m.begin(), reach_m.end());
  StepParts parts{std::vector<bool>(asleep.size(), false), {}};
  if (farthest_m == kAtRest) return parts;
  const std::vector<SolidGap> gaps = scene.gaps(poses.now, farthest_m + kSight_m);
  pass_on(scene, gaps, reach_m);
  std::vector<bool> seen(asleep.size());
  for (std::size_t k = 0; k < asleep.size(); ++k) seen[k] = parts.may_move[k] = reach_m[k] != kAtRest;
  for (const SolidGap& gap : gaps) {
    if (gap.partner < 0) continue;
    const auto a = static_cast<std::size_t>(gap.body), b = static_cast<std::size_t>(gap.partner);
    if (parts.may_move[a] && gap.gap_m < reach_m[a] + kSight_m) seen[b] = true;
    if (parts.may_move[b] && gap.gap_m < reach_m[b] + kSight_m) seen[a] = true;
  }
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (seen[k]) parts.seen.push_back(static_cast<std::int64_t>(k));
  }
  return parts;
}

}  // namespace rigidformer
