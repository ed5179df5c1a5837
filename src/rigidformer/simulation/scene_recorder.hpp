// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "rigidformer/simulation/bullet_world.hpp"

namespace rigidformer {

inline const Shape& find_shape(const std::vector<Shape>& shapes, const std::string& name) {
  const auto found = std::find_if(shapes.begin(), shapes.end(), [&](const Shape& s) { return s.name == name; });
  if (found == shapes.end()) throw std::invalid_argument("shape '" + name + "' is not in the shape library");
  return *found;
}

/// State of an object at a frame of its recording. Velocities that are not recorded count as zero.
inline BodyState state_at(const RecordedObject& object, std::size_t frame) {
  BodyState state;
  state.T_world_object = object.T_world_object.at(frame);
  if (frame < object.velocities.size()) state.velocity = object.velocities[frame];
  if (frame < object.angular_velocities.size()) state.angular_velocity = object.angular_velocities[frame];
  return state;
}

/// Runs a world made of `scene` and returns the scene with `num_frames` frames of poses and velocities, the first of
/// them `first_frame` frames after the start. Worlds and settings of both engines have the same members.
template <typename World, typename Settings>
SceneRecording record(const SceneRecording& scene, World& world, const Settings& settings, int num_frames,
                      int first_frame) {
  if (first_frame < 0) throw std::invalid_argument("first_frame = " + std::to_string(first_frame) + " must be >= 0");
  if (num_frames < 1) throw std::invalid_argument("num_frames = " + std::to_string(num_frames) + " must be >= 1");
  SceneRecording recording = scene;
  recording.num_frames = num_frames;
  recording.frame_rate_hz = settings.frame_rate_hz;
  recording.gravity = settings.gravity;
  recording.ground = {settings.floor_friction, settings.floor_restitution};
  for (RecordedObject& object : recording.objects) {
    object.T_world_object.clear();
    object.velocities.clear();
    object.angular_velocities.clear();
  }
  for (int frame = 0; frame < first_frame; ++frame) world.step_frame();
  for (int frame = 0; frame < num_frames; ++frame) {
    if (frame > 0) world.step_frame();
    for (std::size_t i = 0; i < recording.objects.size(); ++i) {
      const BodyState state = world.state(static_cast<int>(i));
      recording.objects[i].T_world_object.push_back(state.T_world_object);
      recording.objects[i].velocities.push_back(state.velocity);
      recording.objects[i].angular_velocities.push_back(state.angular_velocity);
    }
  }
  return recording;
}

}  // namespace rigidformer
