// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/health/rejection_log.hpp"

namespace rigidformer_ros {

void RejectionLog::count(const std::string& reason, const std::string& detail, bool was_rejected) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Count& count = counts_[reason];
  ++count.total;
  count.detail = detail;
  count.was_rejected = was_rejected;
}

std::vector<std::string> RejectionLog::take_report() {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<std::string> lines;
  for (auto& [reason, count] : counts_) {
    if (count.total > count.reported) {
      lines.push_back((count.was_rejected ? "Rejected, " : "Noticed, ") + reason + ": " +
                      std::to_string(count.total - count.reported) + " (in all " + std::to_string(count.total) +
                      "); last: " + count.detail);
      count.reported = count.total;
    }
  }
  return lines;
}

std::map<std::string, RejectionLog::Count> RejectionLog::counts() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return counts_;
}

}  // namespace rigidformer_ros
