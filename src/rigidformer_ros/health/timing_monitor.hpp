// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>

namespace rigidformer_ros {

/// The stages that take time between a cloud and a forecast: reading a cloud (kPreprocess), finding the object's pose
/// (kRegistration), the rollout (kInference), and a whole forecast from the scene to the topics (kForecast).
enum class Stage { kPreprocess, kRegistration, kInference, kForecast };
/// The number of values of Stage.
inline constexpr std::size_t kNumStages = 4;

/// How long one stage took since the previous report.
struct StageReport {
  std::uint64_t runs = 0;  ///< How often the stage ran
  double mean_s = 0.0;     ///< Mean time of these runs [s]
  double max_s = 0.0;      ///< Longest of these runs [s]
};

/// How long all stages took, and whether forecasts keep up.
struct TimingReport {
  std::array<StageReport, kNumStages> stages;  ///< One report per Stage, in the order of the enumeration
  double late_s = 0.0;  ///< How long forecasts have been too slow in a row, with the one in progress [s]; 0 = in time
};

/// Measures the stages. All functions may be called from any thread. A forecast that hangs is reported as late while it
/// hangs.
class TimingMonitor {
 public:
  /// Counts one run of a stage.
  void add(Stage stage, double seconds);

  /// Notes that a forecast begins. `now_s` is the time of a clock that never jumps [s].
  void begin_forecast(double now_s);

  /// Notes that the forecast ended. It was too slow if it took more than `max_processing_time_s`.
  void end_forecast(double now_s, double max_processing_time_s);

  /// Makes a report and starts the sums anew.
  TimingReport take_report(double now_s, double max_processing_time_s);

 private:
  double late_s(double now_s, double max_processing_time_s) const;

  std::mutex mutex_;
  std::array<StageReport, kNumStages> sums_;  ///< Reports in the making; their mean_s holds the sum of the times
  std::optional<double> forecast_since_s_;    ///< When the forecast in progress began
  std::optional<double> slow_since_s_;        ///< When the first of the slow forecasts in a row began
  double slow_until_s_ = 0.0;                 ///< When the last of the slow forecasts in a row ended
};

/// The time of a clock that never jumps [s].
double steady_seconds();

/// Measures a stage from the construction of the timer to its end.
class StageTimer {
 public:
  StageTimer(TimingMonitor& monitor, Stage stage) : monitor_(monitor), stage_(stage), start_s_(steady_seconds()) {}
  ~StageTimer() { monitor_.add(stage_, steady_seconds() - start_s_); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  TimingMonitor& monitor_;
  Stage stage_;
  double start_s_;
};

/// Measures a whole forecast from the construction of the timer to its end.
class ForecastTimer {
 public:
  ForecastTimer(TimingMonitor& monitor, double max_processing_time_s);
  ~ForecastTimer();
  ForecastTimer(const ForecastTimer&) = delete;
  ForecastTimer& operator=(const ForecastTimer&) = delete;

 private:
  TimingMonitor& monitor_;
  double max_processing_time_s_;
};

}  // namespace rigidformer_ros
