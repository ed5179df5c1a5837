// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/perceived_objects.hpp"

#include <algorithm>
#include <cmath>

#include "rigidformer/engine/engine_step.hpp"
#include "rigidformer/engine/standing_hull.hpp"
#include "rigidformer/model/nearest.hpp"
#include "rigidformer/standing.hpp"

namespace rigidformer {
namespace {

// Tensors of a batch that hold for the whole scene, [B, ...] instead of [B, K, ...].
constexpr std::array kSceneTensors{&SceneBatch::step_size,       &SceneBatch::ground_height, &SceneBatch::gravity,
                                   &SceneBatch::ground_material, &SceneBatch::ground_known,  &SceneBatch::control};

bool holds_for_scene(Tensor SceneBatch::*tensor) {
  return std::find(kSceneTensors.begin(), kSceneTensors.end(), tensor) != kSceneTensors.end();
}

/// Rows [1, 1, ...] of objects as one tensor [1, K, ...]; clouds of fewer points are padded with zeros.
Tensor joined(const std::vector<Tensor>& rows) {
  std::int64_t longest = 0;
  for (const Tensor& row : rows) longest = std::max(longest, row.dim() > 2 ? row.size(2) : 0);
  std::vector<Tensor> padded;
  for (const Tensor& row : rows) {
    if (row.dim() <= 2 || row.size(2) == longest) {
      padded.push_back(row);
      continue;
    }
    std::vector<std::int64_t> shape = row.sizes().vec();
    shape[2] = longest - row.size(2);
    padded.push_back(torch::cat({row, torch::zeros(shape, row.options())}, 2));
  }
  return torch::cat(padded, 1);
}

/// Nearest points from one search tree per rigid object, for the CPU.
NearestSearch tree_search(const std::vector<std::shared_ptr<const SearchableCloud>>& clouds) {
  auto trees = std::make_shared<NearestPoints>(NearestPoints::sharing(clouds));
  auto found = std::make_shared<std::vector<NearestNeighbors>>();
  return [=](const SceneBatch& batch, const Pose& current, const Tensor&) {
    const std::int64_t K = batch.max_objects(), N = batch.max_points();
    trees->query(to_world(current, Eigen::Vector3d::Zero()), *found);
    Nearest nearest{torch::zeros({1, K, N}, torch::kInt64), torch::zeros({1, K, N}, torch::kBool)};
    auto index = nearest.index.accessor<std::int64_t, 3>();
    auto valid = nearest.found.accessor<bool, 3>();
    for (std::int64_t k = 0; k < K; ++k) {
      const NearestNeighbors& neighbors = (*found)[static_cast<size_t>(k)];
      for (size_t i = 0; i < neighbors.object.size(); ++i) {
        if (neighbors.object[i] < 0) continue;
        index[0][k][static_cast<std::int64_t>(i)] = neighbors.object[i] * N + neighbors.point[i];
        valid[0][k][static_cast<std::int64_t>(i)] = true;
      }
    }
    return nearest;
  };
}

bool is_at_rest(const ObjectState& object) {
  return object.mode == MotionMode::kDynamic &&
         object.T_world_current.translation == object.T_world_previous.translation &&
         object.T_world_current.rotation.coeffs() == object.T_world_previous.rotation.coeffs();
}

/// What stands is a body that can stand; so is what is seen from one side and taken to be at rest on something.
void set_on_feet(const std::vector<ObjectState>& objects, const Pose& current, PerceivedObjects& perceived) {
  if (perceived.solids.empty()) return;
  const SolidScene scene(perceived.solids, perceived.batch.ground_height[0].item<double>());
  const auto poses = scene.body_poses(to_world(current, Eigen::Vector3d::Zero()));
  std::vector<bool> stands = who_stands(objects, scene, poses);
  const std::vector<double> height_m = heights_above_support(scene, poses);
  std::vector<BodyProperties> properties;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const bool may_stand = is_at_rest(objects[k]) && !perceived.solids[k].complete && std::isfinite(height_m[k]);
    stands[k] = stands[k] || may_stand;
    properties.push_back(objects[k].properties);
  }
  perceived.solids = on_their_feet(scene, poses, stands, properties);
}

}  // namespace

NearestSearch nearest_search(const PerceivedObjects& perceived) {
  return perceived.batch.points_reference.is_cpu() ? tree_search(perceived.trees)
                                                   : NearestSearch(nearest_by_distance_matrix);
}

PerceivedObjects perceive(RigidFormer& model, const torch::Device& device, int max_points,
                          const std::vector<ObjectState>& objects, const RolloutOptions& rollout) {
  SceneInput input = make_scene_input(objects, rollout, model->options, max_points);
  PerceivedObjects perceived;
  perceived.origin_world = input.origin_world;
  perceived.batch = input.batch.to(device);
  const Pose current = input.state.current.to(device);
  perceived.centre = model->centre_of_mass(perceived.batch, current);
  perceived.batch.hidden_points = model->hidden_side(perceived.batch, current, perceived.centre);
  perceived.solids = make_solids(perceived.batch, perceived.centre);
  set_on_feet(objects, input.state.current, perceived);
  if (device.is_cpu()) {
    for (Points& cloud : input.clouds) perceived.trees.push_back(make_searchable(std::move(cloud)));
  }
  return perceived;
}

PerceivedObjects gather(const std::vector<const PerceivedObjects*>& parts, const std::vector<std::int64_t>& rows,
                        const PerceivedObjects& scene) {
  PerceivedObjects all;
  all.origin_world = scene.origin_world;
  const auto join = [&](const auto& tensor_of) {
    std::vector<Tensor> found;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Tensor tensor = tensor_of(*parts[i]);
      if (!tensor.defined()) return Tensor();
      found.push_back(tensor.slice(1, rows[i], rows[i] + 1));
    }
    return joined(found);
  };
  for (const auto tensor : kBatchTensors) {
    all.batch.*tensor = holds_for_scene(tensor)
                            ? scene.batch.*tensor
                            : join([&](const PerceivedObjects& part) { return part.batch.*tensor; });
  }
  all.centre = join([](const PerceivedObjects& part) { return part.centre; });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto row = static_cast<std::size_t>(rows[i]);
    if (!parts[i]->trees.empty()) all.trees.push_back(parts[i]->trees[row]);
    if (!parts[i]->solids.empty()) all.solids.push_back(parts[i]->solids[row]);
  }
  return all;
}

}  // namespace rigidformer
