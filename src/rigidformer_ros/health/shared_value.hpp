// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <utility>

namespace rigidformer_ros {

/// A value that one thread hands to others. They always see a whole value, never one that is being written.
template <class T>
class SharedValue {
 public:
  explicit SharedValue(T value = {}) : value_(std::move(value)) {}

  T get() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return value_;
  }

  void set(T value) {
    const std::lock_guard<std::mutex> lock(mutex_);
    value_ = std::move(value);
  }

 private:
  mutable std::mutex mutex_;
  T value_;
};

}  // namespace rigidformer_ros
