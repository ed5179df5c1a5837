// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a RolloutWorld writes down of its steps.
#include "rigidformer/rollout_world.hpp"

namespace rigidformer {
namespace {

bool is_finite(const RigidTransform& T) { return T.translation.allFinite() && T.rotation.coeffs().allFinite(); }

}  // namespace

void RolloutWorld::record(SceneState& next) {
  const std::vector<RigidTransform> T_world = to_world(next.current, perceived_.origin_world);
  for (size_t k = 0; k < T_world.size(); ++k) {
    ObjectTrajectory& object = forecast_.objects[k];
    if (object.status == ObjectTrajectory::Status::kOk && is_finite(T_world[k])) {
      object.poses.push_back(T_world[k]);
    } else {
      object.status = ObjectTrajectory::Status::kDiverged;
      object.poses.push_back(object.poses.back());
      freeze(next, static_cast<std::int64_t>(k));
    }
  }
}

/// A diverged object stays where it was last finite, so that the others can go on around it.
void RolloutWorld::freeze(SceneState& next, std::int64_t k) {
  perceived_.batch.dynamic_mask[0][k] = false;
  for (const Pose& pose : {next.current, next.previous}) {
    Tensor rotation = pose.rotation[0][k], translation = pose.translation[0][k];
    rotation.copy_(state_.current.rotation[0][k]);
    translation.copy_(state_.current.translation[0][k]);
  }
}

void RolloutWorld::record_contacts() {
  if (solids_.solids().empty()) return;
  const std::vector<StepContact> contacts =
      find_contacts(steps_done(), objects_, solids_.gaps(body_poses().now, kContact_m), pressed_, met_);
  forecast_.contacts.insert(forecast_.contacts.end(), contacts.begin(), contacts.end());
}

/// Whether every later step would be as this one: nothing moved, and nothing is to come.
bool RolloutWorld::stays(const SceneState& next) const {
  const auto same = [](const Pose& a, const Pose& b) {
    return torch::equal(a.rotation, b.rotation) && torch::equal(a.translation, b.translation);
  };
  if (rollout_.control.size() > 1) return false;
  const double now_s = forecast_.times_s.back();
  for (const CandidateObject& object : objects_) {
    if (object.track && object.track->times_s.back() > now_s) return false;
    for (const Push& push : object.pushes) {
      if (push.time_s >= now_s) return false;
    }
  }
  return same(next.current, state_.current) && same(next.previous, state_.previous) &&
         same(next.previous, next.current);
}

void RolloutWorld::repeat() {
  const int last = steps_done();
  forecast_.times_s.push_back(static_cast<double>(forecast_.times_s.size()) * rollout_.time_step_s);
  for (ObjectTrajectory& object : forecast_.objects) object.poses.push_back(object.poses.back());
  std::vector<StepContact> contacts;
  for (const StepContact& contact : forecast_.contacts) {
    if (contact.step == last) contacts.push_back(contact);
  }
  for (StepContact& contact : contacts) contact.step = last + 1;
  forecast_.contacts.insert(forecast_.contacts.end(), contacts.begin(), contacts.end());
}

}  // namespace rigidformer
