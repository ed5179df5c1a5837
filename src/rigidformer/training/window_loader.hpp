// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <future>

#include "rigidformer/training/training_data.hpp"
#include "rigidformer/windows/window_batch.hpp"

namespace rigidformer {

/// The windows that are wanted: all randomness of a batch follows from its number and the run's seed.
struct BatchRequest {
  std::int64_t number = 0;
  int num_steps = 1;  ///< Steps that are unrolled
};

/// Assembles the windows of training on a thread of its own, one batch ahead, so that the device does not wait.
class WindowLoader {
 public:
  /// `data` must outlive the loader.
  WindowLoader(const TrainingData& data, const TrainingOptions& options) : data_(data), options_(options) {}

  /// Returns the windows of `request` and begins those of `next`.
  WindowBatch take(const BatchRequest& request, const BatchRequest& next);

 private:
  WindowBatch assemble(const BatchRequest& request) const;

  const TrainingData& data_;
  TrainingOptions options_;
  BatchRequest ahead_request_;
  std::future<WindowBatch> ahead_;
};

}  // namespace rigidformer
