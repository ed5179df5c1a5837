// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "drivers.hpp"

#include <algorithm>
#include <memory>

namespace rigidformer {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// Robots push, carry and grip things of about 0.1 m at 0.02 ... 1 m/s. Objects of the MOVi sets are ten times as large:
// with times and speeds as the root of lengths, gravity being the same, this is 0.06 ... 3.2 m/s.
constexpr Range kRealSpeed_mps{0.02, 1.0};
constexpr double kLengthRatio = 10.0;

// All other numbers were chosen by eye: [m] where objects are about 1 m large, [s] there as well.
constexpr Range kOnset{0.02, 0.3};  // of the recording
constexpr double kClearance = 0.02, kSqueeze = 0.002, kShortestMove_s = 0.03;
constexpr Range kPusherEdge{0.2, 1.0}, kPusherThickness{0.1, 0.4}, kPushTime{0.3, 0.9}, kApproachTime{0.03, 0.4};
constexpr double kLongestPush = 3.0, kLongestApproach = 1.2, kPegShare = 0.3;
constexpr Range kAside{-0.3, 0.3}, kPusherTurn_rad{-0.4, 0.4}, kPause{0.03, 0.4};
constexpr Range kFingerThickness{0.12, 0.3}, kFingerShare{0.35, 0.9}, kLift{0.3, 1.5}, kCarry{0.0, 2.0};
constexpr Range kGripperTurn_rad{-0.8, 0.8}, kOpening{0.1, 0.5};
constexpr int kGraspTries = 6;
constexpr Range kPalmEdge{1.3, 2.6}, kPalmThickness{0.1, 0.3}, kPalmHeight{0.2, 1.2}, kTilt_rad{0.15, 0.8};
constexpr double kPalmTime = 0.7;

/// A spline under way: where it is, and when.
struct Track {
  const DriverScale& scale;
  Random& random;
  std::shared_ptr<MonotoneSpline> spline = std::make_shared<MonotoneSpline>();
  VectorXd values;
  double time_s = 0.0;

  Track(const DriverScale& of_scene, Random& generator, const VectorXd& start, double start_s)
      : scale(of_scene), random(generator), values(start), time_s(start_s) {
    spline->add_key(time_s, values);
  }

  void wait(double duration_s) {
    time_s += std::max(duration_s, kShortestMove_s * scale.unit_s());
    spline->add_key(time_s, values);
  }

  /// Goes to `goal`, most of the way at an even speed.
  void go(const VectorXd& goal, double duration_s) {
    constexpr double kRamp = 0.2, kRampWay = 0.12;  // of the time and of the way, to start and to stop
    const VectorXd start = values;
    const double begin_s = time_s, length_s = std::max(duration_s, kShortestMove_s * scale.unit_s());
    spline->add_key(begin_s + kRamp * length_s, start + kRampWay * (goal - start));
    spline->add_key(begin_s + (1.0 - kRamp) * length_s, start + (1.0 - kRampWay) * (goal - start));
    values = goal;
    time_s = begin_s + length_s;
    spline->add_key(time_s, values);
  }

  double draw_speed() const {
    return draw_magnitude(random, kRealSpeed_mps) * std::sqrt(kLengthRatio) * scale.unit_mps();
  }
};

double draw_onset(const DriverScale& scale, Random& random) { return scale.duration_s * draw(random, kOnset); }

VectorXd numbers(std::initializer_list<double> values) {
  VectorXd vector(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), vector.data());
  return vector;
}

/// The frame at `origin` whose x axis is `ahead`, which is level.
RigidTransform frame_towards(const Vector3d& ahead, const Vector3d& origin) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(std::atan2(ahead.y(), ahead.x()), Vector3d::UnitZ())), origin};
}

RigidTransform with_block(const RigidTransform& T_world_body, const Block& block) {
  return {(T_world_body.rotation * block.rotation).normalized(), T_world_body.translation};
}

Block draw_pusher_block(const DriverScale& scale, Random& random) {
  const double width = scale.unit_m * draw_magnitude(random, kPusherEdge);
  const double height = scale.unit_m * draw_magnitude(random, kPusherEdge);
  const double thickness = scale.unit_m * draw_magnitude(random, kPusherThickness);
  return draw_chance(random, kPegShare) ? peg_of(thickness, height) : block_of({thickness, width, height});
}

/// Pushes and goes back until the recording is over. The numbers of the track: ahead, aside [m], turn [rad].
void push_on(Track& track, double approach_m) {
  Random& random = track.random;
  const double unit_m = track.scale.unit_m, unit_s = track.scale.unit_s();
  while (track.time_s < track.scale.duration_s) {
    const double speed = track.draw_speed();
    const double way = std::min(speed * unit_s * draw(random, kPushTime), kLongestPush * unit_m) + approach_m;
    const VectorXd start = track.values;
    track.go(start + numbers({way, way * draw(random, kAside), draw(random, kPusherTurn_rad)}), way / speed);
    track.wait(unit_s * draw(random, kPause));
    approach_m = 0.0;
    if (draw_chance(random, 0.5)) continue;
    const double back = random.uniform(0.1, 0.6);
    track.go(track.values + back * (start - track.values), back * way / track.draw_speed());
    track.wait(unit_s * draw(random, kPause));
    approach_m = back * way;
  }
}

