// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/worst_scenes.hpp"

#include <algorithm>

namespace rigidformer {
namespace {

ScenePaths paths_of(const SceneResult& result, int last_frame) {
  ScenePaths paths;
  paths.set = result.set;
  paths.scene = result.scene->name;
  paths.start = result.start;
  paths.step = result.step;
  paths.error = result.at_horizon.back();
  const std::size_t num_poses = std::min<std::size_t>(last_frame / result.step, result.predicted.front().size());
  for (std::size_t i = 0; i < result.predicted.size(); ++i) {
    const RecordedObject& object = result.scene->objects[i];
    paths.shapes.push_back(object.shape);
    auto& predicted = paths.predicted.emplace_back();
    auto& recorded = paths.recorded.emplace_back();
    for (std::size_t k = 0; k < num_poses; ++k) {
      predicted.push_back(result.predicted[i][k].translation);
      recorded.push_back(object.T_world_object.at(result.start + result.step * (k + 1)).translation);
    }
  }
  return paths;
}

}  // namespace

int WorstScenes::last_frame(const SceneResult& result) const {
  if (unit_ == HorizonUnit::kFrames) return horizon_;
  return static_cast<int>(horizon_ * result.scene->frame_rate_hz / 1000.0);
}

void WorstScenes::add(const SceneResult& result) {
  if (result.model != model_) {
    return;
  }
  std::vector<ScenePaths>& worst = worst_[{result.set, result.start}];
  const double error = result.at_horizon.back().position_rmse_m;
  const auto same =
      std::find_if(worst.begin(), worst.end(), [&](const ScenePaths& s) { return s.scene == result.scene->name; });
  if (same != worst.end()) {
    if (same->error.position_rmse_m >= error) {
      return;
    }
    worst.erase(same);
  }
  const auto place =
      std::find_if(worst.begin(), worst.end(), [&](const ScenePaths& s) { return s.error.position_rmse_m < error; });
  if (place - worst.begin() >= kept_per_start_) {
    return;
  }
  worst.insert(place, paths_of(result, last_frame(result)));
  worst.resize(std::min<std::size_t>(worst.size(), kept_per_start_));
}

std::vector<ScenePaths> WorstScenes::list() const {
  std::vector<ScenePaths> all;
  for (const auto& [place, scenes] : worst_) {
    all.insert(all.end(), scenes.begin(), scenes.end());
  }
  return all;
}

}  // namespace rigidformer
