// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "stable_labels.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

std::vector<std::uint32_t> StableLabels::assign(const std::vector<Eigen::Vector3d>& centroids) {
  // The nearest pairs are matched first, so that two neighbours do not take each other's label.
  std::vector<std::tuple<double, std::uint32_t, std::size_t>> pairs;
  for (const auto& [label, known] : known_) {
    for (std::size_t i = 0; i < centroids.size(); ++i) {
      const double distance_m = (centroids[i] - known.centroid).norm();
      if (distance_m <= max_distance_m_) {
        pairs.emplace_back(distance_m, label, i);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (auto& [label, known] : known_) {
    ++known.missed;
  }
  std::vector<std::uint32_t> labels(centroids.size(), 0);
  for (const auto& [distance_m, label, i] : pairs) {
    Known& known = known_.at(label);
    if (labels[i] == 0 && known.missed > 0) {
      labels[i] = label;
      known = {centroids[i], 0};
    }
  }
  for (std::size_t i = 0; i < centroids.size(); ++i) {
    if (labels[i] == 0) {
      labels[i] = next_label_++;
      known_[labels[i]] = {centroids[i], 0};
    }
  }
  for (auto it = known_.begin(); it != known_.end();) {
    it = it->second.missed > max_missed_ ? known_.erase(it) : std::next(it);
  }
  return labels;
}
