// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace rigidformer_ros {

/// Ends the process when it is still there 1 s of wall time after SIGINT (see catch_interrupt()) or start(). Three
/// things cannot be interrupted: the loading of a model, a job of the network, and a call of a master that does not
/// answer. No file is left half-written by this, because the node writes none.
class ShutdownLimit {
 public:
  ShutdownLimit();
  /// Gives up the limit: the process has ended in an orderly way.
  ~ShutdownLimit();
  ShutdownLimit(const ShutdownLimit&) = delete;
  ShutdownLimit& operator=(const ShutdownLimit&) = delete;

  /// Starts the time limit and sets the exit code of a process that exceeds it. Without a call the code is 0.
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

/// Makes SIGINT end wait_for_end() with exit code 0, so that the main thread shuts ROS down. This replaces the handler
/// of roscpp, which leaves the shutdown to a thread of its own that nobody waits for at the end of the process. It must
/// be called after ROS has started, because ROS sets its handler then.
void catch_interrupt();

/// Waits for SIGINT, or until ROS begins to shut down, and then returns 0. A master that is away is waited for. When a
/// restarted master does not know this node, the function says so and returns 1: the parameters and registrations of
/// the node went with the old master.
int wait_for_end();

}  // namespace rigidformer_ros
