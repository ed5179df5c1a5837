// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "rigidformer/model/rigidformer.hpp"
#include "rigidformer/windows/scene_tensors.hpp"
#include "rigidformer/windows/window_batch.hpp"
#include "rigidformer/windows/window_sampler.hpp"

namespace rigidformer {

/// Errors of the last poses of many rollouts: the mean over scenes of the RMSE of each scene.
struct RolloutScore {
  int start_frame = 0;
  double position_m = 0.0, orientation_deg = 0.0;
  double ballistic_position_m = 0.0, ballistic_orientation_deg = 0.0;
};

/// The rollouts for validation: num_steps steps of step_size frames from each start frame, in frames of 1/240 s that
/// become as many of the scene's own. Frames and step size are the paper's, with later starts.
struct ValidationOptions {
  std::vector<int> start_frames = {0, 120, 240};
  int step_size = 10;
  int num_steps = 9;  ///< Two frames are given, so that frame start + 10 s = 100 is reached after nine steps
  int num_points = kAllVertices;  ///< Or a number of surface samples per object
  int batch_size = 1;             ///< Scenes per forward pass; more would be padded to the largest mesh of all

  /// Where a rollout from `start` begins and ends in a scene of that rate.
  Window window(int scene, int start, double frame_rate_hz) const {
    const int first = start == 0 ? 0 : frames_at_rate(start, frame_rate_hz);
    return {scene, first, frames_at_rate(step_size, frame_rate_hz)};
  }
  int last_frame(int start, double frame_rate_hz) const {
    const Window rollout = window(0, start, frame_rate_hz);
    return rollout.frame + rollout.step_size * (num_steps + 1);
  }
};

/// The scenes that are long enough for a rollout from `start`.
std::vector<int> scenes_reaching(const SceneTensors& tensors, int start, const ValidationOptions& options);

/// Rolls out the first `max_scenes` scenes of `tensors` that are long enough with the model's current weights, on the
/// tensors' device. Starts that no scene is long enough for have no score; static objects do not count.
std::vector<RolloutScore> validate_rollouts(RigidFormer& model, const SceneTensors& tensors, int max_scenes,
                                            const ValidationOptions& options);

/// Mean error of the anchors [m] after one step, over windows of one kind, for the model and for the base motion.
struct OneStepScore {
  double model_m = 0.0, base_m = 0.0;
};
OneStepScore one_step_error(RigidFormer& model, const SceneTensors& tensors, const std::vector<Window>& windows,
                            int num_points);

}  // namespace rigidformer
