// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/health/forecast_check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigidformer_ros {

namespace {

// Most poses of forecasts that wait for their observations; chosen by eye. At 64 bytes each they take about 6 MB.
constexpr std::size_t kMaxKeptPoses = 100000;
// Parts into which the window is cut; chosen by eye. An error is dropped together with all errors of its part.
constexpr int kSlots = 10;
// Fewest comparisons from which a horizon can be trusted; chosen by eye. Fewer say little about it.
constexpr std::uint64_t kMinSamples = 10;

bool counts(const ObservedObject& object, const rigidformer::ObjectTrajectory& forecast) {
  return object.state.mode == rigidformer::MotionMode::kDynamic && !object.low_quality && !object.assumed_static &&
         forecast.status == rigidformer::ObjectTrajectory::Status::kOk;
}

}  // namespace

void ForecastCheck::expect(const SceneRollout& rollout) {
  const rigidformer::Forecast& forecast = rollout.outcome.forecast;
  for (std::size_t i = 0; i < rollout.scene.objects.size(); ++i) {
    const ObservedObject& object = rollout.scene.objects[i];
    const std::size_t num_poses = forecast.objects[i].poses.size();
    if (counts(object, forecast.objects[i]) && num_kept_poses_ + num_poses <= kMaxKeptPoses) {
      expectations_.push_back(
          {object.state.id, object.track, rollout.scene.stamp, forecast.times_s, forecast.objects[i].poses});
      num_kept_poses_ += num_poses;
    }
  }
}

int ForecastCheck::compare(const TrackRecords& tracks) {
  int comparisons = 0;
  std::deque<Expectation> waiting;
  num_kept_poses_ = 0;
  for (Expectation& expected : expectations_) {
    const auto record = tracks.find(expected.id);
    if (record == tracks.end() || record->second.track != expected.track) {
      continue;
    }
    comparisons += compare(expected, record->second);
    if (expected.next < expected.poses.size()) {
      num_kept_poses_ += expected.poses.size();
      waiting.push_back(std::move(expected));
    }
  }
  expectations_ = std::move(waiting);
  return comparisons;
}

int ForecastCheck::compare(Expectation& expected, const TrackRecord& record) {
  int comparisons = 0;
  for (; expected.next < expected.poses.size(); ++expected.next) {
    const rigidformer::Stamp instant = expected.t0 + rigidformer::to_duration(expected.times_s[expected.next]);
    if (instant > record.poses.newest_stamp()) {
      break;  // Neither this step nor a later one has been observed yet.
    }
    const auto T_world_observed = record.poses.pose_at(instant);
    if (T_world_observed && !record.low_quality) {
      add_error(expected, *T_world_observed);
      ++comparisons;
    }
  }
  return comparisons;
}

void ForecastCheck::add_error(const Expectation& expected, const rigidformer::RigidTransform& T_world_observed) {
  const rigidformer::RigidTransform& T_world_predicted = expected.poses[expected.next];
  const double angle = rigidformer::rotation_angle(T_world_predicted.rotation, T_world_observed.rotation);
  std::vector<ErrorSum>& steps = slot_at(expected.t0 + rigidformer::to_duration(expected.times_s[expected.next])).steps;
  if (steps.size() <= expected.next) {
    steps.resize(expected.next + 1);
  }
  ErrorSum& sum = steps[expected.next];
  sum.horizon_s = expected.times_s[expected.next];
  sum.position_m2 += (T_world_predicted.translation - T_world_observed.translation).squaredNorm();
  sum.rotation_rad2 += angle * angle;
  ++sum.num_samples;
}

// Comparisons come nearly in the order of time. One that is too late for its own slot goes to the oldest that is left.
ForecastCheck::Slot& ForecastCheck::slot_at(rigidformer::Stamp stamp) {
  const auto number =
      static_cast<std::int64_t>(std::floor(rigidformer::seconds_between({}, stamp) / window_s_ * kSlots));
  if (slots_.empty() || number > slots_.back().number) {
    slots_.push_back({number, {}});
  }
  while (slots_.front().number <= slots_.back().number - kSlots) {
    slots_.pop_front();
  }
  const auto later = std::find_if(slots_.rbegin(), slots_.rend(), [=](const Slot& s) { return s.number <= number; });
  return later == slots_.rend() ? slots_.front() : *later;
}

std::vector<HorizonError> ForecastCheck::errors() const {
  std::vector<ErrorSum> sums;
  for (const Slot& slot : slots_) {
    sums.resize(std::max(sums.size(), slot.steps.size()));
    for (std::size_t k = 0; k < slot.steps.size(); ++k) {
      sums[k].horizon_s = std::max(sums[k].horizon_s, slot.steps[k].horizon_s);
      sums[k].position_m2 += slot.steps[k].position_m2;
      sums[k].rotation_rad2 += slot.steps[k].rotation_rad2;
      sums[k].num_samples += slot.steps[k].num_samples;
    }
  }
  std::vector<HorizonError> errors;
  for (const ErrorSum& sum : sums) {
    if (sum.num_samples > 0) {
      const auto count = static_cast<double>(sum.num_samples);
      errors.push_back(
          {sum.horizon_s, std::sqrt(sum.position_m2 / count), std::sqrt(sum.rotation_rad2 / count), sum.num_samples});
    }
  }
  return errors;
}

void ForecastCheck::reset() {
  expectations_.clear();
  num_kept_poses_ = 0;
  slots_.clear();
}

ForecastError to_message(const ForecastQuality& quality, double window_s) {
  ForecastError message;
  for (const HorizonError& error : quality.errors) {
    message.horizons.push_back(error.horizon_s);
    message.position_rmse.push_back(error.position_rmse_m);
    message.rotation_rmse.push_back(error.rotation_rmse_rad);
    message.num_samples.push_back(error.num_samples);
  }
  message.window = window_s;
  message.trusted_horizon = quality.trusted_horizon_s;
  return message;
}

double trusted_horizon_s(const std::vector<HorizonError>& errors, double max_position_m, double max_rotation_rad) {
  double horizon_s = 0.0;
  for (const HorizonError& error : errors) {
    if (error.num_samples < kMinSamples || error.position_rmse_m > max_position_m ||
        error.rotation_rmse_rad > max_rotation_rad) {
      break;
    }
    horizon_s = error.horizon_s;
  }
  return horizon_s;
}

}  // namespace rigidformer_ros
