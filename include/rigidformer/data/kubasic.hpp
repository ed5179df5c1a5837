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

/// Reads one shape in KuBasic layout: `collision_geometry.obj` with one closed convex mesh per `o` or `g` group, and
/// `data.json` for the mass. Where data.json is missing or broken the mass is the one known from MOVi, else the volume
/// of the parts, and a sentence is appended to `warnings` when given. Throws std::runtime_error naming path and defect.
Shape load_kubasic_shape(const std::filesystem::path& folder, std::vector<std::string>* warnings = nullptr);

/// Names of the sub-folders of `folder` that hold a shape, in alphabetical order. Throws std::runtime_error when there
/// is none.
std::vector<std::string> kubasic_shape_names(const std::filesystem::path& folder);

/// Reads every shape of `folder`, ordered by name. Throws std::runtime_error when there is none or one is unusable.
std::vector<Shape> load_kubasic_shapes(const std::filesystem::path& folder,
                                       std::vector<std::string>* warnings = nullptr);

/// Same without backgrounds (data.json says `"background": true`) and shapes that cannot be read; each is named in
/// `warnings`. Throws std::runtime_error when none is left.
std::vector<Shape> load_usable_kubasic_shapes(const std::filesystem::path& folder, std::vector<std::string>& warnings);

/// Writes `<folder>/<shape name>/` in KuBasic layout (geometry and mass, no visual mesh). Throws std::runtime_error.
void write_kubasic_shape(const std::filesystem::path& folder, const Shape& shape);

}  // namespace rigidformer
