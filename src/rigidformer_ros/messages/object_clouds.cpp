// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/messages/object_clouds.hpp"

#include <stdexcept>

#include "rigidformer_ros/messages/conversions.hpp"

namespace rigidformer_ros {

namespace {

void require_length(const std::string& field, const char* member, std::size_t length, std::size_t expected,
                    bool may_be_empty) {
  if (length != expected && !(may_be_empty && length == 0)) {
    throw std::invalid_argument(field + "." + member + ": has " + std::to_string(length) + " entries, " + field +
                                ".ids has " + std::to_string(expected));
  }
}

}  // namespace

bool is_empty(const ObjectClouds& clouds) {
  return clouds.ids.empty() && clouds.modes.empty() && clouds.clouds.empty() && clouds.poses.empty() &&
         clouds.properties.empty();
}

void check_lengths(const ObjectClouds& clouds, const std::string& field) {
  const std::size_t count = clouds.ids.size();
  if (count == 0) {
    throw std::invalid_argument(field + ".ids: is empty although other fields of " + field + " are filled");
  }
  require_length(field, "clouds", clouds.clouds.size(), count, false);
  require_length(field, "modes", clouds.modes.size(), count, true);
  require_length(field, "poses", clouds.poses.size(), count, true);
  require_length(field, "properties", clouds.properties.size(), count, true);
}

rigidformer::ObjectObservation read_object(const ObjectClouds& clouds, std::size_t i, const PointLimit& limit,
                                           const rigidformer::RigidTransform& T_fixed_cloud) {
  rigidformer::ObjectObservation object;
  object.id = clouds.ids[i];
  object.stamp = to_stamp(clouds.header.stamp);
  object.points_world = T_fixed_cloud.apply(read_points(clouds.clouds[i], limit));
  if (!clouds.modes.empty()) {
    object.mode = to_motion_mode(clouds.modes[i]);
  }
  if (!clouds.poses.empty()) {
    object.T_world_object = T_fixed_cloud * to_transform(clouds.poses[i]);
  }
  if (!clouds.properties.empty()) {
    object.properties = to_properties(clouds.properties[i]);
  }
  return object;
}

}  // namespace rigidformer_ros
