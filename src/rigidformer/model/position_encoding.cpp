// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/position_encoding.hpp"

#include <cmath>

#include "rigidformer/model/layers.hpp"

namespace rigidformer {
namespace {

// Wavelengths from about three widths of the MOVi arena, where a position is unambiguous, down to a fraction of an
// object (docs/paper_map.md, "§3.3, ω").
constexpr double kLongestWavelength = 32.0;       // [m]
constexpr double kShortestWavelength = 0.5;       // [m]
constexpr std::int64_t kMaxIndexedObjects = 256;  // rows of the learned index embedding; chosen by eye

Tensor masked_mean(const Tensor& points, const Tensor& mask) {
  const Tensor weight = mask.unsqueeze(-1).to(points.scalar_type());
  return (points * weight).sum(2) / weight.sum(2).clamp_min(1.0);
}

/// Principal axes as columns, scaled by the standard deviation along them, [B, K, 9]. Signs are fixed so
/// that the largest component is positive. The gradient takes them for constants: it does not exist
/// where two variances are equal.
Tensor principal_axes(const Tensor& offsets, const Tensor& mask) {
  const Tensor weighted = offsets * mask.unsqueeze(-1).to(offsets.scalar_type());
  const Tensor count = mask.sum(-1).clamp_min(1).to(offsets.scalar_type()).unsqueeze(-1).unsqueeze(-1);
  const Tensor covariance = torch::matmul(weighted.transpose(-1, -2), weighted) / count;
  auto [values, vectors] = torch::linalg_eigh(covariance.detach());
  const Tensor largest = vectors.abs().argmax(-2, true);
  const Tensor sign = torch::sign(vectors.gather(-2, largest));
  return (vectors * sign * values.clamp_min(0.0).sqrt().unsqueeze(-2)).flatten(-2);
}

/// Box along the principal axes: its half extents times the axes, [B, K, 9].
Tensor oriented_box(const Tensor& offsets, const Tensor& mask) {
  const Tensor axes = torch::nn::functional::normalize(principal_axes(offsets, mask).unflatten(-1, {3, 3}),
                                                       torch::nn::functional::NormalizeFuncOptions().dim(-2));
  const Tensor along = torch::matmul(offsets * mask.unsqueeze(-1).to(offsets.scalar_type()), axes);
  return (axes * along.abs().amax(2).unsqueeze(-2)).flatten(-2);
}

Tensor sinusoidal(const Tensor& positions) {
  const Tensor angles = rotary_angles(positions, 96).unflatten(-1, {3, 2, 16}).select(-2, 0).flatten(-2);
  return torch::cat({angles.sin(), angles.cos()}, -1);
}

}  // namespace

Tensor rotary_angles(const Tensor& positions, std::int64_t rotary_dim) {
  const std::int64_t per_axis = rotary_dim / 6;  // frequencies per axis, each used for a pair of channels
  const Tensor exponent = torch::linspace(0.0, 1.0, per_axis, positions.options());
  const Tensor omega = 2.0 * M_PI / kLongestWavelength *
                       torch::pow(torch::full_like(exponent, kLongestWavelength / kShortestWavelength), exponent);
  const Tensor phase = positions.unsqueeze(-1) * omega;  // [..., 3, per_axis]
  return torch::cat({phase, phase}, -1).flatten(-2);     // [..., 3 * 2 * per_axis]
}

Tensor apply_rotary(const Tensor& x, const Tensor& angles) {
  const std::int64_t rotary_dim = angles.size(-1);
  const Tensor rotated = x.slice(-1, 0, rotary_dim);
  const auto halves = rotated.unflatten(-1, {3, rotary_dim / 3}).chunk(2, -1);  // per axis: [first | second of pair]
  const Tensor swapped = torch::cat({-halves[1], halves[0]}, -1).flatten(-2);
  const Tensor a = angles.unsqueeze(1);
  const Tensor turned = rotated * a.cos().to(x.scalar_type()) + swapped * a.sin().to(x.scalar_type());
  return torch::cat({turned, x.slice(-1, rotary_dim)}, -1);
}

TokenPositionEncoderImpl::TokenPositionEncoderImpl(const ModelOptions& model_options) : options(model_options) {
  const std::int64_t D = options.embedding_dim;
  switch (options.position_encoding) {
    case PositionEncoding::kArope:
    case PositionEncoding::kNone:
      break;
    case PositionEncoding::kSinusoidal:
      embed = register_module("embed", torch::nn::Sequential(Linear(96, D)));
      break;
    case PositionEncoding::kLearned:
      table = register_parameter("table", 0.02 * torch::randn({kMaxIndexedObjects, D}));
      break;
    case PositionEncoding::kObb:
    case PositionEncoding::kPca:
    case PositionEncoding::kSe3:
      embed = register_module("embed", torch::nn::Sequential(Mlp(12, D, D)));
      break;
  }
}

TokenPositions TokenPositionEncoderImpl::forward(const SceneBatch& batch, const Pose& current,
                                                 const Tensor& points_world, const Tensor& anchors_world) {
  TokenPositions positions;
  const Tensor centroid = masked_mean(points_world, batch.point_mask);
  const Tensor offsets = points_world - centroid.unsqueeze(2);
  switch (options.position_encoding) {
    case PositionEncoding::kNone:
      break;
    case PositionEncoding::kArope:
      positions.anchor_angles = rotary_angles(anchors_world, options.rotary_dim);
      positions.object_angles = positions.anchor_angles.mean(2);  // Eq. (1)
      break;
    case PositionEncoding::kSinusoidal:
      positions.object_embedding = embed->forward(sinusoidal(centroid));
      positions.anchor_embedding = embed->forward(sinusoidal(anchors_world));
      break;
    case PositionEncoding::kLearned:
      positions.object_embedding = table.slice(0, 0, batch.max_objects()).unsqueeze(0);
      break;
    case PositionEncoding::kObb:
      positions.object_embedding = embed->forward(torch::cat({centroid, oriented_box(offsets, batch.point_mask)}, -1));
      break;
    case PositionEncoding::kPca:
      positions.object_embedding =
          embed->forward(torch::cat({centroid, principal_axes(offsets, batch.point_mask)}, -1));
      break;
    case PositionEncoding::kSe3:
      positions.object_embedding = embed->forward(torch::cat({current.translation, current.rotation.flatten(-2)}, -1));
      break;
  }
  if (positions.object_embedding.defined() && !positions.anchor_embedding.defined()) {
    positions.anchor_embedding = positions.object_embedding.unsqueeze(2);
  }
  return positions;
}

}  // namespace rigidformer
