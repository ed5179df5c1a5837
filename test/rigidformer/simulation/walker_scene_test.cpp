// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/walker_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rigidformer/simulation/scene_set.hpp"

namespace rigidformer {
namespace {

double angle_between(const Eigen::Vector2d& v, double direction_rad) {
  return std::abs(std::remainder(std::atan2(v.y(), v.x()) - direction_rad, 2.0 * M_PI));
}

/// Where something points that points along x in its own frame.
double yaw_of(const RigidTransform& T) {
  const Eigen::Vector3d ahead = T.rotation * Eigen::Vector3d::UnitX();
  return std::atan2(ahead.y(), ahead.x());
}

Eigen::Vector2d place(const SceneRecording& scene, std::size_t part, std::size_t frame) {
  return scene.objects[part].T_world_object[frame].translation.head<2>();
}

class WalkerScene : public ::testing::TestWithParam<std::string> {
 protected:
  const WalkerDesign& design_ = *walker_set(GetParam());

  std::vector<WalkerCommand> commanded(double speed_mps, double direction_rad, double facing_rad, int frames) const {
    WalkerCommand command{speed_mps, direction_rad, std::nullopt};
    if (design_.neck) command.facing_rad = facing_rad;
    return std::vector<WalkerCommand>(static_cast<std::size_t>(frames), command);
  }
};

TEST_P(WalkerScene, HasThePartsPointsAndCommandsOfThePaper) {
  const bool has_head = GetParam() == "walker_15";
  EXPECT_EQ(design_.parts.size(), has_head ? 15u : 31u);
  EXPECT_EQ(max_num_objects(GetParam()), static_cast<int>(design_.parts.size()));
  for (const Shape& shape : walker_shapes(design_)) {
    EXPECT_GE(shape.vertices().rows(), 200) << shape.name;
    EXPECT_LE(shape.vertices().rows(), 300) << shape.name;
  }
  MoviOptions options;
  options.num_frames = usual_num_frames(GetParam());
  const SceneRecording scene = generate_scene(GetParam(), {}, 1, 0, options);
  EXPECT_EQ(scene.num_frames, 300);
  EXPECT_EQ(scene.frame_rate_hz, 30.0);
  ASSERT_EQ(scene.control.size(), 300u);
  EXPECT_EQ(scene.control[0].size(), has_head ? 5u : 3u);
  EXPECT_NE(scene.control.front(), scene.control.back());
}

TEST_P(WalkerScene, SameSeedGivesTheSameMotion) {
  const auto commands = draw_walker_commands(design_, 5, 2, 30);
  const SceneRecording a = simulate_walker(design_, commands, 5, 2), b = simulate_walker(design_, commands, 5, 2);
  EXPECT_EQ(place(a, 0, 29), place(b, 0, 29));
}

TEST_P(WalkerScene, WalksAndLooksWhereItIsToldAlsoAfterAChange) {
  for (const double turn_rad : {0.5 * M_PI, -0.5 * M_PI}) {
    std::vector<WalkerCommand> commands = commanded(0.5, 0.3, -0.2, 60);
    const double new_direction_rad = 0.3 + turn_rad, new_facing_rad = new_direction_rad + 0.4;
    const auto changed = commanded(0.5, new_direction_rad, new_facing_rad, 120);
    commands.insert(commands.end(), changed.begin(), changed.end());
    const SceneRecording scene = simulate_walker(design_, commands, 1, 0);
    EXPECT_LT(angle_between(place(scene, 0, 59) - place(scene, 0, 20), 0.3), 0.2);
    const Eigen::Vector2d after = place(scene, 0, 179) - place(scene, 0, 119);
    EXPECT_LT(angle_between(after, new_direction_rad), 0.2);
    EXPECT_GT(after.norm(), 0.6 * 0.5 * 2.0);  // two seconds at half a metre per second
    if (!design_.neck) continue;
    EXPECT_LT(std::abs(std::remainder(yaw_of(scene.objects.back().T_world_object[179]) - new_facing_rad, 2.0 * M_PI)),
              0.15);
  }
}

TEST_P(WalkerScene, ASlowerCommandGivesASlowerWalk) {
  const auto way = [&](double speed_mps) {
    const SceneRecording scene = simulate_walker(design_, commanded(speed_mps, 0.0, 0.0, 60), 1, 0);
    return (place(scene, 0, 59) - place(scene, 0, 0)).norm();
  };
  EXPECT_GT(way(0.5), 1.6 * way(0.25));
}

TEST_P(WalkerScene, StaysUprightWithItsPartsTogether) {
  const SceneRecording scene = simulate_walker(design_, draw_walker_commands(design_, 8, 0, 150), 8, 0);
  for (std::size_t frame = 0; frame < 150; ++frame) {
    const RigidTransform& T_world_torso = scene.objects[0].T_world_object[frame];
    EXPECT_GT((T_world_torso.rotation * Eigen::Vector3d::UnitZ()).z(), 0.98);
    EXPECT_NEAR(T_world_torso.translation.z(), design_.height_m, 0.05);
    for (const WalkerHinge& hinge : design_.hinges) {
      const auto on = [&](int part) {
        const auto index = static_cast<std::size_t>(part);
        return scene.objects[index].T_world_object[frame] * (design_.parts[index].T_torso_part.inverse() * hinge.point);
      };
      EXPECT_LT((on(hinge.parent) - on(hinge.child)).norm(), 0.01);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, WalkerScene, ::testing::ValuesIn(walker_set_names()),
                         [](const auto& set) { return set.param; });

}  // namespace
}  // namespace rigidformer
