// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pose_table.hpp"
#include "rigidformer/engine/observed_solid.hpp"

namespace rigidformer {

/// A contact as one side sees it; the members are those of Contacts.
struct FoundContact {
  std::int64_t object = 0, partner = -1;
  Eigen::Vector3d point, partner_point, normal;
  double fraction = 0.0, gap_m = 0.0;
};

/// The objects of one scene as convex hulls, among which contacts are searched. Only geometry: nothing moves by it.
class ContactScene {
 public:
  /// The bodies of scene number `scene` of a batch.
  ContactScene(std::vector<ObservedSolid> solids, std::int64_t scene, double ground_height_m);

  /// The contacts of a step between two poses of every object.
  std::vector<FoundContact> search(const PoseTable& from, const PoseTable& to) const;

  /// Writes this scene's rows of Contacts::mass and Contacts::inverse_inertia, both in double precision.
  void describe_bodies(Tensor& mass, Tensor& inverse_inertia) const;

 private:
  struct Motion;

  void meet_each_other(const Motion& a, const Motion& b, std::vector<FoundContact>& found) const;
  void meet_ground(const Motion& motion, std::vector<FoundContact>& found) const;

  std::int64_t scene_;
  double ground_height_m_;
  std::vector<ObservedSolid> bodies_;
};

}  // namespace rigidformer
