// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "rigidformer/tracking/observation.hpp"
#include "rigidformer_ros/forecast/batch_run.hpp"
#include "rigidformer_ros/forecast/inference_worker.hpp"
#include "rigidformer_ros/forecast/rollout.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

using rigidformer::ObservedObject;
using rigidformer::ObservedScene;

/// An observed scene with its predicted future. The objects stand in the same order in scene, outcome.forecast and
/// outcome.settled_steps.
struct SceneRollout {
  ObservedScene scene;
  RolloutOutcome outcome;
  rigidformer::ModelInfo model;    ///< The model, its ranges in real lengths and times
  double trusted_horizon_s = 0.0;  ///< How far ahead forecasts were good lately [s]; 0 = nowhere, or not known
};

/// Moves the objects that only the predictor found to be unusable to scene.skipped.
void skip_unusable(SceneRollout& rollout);

/// A scene whose prediction has begun, for everyone who wants steps of it. The objects stand in the same order in scene
/// and steps.
struct BegunRollout {
  ObservedScene scene;
  rigidformer::ModelInfo model;  ///< The model, its ranges in real lengths and times
  SharedRollout steps;
};

/// A scene whose candidates are being predicted.
struct BegunBatch {
  ObservedScene scene;
  rigidformer::ModelInfo model;  ///< The model, its ranges in real lengths and times
  BatchRun run;
};

/// Predicts observed scenes as the parameters say. The topic and the service share one forecaster, so that both give
/// the same numbers for the same state.
class SceneForecaster {
 public:
  SceneForecaster(const NodeParameters& parameters, PredictorFactory make_predictor);

  /// Ends rollouts in progress after their current job; they throw. The node calls this when it shuts down.
  void stop() { worker_.stop(); }

  InferenceWorker::State state() const { return worker_.state(); }
  bool ready() const { return state() == InferenceWorker::State::kReady; }
  /// Says why the model is not ready; the text is empty when it is.
  std::string message() const { return worker_.message(); }

  /// The model with its ranges as trained; empty before it is ready.
  std::optional<rigidformer::ModelInfo> model() const;

  /// The loaded model with its ranges in real lengths and times, at the length scale of `scene`.
  rigidformer::ModelInfo model_for(const ObservedScene& scene) const;

  /// The nearest time step that the model takes at the length scale of `scene`.
  double nearest_time_step(const ObservedScene& scene, double wished_s) const;

  /// The settings that the parameters `predict/*` and `service/settle_*` describe.
  RolloutSettings default_settings() const;
  void set_num_steps(int num_steps) { num_steps_ = num_steps; }

  /// The scene with what cannot be predicted, or is beyond the most that the model takes, moved to scene.skipped. The
  /// model must be loaded.
  ObservedScene usable_part(ObservedScene scene) const;

  /// Begins a rollout of the usable part of the scene, as if there were nothing else, for users who want the numbers of
  /// steps in `ends`. Nothing is predicted before somebody wants a step.
  std::shared_ptr<BegunRollout> begin(ObservedScene scene, const rigidformer::RolloutOptions& options,
                                      std::set<int> ends, JobLane lane);

  /// Begins the rollouts of candidates for the usable part of the scene, all in real lengths and times.
  std::unique_ptr<BegunBatch> begin_batch(ObservedScene scene, const std::vector<rigidformer::Candidate>& candidates,
                                          const rigidformer::BatchOptions& options);

  /// Predicts the whole scene for the forecast that the node publishes. Throws what the predictor throws.
  SceneRollout roll_out(ObservedScene scene, const RolloutSettings& settings);

 private:
  double take_usable(ObservedScene& scene, const rigidformer::ModelInfo& info) const;

  PredictParameters predict_;
  std::atomic<int> num_steps_;
  ServiceParameters service_;
  InferenceWorker worker_;
};

}  // namespace rigidformer_ros
