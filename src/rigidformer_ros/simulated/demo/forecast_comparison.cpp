// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/demo/forecast_comparison.hpp"

#include <algorithm>

namespace rigidformer_ros::demo {
namespace {

// [s]. Stamps are rounded to nanoseconds, so a time at the end of the list may seem to lie behind it.
constexpr double kTolerance = 1e-6;

Eigen::Vector3d position(const geometry_msgs::Pose& pose) {
  return {pose.position.x, pose.position.y, pose.position.z};
}

const ObjectForecast* find_object(const SceneForecast& scene, const std::string& id) {
  const auto found =
      std::find_if(scene.objects.begin(), scene.objects.end(), [&](const auto& object) { return object.id == id; });
  return found == scene.objects.end() ? nullptr : &*found;
}

}  // namespace

std::optional<Eigen::Vector3d> position_at(const std::vector<double>& times, const ObjectForecast& motion,
                                           double time) {
  if (times.empty() || motion.poses.size() != times.size() || time < times.front() - kTolerance ||
      time > times.back() + kTolerance) {
    return std::nullopt;
  }
  if (times.size() == 1) {
    return position(motion.poses.front());
  }
  const auto upper = std::upper_bound(times.begin() + 1, times.end() - 1, time);
  const std::size_t next = upper - times.begin();
  const double fraction = std::clamp((time - times[next - 1]) / (times[next] - times[next - 1]), 0.0, 1.0);
  return (1.0 - fraction) * position(motion.poses[next - 1]) + fraction * position(motion.poses[next]);
}

std::vector<Comparison> compare(const SceneForecast& forecast, const SceneForecast& truth,
                                const std::vector<double>& horizons_s, double gravity) {
  std::vector<Comparison> comparisons;
  const double t0 = (forecast.header.stamp - truth.header.stamp).toSec();  // The time of the forecast in the scene.
  for (const ObjectForecast& object : forecast.objects) {
    const ObjectForecast* actual = find_object(truth, object.id);
    if (actual == nullptr) {
      continue;
    }
    const auto before = position_at(truth.times, *actual, t0 - truth.time_step);
    const auto start = position_at(truth.times, *actual, t0);
    for (const double horizon : horizons_s) {
      const auto predicted = position_at(forecast.times, object, horizon);
      const auto arrived = position_at(truth.times, *actual, t0 + horizon);
      if (!before || !start || !predicted || !arrived) {
        continue;
      }
      const Eigen::Vector3d fall(0.0, 0.0, 0.5 * gravity * horizon * horizon);
      const Eigen::Vector3d ballistic = *start + (*start - *before) / truth.time_step * horizon + fall;
      comparisons.push_back({object.id, horizon, *predicted, *arrived, ballistic});
    }
  }
  return comparisons;
}

}  // namespace rigidformer_ros::demo
