// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

namespace rigidformer_ros {

/// How many clients have a request that is being answered or waits. All services share one.
class ClientCount {
 public:
  /// Counts a client as present for the length of a scope.
  class Presence {
   public:
    explicit Presence(ClientCount& clients) : clients_(clients), number_(++clients.count_) {}
    ~Presence() { --clients_.count_; }
    Presence(const Presence&) = delete;
    Presence& operator=(const Presence&) = delete;

    /// The number of clients that were present when this one came, with itself.
    int number() const { return number_; }

   private:
    ClientCount& clients_;
    int number_;
  };

 private:
  std::atomic<int> count_{0};
};

}  // namespace rigidformer_ros
