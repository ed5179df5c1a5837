// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace rigidformer {

/// One line of a training log.
struct LogEntry {
  std::int64_t iteration = 0;
  double loss = 0.0, gradient_norm = 0.0, learning_rate = 0.0;
  double windows_per_s = 0.0;
  /// Multiply-adds per second in products with weights, over what large matrix products reach.
  double share_of_peak = 0.0;
  int unroll_steps = 1;
};

/// Writes log.csv (appending when a run goes on), shows a progress line with the time left, and draws loss.svg with
/// gnuplot where that is installed.
class RunLog {
 public:
  RunLog(const std::filesystem::path& folder, std::int64_t total_iterations, bool append);

  void write(const LogEntry& entry);

  /// Writes a message on a line of its own, and to validation.log.
  void note(const std::string& message);

  void plot() const;

 private:
  std::filesystem::path folder_;
  std::int64_t total_iterations_, first_iteration_ = -1;
  std::chrono::steady_clock::time_point start_;
  std::ofstream csv_, notes_;
};

}  // namespace rigidformer
