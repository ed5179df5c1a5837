// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/wrecking_ball_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "rigidformer/simulation/hull_distance.hpp"
#include "rigidformer/simulation/scene_set.hpp"

namespace rigidformer {
namespace {

const ConvexPart& part_of(const RecordedObject& object) {
  const auto& shapes = wrecking_ball_shapes();
  return std::find_if(shapes.begin(), shapes.end(), [&](const Shape& s) { return s.name == object.shape; })->parts[0];
}

SolidHull hull_of(const RecordedObject& object) {
  ConvexPart part = part_of(object);
  part.vertices *= static_cast<float>(object.size);
  return SolidHull(part);
}

/// Kinetic energy of the centres and height [J]; turning is left out, so that it can only be too small.
double energy(const SceneRecording& scene, std::size_t frame) {
  double sum = 0.0;
  for (const RecordedObject& object : scene.objects) {
    const double mass = *object.properties.mass_kg;
    sum += 0.5 * mass * object.velocities[frame].squaredNorm() -
           mass * scene.gravity.z() * object.T_world_object[frame].translation.z();
  }
  return sum;
}

TEST(WreckingBallScene, HasTheNumbersOfObjectsCornersAndMaterialOfThePaper) {
  EXPECT_EQ(wrecking_ball_shapes()[0].vertices().rows(), 8);
  for (const std::string& set : wrecking_ball_set_names()) {
    const SceneRecording scene = sample_wrecking_ball_scene(*wrecking_ball_set(set), 1, 0);
    EXPECT_EQ("wrecking_ball_" + std::to_string(scene.objects.size()), set);
    EXPECT_EQ(static_cast<int>(scene.objects.size()), max_num_objects(set));
    EXPECT_EQ(usual_num_frames(set), 600);
    const auto is_cube = [](const RecordedObject& object) {
      return object.shape == "block" && object.properties.mass_kg == 1.0 && object.properties.friction == 0.5 &&
             object.properties.restitution == 0.3;
    };
    EXPECT_EQ(std::count_if(scene.objects.begin(), scene.objects.end(), is_cube),
              static_cast<std::ptrdiff_t>(scene.objects.size()) - 1);
    EXPECT_EQ(scene.objects.back().shape, "sphere");
  }
}

TEST(WreckingBallScene, StartsWithoutOverlapAndAboveTheFloor) {
  for (std::uint64_t index = 0; index < 5; ++index) {
    const SceneRecording scene = sample_wrecking_ball_scene(*wrecking_ball_set("wrecking_ball_65"), 3, index);
    std::vector<SolidHull> hulls;
    for (const RecordedObject& object : scene.objects) hulls.push_back(hull_of(object));
    for (std::size_t a = 0; a < scene.objects.size(); ++a) {
      const RigidTransform& T_a = scene.objects[a].T_world_object[0];
      const Eigen::Matrix3Xd corners = T_a.rotation.toRotationMatrix() * hulls[a].vertices();
      EXPECT_GT(corners.row(2).minCoeff() + T_a.translation.z(), 0.0);
      for (std::size_t b = 0; b < a; ++b) {
        const auto closest = closest_points(hulls[a], T_a, hulls[b], scene.objects[b].T_world_object[0]);
        ASSERT_TRUE(closest);
        EXPECT_GT(closest->gap_m, 0.0) << a << ' ' << b;
      }
    }
  }
}

TEST(WreckingBallScene, SameSeedGivesTheSameMotionAndAnotherSeedAnother) {
  MoviOptions options;
  options.num_frames = 30;
  const auto last_ball = [&](std::uint64_t seed) {
    const SceneRecording scene = generate_scene("wrecking_ball_28", wrecking_ball_shapes(), seed, 0, options);
    return scene.objects.back().T_world_object.back().translation;
  };
  EXPECT_EQ(last_ball(4), last_ball(4));
  EXPECT_GT((last_ball(4) - last_ball(5)).norm(), 0.01);
}

TEST(WreckingBallScene, TheBallMovesCubesEnergyIsLostAndNothingSinks) {
  MoviOptions options;
  options.num_frames = 120;
  const SceneRecording scene = generate_scene("wrecking_ball_28", wrecking_ball_shapes(), 2, 0, options);
  for (std::size_t frame = 10; frame < 120; ++frame) EXPECT_LE(energy(scene, frame), energy(scene, 0) * 1.001);
  int moved = 0;
  for (std::size_t i = 0; i + 1 < scene.objects.size(); ++i) {
    const auto& poses = scene.objects[i].T_world_object;
    moved += (poses.back().translation - poses.front().translation).norm() > 0.2 ? 1 : 0;
    for (const RigidTransform& T : poses) EXPECT_GT(T.translation.z(), 0.45) << "a cube sank into the floor";
  }
  EXPECT_GT(moved, 3);
}

TEST(WreckingBallScene, ColumnsThatNothingHitsStand) {
  WreckingBallOptions options = *wrecking_ball_set("wrecking_ball_65");
  options.min_gap_m = options.max_gap_m = 100.0;
  const SceneRecording scene =
      simulate(sample_wrecking_ball_scene(options, 6, 0), wrecking_ball_shapes(), wrecking_ball_settings(), 240);
  for (std::size_t i = 0; i + 1 < scene.objects.size(); ++i) {
    const auto& poses = scene.objects[i].T_world_object;
    EXPECT_LT((poses.back().translation - poses.front().translation).norm(), 0.03) << i;
  }
}

TEST(SceneSet, OtherNamesAreRefusedWithTheAcceptedOnes) {
  try {
    check_scene_set("wrecking_ball_29");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("wrecking_ball_217"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace rigidformer
