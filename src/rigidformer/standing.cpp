// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/standing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rigidformer/engine/standing_hull.hpp"

namespace rigidformer {
namespace {

// Time [s] at the scale of the model. From rest, what falls comes 0.6 m down in it, and what tips over turns by 0.1 rad
// when its centre of mass is 6 cm beside its foot: far more than the error of a pose (tracking/stillness.cpp).
constexpr double kStood_s = 0.35;
constexpr double kHung_s = 0.7;  // where nothing is below: what is thrown up passes a place twice, here after 0.6 m
constexpr double kCarryingNormal_z = 0.5;  // a surface steeper than 60 degrees carries nothing; chosen by eye

bool contains(const std::vector<std::size_t>& numbers, std::size_t number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

double farthest_reach_m(const SolidScene& scene) {
  double reach_m = kContact_m;
  for (const ObservedSolid& solid : scene.solids()) reach_m = std::max(reach_m, unseen_bottom_m(solid));
  return reach_m;
}

/// Those pairs of bodies that lie on each other or touch, with what may be hidden between them.
std::vector<SolidGap> near_pairs(const SolidScene& scene, const std::vector<RigidTransform>& T_world_body) {
  std::vector<SolidGap> pairs;
  for (const SolidGap& gap : scene.gaps(T_world_body, farthest_reach_m(scene))) {
    if (gap.partner < 0) continue;
    const auto upper = static_cast<std::size_t>(gap.normal.z() > 0.0 ? gap.body : gap.partner);
    if (gap.gap_m <= std::max(kContact_m, unseen_bottom_m(scene.solids()[upper]))) pairs.push_back(gap);
  }
  return pairs;
}

}  // namespace

std::vector<bool> who_stands(const std::vector<ObjectState>& objects, const SolidScene& scene,
                             const std::vector<RigidTransform>& T_world_body) {
  std::vector<bool> stands(objects.size(), false);
  const auto has_stood = [](const ObjectState& object) {
    return object.mode == MotionMode::kDynamic && object.stood_s >= kStood_s;
  };
  if (std::none_of(objects.begin(), objects.end(), has_stood)) return stands;
  const std::vector<double> height_m = heights_above_support(scene, T_world_body);
  for (std::size_t k = 0; k < objects.size(); ++k) {
    stands[k] = has_stood(objects[k]) && (std::isfinite(height_m[k]) || objects[k].stood_s >= kHung_s);
  }
  return stands;
}

Standing::Standing(const SolidScene& scene, const std::vector<RigidTransform>& T_world_body, std::vector<bool> stands)
    : stands_(std::move(stands)), stood_(stands_), carriers_(stands_.size()), overlapping_(stands_.size()) {
  if (!any() || scene.solids().empty()) return;
  for (const SolidGap& gap : near_pairs(scene, T_world_body)) {
    const auto a = static_cast<std::size_t>(gap.body), b = static_cast<std::size_t>(gap.partner);
    if (gap.normal.z() >= kCarryingNormal_z) carriers_[a].push_back(b);
    if (gap.normal.z() <= -kCarryingNormal_z) carriers_[b].push_back(a);
    if (gap.gap_m >= -kContact_m) continue;
    overlapping_[a].push_back(b);
    overlapping_[b].push_back(a);
  }
}

bool Standing::any() const { return std::find(stands_.begin(), stands_.end(), true) != stands_.end(); }

/// Hulls that overlap from the start are guesses. An engine parts them, which is no push that anybody has seen.
bool Standing::may_hit(std::size_t moving, std::size_t standing) const {
  return stood_[moving] || !contains(overlapping_[standing], moving);
}

void Standing::let_go(const std::vector<bool>& moves, const std::function<std::vector<ObjectPair>()>& touching) {
  std::vector<std::size_t> loose;
  for (std::size_t k = 0; k < moves.size(); ++k) {
    if (moves[k] && !stands_[k]) loose.push_back(k);
  }
  if (loose.empty() || !any()) return;
  const std::vector<ObjectPair> pairs = touching();
  while (!loose.empty()) {
    const std::size_t mover = loose.back();
    loose.pop_back();
    const auto release = [&](std::size_t k) {
      if (!stands_[k]) return;
      stands_[k] = false;
      if (moves[k]) loose.push_back(k);
    };
    for (std::size_t k = 0; k < carriers_.size(); ++k) {
      if (contains(carriers_[k], mover)) release(k);
    }
    for (const auto& [a, b] : pairs) {
      if (a < 0 || b < 0) continue;
      const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
      if (i == mover && may_hit(i, j)) release(j);
      if (j == mover && may_hit(j, i)) release(i);
    }
  }
}

void forget_lost_support(const std::vector<ObservedSolid>& solids, const std::vector<ObjectState>& states,
                         std::vector<CandidateObject>& objects) {
  std::vector<bool> left(solids.size(), false);
  std::vector<CandidateObject*> object_of(solids.size(), nullptr);
  for (CandidateObject& object : objects) {
    if (object.source < 0) continue;
    const auto k = static_cast<std::size_t>(object.source);
    if (k >= solids.size()) continue;  // without Bullet there are none
    object_of[k] = &object;
    left[k] = !object.is_placed && !object.twist;
  }
  if (std::find(left.begin(), left.end(), false) == left.end()) return;
  std::vector<RigidTransform> T_world_reference;
  for (const ObjectState& state : states) T_world_reference.push_back(state.T_world_current);
  const SolidScene scene(solids, 0.0);
  for (const SolidGap& gap : near_pairs(scene, scene.body_poses(T_world_reference))) {
    const auto a = static_cast<std::size_t>(gap.body), b = static_cast<std::size_t>(gap.partner);
    if (!left[a] && object_of[b] != nullptr) object_of[b]->state.stood_s = 0.0;
    if (!left[b] && object_of[a] != nullptr) object_of[a]->state.stood_s = 0.0;
  }
}

}  // namespace rigidformer
