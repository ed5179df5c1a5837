// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/network_rollout.hpp"

#include <chrono>
#include <utility>

namespace rigidformer {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

NetworkRollout::NetworkRollout(const StepMaker& maker, const torch::Device& device, int max_points,
                               const std::vector<ObjectState>& objects, const RolloutOptions& rollout) {
  const auto start = std::chrono::steady_clock::now();
  c10::InferenceMode inference;
  RigidFormer model = maker.model;
  PerceivedObjects perceived = perceive(model, device, max_points, objects, rollout);
  world_.emplace(maker, std::move(perceived), candidate_objects({}, objects, rollout.time_step_s), rollout, forecast_);
  forecast_.compute_time_s = seconds_since(start);
}

const Forecast& NetworkRollout::advance(int num_steps) {
  const auto start = std::chrono::steady_clock::now();
  c10::InferenceMode inference;
  for (int i = 0; i < num_steps; ++i) world_->step();
  forecast_.compute_time_s += seconds_since(start);
  return forecast_;
}

}  // namespace rigidformer
