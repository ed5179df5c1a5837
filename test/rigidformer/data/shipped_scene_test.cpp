// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "rigidformer/data/kubric.hpp"
#include "rigidformer/data/scene_loader.hpp"
#include "test_data.hpp"

namespace rigidformer {
namespace {

TEST(ShippedScene, IsLoadedWithTheMeshesBesideIt) {
  const SceneArchive archive = load_scenes(shipped_movi_a(), std::filesystem::path());
  EXPECT_EQ(archive.set, "movi_a");
  ASSERT_EQ(archive.scenes.size(), 1U);
  const SceneRecording& scene = archive.scenes[0];
  EXPECT_EQ(scene.name, "20");
  EXPECT_EQ(scene.num_frames, 480);
  EXPECT_EQ(scene.frame_rate_hz, 240.0);
  ASSERT_EQ(scene.objects.size(), 3U);
  EXPECT_EQ(archive.shapes.size(), 3U);
  for (const RecordedObject& object : scene.objects) {
    EXPECT_EQ(object.T_world_object.size(), 480U);
    EXPECT_EQ(object.velocities.size(), 480U);
    EXPECT_TRUE(object.properties.mass_kg && object.properties.friction && object.properties.restitution);
  }
}

/// Between two frames in the air, positions move as velocities say, and these change by gravity alone.
TEST(ShippedScene, FallsFreelyAtFirst) {
  const SceneRecording scene = read_kubric_scene(shipped_movi_a() / "20");
  const double dt = 1.0 / scene.frame_rate_hz;
  for (const RecordedObject& object : scene.objects) {
    for (std::size_t i = 0; i + 1 < 100; ++i) {
      const Eigen::Vector3d fallen = object.velocities[i + 1] - object.velocities[i];
      EXPECT_NEAR((fallen - scene.gravity * dt).norm(), 0.0, 1e-4);
      const Eigen::Vector3d moved = object.T_world_object[i + 1].translation - object.T_world_object[i].translation;
      // Bullet moves with the velocity at the end of each of its ten steps of a frame.
      EXPECT_NEAR((moved / dt - 0.5 * (object.velocities[i] + object.velocities[i + 1])).norm(), 0.0, 0.01);
    }
  }
}

}  // namespace
}  // namespace rigidformer
