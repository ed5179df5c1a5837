// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/encoder.hpp"

#include "rigidformer/model/features.hpp"
#include "rigidformer/model/level_pooling.hpp"

namespace rigidformer {

PointEncoderImpl::PointEncoderImpl(const ModelOptions& options) {
  std::int64_t width = num_vertex_features(options) + num_engine_features(options);
  for (const std::int64_t next : options.encoder_widths) {
    backbone->push_back(Linear(width, next));
    width = next;
  }
  if (options.encoder_level_hidden > 0) {
    for (std::size_t level = 0; level < kLevelFractions.size(); ++level) {
      level_mlps->push_back(Mlp(width, options.encoder_level_hidden, width));
    }
  }
  register_module("backbone", backbone);
  register_module("level_mlps", level_mlps);
  fuse = register_module("fuse", Mlp(static_cast<std::int64_t>(kLevelFractions.size()) * width,
                                     options.encoder_fuse_hidden, options.embedding_dim));
}

Encoding PointEncoderImpl::forward(const Tensor& features, const Tensor& point_mask) {
  Tensor f = features;
  for (const auto& layer : *backbone) f = torch::silu(layer->as<Linear>()->forward(f));
  std::array<Tensor, kLevelFractions.size()> levels = pool_levels(f, point_mask);
  if (!level_mlps->is_empty()) {
    for (std::size_t level = 0; level < levels.size(); ++level) {
      levels[level] = level_mlps[level]->as<Mlp>()->forward(levels[level]);
    }
  }
  return {fuse(torch::cat(torch::TensorList(levels.data(), levels.size()), -1)), f};
}

}  // namespace rigidformer
