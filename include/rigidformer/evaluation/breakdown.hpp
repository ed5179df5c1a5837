// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "rigidformer/evaluation/metrics.hpp"
#include "rigidformer/evaluation/protocol.hpp"

namespace rigidformer {

/// One cell of the protocol: a set rolled out by one model from one start with one step size.
/// Keys are ordered as in tables.
struct RoundKey {
  std::string set;
  int start = 0;
  int step = 0;
  std::string model;

  bool operator<(const RoundKey& other) const;
};

RoundKey key_of(const SceneResult& result);

/// Mean error over a part of the scenes or objects of a round.
struct PartialScore {
  int count = 0;  ///< Number of objects of a shape, or of scenes
  PoseError error;
};

/// Splits the errors of the longest horizon by shape and by number of objects, and follows the error over time.
class Breakdown {
 public:
  void add(const SceneResult& result);

  /// For every shape: the root mean square over all objects of that shape in all scenes.
  std::map<RoundKey, std::map<std::string, PartialScore>> by_shape() const;

  /// For every number of objects in a scene: the mean over such scenes of the scene's error.
  std::map<RoundKey, std::map<int, PartialScore>> by_num_objects() const;

  /// For every frame (or millisecond, as horizons count) of the curves: the mean over the scenes that are long enough.
  std::map<RoundKey, std::map<int, PartialScore>> by_frame() const;

 private:
  template <typename Group>
  using Errors = std::map<RoundKey, std::map<Group, std::vector<PoseError>>>;

  Errors<std::string> by_shape_;  ///< One error per object
  Errors<int> by_num_objects_;    ///< One error per scene
  Errors<int> by_frame_;          ///< One error per scene
};

}  // namespace rigidformer
