// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <set>
#include <string>
#include <vector>

namespace rigidformer_ros::demo {

/// Reads the private parameters of a program and remembers their names, so that others can be reported.
class PrivateParameters {
 public:
  explicit PrivateParameters(const ros::NodeHandle& private_node) : node_(private_node) {}

  /// Leaves `value` alone where the parameter is absent. Throws std::invalid_argument naming the parameter, what was
  /// read and the default, which has the right type.
  template <typename T>
  void read(const std::string& name, T& value) {
    known_.insert(name);
    if (node_.hasParam(name) && !node_.getParam(name, value)) fail(name, accepted_for(value));
  }

  /// Throws std::invalid_argument naming a parameter that nothing read, and those that exist.
  void finish() const;

 private:
  static const char* accepted_for(bool) { return "true or false"; }
  static const char* accepted_for(int) { return "an integer"; }
  static const char* accepted_for(double) { return "a number"; }
  static const char* accepted_for(const std::string&) { return "a text"; }
  static const char* accepted_for(const std::vector<double>&) { return "a list of numbers"; }

  [[noreturn]] void fail(const std::string& name, const char* accepted) const;

  ros::NodeHandle node_;
  std::set<std::string> known_;
};

}  // namespace rigidformer_ros::demo
