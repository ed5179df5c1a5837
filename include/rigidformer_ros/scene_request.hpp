// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/ObjectClouds.h>

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "rigidformer_ros/parameters.hpp"
#include "rigidformer_ros/track_store.hpp"

namespace rigidformer_ros {

/// A request that cannot be answered: one of the PredictRollout codes and a sentence naming the field at fault.
class RequestError : public std::runtime_error {
 public:
  RequestError(std::int32_t code, const std::string& message) : std::runtime_error(message), code_(code) {}
  std::int32_t code() const { return code_; }

 private:
  std::int32_t code_;
};

/// Transform from a frame into the fixed frame at an instant; throws TransformError.
using FrameLookup = std::function<RigidTransform(const std::string& frame_id, const ros::Time& stamp)>;

/// True when nothing in the message is filled.
bool is_empty(const ObjectClouds& clouds);

/// Throws RequestError when the arrays of `clouds` do not belong together or there is no object. `field` is its name in
/// messages.
void check_lengths(const ObjectClouds& clouds, const std::string& field);

/// Object `i` of a message whose arrays fit, in the fixed frame. Throws std::invalid_argument naming what is at fault.
ObjectObservation read_object(const ObjectClouds& clouds, std::size_t i, const NodeParameters& parameters,
                              const RigidTransform& T_fixed_cloud);

/// Checks a scene in a request and brings it into the fixed frame. `field` is its name in the request.
/// Throws RequestError.
std::vector<ObjectObservation> read_scene(const ObjectClouds& clouds, const std::string& field,
                                          const NodeParameters& parameters, const FrameLookup& T_fixed_from);

/// Tracks of a scene given in a request and, if `previous` is filled, of what was seen before it. Throws RequestError
/// when the two do not belong together.
TrackStore track_scenes(const ObjectClouds& scene, const ObjectClouds& previous, const NodeParameters& parameters,
                        const FrameLookup& T_fixed_from);

}  // namespace rigidformer_ros
