// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/weight_transfer.hpp"

#include <sstream>
#include <stdexcept>

#include "rigidformer/model/checkpoint.hpp"

namespace rigidformer {
namespace {

/// The part of `larger` that a tensor like `like` fills. Throws when `like` does not fit into `larger`.
Tensor corner(const std::string& name, Tensor larger, const Tensor& like) {
  bool fits = larger.dim() == like.dim();
  for (std::int64_t d = 0; fits && d < like.dim(); ++d) fits = larger.size(d) >= like.size(d);
  if (!fits) {
    std::ostringstream message;
    message << "tensor '" << name << "' has shape " << like.sizes() << ", which does not fit into " << larger.sizes();
    throw std::invalid_argument(message.str());
  }
  for (std::int64_t d = 0; d < like.dim(); ++d) larger = larger.slice(d, 0, like.size(d));
  return larger;
}

}  // namespace

void transfer_weights(const RigidFormer& from, RigidFormer& to) {
  torch::NoGradGuard no_grad;
  auto targets = to->named_parameters();
  for (const auto& source : from->named_parameters()) {
    Tensor* target = targets.find(source.key());
    if (target == nullptr) throw std::invalid_argument("the new model has no tensor '" + source.key() + "'");
    Tensor part = corner(source.key(), *target, source.value());
    target->zero_();
    part.copy_(source.value());
  }
}

void transfer_weights(const std::filesystem::path& file, RigidFormer& to) {
  const RigidFormer from = load_checkpoint(file).model;
  try {
    transfer_weights(from, to);
  } catch (const std::invalid_argument& exception) {
    throw std::invalid_argument("'" + file.string() + "' is not a start for this model: " + exception.what());
  }
}

}  // namespace rigidformer
