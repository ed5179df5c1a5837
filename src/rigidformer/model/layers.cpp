// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/layers.hpp"

#include <cmath>

namespace rigidformer {

LinearImpl::LinearImpl(std::int64_t in, std::int64_t out, bool with_bias) {
  const double bound = 1.0 / std::sqrt(static_cast<double>(in));
  weight = register_parameter("weight", torch::empty({out, in}).uniform_(-bound, bound));
  if (with_bias) bias = register_parameter("bias", torch::zeros({out}));
}

Tensor LinearImpl::forward(const Tensor& x) {
  const auto type = x.scalar_type();
  if (!bias.defined()) return torch::linear(x, weight.to(type));
  // Of rows in one matrix LibTorch adds the bias inside the product, else in a pass of its own.
  auto shape = x.sizes().vec();
  shape.back() = weight.size(0);
  return torch::linear(x.reshape({-1, weight.size(1)}), weight.to(type), bias.to(type)).reshape(shape);
}

void LinearImpl::zero() {
  torch::NoGradGuard no_grad;
  weight.zero_();
  if (bias.defined()) bias.zero_();
}

RmsNormImpl::RmsNormImpl(std::int64_t dim) { scale = register_parameter("scale", torch::ones({dim})); }

Tensor RmsNormImpl::forward(const Tensor& x) {
  const auto wide_type = x.scalar_type() == torch::kFloat64 ? torch::kFloat64 : torch::kFloat32;
  const Tensor wide = x.to(wide_type);
  const Tensor inverse_rms = torch::rsqrt(wide.square().mean(-1, true) + 1e-6);
  return (wide * inverse_rms * scale.to(wide_type)).to(x.scalar_type());
}

MlpImpl::MlpImpl(std::int64_t in, std::int64_t hidden, std::int64_t out, bool zero_last) {
  first = register_module("first", Linear(in, hidden));
  second = register_module("second", Linear(hidden, out));
  if (zero_last) second->zero();
}

Tensor MlpImpl::forward(const Tensor& x) { return second(torch::silu(first(x))); }

SwiGluImpl::SwiGluImpl(std::int64_t dim, double expansion, double dropout) {
  const auto hidden = static_cast<std::int64_t>(std::lround(expansion * static_cast<double>(dim)));
  gate_and_value = register_module("gate_and_value", Linear(dim, 2 * hidden, false));
  output = register_module("output", Linear(hidden, dim, false));
  drop = register_module("drop", torch::nn::Dropout(dropout));
}

Tensor SwiGluImpl::forward(const Tensor& x) {
  const auto parts = gate_and_value(x).chunk(2, -1);
  return drop(output(torch::silu(parts[0]) * parts[1]));
}

FilmImpl::FilmImpl(std::int64_t code_dim, std::int64_t hidden, std::int64_t dim) {
  mlp = register_module("mlp", Mlp(code_dim, hidden, 2 * dim, /*zero_last=*/true));
}

Tensor FilmImpl::forward(const Tensor& z, const Tensor& code) {
  const auto parts = mlp(code.to(z.scalar_type())).unsqueeze(1).chunk(2, -1);
  return (1.0 + parts[0]) * z + parts[1];
}

}  // namespace rigidformer
