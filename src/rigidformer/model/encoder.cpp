// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/encoder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "rigidformer/model/features.hpp"

namespace rigidformer {
namespace {

constexpr double kLevelFractions[] = {1.0, 0.5, 0.25, 0.125};  // share of the points in each level (§3.1)
constexpr size_t kNumLevels = std::size(kLevelFractions);

/// Maximum over the first ceil(fraction * n) of each object's n valid points: f [B, K, N, E] -> [B, K, E].
Tensor pool_level(const Tensor& f, const Tensor& point_mask, double fraction) {
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

/// Writes the maxima of one object's rows f [count, E] to pooled[level] [E].
void pool_object(const float* f, std::int64_t count, std::int64_t E, const std::array<float*, kNumLevels>& pooled) {
  std::array<std::int64_t, kNumLevels> kept{};
  for (size_t level = 0; level < kNumLevels; ++level) {
    kept[level] = static_cast<std::int64_t>(std::ceil(static_cast<double>(count) * kLevelFractions[level]));
  }
  std::vector<float> best(f, f + E);
  for (std::int64_t row = 0; row < count; ++row) {
    const float* value = f + row * E;
    for (std::int64_t e = 0; e < E; ++e) {
      const bool replaces = value[e] > best[e] || std::isnan(value[e]);  // NaN stays, as it does in amax()
      best[e] = replaces ? value[e] : best[e];
    }
    for (size_t level = 0; level < kNumLevels; ++level) {
      if (row + 1 == kept[level]) std::copy(best.begin(), best.end(), pooled[level]);
    }
  }
}

/// Does what pool_level() does for all levels, in one pass over f instead of a copy of it per level.
/// For the CPU, without gradients.
std::vector<Tensor> pool_all_levels(const Tensor& f, const Tensor& point_mask) {
  const std::int64_t K = f.size(1), N = f.size(2), E = f.size(3);
  const Tensor count = point_mask.sum(-1).contiguous();  // [B, K]
  std::vector<Tensor> levels;
  for (size_t level = 0; level < kNumLevels; ++level) levels.push_back(torch::zeros({f.size(0), K, E}));
  for (std::int64_t object = 0; object < count.numel(); ++object) {
    std::array<float*, kNumLevels> pooled{};
    for (size_t level = 0; level < kNumLevels; ++level) pooled[level] = levels[level].data_ptr<float>() + object * E;
    pool_object(f.data_ptr<float>() + object * N * E, count.data_ptr<std::int64_t>()[object], E, pooled);
  }
  return levels;
}

std::vector<Tensor> pool_levels(const Tensor& f, const Tensor& point_mask) {
  const bool plain = f.is_cpu() && f.scalar_type() == torch::kFloat32 && f.is_contiguous();
  if (plain && !torch::GradMode::is_enabled()) return pool_all_levels(f, point_mask);
  std::vector<Tensor> levels;
  for (const double fraction : kLevelFractions) levels.push_back(pool_level(f, point_mask, fraction));
  return levels;
}

}  // namespace

PointEncoderImpl::PointEncoderImpl(const ModelOptions& options) {
  std::int64_t width = num_vertex_features(options) + num_engine_features(options) + num_ground_features(options);
  for (const std::int64_t next : options.encoder_widths) {
    backbone->push_back(Linear(width, next));
    width = next;
  }
  if (options.encoder_level_hidden > 0) {
    for (size_t level = 0; level < kNumLevels; ++level) {
      level_mlps->push_back(Mlp(width, options.encoder_level_hidden, width));
    }
  }
  register_module("backbone", backbone);
  register_module("level_mlps", level_mlps);
  fuse = register_module(
      "fuse", Mlp(static_cast<std::int64_t>(kNumLevels) * width, options.encoder_fuse_hidden, options.embedding_dim));
}

Encoding PointEncoderImpl::forward(const Tensor& features, const Tensor& point_mask) {
  Tensor f = features;
  for (const auto& layer : *backbone) f = torch::silu(layer->as<Linear>()->forward(f));
  std::vector<Tensor> levels = pool_levels(f, point_mask);
  if (!level_mlps->is_empty()) {
    for (size_t level = 0; level < kNumLevels; ++level) {
      levels[level] = level_mlps[level]->as<Mlp>()->forward(levels[level]);
    }
  }
  return {fuse(torch::cat(levels, -1)), f};
}

}  // namespace rigidformer
