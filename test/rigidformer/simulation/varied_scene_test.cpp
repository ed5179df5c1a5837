// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/varied_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "rigidformer/simulation/builtin_shapes.hpp"

namespace rigidformer {
namespace {

constexpr std::uint64_t kScenes = 120;

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = movi_shapes(MoviSet::kB, builtin_shapes());
  return all;
}

VariedScene scene_at(std::uint64_t index, std::uint64_t seed = 3) {
  return sample_varied_scene(MoviSet::kB, shapes(), seed, index);
}

double spread(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high / *low;
}

TEST(VariedScene, TheSameSeedGivesTheSameScene) {
  const VariedScene a = scene_at(7), b = scene_at(7), other = scene_at(8);
  EXPECT_EQ(a.start.objects[0].T_world_object[0].translation, b.start.objects[0].T_world_object[0].translation);
  EXPECT_EQ(a.start.ground, b.start.ground);
  EXPECT_EQ(a.bullet.contact_erp, b.bullet.contact_erp);
  EXPECT_EQ(a.mujoco.steps_per_contact, b.mujoco.steps_per_contact);
  EXPECT_FALSE(a.start.ground == other.start.ground);
}

TEST(VariedScene, BothEnginesGetTheSameWorld) {
  for (std::uint64_t i = 0; i < kScenes; ++i) {
    const VariedScene scene = scene_at(i);
    EXPECT_EQ(scene.bullet.gravity, scene.start.gravity);
    EXPECT_EQ(scene.mujoco.gravity, scene.start.gravity);
    EXPECT_EQ(scene.bullet.floor_friction, *scene.start.ground.friction);
    EXPECT_EQ(scene.mujoco.floor_friction, *scene.start.ground.friction);
    EXPECT_EQ(scene.bullet.floor_restitution, scene.mujoco.floor_restitution);
    EXPECT_EQ(scene.bullet.rolling_friction, scene.mujoco.rolling_friction);
    EXPECT_EQ(scene.bullet.spinning_friction, scene.mujoco.spinning_friction);
    EXPECT_NO_THROW(scene.bullet.validate());
    EXPECT_NO_THROW(scene.mujoco.validate());
  }
}

TEST(VariedScene, ContactsCoverWhatRealPairsHave) {
  std::vector<double> friction, restitution, sizes, masses;
  std::set<double> gravities;
  int level = 0;
  for (std::uint64_t i = 0; i < kScenes; ++i) {
    const SceneRecording scene = scene_at(i).start;
    EXPECT_TRUE(points_down(scene.gravity));
    level += scene.gravity.head<2>().norm() == 0.0 ? 1 : 0;
    if (scene.gravity.head<2>().norm() == 0.0) gravities.insert(scene.gravity.z());
    for (const RecordedObject& object : scene.objects) {
      friction.push_back(*object.properties.friction * *scene.ground.friction);
      restitution.push_back(*object.properties.restitution * *scene.ground.restitution);
      sizes.push_back(object.size);
      masses.push_back(*object.properties.mass_kg);
    }
  }
  EXPECT_LT(*std::min_element(friction.begin(), friction.end()), 0.06);
  EXPECT_GT(*std::max_element(friction.begin(), friction.end()), 1.0);
  EXPECT_LT(*std::min_element(restitution.begin(), restitution.end()), 0.02);
  EXPECT_GT(*std::max_element(restitution.begin(), restitution.end()), 0.8);
  EXPECT_GT(spread(sizes), 25.0);
  EXPECT_GT(spread(masses), 100.0);
  EXPECT_EQ(gravities, (std::set<double>{-10.0, -9.81}));
  EXPECT_NEAR(static_cast<double>(level) / kScenes, 0.5, 0.15);
}

TEST(VariedScene, NothingOverlapsAtTheStart) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    const VariedScene scene = scene_at(i);
    const BulletWorld world = make_world(scene.start, shapes(), scene.bullet);
    for (int body = 0; body < world.num_bodies(); ++body) EXPECT_FALSE(world.overlaps_any(body)) << "scene " << i;
  }
}

}  // namespace
}  // namespace rigidformer
