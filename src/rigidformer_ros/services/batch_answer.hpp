// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/BatchRequest.h>
#include <rigidformer_ros/BatchResult.h>

#include <functional>
#include <vector>

#include "rigidformer_ros/forecast/scene_forecaster.hpp"
#include "rigidformer_ros/inputs/frame_transformer.hpp"
#include "rigidformer_ros/inputs/live_scene.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"
#include "rigidformer_ros/services/batch_request.hpp"
#include "rigidformer_ros/services/batch_result.hpp"
#include "rigidformer_ros/services/client_count.hpp"

namespace rigidformer_ros {

/// How far a batch has come, and what was done since the last time.
struct BatchProgress {
  int steps_done = 0;  ///< Of the candidates that are still in progress
  int num_steps = 0;
  int num_done = 0;
  std::vector<std::uint32_t> indices;    ///< Of the candidates done since then
  std::vector<CandidateResult> results;  ///< Theirs
};

/// What somebody who waits for a batch may say and hear meanwhile.
struct BatchWatcher {
  std::function<bool()> is_cancelled = [] { return false; };
  std::function<void(const BatchProgress&)> tell = [](const BatchProgress&) {};
};

/// Answers requests for many candidates. Jobs of 50 ms take turns with other rollouts, and every other turn is the
/// forecast's.
class BatchAnswerer {
 public:
  /// All references must outlive it.
  BatchAnswerer(const NodeParameters& parameters, SceneForecaster& forecaster, LiveScene& live_scene,
                const FrameTransformer& frames, ClientCount& clients);

  /// Answers one request and never throws. This may be called from any thread.
  BatchResult answer(const BatchRequest& request, const BatchWatcher& watcher = {});

 private:
  BatchResult answer_ready(const BatchRequest& request, const BatchWatcher& watcher);
  ObservedScene read(const PredictRollout::Request& question, const RolloutTask& task) const;

  NodeParameters parameters_;
  SceneForecaster& forecaster_;
  LiveScene& live_scene_;
  const FrameTransformer& frames_;
  ClientCount& clients_;
};

}  // namespace rigidformer_ros
