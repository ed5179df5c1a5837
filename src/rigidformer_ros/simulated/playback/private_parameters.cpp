// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/playback/private_parameters.hpp"

#include <sstream>
#include <stdexcept>

namespace rigidformer_ros::demo {

void PrivateParameters::finish() const {
  XmlRpc::XmlRpcValue tree;
  if (!node_.getParam("", tree) || tree.getType() != XmlRpc::XmlRpcValue::TypeStruct) return;
  for (const auto& member : tree) {
    if (known_.count(member.first) > 0) continue;
    std::string names;
    for (const std::string& name : known_) names += (names.empty() ? "" : ", ") + name;
    throw std::invalid_argument("parameter " + node_.resolveName(member.first) + ": unknown; known here: " + names);
  }
}

void PrivateParameters::fail(const std::string& name, const char* accepted) const {
  XmlRpc::XmlRpcValue given;
  node_.getParam(name, given);
  std::ostringstream text;
  given.write(text);
  throw std::invalid_argument("parameter " + node_.resolveName(name) + ": is " + text.str() + ", must be " + accepted);
}

}  // namespace rigidformer_ros::demo
