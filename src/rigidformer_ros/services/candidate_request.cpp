// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/services/candidate_request.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "rigidformer/candidate_objects.hpp"
#include "rigidformer/geometry/point_rows.hpp"
#include "rigidformer_ros/messages/cloud_conversion.hpp"
#include "rigidformer_ros/messages/conversions.hpp"

namespace rigidformer_ros {

namespace {

using rigidformer::Candidate;
using rigidformer::GivenTrack;
using rigidformer::Push;
using rigidformer::RigidTransform;
using rigidformer::StateChange;
using rigidformer::StopRule;

template <typename Vector>
Eigen::Vector3d to_vector(const Vector& v) {
  return {v.x, v.y, v.z};
}

// Calls `read`; what it throws gets the name of the field in front.
template <typename Read>
auto named(const std::string& field, const Read& read) {
  try {
    return read();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(field + ": " + error.what());
  }
}

StateChange read_override(const StateOverride& message, const RigidTransform& T_fixed_request) {
  constexpr std::uint8_t kAll =
      StateOverride::POSE | StateOverride::TWIST | StateOverride::MODE | StateOverride::PROPERTIES;
  if ((message.fields & ~kAll) != 0) {
    throw std::invalid_argument("fields: is " + std::to_string(message.fields) + ", must be a sum of 1, 2, 4 and 8");
  }
  StateChange change;
  change.id = message.id;
  if ((message.fields & StateOverride::POSE) != 0) {
    change.T_world_reference = T_fixed_request * to_transform(message.pose);
  }
  if ((message.fields & StateOverride::TWIST) != 0) {
    change.twist = rigidformer::Twist{T_fixed_request.rotation * to_vector(message.twist.linear),
                                      T_fixed_request.rotation * to_vector(message.twist.angular)};
  }
  if ((message.fields & StateOverride::MODE) != 0) {
    change.mode = named("mode", [&] { return to_motion_mode(message.mode); });
  }
  if ((message.fields & StateOverride::PROPERTIES) != 0) {
    change.properties = to_properties(message.properties);
  }
  return change;
}

GivenTrack read_track(const KinematicTrack& message, const NodeParameters& parameters,
                      const RigidTransform& T_fixed_request) {
  GivenTrack track;
  track.id = message.id;
  const bool has_cloud = message.cloud.width > 0 && message.cloud.height > 0;
  if (has_cloud) {
    const Points points =
        named("cloud", [&] { return read_points(message.cloud, max_points_per_object(parameters.input)); });
    track.points_reference = rigidformer::select_rows(points, rigidformer::finite_rows(points));
    if (track.points_reference.rows() < parameters.input.min_points) {
      throw std::invalid_argument("cloud: has " + std::to_string(track.points_reference.rows()) +
                                  " finite points, needs at least " + std::to_string(parameters.input.min_points));
    }
    track.properties = resolve_properties(parameters.properties, message.id, to_properties(message.properties));
  }
  track.times_s = message.times;
  for (std::size_t i = 0; i < message.poses.size(); ++i) {
    track.T_world_reference.push_back(
        named("poses[" + std::to_string(i) + "]", [&] { return T_fixed_request * to_transform(message.poses[i]); }));
  }
  track.max_speed_mps = message.max_speed;
  return track;
}

Push read_push(const Impulse& message, const RigidTransform& T_fixed_request) {
  return {message.id, message.time, T_fixed_request.rotation * to_vector(message.linear),
          T_fixed_request.rotation * to_vector(message.angular), to_vector(message.application_point)};
}

std::string entry(const char* field, std::size_t i, const std::string& id) {
  return std::string(field) + "[" + std::to_string(i) + "] '" + id + "'";
}

rigidformer::BoxRegion region_of(const std::vector<rigidformer::BoxRegion>& regions, const std::string& name) {
  for (const rigidformer::BoxRegion& region : regions) {
    if (region.name == name) {
      return region;
    }
  }
  throw std::invalid_argument("region: '" + name + "' is none of the regions");
}

StopRule read_stop_rule(const StopCondition& message, const std::vector<rigidformer::BoxRegion>& regions) {
  StopRule rule;
  switch (message.kind) {
    case StopCondition::TOUCH:
      rule.kind = StopRule::Kind::kTouch;
      break;
    case StopCondition::TILT:
      rule.kind = StopRule::Kind::kTilt;
      break;
    case StopCondition::LEAVE:
      rule.kind = StopRule::Kind::kLeave;
      rule.region = region_of(regions, message.region);
      break;
    case StopCondition::ALL_SETTLED:
      rule.kind = StopRule::Kind::kAllSettled;
      break;
    default:
      throw std::invalid_argument("kind: is " + std::to_string(message.kind) + ", must be 0 to 3");
  }
  rule.ids = message.ids;
  rule.value = message.value;
  return rule;
}

// The object in the state that the candidate gives it; `seen` is null for a body that only a track knows.
ObservedObject in_state(const rigidformer::CandidateObject& object, const ObservedObject* seen, double time_step_s) {
  ObservedObject observed = seen != nullptr ? *seen : ObservedObject();
  observed.state = object.state;
  if (object.twist) {
    const RigidTransform& now = object.state.T_world_current;
    observed.state.T_world_previous = {
        rigidformer::rotation_about(-time_step_s * object.twist->angular_rps) * now.rotation,
        now.translation - time_step_s * object.twist->linear_mps};
  }
  return observed;
}

}  // namespace

bool is_empty(const RolloutCandidate& candidate) {
  return candidate.removed_ids.empty() && candidate.overrides.empty() && candidate.impulses.empty() &&
         candidate.kinematic.empty();
}

Candidate read_candidate(const RolloutCandidate& message, const NodeParameters& parameters,
                         const RigidTransform& T_fixed_request) {
  Candidate candidate;
  candidate.name = message.name;
  candidate.removed_ids = message.removed_ids;
  for (std::size_t i = 0; i < message.overrides.size(); ++i) {
    candidate.changes.push_back(named(entry("overrides", i, message.overrides[i].id),
                                      [&] { return read_override(message.overrides[i], T_fixed_request); }));
  }
  for (const Impulse& impulse : message.impulses) {
    candidate.pushes.push_back(read_push(impulse, T_fixed_request));
  }
  for (std::size_t i = 0; i < message.kinematic.size(); ++i) {
    candidate.tracks.push_back(named(entry("kinematic", i, message.kinematic[i].id),
                                     [&] { return read_track(message.kinematic[i], parameters, T_fixed_request); }));
  }
  return candidate;
}

Candidate combined(const Candidate& base, Candidate own) {
  const auto put_in_front = [](const auto& first, auto& rest) {
    rest.insert(rest.begin(), first.begin(), first.end());
  };
  put_in_front(base.removed_ids, own.removed_ids);
  put_in_front(base.changes, own.changes);
  put_in_front(base.pushes, own.pushes);
  put_in_front(base.tracks, own.tracks);
  return own;
}

std::vector<rigidformer::BoxRegion> read_regions(const BatchRequest& request, const RigidTransform& T_fixed_request) {
  std::vector<rigidformer::BoxRegion> regions;
  for (std::size_t i = 0; i < request.regions.size(); ++i) {
    const Region& message = request.regions[i];
    regions.push_back(named("regions[" + std::to_string(i) + "]", [&] {
      return rigidformer::BoxRegion{message.name, T_fixed_request * to_transform(message.pose),
                                    to_vector(message.size)};
    }));
  }
  return regions;
}

std::vector<StopRule> read_stop_rules(const BatchRequest& request, const std::vector<rigidformer::BoxRegion>& regions) {
  std::vector<StopRule> rules;
  for (std::size_t i = 0; i < request.stop.size(); ++i) {
    rules.push_back(named("stop[" + std::to_string(i) + "]", [&] { return read_stop_rule(request.stop[i], regions); }));
  }
  return rules;
}

ObservedScene scene_of_candidate(const ObservedScene& scene, const Candidate& candidate,
                                 const std::vector<rigidformer::ObjectTrajectory>& unusable) {
  std::vector<const ObservedObject*> seen;
  std::vector<rigidformer::ObjectState> states;
  for (const ObservedObject& object : scene.objects) {
    const auto is_it = [&](const rigidformer::ObjectTrajectory& other) { return other.id == object.state.id; };
    if (std::none_of(unusable.begin(), unusable.end(), is_it)) {
      seen.push_back(&object);
      states.push_back(object.state);
    }
  }
  ObservedScene changed = scene;
  changed.objects.clear();
  for (const auto& object : rigidformer::candidate_objects(candidate, states, scene.time_step_s)) {
    const ObservedObject* source = object.source < 0 ? nullptr : seen[static_cast<std::size_t>(object.source)];
    changed.objects.push_back(in_state(object, source, scene.time_step_s));
  }
  for (const rigidformer::ObjectTrajectory& object : unusable) {
    changed.skipped.push_back({object.id, object.reason, rigidformer::SkipCause::kUnusable});
  }
  return changed;
}

}  // namespace rigidformer_ros
