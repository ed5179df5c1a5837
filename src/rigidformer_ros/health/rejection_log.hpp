// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace rigidformer_ros {

/// The reason under which clouds are counted that could not be brought into the fixed frame.
inline constexpr char kNoTransform[] = "no transform";
/// The reason under which forecasts are counted that ended in an error.
inline constexpr char kFailedForecast[] = "failed forecast";
/// Reason of objects that cannot be predicted.
inline constexpr char kUnusableObject[] = "unusable object";

/// Counts what was rejected, and what was used but is worth a line, by reason. Safe to call from any thread.
class RejectionLog {
 public:
  /// Counts one case. `detail` says what happened this time; the newest detail of a reason is kept as its example.
  void add(const std::string& reason, const std::string& detail) { count(reason, detail, /*was_rejected=*/true); }

  /// Counts one case of something that was used all the same.
  void note(const std::string& reason, const std::string& detail) { count(reason, detail, /*was_rejected=*/false); }

  /// Gives one sentence for every reason that occurred since the last call.
  std::vector<std::string> take_report();

  struct Count {
    std::uint64_t total = 0;     ///< Cases since the start
    std::uint64_t reported = 0;  ///< Cases that a report has told of already
    std::string detail;          ///< What happened in the newest case
    bool was_rejected = true;    ///< False for what was used all the same
  };

  /// All counts since the start, by reason.
  std::map<std::string, Count> counts() const;

 private:
  void count(const std::string& reason, const std::string& detail, bool was_rejected);

  mutable std::mutex mutex_;
  std::map<std::string, Count> counts_;
};

}  // namespace rigidformer_ros
