// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/batch.hpp"
#include "rigidformer/training/options.hpp"

namespace rigidformer {

/// Learning rate at `progress` in [0, 1]: linear warm-up from 10 %, then cosine to the final rate (App. C.1).
double learning_rate_at(const OptimizerOptions& options, double progress);

/// AdamW with gradient clipping and weight averaging over one flat buffer that all parameters of a module share: a few
/// kernels per step instead of thousands, and one tensor per quantity to save or to reduce across processes. The step
/// follows Loshchilov & Hutter (decoupled weight decay on matrices only).
class FlatAdamW {
 public:
  /// Moves the parameters of `module` into the shared buffer. The module must already be on its device.
  FlatAdamW(torch::nn::Module& module, const OptimizerOptions& options);

  void zero_gradient();

  /// All gradients as one tensor, which several processes can sum up.
  Tensor& gradient() { return gradient_; }

  /// Updates the weights once with the current gradient; a non-finite gradient counts as zero. Returns the norm of the
  /// gradient before clipping, as a tensor, so that nothing waits for the device.
  Tensor step(double learning_rate);

  /// The quantities with which a resumed run continues exactly: name -> flat tensor.
  std::vector<std::pair<std::string, Tensor>> state() const;

  /// Exchanges the weights of the module with their running average; a second call exchanges them back.
  void swap_average();

  std::int64_t num_steps = 0;

 private:
  OptimizerOptions options_;
  Tensor weights_, gradient_, first_moment_, second_moment_, average_, decay_mask_;
};

}  // namespace rigidformer
