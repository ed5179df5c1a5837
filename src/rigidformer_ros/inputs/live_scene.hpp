// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "rigidformer/tracking/track_store.hpp"
#include "rigidformer_ros/health/rejection_log.hpp"
#include "rigidformer_ros/inputs/stamp_gate.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

using rigidformer::ObjectObservation;
using rigidformer::ObservedScene;
using rigidformer::TrackRecords;

/// The node's current view of the scene. The input, forecast and service threads share it.
class LiveScene {
 public:
  LiveScene(const NodeParameters& parameters, RejectionLog& rejections);

  /// Tells whether a cloud with this stamp can belong to the present. Callers ask this before costly work. If the
  /// answer is no, a rejection is counted.
  bool accepts(const std::string& id, const ros::Time& stamp, const ros::Time& now);

  /// Gives an observation to the tracks. If they refuse it, a rejection is counted.
  void add(const ObjectObservation& observation);

  /// Whether a cloud has come within the last `timeout_s`, however old it was then.
  bool is_fed(rigidformer::Stamp now, double timeout_s) const;

  /// Forgets everything when the clock has jumped back since the last call.
  void watch_clock(const ros::Time& now);

  /// Forgets everything.
  void reset();

  /// The newest scene: each object with its pose then and one time step earlier.
  ObservedScene snapshot(double time_step_s) const;

  /// The poses at which each tracked object was seen.
  TrackRecords records() const;

  /// How often everything was forgotten. What was derived from the scene of an earlier epoch is void.
  std::uint64_t epoch() const;

 private:
  /// Whether the cloud was dropped.
  bool count_dropped(const std::string& id, rigidformer::AddResult result);
  void count_taken(const ObjectObservation& observation, rigidformer::AddResult result,
                   std::optional<rigidformer::Stamp> before);
  std::string describe_gap(const ObjectObservation& observation, rigidformer::Stamp before) const;

  RejectionLog& rejections_;
  mutable std::mutex mutex_;
  StampGate gate_;
  rigidformer::TrackStore tracks_;
  double max_dt_s_;
  rigidformer::Stamp newest_arrival_;
  std::uint64_t epoch_ = 0;
};

}  // namespace rigidformer_ros
