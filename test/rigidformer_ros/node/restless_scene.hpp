// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "rigidformer_ros/node/node_client.hpp"

namespace rigidformer_ros::testing {

/// A scene of objects that appear, fly, change their number of points and vanish. Its camera sometimes sends nonsense.
/// The same seed gives the same clouds.
class RestlessScene {
 public:
  explicit RestlessScene(unsigned seed) : random_(seed) {}

  /// The cloud of one object at one instant.
  struct Cloud {
    std::string id;
    sensor_msgs::PointCloud2 message;
    bool usable = true;  ///< False for a cloud that the node has to refuse
  };

  /// The clouds of all objects at one instant. Instants must be asked for in order.
  std::vector<Cloud> clouds_at(const ros::Time& stamp) {
    come_and_go(stamp);
    std::vector<Cloud> clouds;
    for (auto& [id, object] : objects_) {
      if (chance(0.02)) {
        object.points = blob(integer(16, 400), static_cast<unsigned>(integer(0, 1000)));
      }
      const Points points = object.flight.pose((stamp - object.since).toSec()).apply(object.points);
      clouds.push_back({id, stamped_cloud(points, stamp)});
      if (chance(0.03)) {
        damage(clouds.back());
      }
    }
    return clouds;
  }

  /// Removes all objects, as is needed when time restarts.
  void restart() { objects_.clear(); }

 private:
  // Most objects at once; chosen by eye. BallisticPredictor takes 8.
  static constexpr int kMaxObjects = 6;

  struct Object {
    ros::Time since;
    Flight flight;
    Points points;
  };

  bool chance(double probability) { return std::bernoulli_distribution(probability)(random_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  void come_and_go(const ros::Time& stamp) {
    if (objects_.empty() || chance(0.1)) {
      const std::string id = "soak_" + std::to_string(integer(1, kMaxObjects));
      Object object;
      object.since = stamp;
      object.flight.start = {2.0 * integer(-3, 3), 2.0 * integer(-3, 3), 5.0};
      object.points = blob(integer(16, 400), static_cast<unsigned>(integer(0, 1000)));
      objects_.insert_or_assign(id, object);
    }
    if (objects_.size() > 1 && chance(0.08)) {
      objects_.erase(std::next(objects_.begin(), integer(0, static_cast<int>(objects_.size()) - 1)));
    }
  }

  void damage(Cloud& cloud) {
    sensor_msgs::PointCloud2& message = cloud.message;
    cloud.usable = false;
    switch (integer(0, 3)) {
      case 0:
        message.width = 0xffffffff;
        break;
      case 1:
        message.data.pop_back();
        break;
      case 2:
        message.header.frame_id = "";
        break;
      default: {
        const float nan = std::numeric_limits<float>::quiet_NaN();
        for (std::size_t i = 0; i + 4 <= message.data.size(); i += 4) {
          std::memcpy(message.data.data() + i, &nan, 4);
        }
      }
    }
  }

  std::mt19937 random_;
  std::map<std::string, Object> objects_;
};

}  // namespace rigidformer_ros::testing
