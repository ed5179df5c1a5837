// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <string>

#include "rigidformer_ros/parameters/parameters.hpp"
#include "rigidformer_ros/yaml_tree.hpp"

/// Turns text into YAML and into the tree that the parameter server would hand out: it must be accepted,
/// or refused with an explanation.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  XmlRpc::XmlRpcValue tree;
  try {
    tree = rigidformer_ros::testing::to_tree(YAML::Load(std::string(reinterpret_cast<const char*>(data), size)));
  } catch (const YAML::Exception&) {
    return 0;
  }
  try {
    rigidformer_ros::read_parameters(tree);
  } catch (const std::invalid_argument& error) {
    if (std::string(error.what()).find("parameter") == std::string::npos) __builtin_trap();
  }
  return 0;
}
