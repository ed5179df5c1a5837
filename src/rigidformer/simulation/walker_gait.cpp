// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "walker_gait.hpp"

#include <algorithm>
#include <cmath>

namespace rigidformer {
namespace {

// The gait; all chosen by eye.
constexpr double kCycles_hz = 1.2;
constexpr double kMaxTurn_radps = 1.2, kTurnGain_hz = 2.5;  // towards the commanded direction
constexpr double kLag_s = 0.15;                             // in which legs and neck follow a new command
constexpr double kMaxSwing_rad = 0.45;                      // to each side
constexpr double kLift_rad = 0.35;
constexpr double kMaxLook_rad = 2.0;
constexpr double kNod_rad = 0.1;

double wrapped(double angle_rad) { return std::remainder(angle_rad, 2.0 * M_PI); }

}  // namespace

std::vector<double> WalkerCommand::numbers() const {
  std::vector<double> numbers{speed_mps, std::cos(direction_rad), std::sin(direction_rad)};
  if (facing_rad) numbers.insert(numbers.end(), {std::cos(*facing_rad), std::sin(*facing_rad)});
  return numbers;
}

std::vector<double> WalkerGait::advance(const WalkerCommand& command, double yaw_rad, double time_step_s) {
  const double aside_rad = wrapped(command.direction_rad - yaw_rad);
  const double share = std::min(1.0, time_step_s / kLag_s);
  forward_mps_ += share * (command.speed_mps * std::max(0.0, std::cos(aside_rad)) - forward_mps_);
  turn_radps_ += share * (std::clamp(kTurnGain_hz * aside_rad, -kMaxTurn_radps, kMaxTurn_radps) - turn_radps_);
  phase_ += kCycles_hz * time_step_s;

  std::vector<double> angles(design_.hinges.size(), 0.0);
  for (const WalkerLeg& leg : design_.legs) place_leg(leg, angles);
  if (design_.neck) {
    const double look_rad =
        std::clamp(wrapped(command.facing_rad.value_or(yaw_rad) - yaw_rad), -kMaxLook_rad, kMaxLook_rad);
    look_rad_ += share * (look_rad - look_rad_);
    const auto neck = static_cast<std::size_t>(*design_.neck);
    angles[neck] = look_rad_;
    angles[neck + 1] = kNod_rad * std::sin(2.0 * M_PI * phase_);
  }
  return angles;
}

void WalkerGait::place_leg(const WalkerLeg& leg, std::vector<double>& angles) const {
  const Eigen::Vector2d outward(std::cos(leg.outward_rad), std::sin(leg.outward_rad));
  const Eigen::Vector2d foot = leg.hip.head<2>() + leg.reach_m * outward;
  // A foot that stands moves against the torso; the swing gives what of it lies across the leg.
  const Eigen::Vector2d back(-forward_mps_ + turn_radps_ * foot.y(), -turn_radps_ * foot.x());
  const double across_mps = back.dot(Eigen::Vector2d(-outward.y(), outward.x()));
  const double stance_s = 0.5 / kCycles_hz;
  const double swing_rad = std::clamp(0.5 * across_mps / leg.reach_m * stance_s, -kMaxSwing_rad, kMaxSwing_rad);

  const double phase = phase_ + leg.phase - std::floor(phase_ + leg.phase);
  const bool stands = phase < 0.5;
  const double done = stands ? 2.0 * phase : 2.0 * phase - 1.0;  // of stance or swing
  const double lift_rad = stands ? 0.0 : kLift_rad * std::sin(M_PI * done);
  angles[static_cast<std::size_t>(leg.swing)] = swing_rad * (stands ? 2.0 * done - 1.0 : std::cos(M_PI * done));
  angles[static_cast<std::size_t>(leg.lift)] = lift_rad;
  if (leg.upright) angles[static_cast<std::size_t>(*leg.upright)] = -lift_rad;
}

}  // namespace rigidformer
