// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/node/process_end.hpp"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/this_node.h>
#include <ros/time.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace rigidformer_ros {

namespace {

// Time that the node has for an orderly end; chosen by eye. In 60 interrupts at random moments it took 0.5 s at most
// (docs/reliability.md).
constexpr std::chrono::milliseconds kTidyUpLimit(1000);
// Time between two looks for an interrupt; chosen by eye, short beside kTidyUpLimit.
constexpr std::chrono::milliseconds kInterruptPoll(50);
// [s] of wall time between two looks for a shutdown; chosen by eye, short beside kTidyUpLimit.
constexpr double kShutdownPoll = 0.05;
// Looks for a shutdown per question to the master, which is thus asked every 2 s; chosen by eye.
constexpr int kPollsPerMasterCheck = 40;

// A signal handler may set this flag, because it needs no lock.
std::atomic<bool> interrupted{false};

void on_interrupt(int signal) {
  interrupted = true;
  std::signal(signal, SIG_DFL);  // A second interrupt ends the process at once.
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

ShutdownLimit::ShutdownLimit() : thread_([this] { run(); }) {}

ShutdownLimit::~ShutdownLimit() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void ShutdownLimit::start(int exit_code) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    started_ = true;
    exit_code_ = exit_code;
  }
  changed_.notify_all();
}

void ShutdownLimit::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!started_ && !done_ && !interrupted) {
    changed_.wait_for(lock, kInterruptPoll);  // It must look again: a signal handler is not allowed to notify it.
  }
  if (!changed_.wait_for(lock, kTidyUpLimit, [this] { return done_; })) {
    std::fputs("prediction_node: something cannot be interrupted, ending anyway\n", stderr);
    std::_Exit(exit_code_);
  }
}

void catch_interrupt() { std::signal(SIGINT, on_interrupt); }

int wait_for_end() {
  MasterState last = MasterState::kKnowsNode;
  for (int poll = 1; !interrupted && !ros::isShuttingDown(); ++poll) {
    ros::WallDuration(kShutdownPoll).sleep();
    if (poll % kPollsPerMasterCheck != 0) {
      continue;
    }
    const MasterState state = ask_master();
    if (state == MasterState::kForgotNode && !interrupted && !ros::isShuttingDown()) {
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
