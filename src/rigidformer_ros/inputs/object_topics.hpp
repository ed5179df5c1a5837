// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>
#include <sensor_msgs/PointCloud2.h>

#include <functional>
#include <map>
#include <set>
#include <string>

#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

/// Subscriptions to one PointCloud2 topic per object. Listed topics are subscribed to from the start, topics that match
/// the pattern as soon as somebody publishes them.
class ObjectTopics {
 public:
  /// A function that takes a cloud. `source` says which object the cloud shows; its topic is the resolved name.
  using Handler = std::function<void(const ListedObject& source, const sensor_msgs::PointCloud2& cloud)>;

  /// Callbacks run on the callback queue of `node`.
  ObjectTopics(ros::NodeHandle& node, const InputParameters& input, Handler handler);

  /// Names the topics that are read, for a message to the user.
  std::string describe() const;

 private:
  void subscribe(const ListedObject& source);
  void discover();
  void forget_silent(const std::set<std::string>& published);

  ros::NodeHandle node_;
  InputParameters input_;
  std::string pattern_;  ///< The resolved pattern; empty = no search for new topics
  Handler handler_;
  std::map<std::string, ros::Subscriber> subscribers_;  ///< Subscriptions by resolved topic
  std::map<std::string, std::string> discovered_;       ///< Topics found while running, with the id of the object
  std::set<std::string> ids_;                           ///< Objects with a topic; no second topic is taken for them
  ros::WallTimer discovery_timer_;
};

}  // namespace rigidformer_ros
