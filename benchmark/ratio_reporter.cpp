// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ratio_reporter.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace rigidformer {
namespace {

using Comparison = std::pair<std::string, std::string>;

std::vector<Comparison>& comparisons() {
  static std::vector<Comparison> list;
  return list;
}

}  // namespace

void RatioReporter::compare(const std::string& fast, const std::string& reference) {
  comparisons().emplace_back(fast, reference);
}

void RatioReporter::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.run_type == Run::RT_Iteration && !run.error_occurred && run.iterations > 0) {
      const double seconds = run.real_accumulated_time / static_cast<double>(run.iterations);
      const auto [entry, is_new] = seconds_.emplace(run.run_name.function_name, seconds);
      entry->second = is_new ? seconds : std::min(entry->second, seconds);
    }
  }
  ConsoleReporter::ReportRuns(runs);
}

void RatioReporter::Finalize() {
  ConsoleReporter::Finalize();
  std::printf("\n%-44s %12s   %-40s %12s %8s\n", "benchmark", "ms", "alternative", "ms", "ratio");
  for (const auto& [fast, reference] : comparisons()) {
    if (seconds_.count(fast) != 0 && seconds_.count(reference) != 0) {
      std::printf("%-44s %12.3f   %-40s %12.3f %7.1fx\n", fast.c_str(), 1e3 * seconds_[fast], reference.c_str(),
                  1e3 * seconds_[reference], seconds_[reference] / seconds_[fast]);
    }
  }
}

}  // namespace rigidformer
