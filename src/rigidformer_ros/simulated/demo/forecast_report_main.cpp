// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "rigidformer_ros/simulated/demo/forecast_report.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "forecast_report", ros::init_options::AnonymousName);
  ros::NodeHandle node;
  rigidformer_ros::demo::ForecastReport report(node);
  if (!report.listen(ros::NodeHandle("~").param("timeout", 180.0))) {
    std::fprintf(stderr, "forecast_report: %s\n", report.missing().c_str());
    return 1;
  }
  std::printf("%s", report.text().c_str());
  return 0;
}
