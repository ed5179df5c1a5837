// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "rigidformer/candidates.hpp"

namespace rigidformer {

/// A candidate that is not possible.
class CandidateError : public std::invalid_argument {
 public:
  CandidateError(CandidateOutcome::Error kind, const std::string& message)
      : std::invalid_argument(message), kind_(kind) {}
  CandidateOutcome::Error kind() const { return kind_; }

 private:
  CandidateOutcome::Error kind_;
};

/// One object of a candidate's scene.
struct CandidateObject {
  ObjectState state;
  int source = -1;                       ///< Index in the observed scene; -1 = only a track knows the body
  bool is_placed = false;                ///< Its pose is not the observed one
  std::optional<Twist> twist = {};       ///< That replaces the one between its two poses
  std::optional<GivenTrack> track = {};  ///< That it follows
  std::vector<Push> pushes = {};
};

/// The objects of a candidate: the scene without what is removed, with all changes, and the bodies that only its tracks
/// know at the end. Throws CandidateError naming object, field and value.
std::vector<CandidateObject> candidate_objects(const Candidate& candidate, const std::vector<ObjectState>& scene,
                                               double time_step_s);

/// Where a track is at a time. Inline, so that engines need no LibTorch to follow one.
inline RigidTransform pose_at(const GivenTrack& track, double time_s) {
  const auto next = std::upper_bound(track.times_s.begin(), track.times_s.end(), time_s);
  if (next == track.times_s.begin()) return track.T_world_reference.front();
  if (next == track.times_s.end()) return track.T_world_reference.back();
  const auto i = static_cast<std::size_t>(next - track.times_s.begin());
  const double fraction = (time_s - track.times_s[i - 1]) / (track.times_s[i] - track.times_s[i - 1]);
  return interpolate(track.T_world_reference[i - 1], track.T_world_reference[i], fraction);
}

}  // namespace rigidformer
