// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/optimizer.hpp"

#include <algorithm>
#include <cmath>

namespace rigidformer {

double learning_rate_at(const OptimizerOptions& options, double progress) {
  if (progress < options.warmup) {
    return options.learning_rate * (0.1 + 0.9 * progress / options.warmup);
  }
  const double phase = std::min(1.0, (progress - options.warmup) / std::max(1e-12, 1.0 - options.warmup));
  const double range = options.learning_rate - options.final_learning_rate;
  return options.final_learning_rate + 0.5 * range * (1.0 + std::cos(M_PI * phase));
}

FlatAdamW::FlatAdamW(torch::nn::Module& module, const OptimizerOptions& options) : options_(options) {
  torch::NoGradGuard no_grad;
  const std::vector<Tensor> parameters = module.parameters();
  std::int64_t total = 0;
  for (const Tensor& parameter : parameters) total += parameter.numel();
  const auto like = parameters.front().options().requires_grad(false);
  weights_ = torch::empty({total}, like);
  gradient_ = torch::zeros({total}, like);
  decay_mask_ = torch::zeros({total}, like);
  std::int64_t begin = 0;
  for (Tensor parameter : parameters) {
    const std::int64_t end = begin + parameter.numel();
    const Tensor home = weights_.slice(0, begin, end).view(parameter.sizes());
    home.copy_(parameter);
    parameter.set_data(home);
    parameter.mutable_grad() = gradient_.slice(0, begin, end).view(parameter.sizes());
    if (parameter.dim() >= 2) decay_mask_.slice(0, begin, end).fill_(1.0);
    begin = end;
  }
  first_moment_ = torch::zeros_like(weights_);
  second_moment_ = torch::zeros_like(weights_);
  average_ = weights_.clone();
}

void FlatAdamW::zero_gradient() { gradient_.zero_(); }

Tensor FlatAdamW::step(double learning_rate) {
  torch::NoGradGuard no_grad;
  ++num_steps;
  const Tensor norm = gradient_.norm();
  const Tensor finite = torch::isfinite(norm);
  const Tensor scale = (options_.clip_norm / (norm + 1e-6)).clamp_max(1.0);
  // A non-finite gradient becomes zero: the step then only follows momentum, and the weights stay finite.
  gradient_.mul_(torch::where(finite, scale, torch::zeros_like(scale))).nan_to_num_(0.0, 0.0, 0.0);

  first_moment_.lerp_(gradient_, 1.0 - options_.beta1);
  second_moment_.mul_(options_.beta2).addcmul_(gradient_, gradient_, 1.0 - options_.beta2);
  const double correction1 = 1.0 - std::pow(options_.beta1, static_cast<double>(num_steps));
  const double correction2 = 1.0 - std::pow(options_.beta2, static_cast<double>(num_steps));
  weights_.addcmul_(weights_, decay_mask_, -learning_rate * options_.weight_decay);
  const Tensor denominator = second_moment_.sqrt().div_(std::sqrt(correction2)).add_(1e-8);
  weights_.addcdiv_(first_moment_, denominator, -learning_rate / correction1);
  if (options_.ema_decay > 0.0) {
    // Young averages forget faster, so that the first weights do not linger.
    const double age = static_cast<double>(num_steps);
    average_.lerp_(weights_, 1.0 - std::min(options_.ema_decay, (1.0 + age) / (10.0 + age)));
  }
  return norm;
}

std::vector<std::pair<std::string, Tensor>> FlatAdamW::state() const {
  return {
      {"weights", weights_}, {"first_moment", first_moment_}, {"second_moment", second_moment_}, {"average", average_}};
}

void FlatAdamW::swap_average() {
  torch::NoGradGuard no_grad;
  if (options_.ema_decay <= 0.0) return;
  const Tensor saved = weights_.clone();
  weights_.copy_(average_);
  average_.copy_(saved);
}

}  // namespace rigidformer
