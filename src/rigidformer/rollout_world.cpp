// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/rollout_world.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "rigidformer/engine/engine_step.hpp"
#include "rigidformer/model/command.hpp"
#include "rigidformer/model/given_motion.hpp"
#include "rigidformer/simulation/observed_motion.hpp"

namespace rigidformer {
namespace {

constexpr double kLargestOverlap = 0.05;  // of its diameter, with which a body may be placed in another one
constexpr double kUnmoved = 1e-6;         // [m], [rad] of a given body during a step, which is rounding; by eye

bool any(const std::vector<bool>& values) { return std::find(values.begin(), values.end(), true) != values.end(); }

bool is_given(const CandidateObject& object) { return object.state.mode != MotionMode::kDynamic; }

/// The solids in the roles and of the material that a candidate gives them.
PerceivedObjects in_roles(PerceivedObjects perceived, const std::vector<CandidateObject>& objects) {
  for (std::size_t k = 0; k < perceived.solids.size(); ++k) {
    const ObjectState& state = objects[k].state;
    perceived.solids[k] = with_role(std::move(perceived.solids[k]), static_cast<std::int64_t>(k),
                                    state.mode == MotionMode::kDynamic, state.properties);
  }
  return perceived;
}

/// Whether it is faster within a step than what any model holds at rest.
bool is_moving(const RigidTransform& from, const RigidTransform& to, double time_step_s) {
  const RestLimits limits;
  return !((to.translation - from.translation).norm() < limits.speed_mps * time_step_s &&
           rotation_angle(from.rotation, to.rotation) < limits.spin_radps * time_step_s);
}

/// [1, K] bool.
Tensor mask_of(const std::vector<bool>& values, const torch::Device& device) {
  Tensor mask = torch::zeros({1, static_cast<std::int64_t>(values.size())}, torch::kBool);
  std::copy(values.begin(), values.end(), mask.data_ptr<bool>());
  return mask.to(device);
}

}  // namespace

RolloutWorld::RolloutWorld(const StepMaker& maker, PerceivedObjects perceived, std::vector<CandidateObject> objects,
                           const RolloutOptions& rollout, Forecast& forecast)
    : maker_(maker),
      rollout_(rollout),
      perceived_(in_roles(std::move(perceived), objects)),
      objects_(std::move(objects)),
      solids_(perceived_.solids, perceived_.batch.ground_height[0].item<double>()),
      pushed_(objects_.size(), false),
      forecast_(forecast) {
  assume_roles();
  forecast_.times_s.push_back(0.0);
  for (const CandidateObject& object : objects_) {
    forecast_.objects.push_back({object.state.id, ObjectTrajectory::Status::kOk, {object.state.T_world_current}});
  }
  check_overlaps();
  if (rollout_.control.empty() && !solids_.solids().empty()) stand();
  set_twists();
  state_.first = state_.previous;
  make_steps();
  record_contacts();
}

void RolloutWorld::assume_roles() {
  const torch::Device device = perceived_.batch.points_reference.device();
  std::vector<ObjectState> states;
  for (const CandidateObject& object : objects_) states.push_back(object.state);
  SceneBatch roles;
  store_roles(states, maker_.model->options, roles);
  for (const auto tensor :
       {&SceneBatch::object_mask, &SceneBatch::dynamic_mask, &SceneBatch::properties, &SceneBatch::properties_known}) {
    perceived_.batch.*tensor = (roles.*tensor).to(device);
  }
  state_ = make_scene_state(states, perceived_.origin_world).to(device);
}

void RolloutWorld::make_steps() {
  if (maker_.fidelity == Fidelity::kEngine) {
    engine_ = make_engine_step(perceived_.batch, solids_.solids(), 1, Sleep::kWhileHeld);
  } else {
    network_ = std::make_unique<NetworkSteps>(maker_.model, perceived_);
  }
}

/// Bodies that a camera saw overlap a little; what a candidate places must not begin inside something.
void RolloutWorld::check_overlaps() const {
  const std::vector<SolidGap> gaps = solids_.gaps(body_poses().now, 0.0);
  for (const SolidGap& gap : gaps) {
    for (const int k : {gap.body, gap.partner}) {
      if (k < 0 || !objects_[static_cast<std::size_t>(k)].is_placed) continue;
      const double size_m = 2.0 * solids_.solids()[static_cast<std::size_t>(k)].radius_m;
      const auto& state = objects_[static_cast<std::size_t>(k)].state;
      if (-gap.gap_m <= kLargestOverlap * size_m || (gap.partner < 0 && state.mode != MotionMode::kDynamic)) continue;
      const int other = k == gap.body ? gap.partner : gap.body;
      const std::string what =
          other < 0 ? "the ground" : "'" + objects_[static_cast<std::size_t>(other)].state.id + "'";
      throw CandidateError(CandidateOutcome::Error::kInvalid,
                           "'" + state.id + "' starts " + std::to_string(-gap.gap_m) + " m deep in " + what +
                               ", at most " + std::to_string(kLargestOverlap * size_m) + " m are accepted");
    }
  }
}

/// What was seen to stand has no velocity, whatever the noise of its poses says.
void RolloutWorld::stand() {
  std::vector<ObjectState> states;
  for (const CandidateObject& object : objects_) states.push_back(object.state);
  const std::vector<bool> stands = who_stands(states, solids_, body_poses().now);
  standing_ = Standing(solids_, body_poses().now, stands);
  put_back(state_, mask_of(stands, perceived_.batch.dynamic_mask.device()), state_);
}

BodyPoses RolloutWorld::body_poses() const {
  const auto poses = [&](const Pose& pose) { return solids_.body_poses(to_world(pose, Eigen::Vector3d::Zero())); };
  return {poses(state_.previous), poses(state_.current), rollout_.time_step_s, rollout_.gravity};
}

void RolloutWorld::set_motion(std::size_t k, const BodyPoses& poses, const BodyState& motion) {
  RigidTransform T = departure(solids_, poses, static_cast<int>(k), motion);
  T.translation -= T.rotation * solids_.solids()[k].centre_reference;
  store_pose(T, Eigen::Vector3d::Zero(), state_.previous, static_cast<std::int64_t>(k));
  pushed_[k] = true;
}

void RolloutWorld::set_twists() {
  for (std::size_t k = 0; k < objects_.size(); ++k) {
    if (!objects_[k].twist) continue;
    const BodyPoses poses = body_poses();
    BodyState motion = motion_now(solids_, poses, static_cast<int>(k));
    const Eigen::Vector3d to_centre = motion.T_world_object.rotation * solids_.solids()[k].centre_reference;
    motion.angular_velocity = objects_[k].twist->angular_rps;
    motion.velocity = objects_[k].twist->linear_mps + motion.angular_velocity.cross(to_centre);
    set_motion(k, poses, motion);
  }
}

void RolloutWorld::push() {
  const double begin_s = forecast_.times_s.back(), end_s = begin_s + rollout_.time_step_s;
  for (std::size_t k = 0; k < objects_.size(); ++k) {
    for (const Push& push : objects_[k].pushes) {
      if (push.time_s < begin_s || push.time_s >= end_s) continue;
      const BodyPoses poses = body_poses();
      const BodyState motion = motion_now(solids_, poses, static_cast<int>(k));
      const ObservedSolid& solid = solids_.solids()[k];
      const Eigen::Vector3d arm = motion.T_world_object.rotation * (push.point_reference - solid.centre_reference);
      set_motion(k, poses, pushed(solid, motion, push.linear_Ns, push.angular_Nms, arm));
    }
  }
}

void RolloutWorld::set_coming() {
  state_.coming = std::any_of(objects_.begin(), objects_.end(), is_given) ? coming_pose(state_) : state_.current;
  const double time_s = forecast_.times_s.back() + rollout_.time_step_s;
  for (std::size_t k = 0; k < objects_.size(); ++k) {
    if (!objects_[k].track) continue;
    store_pose(pose_at(*objects_[k].track, time_s), perceived_.origin_world, state_.coming,
               static_cast<std::int64_t>(k));
  }
}

/// What is pushed, or touched by something that is moved or pushed: a contact passes the motion on.
std::vector<bool> RolloutWorld::moved_by_others() const {
  std::vector<bool> moved = pushed_;
  if (!any(moved) && std::none_of(objects_.begin(), objects_.end(), is_given)) return moved;
  const std::vector<RigidTransform> coming = to_world(state_.coming, Eigen::Vector3d::Zero());
  std::vector<RigidTransform> T = to_world(state_.current, Eigen::Vector3d::Zero());
  for (std::size_t k = 0; k < objects_.size(); ++k) {
    if (!is_given(objects_[k])) continue;
    moved[k] = (coming[k].translation - T[k].translation).norm() > kUnmoved ||
               rotation_angle(coming[k].rotation, T[k].rotation) > kUnmoved;
    T[k] = coming[k];
  }
  if (!any(moved)) return moved;
  if (solids_.solids().empty()) return std::vector<bool>(objects_.size(), true);
  const std::vector<SolidGap> gaps = solids_.gaps(solids_.body_poses(T), kTouching_m);
  for (bool changed = true; changed;) {
    changed = false;
    for (const SolidGap& gap : gaps) {
      if (gap.partner < 0) continue;
      const auto a = static_cast<std::size_t>(gap.body), b = static_cast<std::size_t>(gap.partner);
      if (moved[a] == moved[b]) continue;
      const std::size_t other = moved[a] ? b : a;
      if (is_given(objects_[other])) continue;
      moved[other] = changed = true;
    }
  }
  return moved;
}

/// What is exempt from being held at rest is awake, too; a new command may set anything in motion.
StepParts RolloutWorld::find_parts(const std::vector<bool>& moved) {
  const bool may_sleep = maker_.rest.speed_mps > 0.0 && rollout_.control.size() <= 1 && !solids_.solids().empty();
  if (!may_sleep) return everybody(objects_.size());
  std::vector<bool> asleep = sleepers_.find(perceived_.batch, state_);
  for (std::size_t k = 0; k < asleep.size(); ++k) asleep[k] = asleep[k] && !moved[k];
  if (!any(asleep)) return everybody(objects_.size());
  const std::vector<RigidTransform> coming = to_world(state_.coming, Eigen::Vector3d::Zero());
  return rigidformer::find_parts(solids_, body_poses(), solids_.body_poses(coming), asleep);
}

StepPrediction RolloutWorld::predict(const std::vector<bool>& moved) {
  if (maker_.fidelity == Fidelity::kEngine) {
    const EngineMotion motion = engine_(state_).front();
    pressed_ = motion.pressed;
    return {Tensor(), motion.pose, motion.departure};
  }
  parts_ = find_parts(moved);
  const StepPrediction prediction = network_->predict(state_, parts_);
  pressed_ = network_->pressed();
  met_ = network_->met();
  return prediction;
}

void RolloutWorld::hold_standing(const std::vector<bool>& moved, SceneState& next) {
  if (!standing_.any()) return;
  const std::vector<RigidTransform> from = to_world(state_.current, Eigen::Vector3d::Zero());
  const std::vector<RigidTransform> to = to_world(next.current, Eigen::Vector3d::Zero());
  std::vector<bool> moves = moved;
  for (std::size_t k = 0; k < moves.size(); ++k) {
    if (moved[k]) standing_.let_go(k);
    moves[k] = moves[k] || is_moving(from[k], to[k], rollout_.time_step_s);
  }
  standing_.let_go(moves, [&] {
    std::vector<ObjectPair> pairs = met_;
    for (const PressedPair& pair : pressed_) pairs.emplace_back(pair.object, pair.partner);
    for (const SolidGap& gap : solids_.gaps(solids_.body_poses(to), kContact_m)) {
      pairs.emplace_back(gap.body, gap.partner);
    }
    return pairs;
  });
  put_back(state_, mask_of(standing_.who(), perceived_.batch.dynamic_mask.device()), next);
}

void RolloutWorld::step() {
  if (is_over_) return repeat();
  push();
  set_coming();
  const Tensor command = command_of_step(rollout_, steps_done());
  if (command.defined()) perceived_.batch.control = command.to(perceived_.batch.gravity.device());
  const bool holds = maker_.rest.speed_mps > 0.0;
  const std::vector<bool> moved =
      holds || standing_.any() ? moved_by_others() : std::vector<bool>(objects_.size(), false);
  SceneState next = advance(perceived_.batch, state_, predict(moved));
  if (holds) {
    const Tensor exempt = any(moved) ? mask_of(moved, perceived_.batch.dynamic_mask.device()) : Tensor();
    hold_resting(perceived_.batch, state_, next, maker_.rest, exempt);
  }
  hold_standing(moved, next);
  forecast_.times_s.push_back(static_cast<double>(forecast_.times_s.size()) * rollout_.time_step_s);
  record(next);
  settle_pushed(next);
  is_over_ = stays(next);
  state_ = next;
  record_contacts();
}

/// What came to rest is held like everything else again.
void RolloutWorld::settle_pushed(const SceneState& next) {
  if (!any(pushed_)) return;
  const std::vector<RigidTransform> before = to_world(state_.current, Eigen::Vector3d::Zero());
  const std::vector<RigidTransform> after = to_world(next.current, Eigen::Vector3d::Zero());
  SettleCriterion still;
  still.duration_s = 0.0;
  for (std::size_t k = 0; k < pushed_.size(); ++k) {
    if (settled_step({before[k], after[k]}, rollout_.time_step_s, still) == 0) pushed_[k] = false;
  }
}

}  // namespace rigidformer
