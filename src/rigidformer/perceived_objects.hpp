// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "rigidformer/engine/observed_solid.hpp"
#include "rigidformer/geometry/nearest_points.hpp"
#include "rigidformer/model/rigidformer.hpp"
#include "rigidformer/model/scene_input.hpp"

namespace rigidformer {

/// What is made of some clouds once, however often their motion is then predicted: the points that the network looks
/// at, centres of mass, hidden sides, hulls and search trees. It is only read afterwards.
struct PerceivedObjects {
  SceneBatch batch;  ///< B = 1, on the device of the model, with the hidden sides
  Eigen::Vector3d origin_world;
  Tensor centre;                                              ///< Of mass, reference frame [1, K, 3]
  std::vector<std::shared_ptr<const SearchableCloud>> trees;  ///< For models on the CPU
  std::vector<ObservedSolid> solids;                          ///< None without Bullet
};

/// At least one object; objects are usable and options valid. The network looks at `max_points` points per object;
/// larger clouds are thinned evenly. Throws BodyError.
PerceivedObjects perceive(RigidFormer& model, const torch::Device& device, int max_points,
                          const std::vector<ObjectState>& objects, const RolloutOptions& rollout);

/// Some objects out of several perceptions as one: `parts[i]` is the perception of object i, `rows[i]` its row there.
/// Roles and material are those of the perceptions. What holds for the whole scene is that of `scene`.
PerceivedObjects gather(const std::vector<const PerceivedObjects*>& parts, const std::vector<std::int64_t>& rows,
                        const PerceivedObjects& scene);

/// A search of its own for each rollout: it remembers its last answers.
NearestSearch nearest_search(const PerceivedObjects& perceived);

}  // namespace rigidformer
