// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace rigidformer_ros {

/// Counts what was rejected, by reason. Safe to call from any thread.
class RejectionLog {
 public:
  /// `detail` says what happened this time; the newest one is kept as the example.
  void add(const std::string& reason, const std::string& detail);

  /// One sentence per reason that occurred since the last call.
  std::vector<std::string> take_report();

  /// Rejections for `reason` since the start.
  std::uint64_t total(const std::string& reason) const;

 private:
  struct Count {
    std::uint64_t total = 0;
    std::uint64_t reported = 0;
    std::string detail;
  };

  mutable std::mutex mutex_;
  std::map<std::string, Count> counts_;
};

}  // namespace rigidformer_ros
