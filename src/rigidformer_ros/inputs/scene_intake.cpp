// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/inputs/scene_intake.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "rigidformer_ros/inputs/frame_transformer.hpp"
#include "rigidformer_ros/messages/cloud_conversion.hpp"
#include "rigidformer_ros/messages/conversions.hpp"
#include "rigidformer_ros/messages/labelled_cloud.hpp"
#include "rigidformer_ros/messages/object_clouds.hpp"

namespace rigidformer_ros {

namespace {

using rigidformer::MotionMode;

void check_count(const Points& points, int max_points) {
  if (points.rows() > max_points) {
    throw std::invalid_argument("has " + std::to_string(points.rows()) + " points, accepted are at most " +
                                std::to_string(max_points));
  }
}

}  // namespace

SceneIntake::SceneIntake(const NodeParameters& parameters, PatientFrameLookup T_fixed_from, const Sinks& sinks)
    : parameters_(parameters), T_fixed_from_(std::move(T_fixed_from)), sinks_(sinks) {}

// All work on a message runs in here: an exception that leaves a subscriber callback would end the node.
void SceneIntake::guard(const std::string& source, const std::function<void()>& work) {
  try {
    work();
  } catch (const std::invalid_argument& error) {
    sinks_.rejections.add("malformed cloud", source + ": " + error.what());
  } catch (const TransformError& error) {
    sinks_.rejections.add(kNoTransform, source + ": " + error.what());
  } catch (const std::exception& error) {
    sinks_.rejections.add("failed cloud", source + ": " + error.what());
  }
}

// All transforms of one message share one wait: a scene full of lost objects must not hold up the next cloud.
RigidTransform SceneIntake::look_up(const std::string& frame_id, const ros::Time& stamp,
                                    const ros::WallTime& deadline) const {
  return T_fixed_from_(frame_id, stamp, std::max(0.0, (deadline - ros::WallTime::now()).toSec()));
}

void SceneIntake::take_object(const ListedObject& source, const sensor_msgs::PointCloud2& cloud) {
  sinks_.monitor.received(source.topic, cloud.header.seq);
  guard(source.topic, [&] {
    if (!sinks_.scene.accepts(source.id, cloud.header.stamp, ros::Time::now())) {
      return;
    }
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(parameters_.tf_timeout);
    add(to_observation(source, cloud, deadline), deadline);
  });
}

ObjectObservation SceneIntake::to_observation(const ListedObject& source, const sensor_msgs::PointCloud2& cloud,
                                              const ros::WallTime& deadline) {
  const StageTimer timer(sinks_.timing, Stage::kPreprocess);
  const Points points = read_points(cloud, static_cast<std::uint64_t>(parameters_.input.max_points));
  ObjectObservation observation;
  observation.id = source.id;
  observation.stamp = to_stamp(cloud.header.stamp);
  observation.points_world = look_up(cloud.header.frame_id, cloud.header.stamp, deadline).apply(points);
  observation.mode = source.mode;
  observation.properties = resolve_properties(parameters_.properties, source.id, source.properties);
  return observation;
}

void SceneIntake::take_labelled(const std::string& topic, const sensor_msgs::PointCloud2& cloud) {
  sinks_.monitor.received(topic, cloud.header.seq);
  guard(topic, [&] { read_labelled(topic, cloud); });
}

void SceneIntake::read_labelled(const std::string& topic, const sensor_msgs::PointCloud2& cloud) {
  if (!sinks_.scene.accepts(topic, cloud.header.stamp, ros::Time::now())) {
    return;
  }
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(parameters_.tf_timeout);
  const double start_s = steady_seconds();
  const auto parts = split_by_label(cloud, static_cast<std::uint64_t>(parameters_.input.max_cloud_points));
  const RigidTransform T_fixed_cloud = look_up(cloud.header.frame_id, cloud.header.stamp, deadline);
  sinks_.timing.add(Stage::kPreprocess, steady_seconds() - start_s);
  for (const LabelPoints& part : parts) {
    const NamedLabel object = meaning_of(part.label);
    guard(topic + " object '" + object.id + "'", [&] {
      check_count(part.points, parameters_.input.max_points);
      ObjectObservation observation;
      observation.id = object.id;
      observation.stamp = to_stamp(cloud.header.stamp);
      observation.points_world = T_fixed_cloud.apply(part.points);
      observation.mode = object.mode;
      observation.properties = resolve_properties(parameters_.properties, object.id, object.properties);
      add(std::move(observation), deadline);
    });
  }
}

NamedLabel SceneIntake::meaning_of(std::uint32_t label) const {
  for (const NamedLabel& named : parameters_.input.label_names) {
    if (named.label == label) {
      return named;
    }
  }
  return {label, "obj_" + std::to_string(label), MotionMode::kDynamic, {}};
}

void SceneIntake::take_scene(const std::string& topic, const ObjectClouds& clouds) {
  sinks_.monitor.received(topic, clouds.header.seq);
  guard(topic, [&] { read_scene(topic, clouds); });
}

void SceneIntake::read_scene(const std::string& topic, const ObjectClouds& clouds) {
  if (is_empty(clouds) || !sinks_.scene.accepts(topic, clouds.header.stamp, ros::Time::now())) {
    return;  // An empty message is no error: it says that nothing was seen.
  }
  check_lengths(clouds, topic);
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(parameters_.tf_timeout);
  const std::string& frame = clouds.header.frame_id;
  const RigidTransform T_fixed_cloud =
      look_up(frame.empty() ? parameters_.fixed_frame : frame, clouds.header.stamp, deadline);
  std::set<std::string> ids;
  for (std::size_t i = 0; i < clouds.ids.size(); ++i) {
    guard(topic + " object " + std::to_string(i) + " '" + clouds.ids[i] + "'", [&] {
      if (clouds.ids[i].empty() || !ids.insert(clouds.ids[i]).second) {
        throw std::invalid_argument("ids: is empty or occurs twice");
      }
      ObjectObservation observation =
          read_object(clouds, i, static_cast<std::uint64_t>(parameters_.input.max_points), T_fixed_cloud);
      resolve_properties(parameters_.properties, observation);
      add(std::move(observation), deadline);
    });
  }
}

void SceneIntake::add(ObjectObservation observation, const ros::WallTime& deadline) {
  const std::string& prefix = parameters_.input.pose_frame_prefix;
  if (!prefix.empty() && !observation.T_world_object && observation.mode == MotionMode::kStatic) {
    // A static object needs no tracker: the fixed frame can always be its frame.
    observation.T_world_object = RigidTransform();
  } else if (!prefix.empty() && !observation.T_world_object) {
    try {
      observation.T_world_object = look_up(prefix + observation.id, to_ros_time(observation.stamp), deadline);
    } catch (const TransformError& error) {
      sinks_.rejections.add("no pose", "'" + observation.id + "': " + error.what());
      return;
    }
  }
  const StageTimer timer(sinks_.timing, Stage::kRegistration);
  sinks_.scene.add(observation);
  sinks_.monitor.used(to_ros_time(observation.stamp));
}

}  // namespace rigidformer_ros
