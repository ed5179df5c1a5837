// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace rigidformer {

/// Prints the usual table and, at the end, how many times faster each benchmark was than the alternative that it names.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  /// Compares two benchmarks; `fast` and `reference` are their names.
  static void compare(const std::string& fast, const std::string& reference);

  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

 private:
  std::map<std::string, double> seconds_;  ///< Shortest real time per iteration
};

}  // namespace rigidformer
