// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/inputs/scene_intake.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "rigidformer_ros/inputs/frame_transformer.hpp"
#include "rigidformer_ros/messages/cloud_conversion.hpp"
#include "rigidformer_ros/messages/conversions.hpp"
#include "rigidformer_ros/messages/invalid_points.hpp"
#include "rigidformer_ros/messages/labelled_cloud.hpp"
#include "rigidformer_ros/messages/near_origin.hpp"
#include "rigidformer_ros/messages/object_clouds.hpp"

namespace rigidformer_ros {

namespace {

using rigidformer::MotionMode;

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
  const Points points = read_measured(source.topic, cloud, max_points_per_object(parameters_.input));
  ObjectObservation observation;
  observation.id = source.id;
  observation.stamp = to_stamp(cloud.header.stamp);
  observation.points_world = look_up(cloud.header.frame_id, cloud.header.stamp, deadline).apply(points);
  observation.mode = source.mode;
  observation.properties = resolve_properties(parameters_.properties, source.id, source.properties);
  return observation;
}

// What the sensor measured: points that are none become NaN, and are counted.
Points SceneIntake::read_measured(const std::string& topic, const sensor_msgs::PointCloud2& cloud,
                                  const PointLimit& limit) {
  Points points = read_points(cloud, limit);
  if (parameters_.input.drop_invalid_points) {
    const bool simulated = parameters_.correspondence.method == rigidformer::Correspondence::kOrdered;
    const std::size_t num_masked =
        mask_invalid_points(points, simulated ? InvalidPoints::kAtOrigin : InvalidPoints::kAlsoRepeated);
    if (num_masked > 0) {
      sinks_.rejections.note("points that are none",
                             topic + ": " + std::to_string(num_masked) + " of " + std::to_string(points.rows()) +
                                 " points at 0 0 0 of the sensor or at one value that many share (" +
                                 "input/drop_invalid_points)");
    }
  }
  return points;
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
  const Points points = read_measured(topic, cloud, max_points_per_cloud(parameters_.input));
  const auto parts =
      split_by_label(cloud, points, {parameters_.input.label_field, parameters_.input.background_labels});
  const RigidTransform T_fixed_cloud = look_up(cloud.header.frame_id, cloud.header.stamp, deadline);
  sinks_.timing.add(Stage::kPreprocess, steady_seconds() - start_s);
  for (const LabelPoints& part : parts) {
    const NamedLabel object = meaning_of(part.label);
    guard(topic + " object '" + object.id + "'", [&] {
      require_few(part.points, max_points_per_object(parameters_.input));
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
      ObjectObservation observation = read_object(clouds, i, max_points_per_object(parameters_.input), T_fixed_cloud);
      resolve_properties(parameters_.properties, observation);
      add(std::move(observation), deadline);
    });
  }
}

void SceneIntake::note_delay(const ObjectObservation& observation) {
  const double age_s = rigidformer::seconds_between(observation.stamp, observation.arrival);
  if (age_s > parameters_.service.max_state_age) {
    std::ostringstream text;
    text << "'" << observation.id << "': " << age_s << " s old on arrival; predict_rollout answers STALE_STATE beyond "
         << "service/max_state_age = " << parameters_.service.max_state_age
         << " s, and clouds older than max_stamp_skew = " << parameters_.max_stamp_skew << " s are rejected";
    sinks_.rejections.note("late clouds", text.str());
  }
}

void SceneIntake::add(ObjectObservation observation, const ros::WallTime& deadline) {
  require_near_origin(observation.points_world, parameters_.fixed_frame);
  observation.arrival = to_stamp(ros::Time::now());
  note_delay(observation);
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
