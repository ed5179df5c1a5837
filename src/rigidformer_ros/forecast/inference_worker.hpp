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

#include "rigidformer/predictor.hpp"

namespace rigidformer_ros {

/// Makes the predictor; may throw when the model cannot be loaded.
using PredictorFactory = std::function<std::unique_ptr<rigidformer::Predictor>()>;

/// Whose a job is.
enum class JobLane { kForecast, kRequest };

/// One long-lived thread that owns the predictor: it loads the model, warms it up and then runs jobs in the order in
/// which they come, alternately of each lane that has any: requests that hand in one short job at a time take turns,
/// and however many they are, every other turn is the forecast's.
/// All public functions may be called from any thread.
class InferenceWorker {
 public:
  enum class State { kLoading, kReady, kFailed };

  explicit InferenceWorker(PredictorFactory make_predictor);
  /// Waits for the job in progress.
  ~InferenceWorker();
  InferenceWorker(const InferenceWorker&) = delete;
  InferenceWorker& operator=(const InferenceWorker&) = delete;

  /// Takes no more jobs: those still waiting get a broken promise, so that whoever waits for them ends soon.
  void stop();

  State state() const;
  /// Why the model is not usable; empty when it is.
  std::string message() const;
  /// Of the loaded model. Throws std::logic_error unless the state is kReady.
  rigidformer::ModelInfo info() const;

  /// Runs the job on the thread of the predictor; the future gives what it returns or throws. Throws std::logic_error
  /// unless the state is kReady.
  std::future<rigidformer::Forecast> run(std::function<rigidformer::Forecast(rigidformer::Predictor&)> job,
                                         JobLane lane);

 private:
  using Job = std::packaged_task<rigidformer::Forecast()>;

  void live(const PredictorFactory& make_predictor);
  void load(const PredictorFactory& make_predictor);
  bool has_job() const;
  Job take_job();

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  State state_ = State::kLoading;
  std::string error_;
  rigidformer::ModelInfo info_;
  std::unique_ptr<rigidformer::Predictor> predictor_;
  std::array<std::deque<Job>, 2> lanes_;  ///< By JobLane
  std::size_t next_lane_ = 0;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace rigidformer_ros
