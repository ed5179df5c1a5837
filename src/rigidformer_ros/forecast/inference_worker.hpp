// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "rigidformer/predictor.hpp"

namespace rigidformer_ros {

/// A function that makes the predictor. It may throw when the model cannot be loaded.
using PredictorFactory = std::function<std::unique_ptr<rigidformer::Predictor>()>;

/// The two queues of jobs: those of the forecast that the node publishes, and those of requests to the service.
enum class JobLane { kForecast, kRequest };

/// One long-lived thread that owns the predictor. It loads the model, warms it up and then runs jobs. While both lanes
/// have jobs, it takes one from each in turn; within a lane, the job that came first runs first. Requests hand in one
/// short job at a time, so they take turns with each other, and however many there are, every other turn is the
/// forecast's. All public functions may be called from any thread.
class InferenceWorker {
 public:
  enum class State { kLoading, kReady, kFailed };

  /// Starts the thread, which calls `make_predictor` first.
  explicit InferenceWorker(PredictorFactory make_predictor);
  /// Stops the worker and waits for the job in progress.
  ~InferenceWorker();
  InferenceWorker(const InferenceWorker&) = delete;
  InferenceWorker& operator=(const InferenceWorker&) = delete;

  /// Drops all waiting jobs and takes no new ones. The futures of dropped jobs throw std::future_error, so that whoever
  /// waits for them ends soon.
  void stop();

  State state() const;
  /// Says why the model is not usable; the text is empty when it is.
  std::string message() const;
  /// Describes the loaded model. Throws std::logic_error unless the state is kReady.
  rigidformer::ModelInfo info() const;

  /// Runs the job on the thread of the predictor. The future gives what the job returns or throws. Throws
  /// std::logic_error unless the state is kReady, and after stop().
  template <typename Job>
  auto run(Job job, JobLane lane) -> std::future<decltype(job(std::declval<rigidformer::Predictor&>()))> {
    using Result = decltype(job(std::declval<rigidformer::Predictor&>()));
    const auto task = std::make_shared<std::packaged_task<Result(rigidformer::Predictor&)>>(std::move(job));
    add_job([task](rigidformer::Predictor& predictor) { (*task)(predictor); }, lane);
    return task->get_future();
  }

 private:
  using Job = std::function<void(rigidformer::Predictor&)>;

  void live(const PredictorFactory& make_predictor);
  void load(const PredictorFactory& make_predictor);
  void add_job(Job job, JobLane lane);
  bool has_job() const;
  Job take_job();

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  State state_ = State::kLoading;
  std::string error_;
  rigidformer::ModelInfo info_;
  std::unique_ptr<rigidformer::Predictor> predictor_;
  std::array<std::deque<Job>, 2> lanes_;  ///< Waiting jobs of each JobLane
  std::size_t next_lane_ = 0;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace rigidformer_ros
