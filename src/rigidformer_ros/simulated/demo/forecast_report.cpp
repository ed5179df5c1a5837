// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/demo/forecast_report.hpp"

#include <ros/callback_queue.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rigidformer_ros::demo {
namespace {

// [s] after the forecast, the shortest first; chosen by eye.
const std::vector<double> kHorizons{0.25, 0.5, 1.0};
// [s] into the scene: the time of the forecast in the table. Most objects are about to hit the floor then.
constexpr double kTableTime = 0.5;

template <typename... Args>
std::string print(const char* format, Args... args) {
  char line[200];
  std::snprintf(line, sizeof(line), format, args...);
  return line;
}

}  // namespace

ForecastReport::ForecastReport(ros::NodeHandle& node)
    : truth_subscriber_(node.subscribe("demo/truth", 2, &ForecastReport::on_truth, this)),
      forecast_subscriber_(node.subscribe("forecast", 10, &ForecastReport::on_forecast, this)) {}

bool ForecastReport::listen(double timeout_s) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout_s);
  while (ros::ok() && !scene_over_ && ros::WallTime::now() < deadline) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
  }
  return scene_over_;
}

std::string ForecastReport::missing() const {
  if (!has_truth_) {
    return "no scene was published (is demo_publisher waiting for the prediction node?)";
  }
  return print("the scene did not end; %zu forecasts of it were received", forecasts_.size());
}

void ForecastReport::on_truth(const SceneForecast& truth) {
  if (!forecasts_.empty()) {
    scene_over_ = true;
    return;
  }
  truth_ = truth;
  has_truth_ = true;
}

void ForecastReport::on_forecast(const SceneForecast& forecast) {
  if (scene_over_ || !has_truth_ || forecast.header.stamp <= truth_.header.stamp || forecast.objects.empty()) {
    return;
  }
  if (compare(forecast, truth_, {kHorizons.front()}).empty()) {
    scene_over_ = !forecasts_.empty();  // The rest of the scene is too short for even the shortest horizon.
    return;
  }
  forecasts_.push_back(forecast);
}

std::string ForecastReport::text() const { return table() + mean_errors(); }

std::string ForecastReport::table() const {
  const auto time_in_scene = [this](const SceneForecast& forecast) {
    return (forecast.header.stamp - truth_.header.stamp).toSec();
  };
  const auto chosen = std::min_element(forecasts_.begin(), forecasts_.end(), [&](const auto& a, const auto& b) {
    return std::abs(time_in_scene(a) - kTableTime) < std::abs(time_in_scene(b) - kTableTime);
  });
  std::string text = print("Forecast made %.2f s into the scene by %s (positions in metres):\n", time_in_scene(*chosen),
                           chosen->model_id.c_str());
  text += print("%-12s %7s   %-24s   %-24s   %7s\n", "object", "after", "predicted x y z", "true x y z", "error");
  for (const Comparison& c : compare(*chosen, truth_, kHorizons)) {
    text +=
        print("%-12s %5.2f s   %7.3f %7.3f %7.3f    %7.3f %7.3f %7.3f    %7.3f\n", c.id.c_str(), c.horizon_s,
              c.predicted.x(), c.predicted.y(), c.predicted.z(), c.actual.x(), c.actual.y(), c.actual.z(), c.error_m());
  }
  return text;
}

std::string ForecastReport::mean_errors() const {
  std::string text =
      print("\nMean position error over all objects and %zu forecasts of the scene:\n", forecasts_.size());
  text += print("%7s   %10s   %s\n", "after", "predicted", "ballistic guess (no contacts)");
  for (const double horizon : kHorizons) {
    double error = 0.0, ballistic = 0.0;
    int count = 0;
    for (const SceneForecast& forecast : forecasts_) {
      for (const Comparison& c : compare(forecast, truth_, {horizon})) {
        error += c.error_m();
        ballistic += c.ballistic_error_m();
        ++count;
      }
    }
    if (count > 0) {
      text += print("%5.2f s   %8.3f m   %8.3f m\n", horizon, error / count, ballistic / count);
    }
  }
  return text;
}

}  // namespace rigidformer_ros::demo
