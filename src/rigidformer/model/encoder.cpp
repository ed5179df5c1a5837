// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/encoder.hpp"

#include <vector>

#include "rigidformer/model/features.hpp"

namespace rigidformer {
namespace {

constexpr double kLevelFractions[] = {1.0, 0.5, 0.25, 0.125};

/// Max over the first ceil(fraction * n) of each object's n valid points: f [B, K, N, E] -> [B, K, E].
Tensor pool_level(const Tensor& f, const Tensor& point_mask, double fraction) {
  const int64_t N = f.size(2);
  const Tensor count = point_mask.sum(-1, true).to(torch::kFloat32);  // [B, K, 1]
  const Tensor kept = (count * fraction).ceil().clamp_min(1.0);
  const int64_t longest = fraction == 1.0 ? N : static_cast<int64_t>(static_cast<double>(N) * fraction) + 1;
  const int64_t prefix = std::min(N, longest);
  const Tensor rank = torch::arange(prefix, count.options());
  const Tensor drop = (rank >= kept).logical_or(point_mask.slice(2, 0, prefix).logical_not()).unsqueeze(-1);
  const Tensor pooled = f.slice(2, 0, prefix).masked_fill(drop, -1e4).amax(2);
  return pooled.masked_fill(count == 0, 0.0);
}

}  // namespace

PointEncoderImpl::PointEncoderImpl(const ModelOptions& options) {
  int64_t width = num_vertex_features(options) + num_engine_features(options);
  for (const int64_t next : options.encoder_widths) {
    backbone->push_back(Linear(width, next));
    width = next;
  }
  if (options.encoder_level_hidden > 0) {
    for (size_t level = 0; level < std::size(kLevelFractions); ++level) {
      level_mlps->push_back(Mlp(width, options.encoder_level_hidden, width));
    }
  }
  register_module("backbone", backbone);
  register_module("level_mlps", level_mlps);
  const auto num_levels = static_cast<int64_t>(std::size(kLevelFractions));
  fuse = register_module("fuse", Mlp(num_levels * width, options.encoder_fuse_hidden, options.embedding_dim));
}

Encoding PointEncoderImpl::forward(const Tensor& features, const Tensor& point_mask) {
  Tensor f = features;
  for (const auto& layer : *backbone) f = torch::silu(layer->as<Linear>()->forward(f));
  std::vector<Tensor> levels;
  for (size_t level = 0; level < std::size(kLevelFractions); ++level) {
    Tensor pooled = pool_level(f, point_mask, kLevelFractions[level]);
    if (!level_mlps->is_empty()) pooled = level_mlps[level]->as<Mlp>()->forward(pooled);
    levels.push_back(pooled);
  }
  return {fuse(torch::cat(levels, -1)), f};
}

}  // namespace rigidformer
