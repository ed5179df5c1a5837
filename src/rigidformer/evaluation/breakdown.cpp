// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/breakdown.hpp"

#include <cmath>
#include <stdexcept>
#include <tuple>

namespace rigidformer {
namespace {

PoseError root_mean_square(const std::vector<PoseError>& objects) {
  PoseError sum;
  for (const PoseError& object : objects) {
    sum.position_rmse_m += object.position_rmse_m * object.position_rmse_m;
    sum.orientation_rmse_deg += object.orientation_rmse_deg * object.orientation_rmse_deg;
    sum.position_rmse_sizes += object.position_rmse_sizes * object.position_rmse_sizes;
  }
  const auto count = static_cast<double>(objects.size());
  return {std::sqrt(sum.position_rmse_m / count), std::sqrt(sum.orientation_rmse_deg / count),
          std::sqrt(sum.position_rmse_sizes / count)};
}

/// Reduces every list of errors to one error with `reduce`.
template <typename Group, typename Reduce>
std::map<RoundKey, std::map<Group, PartialScore>> reduced(
    const std::map<RoundKey, std::map<Group, std::vector<PoseError>>>& errors, Reduce reduce) {
  std::map<RoundKey, std::map<Group, PartialScore>> scores;
  for (const auto& [key, groups] : errors) {
    for (const auto& [group, list] : groups) {
      scores[key][group] = {static_cast<int>(list.size()), reduce(list)};
    }
  }
  return scores;
}

}  // namespace

bool RoundKey::operator<(const RoundKey& other) const {
  return std::tie(set, start, step, model) < std::tie(other.set, other.start, other.step, other.model);
}

RoundKey key_of(const SceneResult& result) { return {result.set, result.start, result.step, result.model}; }

void Breakdown::add(const SceneResult& result) {
  if (result.at_horizon.empty()) {
    throw std::invalid_argument("breakdown: a result of scene " + result.scene->name + " has no horizons");
  }
  const RoundKey key = key_of(result);
  const std::vector<RecordedObject>& objects = result.scene->objects;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].is_given()) continue;  // nobody predicts it
    by_shape_[key][objects[i].shape].push_back(result.object_at_horizon.back().at(i));
  }
  by_num_objects_[key][static_cast<int>(objects.size())].push_back(result.at_horizon.back());
  for (const auto& [horizon, error] : result.curve) {
    by_frame_[key][horizon].push_back(error);
  }
}

std::map<RoundKey, std::map<std::string, PartialScore>> Breakdown::by_shape() const {
  return reduced(by_shape_, root_mean_square);
}

std::map<RoundKey, std::map<int, PartialScore>> Breakdown::by_num_objects() const {
  return reduced(by_num_objects_, mean_error);
}

std::map<RoundKey, std::map<int, PartialScore>> Breakdown::by_frame() const { return reduced(by_frame_, mean_error); }

}  // namespace rigidformer
