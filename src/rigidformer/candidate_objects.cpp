// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/candidate_objects.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

#include "rigidformer/scene/objection.hpp"

namespace rigidformer {
namespace {

using Error = CandidateOutcome::Error;

constexpr double kRounding = 1.0 + 1e-6;  // a speed written with few digits is still within the limit

[[noreturn]] void refuse(const std::string& message) { throw CandidateError(Error::kInvalid, message); }

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.6g", value);
  return text;
}

std::string quoted(const std::string& field, const std::string& id) { return field + " '" + id + "': "; }

CandidateObject& find(std::vector<CandidateObject>& objects, const std::string& field, const std::string& id) {
  const auto has_id = [&](const CandidateObject& object) { return object.state.id == id; };
  const auto found = std::find_if(objects.begin(), objects.end(), has_id);
  if (found == objects.end()) throw CandidateError(Error::kUnknownObject, quoted(field, id) + "no such object");
  return *found;
}

void remove(const Candidate& candidate, std::vector<CandidateObject>& objects) {
  for (const std::string& id : candidate.removed_ids) {
    const CandidateObject& object = find(objects, "removed_ids", id);
    objects.erase(objects.begin() + (&object - objects.data()));
  }
}

bool is_same(const RigidTransform& a, const RigidTransform& b) {
  constexpr double kSame = 1e-6;  // [m], [rad], which is rounding; chosen by eye
  return (a.translation - b.translation).norm() < kSame && rotation_angle(a.rotation, b.rotation) < kSame;
}

/// The object stands elsewhere, and moves as it did.
void place(const RigidTransform& T_world_new, CandidateObject& object) {
  ObjectState& state = object.state;
  const Eigen::Vector3d step = state.T_world_current.translation - state.T_world_previous.translation;
  const Eigen::Quaterniond back = state.T_world_previous.rotation * state.T_world_current.rotation.conjugate();
  if (!is_same(state.T_world_current, T_world_new)) state.stood_s = 0.0;
  state.T_world_current = T_world_new;
  state.T_world_previous = {(back * T_world_new.rotation).normalized(), T_world_new.translation - step};
  object.is_placed = true;
}

void replace_known(const BodyProperties& given, BodyProperties& properties) {
  if (given.mass_kg) properties.mass_kg = given.mass_kg;
  if (given.friction) properties.friction = given.friction;
  if (given.restitution) properties.restitution = given.restitution;
}

void change(const StateChange& wanted, CandidateObject& object) {
  const std::string name = quoted("overrides", wanted.id);
  if (wanted.T_world_reference) {
    if (!is_valid(*wanted.T_world_reference)) refuse(name + "pose is not finite, or its quaternion not of length 1");
    place(*wanted.T_world_reference, object);
  }
  if (wanted.mode) object.state.mode = *wanted.mode;
  if (object.state.mode == MotionMode::kStatic) {
    if (wanted.twist) refuse(name + "twist of a static object");
    object.state.T_world_previous = object.state.T_world_current;
  }
  if (wanted.twist) {
    if (!wanted.twist->linear_mps.allFinite() || !wanted.twist->angular_rps.allFinite()) {
      refuse(name + "twist is not finite");
    }
    object.twist = wanted.twist;
    object.state.stood_s = 0.0;
  }
  replace_known(wanted.properties, object.state.properties);
  if (const auto found = objection(object.state)) refuse(name + *found);
}

void change_all(const Candidate& candidate, std::vector<CandidateObject>& objects) {
  std::set<std::string> seen;
  for (const StateChange& wanted : candidate.changes) {
    if (!seen.insert(wanted.id).second) refuse(quoted("overrides", wanted.id) + "occurs twice");
    change(wanted, find(objects, "overrides", wanted.id));
  }
}

void check_times(const GivenTrack& track, const std::string& name) {
  const std::size_t count = track.times_s.size();
  if (count == 0 || count != track.T_world_reference.size()) {
    refuse(name + std::to_string(count) + " times and " + std::to_string(track.T_world_reference.size()) +
           " poses, must be as many, and at least one");
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(track.times_s[i]) || (i > 0 && !(track.times_s[i] > track.times_s[i - 1]))) {
      refuse(name + "times[" + std::to_string(i) + "] is " + number(track.times_s[i]) +
             " s, must be finite and later than the one before");
    }
    if (!is_valid(track.T_world_reference[i])) {
      refuse(name + "poses[" + std::to_string(i) + "] is not finite, or its quaternion not of length 1");
    }
  }
}

