// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace rigidformer_ros {

/// Ends the process when it is still there 1 s of wall time after SIGINT (see catch_interrupt()) or start(): the
/// loading of a model, a job of the network and a call of a master that does not answer cannot be interrupted. Nothing
/// on disk is half-written then, as the node writes no files.
class ShutdownLimit {
 public:
  ShutdownLimit();
  /// Nothing is left to be ended.
  ~ShutdownLimit();
  ShutdownLimit(const ShutdownLimit&) = delete;
  ShutdownLimit& operator=(const ShutdownLimit&) = delete;

  /// Without it the exit code is 0.
  void start(int exit_code);

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  bool started_ = false;
  bool done_ = false;
  int exit_code_ = 0;
  std::thread thread_;
};

/// From now on SIGINT ends wait_for_end() with exit code 0, so that the main thread shuts ROS down. The handler of
/// roscpp, replaced here, leaves that to a thread of its own, which nobody waits for at the end of the process. Call it
/// after ROS has started.
void catch_interrupt();

/// Waits for SIGINT, or until ROS begins to shut down: exit code 0. When a restarted master does not know this node,
/// whose parameters and registrations went with the old one, says so and returns 1. A master that is away is waited
/// for.
int wait_for_end();

}  // namespace rigidformer_ros
