// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/rigid_projection.hpp"

#include <Eigen/SVD>

namespace rigidformer {
namespace {

constexpr double kSmallestDenominator = 1e-6;  // share of the largest singular value; chosen by eye

struct Svd {
  Tensor U, S, V;
};

/// Decomposes many 3x3 matrices one by one: a library call per matrix costs more than the decomposition itself.
template <typename Scalar>
Svd svd_on_cpu(const Tensor& H) {
  using RowMatrix = Eigen::Matrix<Scalar, 3, 3, Eigen::RowMajor>;
  const Tensor dense = H.contiguous();
  Svd svd{torch::empty_like(dense), torch::empty(dense.sizes().slice(0, dense.dim() - 1), dense.options()),
          torch::empty_like(dense)};
  for (std::int64_t i = 0; i < dense.numel() / 9; ++i) {
    const RowMatrix matrix = Eigen::Map<const RowMatrix>(dense.data_ptr<Scalar>() + 9 * i);
    const Eigen::JacobiSVD<Eigen::Matrix<Scalar, 3, 3>> solver(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Map<RowMatrix>(svd.U.data_ptr<Scalar>() + 9 * i) = solver.matrixU();
    Eigen::Map<RowMatrix>(svd.V.data_ptr<Scalar>() + 9 * i) = solver.matrixV();
    Eigen::Map<Eigen::Matrix<Scalar, 3, 1>>(svd.S.data_ptr<Scalar>() + 3 * i) = solver.singularValues();
  }
  return svd;
}

Svd decompose(const Tensor& H) {
  if (H.is_cpu() && H.scalar_type() == torch::kFloat32) return svd_on_cpu<float>(H);
  if (H.is_cpu() && H.scalar_type() == torch::kFloat64) return svd_on_cpu<double>(H);
  auto [U, S, Vh] = torch::linalg_svd(H, true);
  return {U, S, Vh.transpose(-1, -2)};
}

struct SpecialProcrustes : torch::autograd::Function<SpecialProcrustes> {
  static Tensor forward(torch::autograd::AutogradContext* context, const Tensor& H) {
    const auto [U, S, V] = decompose(H);
    const Tensor sign = torch::det(torch::matmul(V, U.transpose(-1, -2))).sign().unsqueeze(-1);
    const Tensor diagonal = torch::cat({torch::ones_like(S.slice(-1, 0, 2)), sign}, -1);
    const Tensor R = torch::matmul(V * diagonal.unsqueeze(-2), U.transpose(-1, -2));
    context->save_for_backward({U, S * diagonal, R});
    return R;
  }

  /// Backward pass. With H^T = R P, P = U diag(s) U^T, R^T dR is the antisymmetric solution W
  /// of P W + W P = R^T dH^T - dH R.
  static torch::autograd::tensor_list backward(torch::autograd::AutogradContext* context,
                                               torch::autograd::tensor_list gradients) {
    const auto saved = context->get_saved_variables();
    const Tensor &U = saved[0], &s = saved[1], &R = saved[2];
    const Tensor X = torch::matmul(R.transpose(-1, -2), gradients[0]);
    const Tensor skew = 0.5 * (X - X.transpose(-1, -2));
    Tensor denominator = s.unsqueeze(-1) + s.unsqueeze(-2);
    const Tensor floor = (kSmallestDenominator * s.select(-1, 0)).clamp_min(1e-20).unsqueeze(-1).unsqueeze(-1);
    denominator = torch::where(denominator.abs() < floor, floor.expand_as(denominator), denominator);
    const Tensor Y = torch::matmul(U.transpose(-1, -2), torch::matmul(skew, U)) / denominator;
    const Tensor gradient_Ht = 2.0 * torch::matmul(R, torch::matmul(U, torch::matmul(Y, U.transpose(-1, -2))));
    return {gradient_Ht.transpose(-1, -2)};
  }
};

}  // namespace

Tensor special_procrustes(const Tensor& H) { return SpecialProcrustes::apply(H); }

Pose align_rigidly(const Tensor& source, const Tensor& target_anchors, bool differentiable) {
  const Tensor target = differentiable ? target_anchors : target_anchors.detach();
  const Tensor source_mean = source.mean(-2, true), target_mean = target.mean(-2, true);
  const Tensor H = torch::matmul((source - source_mean).transpose(-1, -2), target - target_mean);
  const Tensor R = special_procrustes(H);
  const Tensor t = target_mean.squeeze(-2) - torch::matmul(R, source_mean.transpose(-1, -2)).squeeze(-1);
  return {R, t};
}

}  // namespace rigidformer
