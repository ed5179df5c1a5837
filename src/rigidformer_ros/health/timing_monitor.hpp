// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>

namespace rigidformer_ros {

/// What takes time between a cloud and a forecast. kForecast is a whole forecast: from the scene to the topics.
enum class Stage { kPreprocess, kRegistration, kInference, kForecast };
inline constexpr std::size_t kNumStages = 4;

struct StageReport {
  std::uint64_t runs = 0;  ///< Since the previous report; the times are of these
  double mean_s = 0.0;
  double max_s = 0.0;
};

struct TimingReport {
  std::array<StageReport, kNumStages> stages;
  double late_s = 0.0;  ///< How long forecasts have been too slow in a row, the one in progress included; 0 = in time
};

/// Measures the stages. Safe to call from any thread; a forecast that hangs shows as late while it hangs.
class TimingMonitor {
 public:
  void add(Stage stage, double seconds);

  /// A forecast begins and ends, in seconds of a clock that never jumps.
  void begin_forecast(double now_s);
  void end_forecast(double now_s, double max_processing_time_s);

  TimingReport take_report(double now_s, double max_processing_time_s);

 private:
  double late_s(double now_s, double max_processing_time_s) const;

  std::mutex mutex_;
  std::array<StageReport, kNumStages> sums_;  ///< mean_s holds the sum
  std::optional<double> forecast_since_s_;    ///< Beginning of the one in progress
  std::optional<double> slow_since_s_;        ///< Beginning of the first of the latest slow ones in a row
  double slow_until_s_ = 0.0;                 ///< End of the last of them
};

/// Seconds of a clock that never jumps.
double steady_seconds();

/// Measures a stage from here to the end of the scope.
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

/// Measures a forecast from here to the end of the scope.
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
