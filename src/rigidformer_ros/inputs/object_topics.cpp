// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/inputs/object_topics.hpp"

#include <ros/console.h>
#include <ros/master.h>
#include <ros/this_node.h>

#include <utility>

#include "rigidformer_ros/parameters/wildcard.hpp"

namespace rigidformer_ros {

namespace {

// A node handle cannot resolve a pattern, because '*' is no legal character of a ROS name.
std::string resolve_pattern(const ros::NodeHandle& node, const std::string& pattern) {
  if (pattern.empty() || pattern.front() == '/') {
    return pattern;
  }
  const std::string& ns = node.getNamespace();
  return ns.back() == '/' ? ns + pattern : ns + "/" + pattern;
}

// Lists the published topics; the list is empty while the ROS master is away. ros::master::getTopics() would wait for
// the master, and the clouds of known objects would wait too.
ros::master::V_TopicInfo published_topics() {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue list;
  request[0] = ros::this_node::getName();
  request[1] = "";  // Topics of every namespace are wanted.
  ros::master::V_TopicInfo topics;
  if (!ros::master::execute("getPublishedTopics", request, response, list, /*wait_for_master=*/false)) {
    return topics;
  }
  for (int i = 0; i < list.size(); ++i) {
    topics.emplace_back(static_cast<std::string&>(list[i][0]), static_cast<std::string&>(list[i][1]));
  }
  return topics;
}

}  // namespace

ObjectTopics::ObjectTopics(ros::NodeHandle& node, const InputParameters& input, Handler handler)
    : node_(node), input_(input), pattern_(resolve_pattern(node, input.object_topics)), handler_(std::move(handler)) {
  for (const ListedObject& object : input_.objects) {
    subscribe(object);
  }
  if (!pattern_.empty()) {
    discover();
    discovery_timer_ = node_.createWallTimer(ros::WallDuration(input_.discovery_period),
                                             [this](const ros::WallTimerEvent&) { discover(); });
  }
}

void ObjectTopics::subscribe(const ListedObject& source) {
  ids_.insert(source.id);
  ListedObject resolved = source;
  resolved.topic = node_.resolveName(source.topic);
  const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> callback =
      [this, resolved](const sensor_msgs::PointCloud2ConstPtr& cloud) { handler_(resolved, *cloud); };
  subscribers_[resolved.topic] = node_.subscribe<sensor_msgs::PointCloud2>(
      resolved.topic, static_cast<std::uint32_t>(input_.queue_size), callback);
  ROS_INFO_STREAM("Object '" << resolved.id << "' is read from " << resolved.topic);
}

// A topic that nobody publishes any more is forgotten, unless it is listed: its object may come back under another. An
// empty list says that the master is away.
void ObjectTopics::forget_silent(const std::set<std::string>& published) {
  for (auto it = discovered_.begin(); it != discovered_.end();) {
    if (published.empty() || published.count(it->first) > 0) {
      ++it;
      continue;
    }
    subscribers_.erase(it->first);
    ids_.erase(it->second);
    it = discovered_.erase(it);
  }
}

void ObjectTopics::discover() {
  std::set<std::string> published;
  for (const ros::master::TopicInfo& topic : published_topics()) {
    published.insert(topic.name);
    const auto id = match_topic(pattern_, topic.name);
    if (id && topic.datatype == "sensor_msgs/PointCloud2" && ids_.count(*id) == 0 &&
        subscribers_.count(topic.name) == 0) {
      subscribe({*id, topic.name, rigidformer::MotionMode::kDynamic, {}});
      discovered_[topic.name] = *id;
    }
  }
  forget_silent(published);
}

std::string ObjectTopics::describe() const {
  std::string text;
  for (const auto& [topic, subscriber] : subscribers_) {
    text += (text.empty() ? "" : ", ") + topic + (subscriber.getNumPublishers() > 0 ? "" : " (nobody publishes it)");
  }
  if (!pattern_.empty()) {
    text += (text.empty() ? "" : ", ") + ("topics that match " + pattern_);
  }
  return text.empty() ? "no topics (input/objects and input/object_topics are empty)" : text;
}

}  // namespace rigidformer_ros
