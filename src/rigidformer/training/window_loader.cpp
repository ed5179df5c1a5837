// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/window_loader.hpp"

namespace rigidformer {

WindowBatch WindowLoader::take(const BatchRequest& request, const BatchRequest& next) {
  const bool is_ahead =
      ahead_.valid() && ahead_request_.number == request.number && ahead_request_.num_steps == request.num_steps;
  WindowBatch batch = is_ahead ? ahead_.get() : assemble(request);
  ahead_request_ = next;
  ahead_ = std::async(std::launch::async, [this, next] { return assemble(next); });
  return batch;
}

WindowBatch WindowLoader::assemble(const BatchRequest& request) const {
  const std::vector<Window> windows =
      data_.sampler->draw_batch(options_.batch_size, request.num_steps, options_.seed, request.number);
  const TensorRandom random(data_.training.poses.device(),
                            options_.seed * 1000003 + static_cast<std::uint64_t>(request.number));
  return make_window_batch(data_.training, windows, request.num_steps, options_.model.num_anchors,
                           options_.augmentation, options_.model.random_anchors, random);
}

}  // namespace rigidformer
