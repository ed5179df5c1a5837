// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "rigidformer/data/scene_archive.hpp"
#include "rigidformer/evaluation/forecaster.hpp"
#include "rigidformer/evaluation/metrics.hpp"
#include "rigidformer/evaluation/observation.hpp"

namespace rigidformer {

/// What horizons count, from the first given frame on.
enum class HorizonUnit { kFrames, kMilliseconds };

/// Which rollouts are made and where they are scored. Starts and steps count frames of the recording. The default step
/// sizes and horizons are the paper's, which starts at frame 0 only (docs/paper_map.md, "§4, scores").
struct ProtocolOptions {
  std::vector<int> starts{0, 120, 240};    ///< First given frames S; the second given frame is S + step
  std::vector<int> steps{1, 5, 10};        ///< Step sizes of the rollouts
  std::vector<int> horizons{50, 75, 100};  ///< Scores are taken that long after S
  HorizonUnit horizon_unit = HorizonUnit::kFrames;
  int max_scenes = 0;         ///< Number of scenes used, from the first on; 0 = all
  bool resting_only = false;  ///< Scores only objects that lie still from the start to the last horizon: their drift
  /// Errors over time are taken up to this horizon, as far as a recording goes: after every step, or every 20 ms.
  int curve_end = 0;
  bool to_the_end = false;  ///< Rolls out to the end of every recording, to see on which face settled objects lie
  ObservationOptions observation;

  /// Throws std::invalid_argument naming field and value, also when a horizon is shorter than a step.
  void validate() const;
};

/// Objects that rest at the end of their recording, and how many of them lie on the right face there in the forecast:
/// tilted by less than 20 degrees. Both are 0 where rollouts do not reach the end.
struct SettledCount {
  int num_settled = 0;
  int num_right_face = 0;
};

/// Mean error over the scenes of one set.
struct Score {
  std::string model;
  std::string set;
  int start = 0;
  int step = 0;
  int horizon = 0;  ///< In ProtocolOptions::horizon_unit
  int num_scenes = 0;
  PoseError error;
  double compute_s_per_predicted_s = 0.0;  ///< Wall time of the forecaster per second of predicted motion
  SettledCount settled = {};               ///< Of all scenes, the same at every horizon
};

/// Outcome of one rollout of one scene.
struct SceneResult {
  std::string model;
  std::string set;
  int start = 0;
  int step = 0;
  const SceneRecording* scene = nullptr;                  ///< The scene that was rolled out; never null
  std::vector<PoseError> at_horizon;                      ///< [horizon] error of the scored objects
  std::vector<std::vector<PoseError>> object_at_horizon;  ///< [horizon][object] distance and angle of one object
  std::map<int, PoseError>
      curve;  ///< Errors of all free objects by horizon, from the second given frame on; see curve_end
  std::vector<std::vector<RigidTransform>> predicted;  ///< [object][k] predicted poses
  SettledCount settled = {};                           ///< Only with to_the_end
};

/// Called after every rollout; the result lives no longer than the call.
using ResultSink = std::function<void(const SceneResult&)>;

/// Called after every scene with the number of rollout steps made so far and in all.
using EvaluationProgress = std::function<void(long done, long total)>;

/// A sentence each about the scenes that evaluate() leaves out: those in which no object can move, and, per start,
/// those that end before the last horizon, so that all horizons of a row are means over the same scenes.
std::vector<std::string> scenes_left_out(const SceneArchive& archive, const ProtocolOptions& options);

/// Rolls every forecaster out from two given frames of every scene and scores it against the recording.
/// Scores come in the order start, step, forecaster, horizon. When only resting objects are scored, scenes in
/// which nothing rests are left out; static objects do not count. Throws std::invalid_argument for invalid options,
/// no scenes, nothing to score or a start that no scene is long enough for.
std::vector<Score> evaluate(const SceneArchive& archive, const std::vector<Forecaster*>& forecasters,
                            const ProtocolOptions& options, const EvaluationProgress& progress = {},
                            const ResultSink& sink = {});

}  // namespace rigidformer
