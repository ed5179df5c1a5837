// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/anchor_vertex_pooling.hpp"

#include <cmath>

namespace rigidformer {
namespace {

constexpr double kInitialBandwidth = 0.3;  // [m] a fraction of an object, chosen by eye (docs/paper_map.md, "§3.2, σ")

}  // namespace

AnchorVertexPoolingImpl::AnchorVertexPoolingImpl(const ModelOptions& options) {
  log_sigma = register_parameter("log_sigma", torch::full({}, std::log(kInitialBandwidth)));
  mlp = register_module("mlp", Mlp(options.encoder_widths.back(), options.avp_hidden, options.avp_dim,
                                   /*zero_last=*/true));
}

Tensor AnchorVertexPoolingImpl::forward(const Tensor& f, const Tensor& points, const Tensor& point_mask,
                                        const Tensor& anchors) {
  const Tensor offsets = anchors.unsqueeze(3) - points.unsqueeze(2);  // [B, K, A, N, 3]
  const Tensor distance = (offsets.square().sum(-1) + 1e-12).sqrt();
  const Tensor exponent =
      (-distance / log_sigma.to(distance.scalar_type()).exp()).masked_fill(point_mask.logical_not().unsqueeze(2), -1e9);
  const Tensor w = torch::softmax(exponent, -1).to(f.scalar_type());  // normalised weights of Eq. (3)
  return mlp(torch::matmul(w, f));
}

}  // namespace rigidformer
