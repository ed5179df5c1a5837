// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/ObjectClouds.h>

#include <cstddef>
#include <string>

#include "rigidformer/tracking/observation.hpp"
#include "rigidformer_ros/messages/cloud_conversion.hpp"

namespace rigidformer_ros {

/// True when nothing in the message is filled.
bool is_empty(const ObjectClouds& clouds);

/// Throws std::invalid_argument when the arrays of `clouds` do not belong together or there is no object. `field` is
/// the message's name in texts.
void check_lengths(const ObjectClouds& clouds, const std::string& field);

/// Object `i` of a message whose arrays fit, in the fixed frame, with at most `limit` points and the properties
/// that the message gives. Throws std::invalid_argument naming what is at fault.
rigidformer::ObjectObservation read_object(const ObjectClouds& clouds, std::size_t i, const PointLimit& limit,
                                           const rigidformer::RigidTransform& T_fixed_cloud);

}  // namespace rigidformer_ros
