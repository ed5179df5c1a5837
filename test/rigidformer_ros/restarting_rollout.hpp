// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/predictor.hpp"

namespace rigidformer {

/// A rollout for the predictors of the tests, which only know how to predict from two poses: every advance() is a new
/// prediction from the last two poses of the previous one.
class RestartingRollout : public Rollout {
 public:
  RestartingRollout(Predictor& predictor, std::vector<ObjectState> objects, const RolloutOptions& rollout)
      : predictor_(predictor), objects_(std::move(objects)), options_(rollout) {
    forecast_.times_s.push_back(0.0);
    for (const ObjectState& object : objects_) {
      forecast_.objects.push_back({object.id, ObjectTrajectory::Status::kOk, {object.T_world_current}});
    }
  }

  const Forecast& advance(int num_steps) override {
    options_.num_steps = num_steps;
    const Forecast part = predictor_.predict(objects_, options_);
    for (int k = 0; k < num_steps; ++k) {
      forecast_.times_s.push_back(static_cast<double>(forecast_.times_s.size()) * options_.time_step_s);
    }
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      if (part.objects[i].status == ObjectTrajectory::Status::kUnusable) {
        forecast_.objects[i].status = part.objects[i].status;
        forecast_.objects[i].reason = part.objects[i].reason;
      }
      const std::vector<RigidTransform>& poses = part.objects[i].poses;
      std::vector<RigidTransform>& all = forecast_.objects[i].poses;
      all.insert(all.end(), poses.begin() + 1, poses.end());
      objects_[i].T_world_previous = all[all.size() - 2];
      objects_[i].T_world_current = all.back();
    }
    return forecast_;
  }

 private:
  Predictor& predictor_;
  std::vector<ObjectState> objects_;
  RolloutOptions options_;
  Forecast forecast_;
};

}  // namespace rigidformer
