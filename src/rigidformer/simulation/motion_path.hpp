// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rigidformer/simulation/bullet_world.hpp"

namespace rigidformer {

/// Numbers that move smoothly from rest to rest through keys: a piecewise cubic with one derivative that nowhere passes
/// beyond the keys around it, so that what stays between two of them stands still (Fritsch and Carlson 1980). Before
/// the first key and after the last one nothing moves.
class MonotoneSpline {
 public:
  /// Adds a key. Throws std::invalid_argument where its time [s] is not later than the one before, or its numbers are
  /// not as many.
  void add_key(double time_s, const Eigen::VectorXd& values);

  /// Throws std::invalid_argument where there is no key.
  Eigen::VectorXd at(double time_s) const;

  double end_s() const { return times_s_.empty() ? 0.0 : times_s_.back(); }

 private:
  Eigen::VectorXd slope(std::size_t key) const;

  std::vector<double> times_s_;
  std::vector<Eigen::VectorXd> values_;
};

/// The state with which a body leaves a path at a time, to be on it again `step_s` later.
BodyState state_on(const MotionPath& path, double time_s, double step_s);

/// The path that begins so much later.
MotionPath started_after(MotionPath path, double delay_s);

/// The path of what never moves.
MotionPath standing_at(const RigidTransform& T_world_body);

}  // namespace rigidformer
