// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/cost.hpp"

#include <gtest/gtest.h>

namespace rigidformer {
namespace {

double matrix_elements(const torch::nn::Module& module) {
  double sum = 0.0;
  for (const Tensor& weight : module.parameters()) sum += weight.dim() == 2 ? static_cast<double>(weight.numel()) : 0.0;
  return sum;
}

TEST(MultiplyAdds, EveryMorePointCostsOneRowOfTheBackbonePerObject) {
  const RigidFormer model(model_preset("tiny"));
  const double backbone = matrix_elements(*model->encoder->backbone);
  EXPECT_EQ(multiply_adds(model, 3, 65) - multiply_adds(model, 3, 64), 3.0 * backbone);
}

TEST(MultiplyAdds, AllPartsAreCountedPerObject) {
  ModelOptions options = model_preset("small");
  const RigidFormer model(options);
  // Without points and registers, one more object costs every weight outside the backbone and the FiLM networks once
  // per object, or once per anchor where anchors are the rows.
  const double slope = multiply_adds(model, 2, 0) - multiply_adds(model, 1, 0);
  const double all = matrix_elements(*model);
  EXPECT_GT(slope, 0.5 * all);
  EXPECT_LT(slope, options.num_anchors * all);
  EXPECT_GT(multiply_adds(model, 10, 256), multiply_adds(model, 10, 64));
}

TEST(MatrixPeak, IsPositiveForBothTypes) {
  EXPECT_GT(measure_matrix_peak(torch::kCPU, torch::kFloat32), 1e6);
  EXPECT_GT(measure_matrix_peak(torch::kCPU, torch::kBFloat16), 1e6);
}

}  // namespace
}  // namespace rigidformer
