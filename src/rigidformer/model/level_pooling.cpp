// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/level_pooling.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rigidformer {
namespace {

constexpr std::size_t kLevels = kLevelFractions.size();

Tensor pool_level_by_mask(const Tensor& f, const Tensor& point_mask, double fraction) {
  const std::int64_t N = f.size(2);
  const Tensor count = point_mask.sum(-1, true).to(torch::kFloat32);  // [B, K, 1]
  const Tensor kept = (count * fraction).ceil().clamp_min(1.0);
  const std::int64_t longest = fraction == 1.0 ? N : static_cast<std::int64_t>(static_cast<double>(N) * fraction) + 1;
  const std::int64_t prefix = std::min(N, longest);
  const Tensor rank = torch::arange(prefix, count.options());
  const Tensor drop = (rank >= kept).logical_or(point_mask.slice(2, 0, prefix).logical_not()).unsqueeze(-1);
  const Tensor pooled = f.slice(2, 0, prefix).masked_fill(drop, -1e4).amax(2);
  return pooled.masked_fill(count == 0, 0.0);
}

/// One object's maxima [kLevels, E] of rows f [count, E], and which rows they come from. A NaN wins, as in amax().
void pool_object(const float* f, std::int64_t count, std::int64_t E, float* pooled, std::int32_t* source) {
  std::array<std::int64_t, kLevels> kept{};
  for (std::size_t level = 0; level < kLevels; ++level) {
    kept[level] = static_cast<std::int64_t>(std::ceil(static_cast<double>(count) * kLevelFractions[level]));
  }
  std::vector<float> best(f, f + E);
  std::vector<std::int32_t> best_row(static_cast<std::size_t>(E), 0);
  for (std::int64_t row = 0; row < count; ++row) {
    const float* value = f + row * E;
    for (std::int64_t e = 0; e < E; ++e) {
      const auto i = static_cast<std::size_t>(e);
      const bool replaces = value[e] > best[i] || std::isnan(value[e]);
      best[i] = replaces ? value[e] : best[i];
      best_row[i] = replaces ? static_cast<std::int32_t>(row) : best_row[i];
    }
    for (std::size_t level = 0; level < kLevels; ++level) {
      if (row + 1 != kept[level]) continue;
      std::copy(best.begin(), best.end(), pooled + static_cast<std::int64_t>(level) * E);
      std::copy(best_row.begin(), best_row.end(), source + static_cast<std::int64_t>(level) * E);
    }
  }
}

/// All levels in one pass over f; the gradient goes to the rows where the maxima are. For contiguous float32 on the
/// CPU.
class PoolLevels : public torch::autograd::Function<PoolLevels> {
 public:
  /// f [B, K, N, E], count [B, K] int64 -> [B, K, kLevels, E]
  static Tensor forward(torch::autograd::AutogradContext* context, const Tensor& f, const Tensor& count) {
    const std::int64_t B = f.size(0), K = f.size(1), N = f.size(2), E = f.size(3), L = kLevels;
    const Tensor pooled = torch::zeros({B, K, L, E});
    const Tensor source = torch::zeros({B, K, L, E}, torch::kInt32);
    for (std::int64_t object = 0; object < B * K; ++object) {
      const std::int64_t points = count.data_ptr<std::int64_t>()[object];
      if (points == 0) continue;
      pool_object(f.data_ptr<float>() + object * N * E, points, E, pooled.data_ptr<float>() + object * L * E,
                  source.data_ptr<std::int32_t>() + object * L * E);
    }
    context->save_for_backward({source, count});
    context->saved_data["points"] = N;
    return pooled;
  }

  static torch::autograd::tensor_list backward(torch::autograd::AutogradContext* context,
                                               torch::autograd::tensor_list gradients) {
    const auto saved = context->get_saved_variables();
    const Tensor &source = saved[0], &count = saved[1], given = gradients[0].contiguous();
    const std::int64_t B = given.size(0), K = given.size(1), L = kLevels, E = given.size(3);
    const std::int64_t N = context->saved_data["points"].toInt();
    const Tensor gradient = torch::zeros({B, K, N, E});
    for (std::int64_t object = 0; object < B * K; ++object) {
      if (count.data_ptr<std::int64_t>()[object] == 0) continue;
      const float* from = given.data_ptr<float>() + object * L * E;
      const std::int32_t* row = source.data_ptr<std::int32_t>() + object * L * E;
      float* to = gradient.data_ptr<float>() + object * N * E;
      for (std::int64_t i = 0; i < L * E; ++i) to[row[i] * E + i % E] += from[i];
    }
    return {gradient, Tensor()};
  }
};

}  // namespace

std::array<Tensor, kLevels> pool_levels_by_masks(const Tensor& f, const Tensor& point_mask) {
  std::array<Tensor, kLevels> levels;
  for (std::size_t level = 0; level < kLevels; ++level) {
    levels[level] = pool_level_by_mask(f, point_mask, kLevelFractions[level]);
  }
  return levels;
}

std::array<Tensor, kLevels> pool_levels(const Tensor& f, const Tensor& point_mask) {
  if (!f.is_cpu() || f.scalar_type() != torch::kFloat32 || !f.is_contiguous()) {
    return pool_levels_by_masks(f, point_mask);
  }
  const Tensor pooled = PoolLevels::apply(f, point_mask.sum(-1).contiguous());
  std::array<Tensor, kLevels> levels;
  for (std::size_t level = 0; level < kLevels; ++level) {
    levels[level] = pooled.select(2, static_cast<std::int64_t>(level));
  }
  return levels;
}

}  // namespace rigidformer
