// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/rollout.hpp"

#include <algorithm>
#include <cmath>

namespace rigidformer {
namespace {

bool is_slow_enough(const RigidTransform& before, const RigidTransform& after, double dt_s,
                    const SettleCriterion& limit) {
  return (after.translation - before.translation).norm() <= limit.linear_speed_mps * dt_s &&
         rotation_angle(before.rotation, after.rotation) <= limit.angular_speed_rps * dt_s;
}

/// The larger one; NaN only where both are.
double known_maximum(double a, double b) { return std::isnan(a) ? b : std::isnan(b) ? a : std::max(a, b); }

}  // namespace

int settled_step(const std::vector<RigidTransform>& poses, double time_step_s, const SettleCriterion& criterion) {
  auto step = static_cast<int>(poses.size()) - 1;
  const auto pose = [&](int k) { return poses[static_cast<std::size_t>(k)]; };
  while (step > 0 && is_slow_enough(pose(step - 1), pose(step), time_step_s, criterion)) --step;
  const double settled_s = (static_cast<double>(poses.size()) - 1.0 - step) * time_step_s;
  return settled_s > 0.0 && settled_s >= criterion.duration_s ? step : -1;
}

int first_contact_step(const Forecast& forecast, int object) {
  for (const StepContact& contact : forecast.contacts) {
    if (contact.object_a == object || contact.object_b == object) return contact.step;
  }
  return -1;
}

std::vector<ContactSpan> contact_spans(const Forecast& forecast) {
  std::vector<ContactSpan> spans;
  for (const StepContact& contact : forecast.contacts) {
    const auto is_pair = [&](const ContactSpan& span) {
      return span.object_a == contact.object_a && span.object_b == contact.object_b;
    };
    const auto known = std::find_if(spans.begin(), spans.end(), is_pair);
    if (known == spans.end()) {
      spans.push_back({contact.object_a, contact.object_b, contact.step, contact.step, contact.penetration_m,
                       contact.normal_impulse_Ns});
      continue;
    }
    known->last_step = contact.step;
    known->max_penetration_m = std::max(known->max_penetration_m, contact.penetration_m);
    known->max_normal_impulse_Ns = known_maximum(known->max_normal_impulse_Ns, contact.normal_impulse_Ns);
  }
  return spans;
}

double max_tilt(const std::vector<RigidTransform>& poses) {
  double largest = 0.0;
  for (const RigidTransform& pose : poses) {
    const Eigen::Vector3d up = pose.rotation * (poses.front().rotation.conjugate() * Eigen::Vector3d::UnitZ());
    largest = std::max(largest, std::atan2(up.head<2>().norm(), up.z()));
  }
  return largest;
}

double path_length(const std::vector<RigidTransform>& poses) {
  double length = 0.0;
  for (std::size_t k = 1; k < poses.size(); ++k) length += (poses[k].translation - poses[k - 1].translation).norm();
  return length;
}

}  // namespace rigidformer
