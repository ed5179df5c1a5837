// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "rigidformer_ros/forecast/forecast_messages.hpp"
#include "still_scene.hpp"

namespace {

using rigidformer_ros::ObjectForecast;

constexpr double kDegrees = 180.0 / M_PI;

template <typename... Args>
std::string print(const char* format, Args... args) {
  char line[200];
  std::snprintf(line, sizeof(line), format, args...);
  return line;
}

const char* name_of(std::uint8_t status) {
  switch (status) {
    case ObjectForecast::OK:
      return "OK";
    case ObjectForecast::ASSUMED_STATIC:
      return "ASSUMED_STATIC";
    case ObjectForecast::LOW_QUALITY:
      return "LOW_QUALITY";
    case ObjectForecast::DIVERGED:
      return "DIVERGED";
    case ObjectForecast::INCOMPLETE:
      return "INCOMPLETE";
    default:
      return "OUT_OF_RANGE";
  }
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

double percent(int part, int whole) { return 100.0 * part / std::max(1, whole); }

}  // namespace

std::string still_table(const StillReport& report) {
  std::string text = print("%-9s %9s %6s   %-23s   %-20s   %s\n", "object", "forecasts", "moved",
                           "moved p50 p95 max [mm]", "turned p50 p95 max [deg]", "status");
  for (const auto& [id, object] : report.objects) {
    const auto of = [](const std::vector<double>& values, double scale) {
      return print("%7.1f %7.1f %7.1f", scale * quantile(values, 0.5), scale * quantile(values, 0.95),
                   scale * quantile(values, 1.0));
    };
    std::string statuses;
    for (const auto& [status, number] : object.num_of_status) {
      statuses += (statuses.empty() ? "" : ", ") + std::to_string(number) + " " + name_of(status);
    }
    text += print("%-9s %9d %6d   %s   %s    ", id.c_str(), object.num_forecasts, object.num_moved,
                  of(object.moved_m, 1e3).c_str(), of(object.turned_rad, kDegrees).c_str()) +
            statuses + "\n";
  }
  return text + print("everything stands still in %.1f %% of %d forecasts, what has status OK in %.1f %%\n",
                      percent(report.num_still, report.num_forecasts), report.num_forecasts,
                      percent(report.num_ok_still, report.num_forecasts));
}
