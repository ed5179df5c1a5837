// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "motion_path.hpp"
#include "scene_recorder.hpp"

namespace rigidformer {

BulletWorld make_world(const SceneRecording& scene, const std::vector<Shape>& shapes, const BulletSettings& settings,
                       int frame) {
  BulletWorld world(settings);
  for (const RecordedObject& object : scene.objects) {
    if (frame < 0 || static_cast<std::size_t>(frame) >= object.T_world_object.size()) {
      throw std::invalid_argument("scene '" + scene.name + "' has no frame " + std::to_string(frame));
    }
    const BodyState state = state_at(object, static_cast<std::size_t>(frame));
    const Shape& shape = find_shape(shapes, object.shape);
    if (!object.is_given()) {
      world.add_body(shape, object.size, object.properties, state);
      continue;
    }
    const int body = world.add_driven_body(shape, object.size, object.properties, state);
    if (object.is_static) world.follow(body, standing_at(state.T_world_object));
  }
  return world;
}

SceneRecording simulate(const SceneRecording& scene, const std::vector<Shape>& shapes, const BulletSettings& settings,
                        int num_frames, int first_frame, const std::vector<MotionPath>& paths) {
  BulletWorld world = make_world(scene, shapes, settings);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (paths[i]) world.follow(static_cast<int>(i), started_after(paths[i], first_frame / settings.frame_rate_hz));
  }
  return record(scene, world, settings, num_frames, first_frame);
}

}  // namespace rigidformer
