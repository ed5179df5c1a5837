// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

#include "rigidformer_ros/ballistic_predictor.hpp"

namespace rigidformer {

/// A predictor that fails in the way that the id of an object asks for. With "throws" there is no forecast. The poses
/// of "nan" are not finite from the third step on. With "slow" every call takes 50 ms, with "hangs" a second.
class FaultyPredictor : public BallisticPredictor {
 public:
  Forecast predict(const std::vector<ObjectState>& objects, const RolloutOptions& rollout) override {
    Forecast forecast = BallisticPredictor::predict(objects, rollout);
    for (ObjectTrajectory& object : forecast.objects) {
      if (object.id == "throws") {
        throw std::runtime_error("tensor trouble");
      }
      if (object.id == "slow" || object.id == "hangs") {
        std::this_thread::sleep_for(std::chrono::milliseconds(object.id == "slow" ? 50 : 1000));
      }
      for (std::size_t k = 3; k < object.poses.size() && object.id == "nan"; ++k) {
        object.poses[k].translation.x() = std::numeric_limits<double>::quiet_NaN();
      }
    }
    return forecast;
  }
};

}  // namespace rigidformer
