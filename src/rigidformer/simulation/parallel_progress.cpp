// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_progress.hpp"

#include <atomic>
#include <cstdio>
#include <exception>
#include <string>
#include <thread>
#include <vector>

namespace rigidformer {
namespace {

constexpr int kBarWidth = 30;  // characters; chosen by eye
constexpr std::chrono::milliseconds kPrintInterval(500);

std::string format_duration(double seconds) {
  const int whole = static_cast<int>(seconds + 0.5);
  char text[32];
  std::snprintf(text, sizeof(text), "%d:%02d:%02d", whole / 3600, whole / 60 % 60, whole % 60);
  return text;
}

}  // namespace

void parallel_for(int count, int jobs, const std::function<void(int)>& work) {
  std::atomic<int> next{0};
  std::exception_ptr error;
  std::mutex error_mutex;
  const auto run = [&] {
    for (int i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(error_mutex);
        if (!error) error = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> threads;
  for (int job = 1; job < jobs; ++job) threads.emplace_back(run);
  run();
  for (std::thread& thread : threads) thread.join();
  if (error) std::rethrow_exception(error);
}

Progress::Progress(int total, std::ostream& log) : total_(total), log_(log), last_print_(start_) {}

void Progress::advance() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++made_;
  const Clock::time_point now = Clock::now();
  if (now - last_print_ >= kPrintInterval) print(now);
}

void Progress::skip(int count) {
  const std::lock_guard<std::mutex> lock(mutex_);
  skipped_ += count;
}

void Progress::finish() {
  const std::lock_guard<std::mutex> lock(mutex_);
  print(Clock::now());
  log_ << std::endl;
}

void Progress::print(Clock::time_point now) {
  last_print_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = seconds > 0.0 ? made_ / seconds : 0.0;
  const int done = made_ + skipped_;
  const int filled = kBarWidth * done / total_;
  char numbers[96];
  std::snprintf(numbers, sizeof(numbers), "] %d/%d scenes  %.1f/s  ", done, total_, rate);
  const std::string time = done == total_ ? "took " + format_duration(seconds)
                           : rate > 0.0   ? "ETA " + format_duration((total_ - done) / rate)
                                          : "ETA unknown";
  log_ << "\r[" << std::string(static_cast<std::size_t>(filled), '=')
       << std::string(static_cast<std::size_t>(kBarWidth - filled), ' ') << numbers << time << "   " << std::flush;
}

}  // namespace rigidformer
