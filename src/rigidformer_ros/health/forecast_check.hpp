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

/// Root mean square error of all forecasts that were compared at one horizon.
struct HorizonError {
  double horizon_s = 0.0;          ///< Time from the observation to the compared step [s]
  double position_rmse_m = 0.0;    ///< Error of the origin [m]
  double rotation_rmse_rad = 0.0;  ///< Error of the orientation, as an angle [rad]
  std::uint64_t num_samples = 0;   ///< Number of comparisons
};

/// How good the forecasts have been lately.
struct ForecastQuality {
  std::vector<HorizonError> errors;  ///< Errors of all compared horizons, the shortest first
  double trusted_horizon_s = 0.0;    ///< How far ahead forecasts were good [s]; 0 = nowhere, or not known
};

/// Compares forecasts with what was then observed. Only forecasts of dynamic objects with a known velocity and a good
/// registration count. Memory is bounded: errors are kept as sums, and while too many forecasts wait for their
/// observations, new ones are passed over. The class is not thread safe.
class ForecastCheck {
 public:
  /// A comparison counts for `window_s` seconds of observed time. Old ones are dropped a tenth of the window at a time.
  explicit ForecastCheck(double window_s) : window_s_(window_s) {}

  /// Keeps the forecast until its horizon has been observed.
  void expect(const SceneRollout& rollout);

  /// Compares the kept forecasts with the poses observed since, interpolated between clouds. Forecasts of a track that
  /// ended or restarted are dropped. Returns the number of comparisons.
  int compare(const TrackRecords& tracks);

  /// The errors of all horizons that have been compared, the shortest horizon first.
  std::vector<HorizonError> errors() const;

  /// Forgets all forecasts and errors. This is needed when time jumped, because their stamps mean nothing then.
  void reset();

 private:
  /// The forecast of one object.
  struct Expectation {
    std::string id;
    std::uint64_t track = 0;
    rigidformer::Stamp t0;
    std::vector<double> times_s;
    std::vector<rigidformer::RigidTransform> poses;
    std::size_t next = 1;  ///< The first step that has not been observed yet
  };
  struct ErrorSum {
    double horizon_s = 0.0;
    double position_m2 = 0.0;
    double rotation_rad2 = 0.0;
    std::uint64_t num_samples = 0;
  };
  /// Sums of the errors in one part of the window.
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

/// Writes the quality as a message. The caller fills in the header.
ForecastError to_message(const ForecastQuality& quality, double window_s);

/// The largest horizon [s] up to which all errors stay within both limits and come from ten comparisons or more. It is
/// 0 when there is none.
double trusted_horizon_s(const std::vector<HorizonError>& errors, double max_position_m, double max_rotation_rad);

}  // namespace rigidformer_ros
