// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/cost.hpp"

#include <algorithm>
#include <chrono>
#include <string>

namespace rigidformer {
namespace {

constexpr std::int64_t kPeakMatrixSize = 1024;  // rows of a matrix large enough to keep a device busy; chosen by eye
constexpr int kPeakRuns = 5;                    // runs, of which the fastest counts; chosen by eye

bool contains(const std::string& name, const char* part) { return name.find(part) != std::string::npos; }

/// Number of rows of one scene that a weight matrix is applied to.
std::int64_t rows_for(const std::string& name, const ModelOptions& options, std::int64_t K, std::int64_t N) {
  const std::int64_t K_A = K * options.num_anchors;
  if (contains(name, "encoder.backbone")) return K * N;
  if (contains(name, "film")) return 1;
  if (contains(name, "decoder.")) return K + options.num_registers;
  if (contains(name, "anchor_vertex_pooling.")) return K_A;
  const bool reads_objects = contains(name, "to_key") || contains(name, "to_value") || contains(name, "own_token");
  if (contains(name, "predictor.") && !reads_objects) return K_A;
  return K;
}

}  // namespace

double multiply_adds(const RigidFormer& model, std::int64_t num_objects, std::int64_t num_points) {
  double sum = 0.0;
  for (const auto& parameter : model->named_parameters()) {
    const Tensor& weight = parameter.value();
    const bool is_matrix = weight.dim() == 2 && !contains(parameter.key(), "registers");
    if (!is_matrix) continue;
    sum += static_cast<double>(weight.numel()) *
           static_cast<double>(rows_for(parameter.key(), model->options, num_objects, num_points));
  }
  return sum;
}

double measure_matrix_peak(const torch::Device& device, torch::ScalarType type) {
  torch::NoGradGuard no_grad;
  const Tensor a = torch::ones({kPeakMatrixSize, kPeakMatrixSize}, torch::TensorOptions(type).device(device));
  double best_s = 1e9;
  for (int run = 0; run <= kPeakRuns; ++run) {
    const auto start = std::chrono::steady_clock::now();
    torch::mm(a, a)[0][0].item();  // item() waits for the device
    const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (run > 0) best_s = std::min(best_s, elapsed_s);  // the first run starts the library and does not count
  }
  return static_cast<double>(kPeakMatrixSize) * kPeakMatrixSize * kPeakMatrixSize / best_s;
}

}  // namespace rigidformer
