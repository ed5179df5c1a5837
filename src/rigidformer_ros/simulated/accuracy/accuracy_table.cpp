// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "rigidformer_ros/simulated/accuracy/tracking_accuracy.hpp"

namespace rigidformer_ros::camera {
namespace {

template <typename... Args>
std::string print(const char* format, Args... args) {
  char line[300];
  std::snprintf(line, sizeof(line), format, args...);
  return line;
}

}  // namespace

double Errors::mean() const {
  return values.empty() ? 0.0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double Errors::quantile(double fraction) const {
  if (values.empty()) {
    return 0.0;
  }
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  return sorted[static_cast<std::size_t>(fraction * static_cast<double>(sorted.size() - 1))];
}

std::string accuracy_table(const std::vector<MethodAccuracy>& methods, const AccuracyOptions& options) {
  std::string text =
      print("Tracked pose of objects with at least %.0f %% of their surface in view\n", 100.0 * options.min_visible);
  text += print("%-13s %7s %7s   %-25s   %-25s   %s\n", "method", "poses", "tracks", "position mean p50 p95 [mm]",
                "rotation mean p50 p95 [deg]", "within 1 cm, 3 deg");
  for (const MethodAccuracy& m : methods) {
    constexpr double kDegrees = 180.0 / M_PI;
    text += print("%-13s %7zu %7d   %8.2f %8.2f %8.2f   %8.2f %8.2f %8.2f   %17.1f %%\n", m.method.c_str(),
                  m.position_m.values.size(), m.num_tracks, 1e3 * m.position_m.mean(), 1e3 * m.position_m.quantile(0.5),
                  1e3 * m.position_m.quantile(0.95), kDegrees * m.rotation_rad.mean(),
                  kDegrees * m.rotation_rad.quantile(0.5), kDegrees * m.rotation_rad.quantile(0.95),
                  100.0 * m.within_target);
  }
  for (std::size_t h = 0; h < options.horizons_s.size(); ++h) {
    text += print("\nForecast position error after %.2f s: all objects, and those in view\n", options.horizons_s[h]);
    text +=
        print("%-13s %7s   %-19s   %7s   %s\n", "method", "number", "mean, median [m]", "number", "mean, median [m]");
    for (const MethodAccuracy& m : methods) {
      text += print("%-13s %7zu   %9.4f %9.4f   %7zu   %9.4f %9.4f\n", m.method.c_str(), m.forecast_m[h].values.size(),
                    m.forecast_m[h].mean(), m.forecast_m[h].quantile(0.5), m.forecast_seen_m[h].values.size(),
                    m.forecast_seen_m[h].mean(), m.forecast_seen_m[h].quantile(0.5));
    }
  }
  return text;
}

}  // namespace rigidformer_ros::camera
