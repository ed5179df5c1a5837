// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "rigidformer/data/scene_archive.hpp"

namespace rigidformer {

/// A unit cube as one convex part, with triangles that face outwards.
inline Shape unit_cube() {
  ConvexPart part;
  part.vertices.resize(8, 3);
  for (int v = 0; v < 8; ++v) {
    part.vertices.row(v) << (v & 1 ? 0.5F : -0.5F), (v & 2 ? 0.5F : -0.5F), (v & 4 ? 0.5F : -0.5F);
  }
  part.triangles.resize(12, 3);
  part.triangles << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5,
      3, 7, 5;
  return {"cube", 1.0, {part}};
}

/// Cubes that fly freely: object i starts at x = 3 i with speed i m/s along x, goes up at 3 m/s and spins about z.
inline SceneRecording flying_cubes(int num_objects, int num_frames) {
  SceneRecording scene;
  scene.name = "flying_cubes";
  scene.num_frames = num_frames;
  for (int i = 0; i < num_objects; ++i) {
    RecordedObject object;
    object.shape = "cube";
    object.size = 1.0 + i;
    object.properties = {2.0, 0.4, 0.6};
    for (int frame = 0; frame < num_frames; ++frame) {
      const double t = frame / scene.frame_rate_hz;
      const Eigen::Quaterniond rotation(Eigen::AngleAxisd(2.0 * t, Eigen::Vector3d::UnitZ()));
      object.T_world_object.push_back({rotation, {3.0 * i + i * t, 0.0, 5.0 + 3.0 * t - 5.0 * t * t}});
    }
    scene.objects.push_back(object);
  }
  return scene;
}

}  // namespace rigidformer
