// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "rigidformer_ros/restarting_rollout.hpp"

namespace rigidformer {

/// A predictor of known physics for tests: every body falls freely and keeps its spin, and nothing touches anything.
/// For bodies that move like that its forecasts are exact, so that tests can compare them with formulas.
class BallisticPredictor : public Predictor {
 public:
  BallisticPredictor() {
    info_.id = "ballistic";
    info_.sha256 = "0123456789abcdef";
    info_.device = "cpu";
    info_.precision = "float32";
    info_.num_parameters = 0;
    info_.min_time_step_s = 1.0 / 240.0;
    info_.max_time_step_s = 10.0 / 240.0;
    info_.min_size_m = 0.1;
    info_.max_size_m = 3.0;
    info_.max_speed_mps = 30.0;
    info_.max_objects = 8;
    info_.max_points = 64;
  }

  void warm_up() override {}
  const ModelInfo& info() const override { return info_; }

  std::unique_ptr<Rollout> start(const std::vector<ObjectState>& objects, const RolloutOptions& rollout) override {
    return std::make_unique<RestartingRollout>(*this, objects, rollout);
  }

  Forecast predict(const std::vector<ObjectState>& objects, const RolloutOptions& rollout) override {
    Forecast forecast;
    for (int k = 0; k <= rollout.num_steps; ++k) {
      forecast.times_s.push_back(k * rollout.time_step_s);
    }
    for (const ObjectState& object : objects) {
      forecast.objects.push_back({object.id, ObjectTrajectory::Status::kOk, fly(object, rollout)});
    }
    return forecast;
  }

 private:
  static std::vector<RigidTransform> fly(const ObjectState& object, const RolloutOptions& rollout) {
    std::vector<RigidTransform> poses{object.T_world_current};
    RigidTransform before = object.T_world_previous;
    const double fall =
        object.mode == MotionMode::kDynamic ? rollout.gravity * rollout.time_step_s * rollout.time_step_s : 0.0;
    for (int k = 0; k < rollout.num_steps; ++k) {
      RigidTransform next = poses.back();
      if (object.mode != MotionMode::kStatic) {
        next.translation = 2.0 * poses.back().translation - before.translation + Eigen::Vector3d(0.0, 0.0, fall);
        next.rotation = (poses.back().rotation * before.rotation.conjugate() * poses.back().rotation).normalized();
      }
      before = poses.back();
      poses.push_back(next);
    }
    return poses;
  }

  ModelInfo info_;
};

}  // namespace rigidformer
