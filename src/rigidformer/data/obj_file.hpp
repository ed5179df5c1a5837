// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace rigidformer {

/// One closed mesh of an OBJ file.
struct ObjPart {
  std::vector<Eigen::Vector3f> vertices;   ///< In the order of the file
  std::vector<Eigen::Vector3i> triangles;  ///< Indices into `vertices`
};

/// The parts of the Wavefront OBJ text of the file at `path`, which only errors name. Every `o` begins a part; so does
/// every `g`, unless the groups of an object share vertices: they are then faces of one part. A part is made of the
/// vertices that its faces name, wherever in the file these stand, and of those of its group that nobody names.
/// Polygons become fans of triangles; texture coordinates, normals, materials and lines of other kinds are passed over.
/// Throws std::runtime_error naming file, line and what is accepted.
std::vector<ObjPart> parse_obj(const std::filesystem::path& path, const std::string& text);

}  // namespace rigidformer
