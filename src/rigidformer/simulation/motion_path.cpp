// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion_path.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace rigidformer {

void MonotoneSpline::add_key(double time_s, const Eigen::VectorXd& values) {
  if (!times_s_.empty() && (!(time_s > times_s_.back()) || values.size() != values_.back().size())) {
    throw std::invalid_argument("spline: a key at " + std::to_string(time_s) + " s with " +
                                std::to_string(values.size()) + " numbers after one at " +
                                std::to_string(times_s_.back()) + " s with " + std::to_string(values_.back().size()));
  }
  times_s_.push_back(time_s);
  values_.push_back(values);
}

/// The harmonic mean of the slopes on both sides, weighted by the distances to the neighbours; 0 at the ends and where
/// the direction turns.
Eigen::VectorXd MonotoneSpline::slope(std::size_t key) const {
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(values_[key].size());
  if (key == 0 || key + 1 == values_.size()) return slope;
  const double before_s = times_s_[key] - times_s_[key - 1], after_s = times_s_[key + 1] - times_s_[key];
  const Eigen::VectorXd before = (values_[key] - values_[key - 1]) / before_s;
  const Eigen::VectorXd after = (values_[key + 1] - values_[key]) / after_s;
  const double weight_before = 2.0 * after_s + before_s, weight_after = after_s + 2.0 * before_s;
  for (Eigen::Index i = 0; i < slope.size(); ++i) {
    if (before[i] * after[i] <= 0.0) continue;
    slope[i] = (weight_before + weight_after) / (weight_before / before[i] + weight_after / after[i]);
  }
  return slope;
}

Eigen::VectorXd MonotoneSpline::at(double time_s) const {
  if (times_s_.empty()) throw std::invalid_argument("spline: there is no key");
  const auto next = std::upper_bound(times_s_.begin(), times_s_.end(), time_s);
  if (next == times_s_.begin()) return values_.front();
  if (next == times_s_.end()) return values_.back();
  const auto i = static_cast<std::size_t>(next - times_s_.begin());
  const double length_s = times_s_[i] - times_s_[i - 1], u = (time_s - times_s_[i - 1]) / length_s, v = 1.0 - u;
  return v * v * (1.0 + 2.0 * u) * values_[i - 1] + u * u * (1.0 + 2.0 * v) * values_[i] +
         length_s * u * v * (v * slope(i - 1) - u * slope(i));
}

BodyState state_on(const MotionPath& path, double time_s, double step_s) {
  const RigidTransform now = path(time_s), coming = path(time_s + step_s);
  return {now, (coming.translation - now.translation) / step_s,
          rotation_vector(coming.rotation * now.rotation.conjugate()) / step_s};
}

MotionPath started_after(MotionPath path, double delay_s) {
  return [path = std::move(path), delay_s](double time_s) { return path(time_s - delay_s); };
}

MotionPath standing_at(const RigidTransform& T_world_body) {
  return [T_world_body](double) { return T_world_body; };
}

}  // namespace rigidformer
