// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/messages/names.hpp"

#include <cctype>

namespace rigidformer_ros::names {

namespace {

std::string as_segment(const std::string& object_id) {
  std::string segment = object_id;
  for (char& c : segment) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) {
      c = '_';
    }
  }
  return segment;
}

}  // namespace

std::string predicted_points(const std::string& object_id) { return "predicted/" + as_segment(object_id) + "/points"; }

std::string path(const std::string& object_id) { return "paths/" + as_segment(object_id); }

}  // namespace rigidformer_ros::names
