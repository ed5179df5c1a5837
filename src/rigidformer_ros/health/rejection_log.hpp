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

/// Counts what was rejected, and what was used but is worth a line, by reason. Safe to call from any thread.
class RejectionLog {
 public:
  /// `detail` says what happened this time; the newest one is kept as the example.
  void add(const std::string& reason, const std::string& detail) { count(reason, detail, /*was_rejected=*/true); }

  /// Likewise for what was used all the same.
  void note(const std::string& reason, const std::string& detail) { count(reason, detail, /*was_rejected=*/false); }

  /// One sentence per reason that occurred since the last call.
  std::vector<std::string> take_report();

  struct Count {
    std::uint64_t total = 0;     ///< Since the start
    std::uint64_t reported = 0;  ///< Of these, in a report already
    std::string detail;          ///< Of the newest
    bool was_rejected = true;
  };

  /// By reason.
  std::map<std::string, Count> counts() const;

 private:
  void count(const std::string& reason, const std::string& detail, bool was_rejected);

  mutable std::mutex mutex_;
  std::map<std::string, Count> counts_;
};

}  // namespace rigidformer_ros
