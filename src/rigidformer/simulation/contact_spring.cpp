// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/contact_spring.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace rigidformer {
namespace {

constexpr double kLeastSteps = 6.0;        // per contact; shorter ones fall between two steps; chosen by eye
constexpr double kMinRestitution = 0.1;    // smaller ones cannot be stepped through and act as this; chosen by eye
constexpr double kMaxDampingRatio = 1.25;  // upper end of the search, above critical damping; chosen by eye
constexpr int kBisections = 40;            // halvings; derived: they leave a ratio's error below 1e-11
constexpr int kPhases = 8;                 // moments between two steps over which impacts are averaged; chosen by eye

/// Follows the contact from the first step that sees a depth until it stops pushing or opens.
double rebound_speed(const ContactSpring& spring, double solver_step_s, double first_depth) {
  double depth = first_depth;
  double speed = 1.0;  // towards the contact
  while (depth > 0.0) {
    speed -= solver_step_s * std::max(0.0, spring.stiffness * depth + spring.damping * speed);
    depth += solver_step_s * speed;
  }
  return -speed;
}

}  // namespace

double rebound_speed(const ContactSpring& spring, double solver_step_s) {
  double sum = 0.0;
  for (int phase = 0; phase < kPhases; ++phase) {
    sum += rebound_speed(spring, solver_step_s, (phase + 0.5) / kPhases * solver_step_s);
  }
  return sum / kPhases;
}

ContactSpring contact_spring(double restitution, double solver_step_s, double steps_per_contact) {
  if (!(restitution >= 0.0 && restitution <= 1.0)) {
    throw std::invalid_argument("contact_spring: restitution is " + std::to_string(restitution) +
                                ", must lie in [0, 1]");
  }
  if (!(solver_step_s > 0.0)) {
    throw std::invalid_argument("contact_spring: solver_step_s is " + std::to_string(solver_step_s) +
                                ", must be positive");
  }
  if (!(steps_per_contact >= kLeastSteps)) {
    throw std::invalid_argument("contact_spring: steps_per_contact is " + std::to_string(steps_per_contact) +
                                ", must be at least " + std::to_string(kLeastSteps));
  }
  const double frequency = M_PI / (steps_per_contact * solver_step_s);
  const auto damped = [&](double ratio) { return ContactSpring{frequency * frequency, 2.0 * ratio * frequency}; };
  double low = 0.0;
  double high = kMaxDampingRatio;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    const bool rebounds_more = rebound_speed(damped(middle), solver_step_s) > std::max(restitution, kMinRestitution);
    (rebounds_more ? low : high) = middle;
  }
  return damped(high);
}

}  // namespace rigidformer
