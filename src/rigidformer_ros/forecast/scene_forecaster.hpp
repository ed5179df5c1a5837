// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "rigidformer/tracking/observation.hpp"
#include "rigidformer_ros/forecast/inference_worker.hpp"
#include "rigidformer_ros/forecast/rollout.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

using rigidformer::ObservedObject;
using rigidformer::ObservedScene;

/// An observed scene with its predicted future. Objects in scene, outcome.forecast and outcome.settled_steps
/// correspond.
struct SceneRollout {
  ObservedScene scene;
  RolloutOutcome outcome;
  rigidformer::ModelInfo model;    ///< Ranges in real lengths and times
  double trusted_horizon_s = 0.0;  ///< 0 = none or not known
};

/// Moves the objects that only the predictor found to be unusable to scene.skipped.
void skip_unusable(SceneRollout& rollout);

/// A scene whose prediction has begun, for all who want steps of it. Objects in scene and steps correspond.
struct BegunRollout {
  ObservedScene scene;
  rigidformer::ModelInfo model;  ///< Ranges in real lengths and times
  SharedRollout steps;
};

/// Predicts observed scenes as the parameters say. The topic and the service share one, so their numbers are the same.
class SceneForecaster {
 public:
  SceneForecaster(const NodeParameters& parameters, PredictorFactory make_predictor);

  /// Ends rollouts in progress after their current job; they throw. For shutting down.
  void stop() { worker_.stop(); }

  InferenceWorker::State state() const { return worker_.state(); }
  bool ready() const { return state() == InferenceWorker::State::kReady; }
  /// Why it is not ready; empty when it is.
  std::string message() const { return worker_.message(); }

  /// The model with its ranges as trained; empty before it is ready.
  std::optional<rigidformer::ModelInfo> model() const;

  /// The loaded model with its ranges in real lengths and times, at the length scale of `scene`.
  rigidformer::ModelInfo model_for(const ObservedScene& scene) const;

  /// What predict.* asks for.
  RolloutSettings default_settings() const;
  void set_num_steps(int num_steps) { num_steps_ = num_steps; }

  /// The scene with what cannot be predicted, or is beyond the model's limit, moved to scene.skipped. The model must be
  /// loaded.
  ObservedScene usable_part(ObservedScene scene) const;

  /// Predicts the usable part of the scene, as if there were nothing else. For requests of the numbers of steps in
  /// `ends`; nothing is predicted before somebody wants a step.
  std::shared_ptr<BegunRollout> begin(ObservedScene scene, const rigidformer::RolloutOptions& options,
                                      std::set<int> ends, JobLane lane);

  /// All of it, for the forecast. Throws what the predictor throws.
  SceneRollout roll_out(ObservedScene scene, const RolloutSettings& settings);

 private:
  double take_usable(ObservedScene& scene, const rigidformer::ModelInfo& info) const;

  PredictParameters predict_;
  std::atomic<int> num_steps_;
  ServiceParameters service_;
  InferenceWorker worker_;
};

}  // namespace rigidformer_ros
