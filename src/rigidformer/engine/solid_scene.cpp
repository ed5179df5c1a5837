// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/solid_scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "rigidformer/simulation/hull_distance.hpp"
#include "rigidformer/simulation/observed_motion.hpp"

namespace rigidformer {
namespace {

constexpr double kCarriedSpeed_mps = 0.3;  // vertical, relative to the support, below which a body lies or rolls on it
constexpr double kSupportNormal_z = 0.5;   // a surface steeper than 60 degrees carries nothing; chosen by eye

}  // namespace

SolidScene::SolidScene(std::vector<ObservedSolid> solids, double ground_height_m)
    : solids_(std::move(solids)), ground_height_m_(ground_height_m) {}

std::vector<RigidTransform> SolidScene::body_poses(const std::vector<RigidTransform>& T_world_reference) const {
  std::vector<RigidTransform> poses;
  for (const ObservedSolid& solid : solids_) {
    const RigidTransform& T = T_world_reference.at(static_cast<std::size_t>(solid.object));
    poses.push_back({T.rotation, T * solid.centre_reference});
  }
  return poses;
}

double SolidScene::height(std::size_t body, const RigidTransform& T_world_body) const {
  return static_cast<double>(T_world_body.apply(solids_[body].hull->vertices).col(2).minCoeff()) - ground_height_m_;
}

void SolidScene::add_gap(std::size_t body, std::size_t partner, const std::vector<RigidTransform>& T, double reach_m,
                         std::vector<SolidGap>& gaps) const {
  const double between = (T[body].translation - T[partner].translation).norm();
  if (!(between < solids_[body].radius_m + solids_[partner].radius_m + reach_m)) return;
#ifdef RIGIDFORMER_HAS_BULLET
  const auto closest = closest_points(*solids_[body].distances, T[body], *solids_[partner].distances, T[partner]);
  if (!closest || closest->gap_m >= reach_m) return;
  gaps.push_back({static_cast<int>(body), static_cast<int>(partner), closest->normal, closest->gap_m});
#else
  (void)gaps;  // without Bullet there are no solids
#endif
}

std::vector<SolidGap> SolidScene::gaps(const std::vector<RigidTransform>& T_world_body, double reach_m) const {
  std::vector<SolidGap> found;
  for (std::size_t i = 0; i < solids_.size(); ++i) {
    if (T_world_body[i].translation.z() - ground_height_m_ > solids_[i].radius_m + reach_m) continue;
    const double gap_m = height(i, T_world_body[i]);
    if (gap_m < reach_m) found.push_back({static_cast<int>(i), -1, Eigen::Vector3d::UnitZ(), gap_m});
  }
  for (std::size_t i = 0; i < solids_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) add_gap(i, j, T_world_body, reach_m, found);
  }
  return found;
}

std::vector<bool> SolidScene::carried(const std::vector<RigidTransform>& T_world_body,
                                      const std::vector<double>& rising_mps) const {
  const std::size_t K = solids_.size();
  std::vector<bool> carried(K, false), may_be(K, false);
  const auto lies_on = [&](std::size_t i, double support_mps) {
    return std::abs(rising_mps[i] - support_mps) < kCarriedSpeed_mps;
  };
  for (std::size_t i = 0; i < K; ++i) {
    if (!solids_[i].dynamic) continue;
    carried[i] = lies_on(i, 0.0) && height(i, T_world_body[i]) < kTouching_m;
    may_be[i] = !carried[i];
  }
  std::vector<SolidGap> supports;
  for (std::size_t i = 0; i < K; ++i) {
    for (std::size_t j = 0; j < K; ++j) {
      const bool is_new_pair = j != i && (!may_be[j] || j < i);
      if (may_be[i] && is_new_pair && lies_on(i, rising_mps[j])) add_gap(i, j, T_world_body, kTouching_m, supports);
    }
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (const SolidGap& gap : supports) {
      if (std::abs(gap.normal.z()) < kSupportNormal_z) continue;
      const bool body_is_above = gap.normal.z() > 0.0;
      const auto upper = static_cast<std::size_t>(body_is_above ? gap.body : gap.partner);
      const auto lower = static_cast<std::size_t>(body_is_above ? gap.partner : gap.body);
      if (!solids_[upper].dynamic || carried[upper] || (solids_[lower].dynamic && !carried[lower])) continue;
      carried[upper] = changed = true;
    }
  }
  return carried;
}

}  // namespace rigidformer
