// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/names.hpp"

#include <cctype>

namespace rigidformer_ros::names {

std::string predicted_points(const std::string& object_id) {
  std::string segment = object_id;
  for (char& c : segment) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) {
      c = '_';
    }
  }
  return "predicted/" + segment + "/points";
}

}  // namespace rigidformer_ros::names
