// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <ostream>

namespace rigidformer {

/// Calls `work(i)` for i in [0, count) on `jobs` threads. The first exception stops the rest and is thrown again.
void parallel_for(int count, int jobs, const std::function<void(int)>& work);

/// A line with a bar, the rate and the time left, rewritten in place at most twice a second. It is thread safe.
class Progress {
 public:
  Progress(int total, std::ostream& log);

  void advance();        ///< Counts one more item as made
  void skip(int count);  ///< Counts items that were there already; they are left out of the rate
  void finish();         ///< Ends the line

 private:
  using Clock = std::chrono::steady_clock;
  void print(Clock::time_point now);

  const int total_;
  std::ostream& log_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point last_print_;
  int made_ = 0;
  int skipped_ = 0;
  std::mutex mutex_;
};

}  // namespace rigidformer
