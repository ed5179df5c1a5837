// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace rigidformer_ros {

/// Reason of clouds that could not be brought into the fixed frame.
inline constexpr char kNoTransform[] = "no transform";
/// Reason of forecasts that ended in an error.
inline constexpr char kFailedForecast[] = "failed forecast";
/// Reason of objects that cannot be predicted.
inline constexpr char kUnusableObject[] = "unusable object";

/// Counts what was rejected, by reason. Safe to call from any thread.
class RejectionLog {
 public:
  /// `detail` says what happened this time; the newest one is kept as the example.
  void add(const std::string& reason, const std::string& detail);

  /// One sentence per reason that occurred since the last call.
  std::vector<std::string> take_report();

  struct Count {
    std::uint64_t total = 0;     ///< Since the start
    std::uint64_t reported = 0;  ///< Of these, in a report already
    std::string detail;          ///< Of the newest
  };

  /// By reason.
  std::map<std::string, Count> counts() const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, Count> counts_;
};

}  // namespace rigidformer_ros
