// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/ObjectClouds.h>

#include <functional>
#include <string>
#include <vector>

#include "rigidformer/tracking/track_store.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

using rigidformer::ObjectObservation;
using rigidformer::RigidTransform;
using rigidformer::TrackStore;

/// Transform from a frame into the fixed frame at an instant; throws TransformError.
using FrameLookup = std::function<RigidTransform(const std::string& frame_id, const ros::Time& stamp)>;

/// Checks a scene in a request and brings it into the fixed frame. `field` is its name in the request.
/// Throws RequestError (services/request_error.hpp).
std::vector<ObjectObservation> read_scene(const ObjectClouds& clouds, const std::string& field,
                                          const NodeParameters& parameters, const FrameLookup& T_fixed_from);

/// Tracks of a scene given in a request and of what was seen before it, null = nothing. Throws RequestError when the
/// two do not belong together.
TrackStore track_scenes(const ObjectClouds& scene, const ObjectClouds* previous, const NodeParameters& parameters,
                        const FrameLookup& T_fixed_from);

}  // namespace rigidformer_ros
