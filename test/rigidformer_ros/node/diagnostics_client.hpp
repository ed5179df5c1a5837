// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>

#include <map>
#include <string>

namespace rigidformer_ros::testing {

/// Keeps what the node said last about each of its diagnostic tasks.
class DiagnosticsClient {
 public:
  DiagnosticsClient() {
    subscriber_ = node_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 10, [this](const diagnostic_msgs::DiagnosticArray::ConstPtr& message) {
          for (const diagnostic_msgs::DiagnosticStatus& status : message->status) {
            const std::string prefix = "prediction_node: ";
            if (status.name.compare(0, prefix.size(), prefix) == 0) {
              statuses_[status.name.substr(prefix.size())] = status;
            }
          }
        });
  }

  bool knows(const std::string& task) const { return statuses_.count(task) > 0; }
  int level(const std::string& task) const { return knows(task) ? statuses_.at(task).level : -1; }
  std::string message(const std::string& task) const { return knows(task) ? statuses_.at(task).message : ""; }

  /// The value of a task; the text is empty when there is no such value.
  std::string value(const std::string& task, const std::string& key) const {
    if (knows(task)) {
      for (const diagnostic_msgs::KeyValue& entry : statuses_.at(task).values) {
        if (entry.key == key) {
          return entry.value;
        }
      }
    }
    return "";
  }

  /// The value of a task as a number; it is -1 when there is no such value.
  int number(const std::string& task, const std::string& key) const {
    const std::string text = value(task, key);
    return text.empty() ? -1 : std::stoi(text);
  }

 private:
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  std::map<std::string, diagnostic_msgs::DiagnosticStatus> statuses_;
};

}  // namespace rigidformer_ros::testing
