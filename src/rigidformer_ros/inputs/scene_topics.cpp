// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/inputs/scene_topics.hpp"

#include <ros/console.h>

#include <cstdint>
#include <utility>

namespace rigidformer_ros {

namespace {

template <typename Message, typename Handler>
ros::Subscriber subscribe(ros::NodeHandle& node, const std::string& name, int queue_size, const Handler& handler) {
  const std::string topic = node.resolveName(name);
  const boost::function<void(const boost::shared_ptr<const Message>&)> callback =
      [topic, &handler](const boost::shared_ptr<const Message>& message) { handler(topic, *message); };
  ROS_INFO_STREAM("The whole scene is read from " << topic);
  return node.subscribe<Message>(topic, static_cast<std::uint32_t>(queue_size), callback);
}

}  // namespace

SceneTopics::SceneTopics(ros::NodeHandle& node, const InputParameters& input, Handlers handlers)
    : handlers_(std::move(handlers)) {
  if (!input.cloud.empty()) {
    subscribers_.push_back(
        subscribe<sensor_msgs::PointCloud2>(node, input.cloud, input.queue_size, handlers_.labelled));
  }
  if (!input.object_clouds.empty()) {
    subscribers_.push_back(subscribe<ObjectClouds>(node, input.object_clouds, input.queue_size, handlers_.scene));
  }
}

std::string SceneTopics::describe() const {
  std::string text;
  for (const ros::Subscriber& subscriber : subscribers_) {
    text += (text.empty() ? "" : ", ") + subscriber.getTopic() +
            (subscriber.getNumPublishers() > 0 ? "" : " (nobody publishes it)");
  }
  return text;
}

}  // namespace rigidformer_ros
