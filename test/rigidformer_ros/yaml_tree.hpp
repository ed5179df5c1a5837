// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <string>

namespace rigidformer_ros::testing {

/// Gives a YAML scalar the type that the parameter server would give it. Text in quotes stays text.
inline XmlRpc::XmlRpcValue to_scalar(const YAML::Node& node) {
  int integer = 0;
  double number = 0.0;
  bool flag = false;
  const bool quoted = node.Tag() == "!";
  if (!quoted && YAML::convert<int>::decode(node, integer)) {
    return XmlRpc::XmlRpcValue(integer);
  }
  if (!quoted && YAML::convert<double>::decode(node, number)) {
    return XmlRpc::XmlRpcValue(number);
  }
  if (!quoted && YAML::convert<bool>::decode(node, flag)) {
    return XmlRpc::XmlRpcValue(flag);
  }
  return XmlRpc::XmlRpcValue(node.Scalar());
}

/// Turns a YAML file into the tree of values that the parameter server makes of it.
inline XmlRpc::XmlRpcValue to_tree(const YAML::Node& node) {
  XmlRpc::XmlRpcValue value;
  if (node.IsMap()) {
    for (const auto& member : node) {
      value[member.first.as<std::string>()] = to_tree(member.second);
    }
  } else if (node.IsSequence()) {
    value.setSize(0);
    for (std::size_t i = 0; i < node.size(); ++i) {
      value[static_cast<int>(i)] = to_tree(node[i]);
    }
  } else {
    value = to_scalar(node);
  }
  return value;
}

}  // namespace rigidformer_ros::testing
