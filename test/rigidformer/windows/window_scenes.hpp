// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "rigidformer/evaluation/flying_cubes.hpp"
#include "rigidformer/windows/scene_tensors.hpp"

namespace rigidformer {

/// Cubes of size 1 ... num_objects in free flight; scene s holds `counts[s]` of them.
inline SceneArchive flying_cubes_archive(const std::vector<int>& counts, int num_frames) {
  SceneArchive archive;
  archive.set = "flying_cubes";
  archive.shapes = {unit_cube()};
  for (const int count : counts) archive.scenes.push_back(flying_cubes(count, num_frames));
  return archive;
}

/// One cube of size 1 on a given path, without spin.
inline SceneRecording moving_cube(int num_frames, const std::function<Eigen::Vector3d(double)>& position_at) {
  SceneRecording scene;
  scene.name = "moving_cube";
  scene.num_frames = num_frames;
  RecordedObject object;
  object.shape = "cube";
  for (int frame = 0; frame < num_frames; ++frame) {
    object.T_world_object.push_back({Eigen::Quaterniond::Identity(), position_at(frame / scene.frame_rate_hz)});
  }
  scene.objects = {object};
  return scene;
}

}  // namespace rigidformer
