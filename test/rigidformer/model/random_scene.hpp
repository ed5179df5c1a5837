// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "rigidformer/engine/contact_search.hpp"
#include "rigidformer/engine/engine_step.hpp"
#include "rigidformer/model/nearest.hpp"
#include "rigidformer/model/options.hpp"
#include "rigidformer/model/rigid_projection.hpp"
#include "rigidformer/model/rigidformer.hpp"

namespace rigidformer {

/// The inputs of one step.
struct RandomScene {
  SceneBatch batch;
  SceneState state;
};

inline double largest_difference(const Tensor& a, const Tensor& b) {
  return (a - b).abs().max().to(torch::kFloat64).item<double>();
}

/// Calls visit(tensor) for every tensor [B, K, ...] of a scene.
template <typename Visitor>
void for_each_object_tensor(RandomScene& scene, Visitor&& visit) {
  SceneBatch& b = scene.batch;
  for (Tensor* tensor : {&b.points_reference, &b.point_mask, &b.object_mask, &b.anchor_index, &b.properties,
                         &b.properties_known, &b.dynamic_mask}) {
    visit(*tensor);
  }
  if (b.normals_reference.defined()) visit(b.normals_reference);
  for (Pose* pose : {&scene.state.first, &scene.state.previous, &scene.state.current}) {
    visit(pose->rotation);
    visit(pose->translation);
  }
}

/// Calls visit(tensor) for every tensor [B] of a scene, and for the control code.
template <typename Visitor>
void for_each_scene_tensor(RandomScene& scene, Visitor&& visit) {
  SceneBatch& b = scene.batch;
  for (Tensor* tensor : {&b.step_size, &b.ground_height, &b.gravity}) visit(*tensor);
  if (b.control.defined()) visit(b.control);
}

/// Moves the pose a little: by up to some centimetres and hundredths of a radian.
inline Pose nudged(const Pose& pose) {
  return {special_procrustes((pose.rotation + 0.03 * torch::randn_like(pose.rotation)).transpose(-1, -2)),
          pose.translation + 0.02 * torch::randn_like(pose.translation)};
}

/// Random clouds close to each other and to the ground. `points[b][k]` is the number of points of object k in scene b;
/// shorter scenes and clouds are padded with zeros. Reseeds torch.
inline RandomScene random_scene(std::uint64_t seed, const std::vector<std::vector<std::int64_t>>& points,
                                int num_anchors = 4, int control_dim = 0, torch::ScalarType type = torch::kFloat64) {
  torch::manual_seed(seed);
  const auto B = static_cast<std::int64_t>(points.size());
  std::int64_t K = 0, N = 0;
  for (const auto& row : points) {
    K = std::max(K, static_cast<std::int64_t>(row.size()));
    N = std::max(N, *std::max_element(row.begin(), row.end()));
  }
  RandomScene scene;
  SceneBatch& b = scene.batch;
  const auto like = torch::TensorOptions(torch::kFloat64);
  b.point_mask = torch::zeros({B, K, N}, torch::kBool);
  b.anchor_index = torch::zeros({B, K, num_anchors}, torch::kInt64);
  for (std::int64_t i = 0; i < B; ++i) {
    const auto& row = points[static_cast<size_t>(i)];
    for (std::int64_t k = 0; k < static_cast<std::int64_t>(row.size()); ++k) {
      const std::int64_t count = row[static_cast<size_t>(k)];
      b.point_mask[i][k].slice(0, 0, count).fill_(true);
      b.anchor_index[i][k].copy_(torch::randperm(count, torch::kInt64).slice(0, 0, num_anchors));
    }
  }
  b.points_reference = 0.3 * torch::randn({B, K, N, 3}, like) * b.point_mask.unsqueeze(-1);
  b.object_mask = b.point_mask.any(-1);
  b.dynamic_mask = b.object_mask.clone();
  b.properties_known = (torch::rand({B, K, 3}, like) > 0.3).to(torch::kFloat64) * b.object_mask.unsqueeze(-1);
  b.properties = (0.2 + torch::rand({B, K, 3}, like)) * b.properties_known;
  b.step_size = torch::randint(1, 11, {B}, like);
  b.ground_height = torch::zeros({B}, like);
  b.gravity = torch::full({B}, -10.0, like);
  if (control_dim > 0) b.control = torch::randn({B, control_dim}, like);

  const Tensor lift = torch::tensor({0.0, 0.0, 0.6}, like);
  scene.state.current = {special_procrustes(torch::randn({B, K, 3, 3}, like)),
                         0.6 * torch::randn({B, K, 3}, like) + lift};
  scene.state.previous = nudged(scene.state.current);
  scene.state.first = nudged(scene.state.previous);

  b.normals_reference = torch::randn({B, K, N, 3}, like);
  b.normals_reference = b.normals_reference / b.normals_reference.norm(2, -1, true) * b.point_mask.unsqueeze(-1);

  const auto convert = [type](Tensor& tensor) {
    if (tensor.is_floating_point()) tensor = tensor.to(type);
  };
  for_each_object_tensor(scene, convert);
  for_each_scene_tensor(scene, convert);
  return scene;
}

/// Turns on all options beyond the paper.
inline ModelOptions contact_aware(ModelOptions options) {
  options.inertial_base_motion = options.contact_gate = options.centre_of_mass_head = true;
  options.position_feature = options.contact_features = options.property_mask = true;
  options.own_token_in_query = options.velocity_output = options.end_velocity_output = true;
  options.local_planes = true;
  options.reference_offset_feature = false;
  return options;
}

/// The tiny preset with contact tokens.
inline ModelOptions token_options() {
  ModelOptions options = contact_aware(model_preset("tiny"));
  options.contact_tokens = true;
  return options;
}

/// The tiny preset, in the paper's form and with all options beyond it.
inline std::vector<ModelOptions> tiny_variants() { return {model_preset("tiny"), contact_aware(model_preset("tiny"))}; }

inline const std::vector<std::string>& encoding_names() {
  static const std::vector<std::string> names = {"arope", "sinusoidal", "learned", "obb", "pca", "se3", "none"};
  return names;
}

/// A model none of whose parts is switched off by its initial zeros, with outputs of several m/s^2. Reseeds torch.
inline RigidFormer random_model(const ModelOptions& options, torch::ScalarType type = torch::kFloat64,
                                std::uint64_t seed = 5) {
  torch::manual_seed(seed);
  RigidFormer model(options);
  torch::NoGradGuard no_grad;
  for (Tensor parameter : model->parameters()) parameter.add_(0.1 * torch::randn_like(parameter));
  model->predictor->head->second->weight.mul_(10.0);
  model->to(type);
  model->set_compute_type(type);
  model->eval();
  return model;
}

inline StepPrediction predict(RigidFormer& model, const RandomScene& scene) {
  torch::NoGradGuard no_grad;
  const Tensor centre = model->centre_of_mass(scene.batch, scene.state.current);
  return model->forward(scene.batch, scene.state, centre, nearest_by_distance_matrix,
                        make_engine_step(model->options, scene.batch, centre),
                        make_contact_search(model->options, scene.batch, centre));
}

}  // namespace rigidformer
