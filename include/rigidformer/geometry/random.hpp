// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <random>

namespace rigidformer {

/// Random numbers that are the same on every platform. The standard fixes the engine but not its distributions, so that
/// the mapping to intervals is our own. Each (seed, stream) pair is an independent sequence.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0);

  /// Draws a number uniformly from [low, high).
  double uniform(double low, double high);

  /// Draws an integer uniformly from [low, high], both included. Requires low <= high.
  int uniform_int(int low, int high);

  /// Draws a rotation uniformly from all rotations.
  Eigen::Quaterniond rotation();

 private:
  std::mt19937_64 engine_;
};

}  // namespace rigidformer
