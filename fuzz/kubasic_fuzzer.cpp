// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <stdexcept>

#include "rigidformer/data/kubasic.hpp"
#include "scratch_file.hpp"

/// Reads the bytes as a shape: the first zero byte ends the geometry, and the rest is data.json. Checks that every
/// accepted part is made of its own vertices.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFolder folder;
  const std::uint8_t* zero = std::find(data, data + size, 0);
  const auto geometry_size = static_cast<std::size_t>(zero - data);
  const std::size_t rest = std::min(size, geometry_size + 1);
  folder.write("collision_geometry.obj", data, geometry_size);
  folder.write("data.json", data + rest, size - rest);
  try {
    std::vector<std::string> warnings;
    const rigidformer::Shape shape = rigidformer::load_kubasic_shape(folder.path(), &warnings);
    for (const rigidformer::ConvexPart& part : shape.parts) {
      if (part.triangles.minCoeff() < 0 || part.triangles.maxCoeff() >= part.vertices.rows()) __builtin_trap();
    }
  } catch (const std::runtime_error&) {
  }
  return 0;
}
