// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <mutex>
#include <string>

#include "rigidformer/tracking/track_store.hpp"
#include "rigidformer_ros/health/rejection_log.hpp"
#include "rigidformer_ros/inputs/stamp_gate.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

using rigidformer::ObjectObservation;
using rigidformer::ObservedScene;
using rigidformer::TrackRecords;

/// The node's current view of the scene, shared between the input, forecast and service threads.
class LiveScene {
 public:
  LiveScene(const NodeParameters& parameters, RejectionLog& rejections);

  /// Whether a cloud with this stamp can belong to the present: to ask before costly work. Counts a rejection.
  bool accepts(const std::string& id, const ros::Time& stamp, const ros::Time& now);

  /// Takes an observation in; rejections are counted.
  void add(const ObjectObservation& observation);

  /// Forgets everything when the clock has jumped back since the last call.
  void watch_clock(const ros::Time& now);

  void reset();
  ObservedScene snapshot(double time_step_s) const;
  TrackRecords records() const;

  /// Counts how often everything was forgotten: what was derived from an earlier epoch is void.
  std::uint64_t epoch() const;

 private:
  void count(const std::string& id, rigidformer::AddResult result);

  RejectionLog& rejections_;
  mutable std::mutex mutex_;
  StampGate gate_;
  rigidformer::TrackStore tracks_;
  std::uint64_t epoch_ = 0;
};

}  // namespace rigidformer_ros
