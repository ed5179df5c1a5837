// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "scene_recorder.hpp"

namespace rigidformer {

BulletWorld make_world(const SceneRecording& scene, const std::vector<Shape>& shapes, const BulletSettings& settings,
                       int frame) {
  BulletWorld world(settings);
  for (const RecordedObject& object : scene.objects) {
    if (frame < 0 || static_cast<std::size_t>(frame) >= object.T_world_object.size()) {
      throw std::invalid_argument("scene '" + scene.name + "' has no frame " + std::to_string(frame));
    }
    world.add_body(find_shape(shapes, object.shape), object.size, object.properties,
                   state_at(object, static_cast<std::size_t>(frame)));
  }
  return world;
}

SceneRecording simulate(const SceneRecording& scene, const std::vector<Shape>& shapes, const BulletSettings& settings,
                        int num_frames, int first_frame) {
  BulletWorld world = make_world(scene, shapes, settings);
  return record(scene, world, settings, num_frames, first_frame);
}

}  // namespace rigidformer
