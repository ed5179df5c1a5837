// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace rigidformer_ros::testing {

/// A collection of waiting times [s] that can describe their distribution.
class Latencies {
 public:
  void add(double seconds) { seconds_.push_back(seconds); }
  void add(const Latencies& other) { seconds_.insert(seconds_.end(), other.seconds_.begin(), other.seconds_.end()); }
  std::size_t size() const { return seconds_.size(); }

  /// One line with the number of waiting times, their median, their 99th percentile and the longest [ms].
  std::string describe() const {
    if (seconds_.empty()) {
      return "none";
    }
    std::vector<double> sorted = seconds_;
    std::sort(sorted.begin(), sorted.end());
    const auto at = [&](double share) {
      return 1e3 * sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    };
    char line[120];
    std::snprintf(line, sizeof(line), "%zu, p50 %.1f ms, p99 %.1f ms, max %.1f ms", sorted.size(), at(0.5), at(0.99),
                  at(1.0));
    return line;
  }

 private:
  std::vector<double> seconds_;
};

}  // namespace rigidformer_ros::testing
