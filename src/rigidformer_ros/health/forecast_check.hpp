// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/ForecastError.h>
#include <ros/time.h>

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "rigidformer/tracking/observation.hpp"
#include "rigidformer_ros/forecast/scene_forecaster.hpp"

namespace rigidformer_ros {

using rigidformer::TrackRecord;
using rigidformer::TrackRecords;

/// Root mean square error of all forecasts compared at one horizon.
struct HorizonError {
  double horizon_s = 0.0;
  double position_rmse_m = 0.0;
  double rotation_rmse_rad = 0.0;
  std::uint64_t num_samples = 0;
};

/// How good the forecasts have been lately.
struct ForecastQuality {
  std::vector<HorizonError> errors;
  double trusted_horizon_s = 0.0;  ///< 0 = none or not known
};

/// Compares forecasts with what was then observed. Forecasts of dynamic objects with a known velocity and a good
/// registration count. Memory is bounded: errors are kept as sums, and while too many forecasts wait for their
/// observations, new ones are passed over. Not thread safe.
class ForecastCheck {
 public:
  /// Comparisons count for `window_s` of observed time (to a tenth of it).
  explicit ForecastCheck(double window_s) : window_s_(window_s) {}

  /// Keeps the forecast until its horizon has been observed.
  void expect(const SceneRollout& rollout);

  /// Compares what is kept with the poses observed since, interpolated between clouds. Forecasts of a track that ended
  /// or restarted are dropped. Returns the number of comparisons.
  int compare(const TrackRecords& tracks);

  /// Horizons that have been compared, in order.
  std::vector<HorizonError> errors() const;

  /// Forgets forecasts and errors: when time jumped.
  void reset();

 private:
  /// One object of one forecast, from the first step that is not observed yet.
  struct Expectation {
    std::string id;
    std::uint64_t track = 0;
    rigidformer::Stamp t0;
    std::vector<double> times_s;
    std::vector<rigidformer::RigidTransform> poses;
    std::size_t next = 1;
  };
  struct ErrorSum {
    double horizon_s = 0.0;
    double position_m2 = 0.0;
    double rotation_rad2 = 0.0;
    std::uint64_t num_samples = 0;
  };
  /// Sums over a tenth of the window.
  struct Slot {
    std::int64_t number = 0;
    std::vector<ErrorSum> steps;
  };

  int compare(Expectation& expected, const TrackRecord& record);
  void add_error(const Expectation& expected, const rigidformer::RigidTransform& T_world_observed);
  Slot& slot_at(rigidformer::Stamp stamp);

  double window_s_;
  std::deque<Expectation> expectations_;
  std::size_t num_kept_poses_ = 0;
  std::deque<Slot> slots_;
};

/// The arrays of the message; the header is left to the caller.
ForecastError to_message(const ForecastQuality& quality, double window_s);

/// Largest horizon up to which all errors stay within both limits, from enough comparisons to tell; 0 = none.
double trusted_horizon_s(const std::vector<HorizonError>& errors, double max_position_m, double max_rotation_rad);

}  // namespace rigidformer_ros
