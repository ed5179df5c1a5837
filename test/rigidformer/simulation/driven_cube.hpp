// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "rigidformer/simulation/builtin_shapes.hpp"
#include "rigidformer/simulation/motion_path.hpp"
#include "rigidformer/simulation/movi_scene.hpp"

namespace rigidformer {

/// A cube of 1 m on the floor, and cubes around it that are static or follow a path. Gravity is 10 m/s^2.
struct DrivenCube {
  SceneRecording scene;
  std::vector<MotionPath> paths{{}};

  explicit DrivenCube(double height_m = 0.501) {
    scene.num_frames = 1;
    add({Eigen::Quaterniond::Identity(), {0.0, 0.0, height_m}}, 1.0).properties.mass_kg = 1.0;
  }

  void add_driven(double size, MotionPath path) {
    add(path(0.0), size).is_driven = true;
    paths.push_back(std::move(path));
  }

  void add_static(double size, const RigidTransform& T) {
    add(T, size).is_static = true;
    paths.emplace_back();
  }

 private:
  RecordedObject& add(const RigidTransform& T, double size) {
    RecordedObject object;
    object.shape = "cube";
    object.size = size;
    object.properties = {std::nullopt, 0.9, 0.0};
    object.T_world_object = {T};
    scene.objects.push_back(object);
    return scene.objects.back();
  }
};

inline MotionPath straight(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double begin_s, double end_s) {
  MonotoneSpline spline;
  spline.add_key(begin_s, from);
  spline.add_key(end_s, to);
  return [spline](double time_s) {
    return RigidTransform{Eigen::Quaterniond::Identity(), Eigen::Vector3d(spline.at(time_s))};
  };
}

/// What holds for scenes of every engine, which `simulate(driven, num_frames)` moves.
template <typename Simulate>
void expect_a_pushed_cube_moves_with_its_pusher(const Simulate& simulate) {
  DrivenCube driven;
  driven.add_driven(0.5, straight({-1.0, 0.0, 0.501}, {0.5, 0.0, 0.501}, 0.1, 1.6));
  const SceneRecording recorded = simulate(driven, 480);
  const auto& cube = recorded.objects[0].T_world_object;
  const auto& pusher = recorded.objects[1].T_world_object;
  for (std::size_t frame = 0; frame < pusher.size(); ++frame) {
    const double time_s = static_cast<double>(frame) / recorded.frame_rate_hz;
    EXPECT_LT((pusher[frame].translation - driven.paths[1](time_s).translation).norm(), 1e-6);
  }
  EXPECT_NEAR(cube[60].translation.x(), 0.0, 5e-3) << "before it is touched";
  EXPECT_NEAR(cube[300].translation.x() - pusher[300].translation.x(), 0.75, 0.02) << "while it is pushed";
  EXPECT_NEAR(cube.back().translation.x(), 1.25, 0.15) << "it slides on a little";
}

template <typename Simulate>
void expect_a_gripped_cube_is_lifted_and_falls(const Simulate& simulate) {
  DrivenCube driven;
  for (const double side : {-1.0, 1.0}) {
    MonotoneSpline spline;  // how far the middle of the finger is from the middle of the cube, and how high it is
    const auto key = [](double open_m, double rise_m) { return Eigen::Vector2d(0.8 + open_m, 0.501 + rise_m); };
    spline.add_key(0.1, key(0.2, 0.0));
    spline.add_key(0.4, key(-0.002, 0.0));
    spline.add_key(0.5, key(-0.002, 0.0));
    spline.add_key(1.0, key(-0.002, 1.0));
    spline.add_key(1.2, key(-0.002, 1.0));
    spline.add_key(1.3, key(0.3, 1.0));
    driven.add_driven(0.6, [spline, side](double time_s) {
      const Eigen::VectorXd at = spline.at(time_s);
      return RigidTransform{Eigen::Quaterniond::Identity(), {side * at[0], 0.0, at[1]}};
    });
  }
  const SceneRecording recorded = simulate(driven, 480);
  const auto& cube = recorded.objects[0].T_world_object;
  EXPECT_NEAR(cube[110].translation.z(), 0.501, 0.01);
  EXPECT_NEAR(cube[280].translation.z(), 1.501, 0.05) << "held up";
  EXPECT_NEAR(cube[430].translation.z(), 0.5, 0.1) << "fallen";
}

template <typename Simulate>
void expect_static_bodies_carry_and_never_move(const Simulate& simulate) {
  DrivenCube driven(3.0);
  driven.add_static(2.0, {Eigen::Quaterniond::Identity(), {0.0, 0.0, 1.2}});
  const SceneRecording recorded = simulate(driven, 360);
  for (const RigidTransform& T : recorded.objects[1].T_world_object) {
    EXPECT_LT((T.translation - Eigen::Vector3d(0.0, 0.0, 1.2)).norm(), 1e-6);
    EXPECT_LT(rotation_angle(T.rotation, Eigen::Quaterniond::Identity()), 1e-6);
  }
  EXPECT_NEAR(recorded.objects[0].T_world_object.back().translation.z(), 2.7, 0.02);
}

template <typename Simulate>
void expect_a_palm_lifts_what_lies_on_it(const Simulate& simulate) {
  DrivenCube driven(2.501);
  driven.add_driven(2.0, straight({0.0, 0.0, 1.0}, {0.3, 0.0, 1.8}, 0.2, 1.2));
  const SceneRecording recorded = simulate(driven, 360);
  EXPECT_NEAR(recorded.objects[0].T_world_object.back().translation.z(), 3.3, 0.02);
  EXPECT_NEAR(recorded.objects[0].T_world_object.back().translation.x(), 0.3, 0.06) << "friction takes it along";
}

}  // namespace rigidformer
