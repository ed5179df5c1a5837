// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

Points Shape::vertices() const {
  Eigen::Index count = 0;
  for (const ConvexPart& part : parts) count += part.vertices.rows();
  Points all(count, 3);
  Eigen::Index row = 0;
  for (const ConvexPart& part : parts) {
    all.middleRows(row, part.vertices.rows()) = part.vertices;
    row += part.vertices.rows();
  }
  return all;
}

double Shape::largest_extent() const {
  const Points all = vertices();
  return all.rows() == 0 ? 0.0 : (all.colwise().maxCoeff() - all.colwise().minCoeff()).maxCoeff();
}

}  // namespace rigidformer
