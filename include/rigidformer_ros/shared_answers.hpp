// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <future>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace rigidformer_ros {

/// Lets callers with the same question share one answer, as long as nobody has begun to work it out: an answer is never
/// older than the question. May be used from any thread.
template <typename Answer>
class SharedAnswers {
 public:
  /// Empty: whoever should have answered gave up.
  using Result = std::optional<Answer>;

  struct Place {
    bool leads;  ///< The first one: has to make a Lead
    std::shared_future<Result> result;
  };

  /// What the first one holds while it works: whatever happens to it, nobody waits for ever.
  class Lead {
   public:
    Lead(SharedAnswers& answers, std::string question) : answers_(answers), question_(std::move(question)) {}
    ~Lead() {
      begin();
      promise_->set_value(std::move(result_));
    }
    Lead(const Lead&) = delete;
    Lead& operator=(const Lead&) = delete;

    /// Whoever asks from now on waits for the next answer.
    void begin() {
      if (!promise_) promise_ = answers_.close(question_);
    }

    /// For those who asked before begin(); handed out at the end of the scope.
    void answer(Answer answer) { result_ = std::move(answer); }

   private:
    SharedAnswers& answers_;
    std::string question_;
    std::optional<std::promise<Result>> promise_;
    Result result_;
  };

  /// Waits with all who ask the same.
  Place join(const std::string& question) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = waiting_.find(question);
    if (found != waiting_.end()) {
      return {false, found->second.result};
    }
    Waiting waiting;
    waiting.result = waiting.promise.get_future().share();
    Place place{true, waiting.result};
    waiting_.emplace(question, std::move(waiting));
    return place;
  }

 private:
  struct Waiting {
    std::promise<Result> promise;
    std::shared_future<Result> result;
  };

  std::promise<Result> close(const std::string& question) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::move(waiting_.extract(question).mapped().promise);
  }

  std::mutex mutex_;
  std::map<std::string, Waiting> waiting_;
};

}  // namespace rigidformer_ros
