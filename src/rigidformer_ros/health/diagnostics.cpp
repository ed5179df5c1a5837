// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/health/diagnostics.hpp"

#include <ros/console.h>

#include <algorithm>
#include <array>
#include <utility>

#include "rigidformer_ros/forecast/forecast_messages.hpp"

namespace rigidformer_ros {

namespace {

using diagnostic_msgs::DiagnosticStatus;

// Names of the stages in /diagnostics, in the order of the enumeration Stage.
constexpr std::array<const char*, kNumStages> kStageNames{"preprocess", "registration", "inference", "forecast"};
// Most horizons listed in /diagnostics, evenly spread over all of them; chosen by eye. forecast_error has them all.
constexpr std::size_t kMaxHorizonsShown = 8;

}  // namespace

NodeDiagnostics::NodeDiagnostics(ros::NodeHandle& node, const ros::NodeHandle& private_node,
                                 const DiagnosticsParameters& parameters, const Sources& sources)
    : sources_(sources), limits_(parameters), updater_(node, private_node, private_node.getNamespace()) {
  updater_.setHardwareID("none");
  updater_.add("model", this, &NodeDiagnostics::report_model);
  updater_.add("input", this, &NodeDiagnostics::report_input);
  updater_.add("tf", this, &NodeDiagnostics::report_tf);
  updater_.add("timing", this, &NodeDiagnostics::report_timing);
  updater_.add("forecast quality", this, &NodeDiagnostics::report_quality);
  timer_ = node.createWallTimer(ros::WallDuration(parameters.period), [this](const ros::WallTimerEvent&) { update(); });
}

void NodeDiagnostics::update() {
  try {
    rejections_before_ = std::exchange(rejections_, sources_.rejections.counts());
    updater_.force_update();
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("diagnostics: " << error.what());
  }
}

std::uint64_t NodeDiagnostics::rejected_since_last_update(const std::string& reason) const {
  const auto now = rejections_.find(reason);
  const auto before = rejections_before_.find(reason);
  return (now == rejections_.end() ? 0 : now->second.total) -
         (before == rejections_before_.end() ? 0 : before->second.total);
}

void NodeDiagnostics::report_model(Status& status) {
  const auto model = sources_.forecaster.model();
  if (!model) {
    const bool failed = sources_.forecaster.state() == InferenceWorker::State::kFailed;
    status.summary(failed ? DiagnosticStatus::ERROR : DiagnosticStatus::WARN, sources_.forecaster.message());
    status.add("state", failed ? "failed" : "loading");
    return;
  }
  status.summary(DiagnosticStatus::OK, "ready");
  if (rejected_since_last_update(kFailedForecast) > 0) {
    status.summary(DiagnosticStatus::ERROR, "a forecast failed: " + rejections_[kFailedForecast].detail);
  }
  status.add("state", "ready");
  status.add("model", model_label(*model));
  status.add("sha256", model->sha256);
  status.add("device", model->device);
  status.add("precision", model->precision);
  status.add("failed forecasts", rejections_[kFailedForecast].total);
}

void NodeDiagnostics::report_input(Status& status) {
  const InputReport input = sources_.input.take_report(ros::Time::now(), steady_seconds());
  const double max_age_s = limits_.get().max_input_age;
  if (!input.age_s) {
    status.summary(DiagnosticStatus::WARN, "no usable cloud yet");
  } else if (*input.age_s > max_age_s) {
    status.summaryf(DiagnosticStatus::WARN, "the newest usable cloud is %.3f s old", *input.age_s);
  } else {
    status.summaryf(DiagnosticStatus::OK, "%zu objects", input.num_objects);
  }
  status.add("objects", input.num_objects);
  status.add("objects that sit out", input.num_skipped);
  status.add("topics with clouds", input.num_topics);
  status.addf("rate [Hz]", "%.2f", input.rate_hz);
  status.add("age of the newest usable cloud [s]", input.age_s ? std::to_string(*input.age_s) : "unknown");
  status.add("clouds received", input.received);
  status.add("clouds overwritten in a queue", input.lost);
  status.add("frames", input.frames);
  status.add("frames forecast", input.forecast);
  for (const auto& [reason, count] : rejections_) {
    if (reason != kFailedForecast) {
      status.add("rejected, " + reason, std::to_string(count.total) + "; last: " + count.detail);
    }
  }
}

void NodeDiagnostics::report_tf(Status& status) {
  const std::uint64_t failures = rejected_since_last_update(kNoTransform);
  if (failures > 0) {
    status.summary(DiagnosticStatus::WARN, rejections_[kNoTransform].detail);
  } else {
    status.summary(DiagnosticStatus::OK, "no failure since the last message");
  }
  status.add("failures since the last message", failures);
  status.add("failures", rejections_[kNoTransform].total);
}

void NodeDiagnostics::report_timing(Status& status) {
  const DiagnosticsParameters limits = limits_.get();
  const TimingReport timing = sources_.timing.take_report(steady_seconds(), limits.max_processing_time);
  const auto level = timing.late_s <= 0.0                           ? DiagnosticStatus::OK
                     : timing.late_s > limits.max_consecutive_delay ? DiagnosticStatus::ERROR
                                                                    : DiagnosticStatus::WARN;
  if (level == DiagnosticStatus::OK) {
    status.summary(level, "in time");
  } else {
    status.summaryf(level, "forecasts have taken more than %.3f s each for %.3f s", limits.max_processing_time,
                    timing.late_s);
  }
  for (std::size_t i = 0; i < kNumStages; ++i) {
    const StageReport& stage = timing.stages[i];
    status.addf(kStageNames[i] + std::string(" [ms]"), "mean %.3f, max %.3f, runs %lu", 1e3 * stage.mean_s,
                1e3 * stage.max_s, static_cast<unsigned long>(stage.runs));
  }
}

void NodeDiagnostics::report_quality(Status& status) {
  const ForecastQuality quality = sources_.quality.get();
  const DiagnosticsParameters limits = limits_.get();
  const std::vector<HorizonError>& errors = quality.errors;
  if (errors.empty()) {
    status.summary(DiagnosticStatus::OK, "no forecast has been compared with an observation yet");
  } else if (quality.trusted_horizon_s > 0.0) {
    status.summaryf(DiagnosticStatus::OK, "trusted up to %.3f s", quality.trusted_horizon_s);
  } else if (errors.front().position_rmse_m > limits.trusted_position_error ||
             errors.front().rotation_rmse_rad > limits.trusted_rotation_error) {
    status.summary(DiagnosticStatus::WARN, "no horizon is trusted: even the first step is off");
  } else {
    status.summary(DiagnosticStatus::OK, "too few comparisons yet");
  }
  status.addf("trusted horizon [s]", "%.3f", quality.trusted_horizon_s);
  const std::size_t stride = (errors.size() + kMaxHorizonsShown - 1) / kMaxHorizonsShown;
  for (std::size_t i = stride; i > 0 && i <= errors.size(); i += stride) {
    const HorizonError& error = errors[i - 1];
    status.addf("error at " + std::to_string(error.horizon_s) + " s", "%.4f m, %.4f rad from %lu comparisons",
                error.position_rmse_m, error.rotation_rmse_rad, static_cast<unsigned long>(error.num_samples));
  }
}

}  // namespace rigidformer_ros
