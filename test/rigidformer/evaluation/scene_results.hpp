// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "rigidformer/evaluation/protocol.hpp"

namespace rigidformer {

/// A scene of the given shapes, which rest beside each other.
inline SceneRecording resting_scene(const std::string& name, const std::vector<std::string>& shapes, int num_frames) {
  SceneRecording scene;
  scene.name = name;
  scene.num_frames = num_frames;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    RecordedObject object;
    object.shape = shapes[i];
    object.T_world_object.assign(num_frames, {Eigen::Quaterniond::Identity(), {static_cast<double>(i), 0.0, 0.5}});
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

/// A result whose object i is off by `errors[i]` at the only horizon, and whose scene error is `scene_error`.
inline SceneResult result_of(const std::string& model, const SceneRecording& scene, const PoseError& scene_error,
                             const std::vector<PoseError>& errors, int step = 10) {
  SceneResult result{model, "toys", 120, step, &scene, {scene_error}, {errors}, {}, {}};
  for (const RecordedObject& object : scene.objects) {
    result.predicted.push_back({object.T_world_object[0], object.T_world_object[0]});
  }
  return result;
}

}  // namespace rigidformer
