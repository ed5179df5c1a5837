// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/ObjectClouds.h>
#include <ros/time.h>
#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <functional>
#include <string>

#include "rigidformer_ros/health/input_monitor.hpp"
#include "rigidformer_ros/health/rejection_log.hpp"
#include "rigidformer_ros/health/timing_monitor.hpp"
#include "rigidformer_ros/inputs/live_scene.hpp"
#include "rigidformer_ros/messages/cloud_conversion.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

using rigidformer::ObjectObservation;
using rigidformer::RigidTransform;

/// A function that gives the transform from a frame into the fixed frame at an instant. It waits for the transform up
/// to `timeout_s` seconds and then throws TransformError.
using PatientFrameLookup =
    std::function<RigidTransform(const std::string& frame_id, const ros::Time& stamp, double timeout_s)>;

/// Brings every cloud into the live scene, whatever topic it came on: checks its stamp, reads its points, moves them
/// into the fixed frame and adds material and pose. A cloud that cannot be used is counted by reason; nothing is
/// thrown. `topic` is the name of the source in messages to the user.
class SceneIntake {
 public:
  /// The objects that the intake feeds. All of them must outlive it.
  struct Sinks {
    LiveScene& scene;
    RejectionLog& rejections;
    InputMonitor& monitor;
    TimingMonitor& timing;
  };

  SceneIntake(const NodeParameters& parameters, PatientFrameLookup T_fixed_from, const Sinks& sinks);

  /// Takes the cloud of one object.
  void take_object(const ListedObject& source, const sensor_msgs::PointCloud2& cloud);

  /// Takes a cloud of the whole scene with a label per point. An object that cannot be used does not hinder the others.
  void take_labelled(const std::string& topic, const sensor_msgs::PointCloud2& cloud);

  /// Takes the whole scene as ObjectClouds. An object that cannot be used does not hinder the others.
  void take_scene(const std::string& topic, const ObjectClouds& clouds);

 private:
  Points read_measured(const std::string& topic, const sensor_msgs::PointCloud2& cloud, const PointLimit& limit);
  void note_delay(const ObjectObservation& observation);
  void guard(const std::string& source, const std::function<void()>& work);
  ObjectObservation to_observation(const ListedObject& source, const sensor_msgs::PointCloud2& cloud,
                                   const ros::WallTime& deadline);
  void read_labelled(const std::string& topic, const sensor_msgs::PointCloud2& cloud);
  void read_scene(const std::string& topic, const ObjectClouds& clouds);
  NamedLabel meaning_of(std::uint32_t label) const;
  RigidTransform look_up(const std::string& frame_id, const ros::Time& stamp, const ros::WallTime& deadline) const;
  void add(ObjectObservation observation, const ros::WallTime& deadline);

  NodeParameters parameters_;
  PatientFrameLookup T_fixed_from_;
  Sinks sinks_;
};

}  // namespace rigidformer_ros
