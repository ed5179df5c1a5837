// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "rigidformer/windows/scene_tensors.hpp"

namespace rigidformer {

/// A moment at which an object's velocity changes abruptly.
struct ContactEvent {
  std::int32_t scene = 0;
  std::int32_t frame = 0;
};

/// Contacts of all scenes by kind, found from the trajectories alone: jumps of velocity that gravity does not explain.
struct ContactEvents {
  std::vector<ContactEvent> mid_air;  ///< Lowest point of the object well above the floor: object against object
  std::vector<ContactEvent> floor;
};

/// `tensors` must be on the CPU.
ContactEvents find_contact_events(const SceneTensors& tensors);

}  // namespace rigidformer
