// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "rigidformer/windows/scene_tensors.hpp"

namespace rigidformer {

/// A moment in the motion of one object.
struct ContactEvent {
  std::int32_t scene = 0;
  std::int32_t frame = 0;
};

/// Moments of contact in all scenes by kind, found from the trajectories alone. Impacts are jumps of velocity that
/// gravity does not explain. Lasting contacts are listed every few frames.
struct ContactEvents {
  std::vector<ContactEvent>
      mid_air;  ///< Impact with the lowest point of the object well above the floor: object against object
  std::vector<ContactEvent> floor;    ///< Impact on the floor
  std::vector<ContactEvent> rolling;  ///< In motion on the floor without impact
  std::vector<ContactEvent> resting;  ///< Without motion, wherever the object lies
  std::vector<ContactEvent> driven;   ///< A driven body moves within reach of the object
};

/// Finds all moments of contact. `tensors` must be on the CPU.
ContactEvents find_contact_events(const SceneTensors& tensors);

}  // namespace rigidformer
