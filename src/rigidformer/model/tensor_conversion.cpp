// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/tensor_conversion.hpp"

#include <cstring>
#include <stdexcept>

namespace rigidformer {
namespace {

torch::ScalarType scalar_type(TensorType type) {
  switch (type) {
    case TensorType::kFloat32:
      return torch::kFloat32;
    case TensorType::kBFloat16:
      return torch::kBFloat16;
    case TensorType::kFloat64:
      return torch::kFloat64;
    case TensorType::kInt64:
      return torch::kInt64;
    case TensorType::kInt32:
      return torch::kInt32;
    case TensorType::kInt16:
      return torch::kInt16;
    case TensorType::kUInt8:
      return torch::kUInt8;
  }
  throw std::invalid_argument("unknown tensor type");
}

}  // namespace

RawTensor to_raw(const torch::Tensor& tensor, TensorType type) {
  const torch::Tensor dense = tensor.detach().to(torch::kCPU).to(scalar_type(type)).contiguous();
  RawTensor raw{type, dense.sizes().vec(), {}};
  raw.bytes.resize(dense.nbytes());
  if (!raw.bytes.empty()) std::memcpy(raw.bytes.data(), dense.data_ptr(), raw.bytes.size());
  return raw;
}

torch::Tensor from_raw(const RawTensor& raw) {
  torch::Tensor tensor = torch::empty(raw.shape, scalar_type(raw.type));
  if (tensor.nbytes() != raw.bytes.size()) {
    throw std::invalid_argument("raw tensor has a size that does not fit its shape");
  }
  if (!raw.bytes.empty()) std::memcpy(tensor.data_ptr(), raw.bytes.data(), raw.bytes.size());
  return tensor;
}

}  // namespace rigidformer
