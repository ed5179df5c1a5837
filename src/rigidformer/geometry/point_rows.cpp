// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/point_rows.hpp"

namespace rigidformer {

std::vector<int> finite_rows(const Points& points) {
  std::vector<int> rows;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (points.row(i).allFinite()) {
      rows.push_back(static_cast<int>(i));
    }
  }
  return rows;
}

Points select_rows(const Points& points, const std::vector<int>& rows) {
  Points selected(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    selected.row(static_cast<Eigen::Index>(i)) = points.row(rows[i]);
  }
  return selected;
}

}  // namespace rigidformer
