// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/ObjectClouds.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <sensor_msgs/PointCloud2.h>

#include <functional>
#include <string>
#include <vector>

#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

/// Subscriptions to topics that show the whole scene at once: a cloud with labels, and ObjectClouds.
class SceneTopics {
 public:
  /// The functions that take the messages. `topic` is the resolved name of the topic.
  struct Handlers {
    std::function<void(const std::string& topic, const sensor_msgs::PointCloud2& cloud)> labelled;
    std::function<void(const std::string& topic, const ObjectClouds& clouds)> scene;
  };

  /// Callbacks run on the callback queue of `node`.
  SceneTopics(ros::NodeHandle& node, const InputParameters& input, Handlers handlers);

  /// Names the topics that are read, for a message to the user. The text is empty when there is none.
  std::string describe() const;

 private:
  Handlers handlers_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace rigidformer_ros
