// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "rigidformer/evaluation/protocol.hpp"

namespace rigidformer {

/// The rollout of a scene to look at: the origins of all objects from the second given frame to the longest horizon.
struct ScenePaths {
  std::string set, scene;
  int start = 0, step = 0;
  PoseError error;                                                ///< Error of the scene at the longest horizon
  std::vector<std::string> shapes;                                ///< Name of every object's shape
  std::vector<std::vector<Eigen::Vector3d>> predicted, recorded;  ///< [object][k] positions [m]
};

/// Keeps the scenes that one model predicts worst, by the position at the longest horizon, for every set and start. A
/// scene counts once, with its worst step size.
class WorstScenes {
 public:
  /// `horizon` counts from the start in `unit`.
  WorstScenes(std::string model, int horizon, int kept_per_start, HorizonUnit unit = HorizonUnit::kFrames)
      : model_(std::move(model)), horizon_(horizon), kept_per_start_(kept_per_start), unit_(unit) {}

  /// Takes a result in; results of other models are ignored.
  void add(const SceneResult& result);

  /// Returns the kept scenes by set and start, the worst one first.
  std::vector<ScenePaths> list() const;

 private:
  int last_frame(const SceneResult& result) const;

  std::string model_;
  int horizon_, kept_per_start_;
  HorizonUnit unit_;
  std::map<std::pair<std::string, int>, std::vector<ScenePaths>> worst_;
};

}  // namespace rigidformer
