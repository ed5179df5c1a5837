// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "rigidformer/evaluation/metrics.hpp"
#include "rigidformer/evaluation/protocol.hpp"

namespace rigidformer {

/// One cell of the protocol: a set rolled out by one model from one start with one step size. In the order of tables.
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
  int count = 0;  ///< Objects of a shape, or scenes
  PoseError error;
};

/// Splits the errors of the longest horizon by shape and by number of objects, and follows the error over time.
class Breakdown {
 public:
  void add(const SceneResult& result);

  /// Per shape: root mean square over all objects of that shape in all scenes.
  std::map<RoundKey, std::map<std::string, PartialScore>> by_shape() const;

  /// Per number of objects in the scene: mean over those scenes of the scene's error.
  std::map<RoundKey, std::map<int, PartialScore>> by_num_objects() const;

  /// Per frame after the start: mean over the scenes that are long enough.
  std::map<RoundKey, std::map<int, PartialScore>> by_frame() const;

 private:
  template <typename Group>
  using Errors = std::map<RoundKey, std::map<Group, std::vector<PoseError>>>;

  Errors<std::string> by_shape_;  ///< One entry per object
  Errors<int> by_num_objects_;    ///< One entry per scene, as in the next
  Errors<int> by_frame_;
};

}  // namespace rigidformer