/// Moves of a palm: rise, aside (two) [m], and a rotation vector [rad].
VectorXd draw_palm_move(const DriverScale& scale, double rise_m, Random& random) {
  VectorXd move = VectorXd::Zero(6);
  const double kind = random.uniform(0.0, 1.0);
  if (kind < 0.35) {
    const double lift = scale.unit_m * draw(random, kLift);
    move[0] = rise_m > 0.0 && draw_chance(random, 0.5) ? -std::min(lift, rise_m) : lift;
  } else if (kind < 0.6) {
    move.segment<3>(0) = scale.unit_m * draw(random, kCarry) * draw_direction(random);
    std::swap(move[0], move[2]);  // the third number of the direction is 0
  } else {
    move.tail<3>() = draw(random, kTilt_rad) * draw_direction(random);
  }
  return move;
}

/// Where the fingers touch the object.
struct Grasp {
  RigidTransform T_world_hand;  ///< x is the direction in which they close; at the height of the fingers
  Block finger;
  double far_m = 0.0;                    ///< From the hand's origin to the fingers when they are open as wide as can be
  double first_m = 0.0, second_m = 0.0;  ///< How far each moves from there to touch
};

std::optional<Grasp> draw_grasp(const DriverScale& scale, const DriverTarget& target, Random& random) {
  const Vector3d size = target.bounds_world.sizes();
  const double height = size.z() * random.uniform(0.6, 1.0) + 0.2 * scale.unit_m;
  Grasp grasp;
  grasp.finger =
      block_of({scale.unit_m * draw(random, kFingerThickness),
                std::max(size.head<2>().minCoeff() * draw(random, kFingerShare), 0.15 * scale.unit_m), height});
  Vector3d middle = target.bounds_world.center();
  middle.z() = target.bounds_world.min().z() + kClearance * scale.unit_m + 0.5 * grasp.finger.edges.z();
  grasp.T_world_hand = frame_towards(draw_direction(random), middle);
  const Vector3d ahead = grasp.T_world_hand.rotation * Vector3d::UnitX();
  grasp.far_m = 0.5 * size.head<2>().norm() + grasp.finger.edges.x() + 0.6 * scale.unit_m;
  const auto reach = [&](double side) {
    RigidTransform T = grasp.T_world_hand;
    T.translation += side * grasp.far_m * ahead;
    return target.reach(grasp.finger, with_block(T, grasp.finger), -side * ahead, grasp.far_m);
  };
  const auto first = reach(-1.0), second = reach(1.0);
  if (!first || !second) return std::nullopt;
  grasp.first_m = *first;
  grasp.second_m = *second;
  return grasp;
}

/// Closes, lifts, carries, perhaps lowers, releases and rises. The numbers of the track: by how much the fingers are
/// open [m], rise, aside (two) [m], turn [rad].
void grip_and_carry(Track& track) {
  Random& random = track.random;
  const double unit_m = track.scale.unit_m, unit_s = track.scale.unit_s();
  const auto move = [&](Eigen::Index first, const VectorXd& by, double most_s) {
    const double speed = track.draw_speed(), way = by.norm();
    if (way <= 0.0) return;
    const double share = std::min(1.0, speed * most_s * unit_s / way);
    VectorXd goal = track.values;
    goal.segment(first, by.size()) += share * by;
    track.go(goal, share * way / speed);
  };
  VectorXd closed = track.values;
  closed[0] = -kSqueeze * unit_m;
  track.go(closed, (track.values[0] - closed[0]) / track.draw_speed());
  track.wait(0.05 * unit_s);
  move(1, numbers({unit_m * draw(random, kLift)}), 0.5);
  const Vector3d aside = unit_m * draw(random, kCarry) * draw_direction(random);
  if (draw_chance(random, 0.7)) move(2, numbers({aside.x(), aside.y()}), 0.6);
  if (draw_chance(random, 0.5)) move(4, numbers({draw(random, kGripperTurn_rad)}), 0.4);
  if (draw_chance(random, 0.4)) move(1, numbers({-track.values[1] * random.uniform(0.3, 0.95)}), 0.3);
  track.wait(0.3 * unit_s * random.uniform(0.1, 1.0));
  move(0, numbers({unit_m * draw(random, kOpening) - track.values[0]}), 0.3);
  move(1, numbers({unit_m * draw(random, kLift)}), 0.5);
}

}  // namespace