void check_speed(const GivenTrack& track, const std::string& name) {
  if (!std::isfinite(track.max_speed_mps) || track.max_speed_mps < 0.0) {
    refuse(name + "max_speed is " + number(track.max_speed_mps) + " m/s, must be finite and not negative");
  }
  if (track.max_speed_mps == 0.0) return;
  for (std::size_t i = 1; i < track.times_s.size(); ++i) {
    const Eigen::Vector3d way = track.T_world_reference[i].translation - track.T_world_reference[i - 1].translation;
    const double speed = way.norm() / (track.times_s[i] - track.times_s[i - 1]);
    if (speed > track.max_speed_mps * kRounding) {
      refuse(name + "is " + number(speed) + " m/s fast before times[" + std::to_string(i) + "], max_speed is " +
             number(track.max_speed_mps) + " m/s");
    }
  }
}

CandidateObject body_of(const GivenTrack& track) {
  CandidateObject object;
  object.state.id = track.id;
  object.state.points_reference = track.points_reference;
  object.state.properties = track.properties;
  return object;
}

void follow(const GivenTrack& track, double time_step_s, CandidateObject& object) {
  const std::string name = quoted("kinematic", track.id);
  if (object.track) refuse(name + "occurs twice");
  check_times(track, name);
  check_speed(track, name);
  const RigidTransform start = pose_at(track, 0.0), seen = object.state.T_world_current;
  object.track = track;
  object.twist = {};
  object.is_placed = object.is_placed || object.source < 0 || !is_same(start, seen);
  object.state.mode = MotionMode::kKinematic;
  object.state.T_world_current = start;
  object.state.T_world_previous = pose_at(track, -time_step_s);
  if (const auto found = objection(object.state)) refuse(name + *found);
}

void follow_all(const Candidate& candidate, double time_step_s, std::vector<CandidateObject>& objects) {
  for (const GivenTrack& track : candidate.tracks) {
    const auto has_id = [&](const CandidateObject& object) { return object.state.id == track.id; };
    const bool is_known = std::any_of(objects.begin(), objects.end(), has_id);
    if (track.id.empty()) refuse(quoted("kinematic", track.id) + "the id is empty");
    if (is_known && track.points_reference.rows() > 0) {
      refuse(quoted("kinematic", track.id) + "has a cloud, although the scene has an object of that id");
    }
    if (!is_known && track.points_reference.rows() > 0) objects.push_back(body_of(track));
    follow(track, time_step_s, find(objects, "kinematic", track.id));
  }
}

void push_all(const Candidate& candidate, std::vector<CandidateObject>& objects) {
  for (const Push& push : candidate.pushes) {
    const std::string name = quoted("impulses", push.id);
    CandidateObject& object = find(objects, "impulses", push.id);
    if (!std::isfinite(push.time_s) || push.time_s < 0.0) {
      refuse(name + "time is " + number(push.time_s) + " s, must be finite and not negative");
    }
    if (!push.linear_Ns.allFinite() || !push.angular_Nms.allFinite() || !push.point_reference.allFinite()) {
      refuse(name + "holds numbers that are not finite");
    }
    if (object.state.mode != MotionMode::kDynamic) refuse(name + "its motion is given, nothing can push it");
    if (!object.state.properties.mass_kg) refuse(name + "its mass is unknown");
    object.pushes.push_back(push);
  }
}

}  // namespace

std::vector<CandidateObject> candidate_objects(const Candidate& candidate, const std::vector<ObjectState>& scene,
                                               double time_step_s) {
  std::vector<CandidateObject> objects;
  for (const ObjectState& state : scene) objects.push_back({state, static_cast<int>(objects.size())});
  remove(candidate, objects);
  change_all(candidate, objects);
  follow_all(candidate, time_step_s, objects);
  push_all(candidate, objects);
  return objects;
}

}  // namespace rigidformer
