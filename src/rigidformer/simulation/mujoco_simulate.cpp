// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "rigidformer/simulation/mujoco_world.hpp"
#include "scene_recorder.hpp"

namespace rigidformer {

SceneRecording simulate(const SceneRecording& scene, const std::vector<Shape>& shapes, const MujocoSettings& settings,
                        int num_frames, int first_frame) {
  std::vector<MujocoBody> bodies;
  for (const RecordedObject& object : scene.objects) {
    bodies.push_back({find_shape(shapes, object.shape).parts, object.properties, state_at(object, 0)});
    for (ConvexPart& part : bodies.back().parts) part.vertices *= static_cast<float>(object.size);
  }
  MujocoWorld world(settings, bodies);
  SceneRecording recording = record(scene, world, settings, num_frames, first_frame);
  if (world.has_diverged()) throw std::runtime_error("mujoco: scene '" + scene.name + "' stopped being finite");
  return recording;
}

}  // namespace rigidformer
