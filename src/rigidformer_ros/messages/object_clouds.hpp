// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/ObjectClouds.h>

#include <cstddef>
#include <string>

#include "rigidformer/tracking/observation.hpp"
#include "rigidformer_ros/messages/cloud_conversion.hpp"

namespace rigidformer_ros {

/// Tells whether all arrays of the message are empty.
bool is_empty(const ObjectClouds& clouds);

/// Throws std::invalid_argument when the arrays of `clouds` have lengths that do not fit together, or when there is no
/// object. `field` is what the text of the error calls the message.
void check_lengths(const ObjectClouds& clouds, const std::string& field);

/// Reads object `i` of a message that check_lengths() accepts, and moves it into the fixed frame. The object has the
/// properties that the message gives and no others. Throws std::invalid_argument naming what is at fault, also for more
/// finite points than `limit`.
rigidformer::ObjectObservation read_object(const ObjectClouds& clouds, std::size_t i, const PointLimit& limit,
                                           const rigidformer::RigidTransform& T_fixed_cloud);

}  // namespace rigidformer_ros
