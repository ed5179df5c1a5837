// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/validation.hpp"

#include <algorithm>
#include <cmath>

#include "rigidformer/engine/contact_search.hpp"
#include "rigidformer/engine/engine_step.hpp"
#include "rigidformer/model/nearest.hpp"
#include "rigidformer/windows/window_batch.hpp"

namespace rigidformer {
namespace {

/// RMSE of every scene over its valid objects, from `squared` [B, K] -> [B].
Tensor scene_rmse(const Tensor& squared, const Tensor& object_mask) {
  const Tensor weight = object_mask.to(squared.scalar_type());
  return ((squared * weight).sum(-1) / weight.sum(-1).clamp_min(1.0)).sqrt();
}

struct Errors {
  Tensor position, orientation;  ///< [B] m and degrees
};

/// Errors of predicted against true poses of body frames whose origin is the centre of mass.
Errors pose_errors(const Pose& predicted, const Pose& truth, const Tensor& object_mask) {
  const Tensor shift = (predicted.translation - truth.translation).square().sum(-1);
  const Tensor relative = torch::matmul(predicted.rotation.transpose(-1, -2), truth.rotation);
  const Tensor trace = relative.diagonal(0, -2, -1).sum(-1);
  const Tensor angle = ((trace - 1.0) / 2.0).clamp(-1.0, 1.0).acos() * (180.0 / M_PI);
  return {scene_rmse(shift, object_mask), scene_rmse(angle.square(), object_mask)};
}

/// Poses of the body frames in free flight: constant velocity with gravity (Verlet form) and constant spin.
Pose ballistic(const WindowBatch& windows, int num_steps) {
  const Pose &first = windows.poses[0], &second = windows.poses[1];
  const Tensor fall = (windows.scene.gravity * windows.scene.time_step().square()).reshape({-1, 1, 1});
  const Tensor spin = torch::matmul(second.rotation, first.rotation.transpose(-1, -2));
  Tensor step = second.translation - first.translation;
  Pose pose = second;
  for (int k = 0; k < num_steps; ++k) {
    step = torch::cat({step.slice(-1, 0, 2), step.slice(-1, 2) + fall}, -1);
    pose = {torch::matmul(spin, pose.rotation), pose.translation + step};
  }
  return pose;
}

Pose roll_out(RigidFormer& model, const WindowBatch& windows, int num_steps) {
  SceneBatch scene = windows.scene;
  SceneState state{windows.poses[0], windows.poses[0], windows.poses[1]};
  const Tensor centre = model->centre_of_mass(scene, state.current);
  scene.hidden_points = model->hidden_side(scene, state.current, centre);
  const EngineStep engine = make_engine_step(model->options, scene, centre);
  const ContactSearch contacts = make_contact_search(model->options, scene, centre);
  for (int k = 0; k < num_steps; ++k) {
    if (!windows.controls.empty()) scene.control = windows.controls[static_cast<size_t>(k)];
    state.coming = windows.poses[static_cast<size_t>(k) + 2];
    state = advance(scene, state, model->forward(scene, state, centre, nearest_by_distance_matrix, engine, contacts));
  }
  return state.current;
}

/// Errors of position and orientation, of the model and of the ballistic guess, summed over scenes [4].
Tensor summed_errors(RigidFormer& model, const SceneTensors& tensors, const std::vector<int>& scenes, int start,
                     const ValidationOptions& options) {
  Tensor sums = torch::zeros({4}, torch::kFloat64);
  const auto stride = static_cast<size_t>(options.batch_size);
  const std::vector<double> rates_hz = tensors.frame_rates();
  for (size_t begin = 0; begin < scenes.size(); begin += stride) {
    std::vector<Window> windows;
    for (size_t i = begin; i < std::min(scenes.size(), begin + stride); ++i) {
      windows.push_back(options.window(scenes[i], start, rates_hz[static_cast<size_t>(scenes[i])]));
    }
    const WindowBatch batch = make_window_batch(tensors, windows, options.num_steps, model->options.num_anchors,
                                                no_augmentation(options.num_points));
    const Pose& truth = batch.poses.back();
    const Tensor& scored = batch.scene.dynamic_mask;
    const Errors errors = pose_errors(roll_out(model, batch, options.num_steps), truth, scored);
    const Errors guess = pose_errors(ballistic(batch, options.num_steps), truth, scored);
    sums +=
        torch::stack({errors.position.sum(), errors.orientation.sum(), guess.position.sum(), guess.orientation.sum()})
            .to(torch::kCPU, torch::kFloat64);
  }
  return sums;
}

}  // namespace

std::vector<int> scenes_reaching(const SceneTensors& tensors, int start, const ValidationOptions& options) {
  const std::vector<std::int64_t> frames = tensors.frame_counts();
  const std::vector<double> rates_hz = tensors.frame_rates();
  std::vector<int> scenes;
  for (size_t scene = 0; scene < frames.size(); ++scene) {
    if (options.last_frame(start, rates_hz[scene]) < frames[scene]) scenes.push_back(static_cast<int>(scene));
  }
  return scenes;
}

std::vector<RolloutScore> validate_rollouts(RigidFormer& model, const SceneTensors& tensors, int max_scenes,
                                            const ValidationOptions& options) {
  torch::NoGradGuard no_grad;
  model->eval();
  std::vector<RolloutScore> scores;
  for (const int start : options.start_frames) {
    std::vector<int> scenes = scenes_reaching(tensors, start, options);
    if (scenes.empty()) continue;
    scenes.resize(std::min(scenes.size(), static_cast<size_t>(max_scenes)));
    const Tensor sums = summed_errors(model, tensors, scenes, start, options) / static_cast<double>(scenes.size());
    scores.push_back(
        {start, sums[0].item<double>(), sums[1].item<double>(), sums[2].item<double>(), sums[3].item<double>()});
  }
  model->train();
  return scores;
}

OneStepScore one_step_error(RigidFormer& model, const SceneTensors& tensors, const std::vector<Window>& windows,
                            int num_points) {
  torch::NoGradGuard no_grad;
  model->eval();
  const WindowBatch batch =
      make_window_batch(tensors, windows, 1, model->options.num_anchors, no_augmentation(num_points));
  SceneBatch scene = batch.scene;
  if (!batch.controls.empty()) scene.control = batch.controls.front();
  const SceneState state{batch.poses[0], batch.poses[0], batch.poses[1], batch.poses[2]};
  const Tensor centre = model->centre_of_mass(scene, state.current);
  const StepPrediction prediction =
      model->forward(scene, state, centre, nearest_by_distance_matrix, make_engine_step(model->options, scene, centre),
                     make_contact_search(model->options, scene, centre));
  const Tensor q = scene.anchors_reference();
  const Tensor truth = batch.poses[2].apply(q);
  const BaseMotion base = make_base_motion(model->options, scene, state, centre);
  const Tensor weight = scene.dynamic_mask.to(torch::kFloat32);
  const auto mean_error = [&](const Tensor& predicted) {
    const Tensor error = (predicted - truth).norm(2, -1).mean(-1);
    return ((error * weight).sum() / weight.sum()).item<double>();
  };
  const OneStepScore score{mean_error(prediction.pose.apply(q)), mean_error(base.apply(q))};
  model->train();
  return score;
}

}  // namespace rigidformer
