// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/network_rollout.hpp"

#include <chrono>

#include "rigidformer/engine/contact_search.hpp"
#include "rigidformer/geometry/nearest_points.hpp"
#include "rigidformer/model/command.hpp"
#include "rigidformer/model/nearest.hpp"

namespace rigidformer {
namespace {

/// Nearest points from one search tree per rigid object, for the CPU.
NearestSearch tree_search(const SceneInput& input) {
  auto trees = std::make_shared<NearestPoints>(input.clouds);
  auto found = std::make_shared<std::vector<NearestNeighbors>>();
  const auto origin_at_zero = std::make_shared<SceneInput>();
  origin_at_zero->origin_world.setZero();
  return [=](const SceneBatch& batch, const Pose& current, const Tensor&) {
    const std::int64_t K = batch.max_objects(), N = batch.max_points();
    trees->query(to_world(*origin_at_zero, current), *found);
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

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool is_finite(const RigidTransform& T) { return T.translation.allFinite() && T.rotation.coeffs().allFinite(); }

}  // namespace

NetworkRollout::NetworkRollout(RigidFormer& model, const torch::Device& device, int max_points, const RestLimits& rest,
                               const std::vector<ObjectState>& objects, const RolloutOptions& rollout)
    : model_(model), rest_(rest), rollout_(rollout) {
  const auto start = std::chrono::steady_clock::now();
  c10::InferenceMode inference;
  input_ = make_scene_input(objects, rollout, model->options, max_points);
  nearest_ = device.is_cpu() ? tree_search(input_) : NearestSearch(nearest_by_distance_matrix);
  batch_ = input_.batch.to(device);
  state_ = input_.state.to(device);
  centre_ = model_->centre_of_mass(batch_, state_.current);
  batch_.hidden_points = model_->hidden_side(batch_, state_.current, centre_);
  engine_ = make_engine_step(model_->options, batch_, centre_);
  contacts_ = make_contact_search(model_->options, batch_, centre_);
  forecast_.times_s.push_back(0.0);
  for (const ObjectState& object : objects) {
    forecast_.objects.push_back({object.id, ObjectTrajectory::Status::kOk, {object.T_world_current}});
  }
  forecast_.compute_time_s = seconds_since(start);
}

const Forecast& NetworkRollout::advance(int num_steps) {
  const auto start = std::chrono::steady_clock::now();
  c10::InferenceMode inference;
  for (int i = 0; i < num_steps; ++i) step();
  forecast_.compute_time_s += seconds_since(start);
  return forecast_;
}

void NetworkRollout::step() {
  const auto steps_done = static_cast<std::int64_t>(forecast_.times_s.size()) - 1;
  const Tensor command = command_of_step(rollout_, steps_done);
  if (command.defined()) batch_.control = command.to(batch_.gravity.device());
  SceneState next =
      rigidformer::advance(batch_, state_, model_->forward(batch_, state_, centre_, nearest_, engine_, contacts_));
  if (rest_.speed_mps > 0.0) hold_resting(batch_, state_, next, rest_);
  forecast_.times_s.push_back(static_cast<double>(forecast_.times_s.size()) * rollout_.time_step_s);
  record(next);
  state_ = next;
}

void NetworkRollout::record(SceneState& next) {
  const std::vector<RigidTransform> T_world = to_world(input_, next.current);
  for (size_t k = 0; k < T_world.size(); ++k) {
    ObjectTrajectory& object = forecast_.objects[k];
    if (object.status == ObjectTrajectory::Status::kOk && is_finite(T_world[k])) {
      object.poses.push_back(T_world[k]);
    } else {
      object.status = ObjectTrajectory::Status::kDiverged;
      object.poses.push_back(object.poses.back());
      freeze(next, static_cast<std::int64_t>(k));
    }
  }
}

/// A diverged object stays where it was last finite, so that the others can go on around it.
void NetworkRollout::freeze(SceneState& next, std::int64_t k) {
  batch_.dynamic_mask[0][k] = false;
  for (const Pose& pose : {next.current, next.previous}) {
    Tensor rotation = pose.rotation[0][k], translation = pose.translation[0][k];
    rotation.copy_(state_.current.rotation[0][k]);
    translation.copy_(state_.current.translation[0][k]);
  }
}

}  // namespace rigidformer
