// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace rigidformer_ros {

/// One topic per object, for objects that come and go.
template <class Message>
class ObjectPublishers {
 public:
  using TopicOf = std::string (*)(const std::string& object_id);

  ObjectPublishers(const ros::NodeHandle& node, TopicOf topic_of) : node_(node), topic_of_(topic_of) {}

  /// Offers a topic for each of these objects and for no other.
  void set_objects(const std::vector<std::string>& ids) {
    std::map<std::string, ros::Publisher> current;
    for (const std::string& id : ids) {
      const auto known = publishers_.find(id);
      current[id] = known != publishers_.end() ? known->second : advertise(id);
    }
    publishers_ = std::move(current);  // the topics of the others end here
  }

  /// Makes and publishes the message of an object, if somebody listens. The object must have been set.
  void publish(const std::string& id, const std::function<Message()>& make_message) {
    const ros::Publisher& publisher = publishers_.at(id);
    if (publisher.getNumSubscribers() > 0) {
      publisher.publish(make_message());
    }
  }

 private:
  // A handle keeps a piece of memory for every topic that it ever offered: with one for all, objects that come and go
  // would fill the memory of a node that runs for days.
  ros::Publisher advertise(const std::string& id) const {
    return ros::NodeHandle(node_).advertise<Message>(topic_of_(id), 1);
  }

  ros::NodeHandle node_;
  TopicOf topic_of_;
  std::map<std::string, ros::Publisher> publishers_;  ///< By object id
};

}  // namespace rigidformer_ros