std::optional<Driver> draw_pusher(const DriverScale& scale, const DriverTarget& target, Random& random) {
  const Block block = draw_pusher_block(scale, random);
  const Vector3d ahead = draw_direction(random), size = target.bounds_world.sizes();
  const double far_m = 0.5 * size.head<2>().norm() + 0.5 * block.edges.norm() + kLongestApproach * scale.unit_m;
  const double aside_m = 0.3 * size.head<2>().minCoeff() * random.uniform(-1.0, 1.0);
  Vector3d start = target.bounds_world.center() - far_m * ahead + aside_m * Vector3d(-ahead.y(), ahead.x(), 0.0);
  start.z() = target.bounds_world.min().z() + kClearance * scale.unit_m + 0.5 * block.edges.z();
  RigidTransform T_world_start = frame_towards(ahead, start);
  const auto reach_m = target.reach(block, with_block(T_world_start, block), ahead, far_m);
  if (!reach_m) return std::nullopt;
  Track track(scale, random, VectorXd::Zero(3), draw_onset(scale, random));
  const double wished_m = track.draw_speed() * scale.unit_s() * draw(random, kApproachTime);
  const double approach_m = std::clamp(wished_m, 0.01 * scale.unit_m, *reach_m);
  T_world_start.translation += (*reach_m - approach_m) * ahead;
  push_on(track, approach_m);
  const auto path = [T_world_start, block, spline = track.spline](double time_s) {
    const VectorXd at = spline->at(time_s);
    const RigidTransform moved{rotation_about({0.0, 0.0, at[2]}), {at[0], at[1], 0.0}};
    return with_block(T_world_start * moved, block);
  };
  return Driver{{block}, {path}};
}

std::optional<Driver> draw_gripper(const DriverScale& scale, const DriverTarget& target, Random& random) {
  std::optional<Grasp> best;
  for (int i = 0; i < kGraspTries; ++i) {
    const auto grasp = draw_grasp(scale, target, random);
    if (!grasp) continue;
    if (!best || grasp->first_m + grasp->second_m > best->first_m + best->second_m) best = grasp;
  }
  if (!best) return std::nullopt;
  const double most_open_m = std::min(best->first_m, best->second_m);
  const double wished_m = scale.unit_m * draw(random, kOpening);
  Track track(scale, random, numbers({std::min(wished_m, most_open_m), 0.0, 0.0, 0.0, 0.0}), draw_onset(scale, random));
  grip_and_carry(track);
  Driver driver;
  driver.grips = true;
  for (const double side : {-1.0, 1.0}) {
    const double touching_m = best->far_m - (side < 0.0 ? best->first_m : best->second_m);
    driver.blocks.push_back(best->finger);
    driver.paths.push_back([grasp = *best, side, touching_m, spline = track.spline](double time_s) {
      const VectorXd at = spline->at(time_s);
      RigidTransform T = grasp.T_world_hand;
      T.translation += Vector3d(at[2], at[3], at[1]);
      T.rotation = T.rotation * rotation_about({0.0, 0.0, at[4]});
      T.translation += T.rotation * Vector3d(side * (touching_m + at[0]), 0.0, 0.0);
      return with_block(T, grasp.finger);
    });
  }
  return driver;
}

Driver draw_palm(const DriverScale& scale, const Vector3d& foot_world, Random& random) {
  const Block block = block_of({scale.unit_m * draw(random, kPalmEdge), scale.unit_m * draw(random, kPalmEdge),
                                scale.unit_m * draw(random, kPalmThickness)});
  const double rise_m = scale.unit_m * draw(random, kPalmHeight);
  const RigidTransform T_world_start =
      frame_towards(draw_direction(random), foot_world + Vector3d(0.0, 0.0, rise_m + 0.5 * block.edges.z()));
  Track track(scale, random, VectorXd::Zero(6), draw_onset(scale, random));
  while (track.time_s < scale.duration_s) {
    const VectorXd move = draw_palm_move(scale, rise_m + track.values[0], random);
    VectorXd way = move;
    if (track.values.tail<3>().norm() > 0.0) way.tail<3>() = -track.values.tail<3>();  // one tilt at a time
    // The speed of a turn is that of the slab's end.
    const double length_m = way.head<3>().norm() + 0.5 * block.edges.maxCoeff() * way.tail<3>().norm();
    const double speed = track.draw_speed();
    const double share = std::min(1.0, speed * scale.unit_s() * kPalmTime / std::max(length_m, 1e-9));
    track.go(track.values + share * way, share * length_m / speed);
    track.wait(scale.unit_s() * draw(random, kPause));
  }
  return {{block}, {[T_world_start, block, spline = track.spline](double time_s) {
            const VectorXd at = spline->at(time_s);
            RigidTransform T = T_world_start;
            T.translation += Vector3d(at[1], at[2], at[0]);
            T.rotation = rotation_about(at.tail<3>()) * T.rotation;
            return with_block(T, block);
          }}};
}

}  // namespace rigidformer
