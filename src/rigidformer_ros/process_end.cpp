// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/process_end.hpp"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/this_node.h>
#include <ros/time.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace rigidformer_ros {

namespace {

constexpr std::chrono::milliseconds kTidyUpLimit(1500);
constexpr double kShutdownPoll = 0.05;  // [s] wall time
constexpr int kPollsPerMasterCheck = 40;

volatile std::sig_atomic_t interrupted = 0;

void on_interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);  // The second one ends the process where it stands
}

enum class MasterState { kKnowsNode, kUnreachable, kForgotNode };

MasterState ask_master() {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue uri;
  request[0] = ros::this_node::getName();
  request[1] = ros::this_node::getName();
  if (ros::master::execute("lookupNode", request, response, uri, /*wait_for_master=*/false)) {
    return MasterState::kKnowsNode;
  }
  return response.valid() ? MasterState::kForgotNode : MasterState::kUnreachable;
}

}  // namespace

ShutdownLimit::~ShutdownLimit() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ = true;
  }
  tidied_up_.notify_all();
  if (thread_.joinable()) {
    thread_.join();
  }
}

void ShutdownLimit::start(int exit_code) {
  thread_ = std::thread([this, exit_code] {
    std::unique_lock<std::mutex> lock(mutex_);
    if (!tidied_up_.wait_for(lock, kTidyUpLimit, [this] { return done_; })) {
      std::fputs("prediction_node: the model is still busy, ending anyway\n", stderr);
      std::_Exit(exit_code);
    }
  });
}

void catch_interrupt() { std::signal(SIGINT, on_interrupt); }

int wait_for_end() {
  MasterState last = MasterState::kKnowsNode;
  for (int poll = 1; interrupted == 0 && !ros::isShuttingDown(); ++poll) {
    ros::WallDuration(kShutdownPoll).sleep();
    if (poll % kPollsPerMasterCheck != 0) {
      continue;
    }
    const MasterState state = ask_master();
    if (state == MasterState::kForgotNode && interrupted == 0 && !ros::isShuttingDown()) {
      ROS_FATAL_STREAM("The ROS master was restarted and does not know " << ros::this_node::getName()
                                                                         << ": launch the node again.");
      return EXIT_FAILURE;
    }
    if (state == MasterState::kUnreachable && last == MasterState::kKnowsNode) {
      ROS_WARN("The ROS master is away: present connections go on, new ones have to wait for it.");
    }
    last = state;
  }
  return EXIT_SUCCESS;
}

}  // namespace rigidformer_ros
