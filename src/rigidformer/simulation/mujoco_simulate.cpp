// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <string>

#include "motion_path.hpp"
#include "rigidformer/simulation/mujoco_world.hpp"
#include "scene_recorder.hpp"

namespace rigidformer {

SceneRecording simulate(const SceneRecording& scene, const std::vector<Shape>& shapes, const MujocoSettings& settings,
                        int num_frames, int first_frame, const std::vector<MotionPath>& paths) {
  std::vector<MujocoBody> bodies;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const RecordedObject& object = scene.objects[i];
    bodies.push_back(
        {find_shape(shapes, object.shape).parts, object.properties, state_at(object, 0), object.is_static});
    for (ConvexPart& part : bodies.back().parts) part.vertices *= static_cast<float>(object.size);
    if (!object.is_driven) continue;
    if (i >= paths.size() || !paths[i]) {
      throw std::invalid_argument("mujoco: object " + std::to_string(i) + " of scene '" + scene.name + "' has no path");
    }
    bodies.back().path = started_after(paths[i], first_frame / settings.frame_rate_hz);
  }
  MujocoWorld world(settings, bodies);
  SceneRecording recording = record(scene, world, settings, num_frames, first_frame);
  if (world.has_diverged()) throw std::runtime_error("mujoco: scene '" + scene.name + "' stopped being finite");
  return recording;
}

}  // namespace rigidformer
