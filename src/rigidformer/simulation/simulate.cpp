// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <stdexcept>

#include "rigidformer/simulation/bullet_world.hpp"

namespace rigidformer {
namespace {

const Shape& find_shape(const std::vector<Shape>& shapes, const std::string& name) {
  const auto found = std::find_if(shapes.begin(), shapes.end(), [&](const Shape& s) { return s.name == name; });
  if (found == shapes.end()) throw std::invalid_argument("shape '" + name + "' is not in the shape library");
  return *found;
}

BodyState state_at(const RecordedObject& object, std::size_t frame) {
  BodyState state;
  state.T_world_object = object.T_world_object[frame];
  if (frame < object.velocities.size()) state.velocity = object.velocities[frame];
  if (frame < object.angular_velocities.size()) state.angular_velocity = object.angular_velocities[frame];
  return state;
}

void append(RecordedObject& object, const BodyState& state) {
  object.T_world_object.push_back(state.T_world_object);
  object.velocities.push_back(state.velocity);
  object.angular_velocities.push_back(state.angular_velocity);
}

}  // namespace

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
  if (first_frame < 0) throw std::invalid_argument("first_frame = " + std::to_string(first_frame) + " must be >= 0");
  if (num_frames < 1) throw std::invalid_argument("num_frames = " + std::to_string(num_frames) + " must be >= 1");
  BulletWorld world = make_world(scene, shapes, settings);
  SceneRecording recording = scene;
  recording.num_frames = num_frames;
  recording.frame_rate_hz = settings.frame_rate_hz;
  recording.gravity = settings.gravity;
  for (RecordedObject& object : recording.objects) {
    object.T_world_object.clear();
    object.velocities.clear();
    object.angular_velocities.clear();
  }
  for (int frame = 0; frame < first_frame; ++frame) world.step_frame();
  for (int frame = 0; frame < num_frames; ++frame) {
    if (frame > 0) world.step_frame();
    for (int i = 0; i < world.num_bodies(); ++i) append(recording.objects[static_cast<std::size_t>(i)], world.state(i));
  }
  return recording;
}

}  // namespace rigidformer
