// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// Names of the shapes of MOVi-B, in alphabetical order.
const std::vector<std::string>& movi_b_shape_names();

/// Mass [kg] of a shape of MOVi at size 1 and density factor 1; 0 for other names.
double movi_shape_mass(const std::string& name);

/// Reads one shape in KuBasic layout: `collision_geometry.obj` with one closed convex mesh per `o` group, and
/// `data.json` for the mass. Where data.json is missing or broken the mass is the one known from MOVi, else the volume
/// of the parts, and a sentence is appended to `warnings` when given. Throws std::runtime_error naming path and defect.
Shape load_kubasic_shape(const std::filesystem::path& folder, std::vector<std::string>* warnings = nullptr);

/// Reads every sub-folder of `folder` that holds a shape, ordered by name. Throws std::runtime_error when there is
/// none.
std::vector<Shape> load_kubasic_shapes(const std::filesystem::path& folder,
                                       std::vector<std::string>* warnings = nullptr);

/// Writes `<folder>/<shape name>/` in KuBasic layout (geometry and mass, no visual mesh). Throws std::runtime_error.
void write_kubasic_shape(const std::filesystem::path& folder, const Shape& shape);

}  // namespace rigidformer
