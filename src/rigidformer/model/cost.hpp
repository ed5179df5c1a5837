// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/rigidformer.hpp"

namespace rigidformer {

/// Number of multiply-adds of one forward pass in products with weight matrices, for one scene of that many objects and
/// points per object. Attention scores and the nearest-point search are left out.
double multiply_adds(const RigidFormer& model, std::int64_t num_objects, std::int64_t num_points);

/// Measures how many multiply-adds per second `device` reaches in the product of two
/// large float32 or bfloat16 matrices.
double measure_matrix_peak(const torch::Device& device, torch::ScalarType type);

}  // namespace rigidformer
