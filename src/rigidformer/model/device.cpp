// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/device.hpp"

#include <stdexcept>

namespace rigidformer {
namespace {

/// Reads the number N of "cuda:N", or 0 of "cuda"; throws std::invalid_argument for anything else.
int cuda_index(const std::string& name) {
  if (name == "cuda") return 0;
  const std::string prefix = "cuda:";
  const std::string digits = name.rfind(prefix, 0) == 0 ? name.substr(prefix.size()) : "";
  if (digits.empty() || digits.size() > 3 || digits.find_first_not_of("0123456789") != std::string::npos) {
    throw std::invalid_argument("device is '" + name + "', must be auto, cpu, cuda or cuda:N");
  }
  return std::stoi(digits);
}

}  // namespace

torch::Device select_device(const std::string& name) {
  if (name == "cpu") return torch::Device(torch::kCPU);
  if (name == "auto") return torch::Device(torch::cuda::is_available() ? torch::kCUDA : torch::kCPU);
  const int index = cuda_index(name);
  const auto available = torch::cuda::is_available() ? static_cast<int>(torch::cuda::device_count()) : 0;
  if (index >= available) {
    throw std::runtime_error("device '" + name + "' is not usable: " + std::to_string(available) +
                             " CUDA devices found; use auto or cpu");
  }
  return torch::Device(torch::kCUDA, static_cast<torch::DeviceIndex>(index));
}

}  // namespace rigidformer
