// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/forecast/inference_worker.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rigidformer_ros {

InferenceWorker::InferenceWorker(PredictorFactory make_predictor)
    : thread_([this, make = std::move(make_predictor)] { live(make); }) {}

InferenceWorker::~InferenceWorker() {
  stop();
  thread_.join();
}

void InferenceWorker::stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
    lanes_ = {};
  }
  wake_.notify_all();
}

InferenceWorker::State InferenceWorker::state() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_;
}

std::string InferenceWorker::message() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  switch (state_) {
    case State::kLoading:
      return "the model is being loaded and warmed up";
    case State::kFailed:
      return "the model could not be loaded: " + error_;
    default:
      return "";
  }
}

rigidformer::ModelInfo InferenceWorker::info() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ != State::kReady) {
    throw std::logic_error("no model information before the model is ready");
  }
  return info_;
}

void InferenceWorker::add_job(Job job, JobLane lane) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (state_ != State::kReady) {
      throw std::logic_error("no prediction before the model is ready");
    }
    if (stopping_) {
      throw std::logic_error("no prediction while the node shuts down");
    }
    lanes_.at(static_cast<std::size_t>(lane)).push_back(std::move(job));
  }
  wake_.notify_all();
}

void InferenceWorker::load(const PredictorFactory& make_predictor) {
  State outcome = State::kReady;
  std::string error;
  rigidformer::ModelInfo info;
  try {
    predictor_ = make_predictor();
    predictor_->warm_up();
    info = predictor_->info();
  } catch (const std::exception& failure) {
    outcome = State::kFailed;
    error = failure.what();
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  info_ = info;
  error_ = error;
  state_ = outcome;
}

bool InferenceWorker::has_job() const {
  return std::any_of(lanes_.begin(), lanes_.end(), [](const std::deque<Job>& jobs) { return !jobs.empty(); });
}

InferenceWorker::Job InferenceWorker::take_job() {
  next_lane_ = lanes_.at(next_lane_).empty() ? 1 - next_lane_ : next_lane_;
  std::deque<Job>& jobs = lanes_.at(next_lane_);
  next_lane_ = 1 - next_lane_;
  Job job = std::move(jobs.front());
  jobs.pop_front();
  return job;
}

void InferenceWorker::live(const PredictorFactory& make_predictor) {
  load(make_predictor);
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return stopping_ || has_job(); });
    if (stopping_) {
      return;
    }
    Job job = take_job();
    lock.unlock();
    job(*predictor_);
    job = nullptr;
    lock.lock();
  }
}

}  // namespace rigidformer_ros
