// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/fixture_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "rigidformer/simulation/builtin_shapes.hpp"
#include "rigidformer/simulation/fixture_shapes.hpp"
#include "rigidformer/simulation/hull_distance.hpp"
#include "rigidformer/simulation/scene_recorder.hpp"

namespace rigidformer {
namespace {

constexpr std::uint64_t kScenes = 8;
constexpr int kFrames = 480;
constexpr double kDuration_s = kFrames / 240.0;

/// Convex shapes, whose overlaps can be measured.
const std::vector<Shape>& free_shapes() {
  static const std::vector<Shape> shapes = movi_shapes(MoviSet::kA, builtin_shapes());
  return shapes;
}

const std::vector<Shape>& all_shapes() {
  static const std::vector<Shape> shapes = [] {
    std::vector<Shape> all = free_shapes();
    all.insert(all.end(), fixture_shapes().begin(), fixture_shapes().end());
    return all;
  }();
  return shapes;
}

FixtureScene draw_scene(std::uint64_t index) {
  const VariedScene free{
      sample_movi_scene(MoviSet::kA, free_shapes(), 21, index), movi_bullet_settings(MoviSet::kA), {}};
  return add_fixtures(free, all_shapes(), 21, index, 0, kDuration_s);
}

const FixtureScene& scene_at(std::uint64_t index) {
  static const std::vector<FixtureScene> scenes = [] {
    std::vector<FixtureScene> drawn;
    for (std::uint64_t i = 0; i < kScenes; ++i) drawn.push_back(draw_scene(i));
    return drawn;
  }();
  return scenes.at(index);
}

const std::vector<SceneRecording>& recordings() {
  static const std::vector<SceneRecording> all = [] {
    std::vector<SceneRecording> made;
    for (std::uint64_t i = 0; i < kScenes; ++i) {
      const FixtureScene& scene = scene_at(i);
      made.push_back(simulate(scene.scene.start, all_shapes(), scene.scene.bullet, kFrames, 0, scene.paths));
    }
    return made;
  }();
  return all;
}

double travelled_m(const RecordedObject& object) {
  double way_m = 0.0;
  for (std::size_t f = 1; f < object.T_world_object.size(); ++f) {
    way_m += (object.T_world_object[f].translation - object.T_world_object[f - 1].translation).norm();
  }
  return way_m;
}

TEST(FixtureScenes, TheSameSeedGivesTheSameScene) {
  const FixtureScene &a = scene_at(3), &other = scene_at(4);
  const FixtureScene b = draw_scene(3);
  ASSERT_EQ(a.scene.start.objects.size(), b.scene.start.objects.size());
  for (std::size_t i = 0; i < a.paths.size(); ++i) {
    const RecordedObject &x = a.scene.start.objects[i], &y = b.scene.start.objects[i];
    EXPECT_EQ(x.shape, y.shape);
    EXPECT_EQ(x.T_world_object[0].translation, y.T_world_object[0].translation);
    ASSERT_EQ(static_cast<bool>(a.paths[i]), static_cast<bool>(b.paths[i]));
    if (!a.paths[i]) continue;
    EXPECT_EQ(a.paths[i](0.7).translation, b.paths[i](0.7).translation);
  }
  EXPECT_NE(a.scene.start.objects[0].T_world_object[0].translation,
            other.scene.start.objects[0].T_world_object[0].translation);
}

TEST(FixtureScenes, HaveFreeStaticAndDrivenObjectsAndOnlyTheFreeOnesHaveAMass) {
  int num_static = 0, num_driven = 0, scenes_with_several = 0;
  for (std::uint64_t i = 0; i < kScenes; ++i) {
    const FixtureScene& made = scene_at(i);
    ASSERT_EQ(made.paths.size(), made.scene.start.objects.size());
    int of_scene = 0;
    EXPECT_FALSE(made.scene.start.objects.front().is_given());
    for (std::size_t k = 0; k < made.paths.size(); ++k) {
      const RecordedObject& object = made.scene.start.objects[k];
      EXPECT_EQ(object.properties.mass_kg.has_value(), !object.is_given());
      EXPECT_TRUE(object.properties.friction && object.properties.restitution);
      EXPECT_EQ(object.is_driven, static_cast<bool>(made.paths[k]));
      EXPECT_FALSE(object.is_driven && object.is_static);
      num_static += object.is_static ? 1 : 0;
      of_scene += object.is_driven ? 1 : 0;
    }
    num_driven += of_scene;
    scenes_with_several += of_scene > 1 ? 1 : 0;
  }
  EXPECT_GT(num_static, 8);
  EXPECT_GT(num_driven, 5);
  EXPECT_GT(scenes_with_several, 1);
}

TEST(FixtureScenes, DrivenBodiesFollowTheirPathsAndStaticOnesNeverMove) {
  for (std::uint64_t i = 0; i < kScenes; ++i) {
    const FixtureScene& made = scene_at(i);
    for (std::size_t k = 0; k < made.paths.size(); ++k) {
      const RecordedObject& recorded = recordings()[i].objects[k];
      if (!recorded.is_given()) continue;
      for (std::size_t frame = 0; frame < recorded.T_world_object.size(); ++frame) {
        const RigidTransform& T = recorded.T_world_object[frame];
        const RigidTransform wanted =
            made.paths[k] ? made.paths[k](static_cast<double>(frame) / 240.0) : recorded.T_world_object.front();
        ASSERT_LT((T.translation - wanted.translation).norm(), 1e-6);
        ASSERT_LT(rotation_angle(T.rotation, wanted.rotation), 2e-6);
      }
    }
  }
}

TEST(FixtureScenes, DriversMoveAtSpeedsOfRobotsAndStayAboveTheFloor) {
  double slowest_mps = 1e9, fastest_mps = 0.0;
  for (const SceneRecording& recording : recordings()) {
    for (const RecordedObject& object : recording.objects) {
      if (!object.is_driven) continue;
      const Points corners = static_cast<float>(object.size) * find_shape(all_shapes(), object.shape).vertices();
      double of_body_mps = 0.0;
      for (std::size_t f = 1; f < object.T_world_object.size(); ++f) {
        const Eigen::Vector3d way = object.T_world_object[f].translation - object.T_world_object[f - 1].translation;
        of_body_mps = std::max(of_body_mps, 240.0 * way.norm());
      }
      for (std::size_t f = 0; f < object.T_world_object.size(); f += 8) {
        EXPECT_GT(object.T_world_object[f].apply(corners).col(2).minCoeff(), -0.05F);
      }
      slowest_mps = std::min(slowest_mps, of_body_mps);
      fastest_mps = std::max(fastest_mps, of_body_mps);
    }
  }
  EXPECT_GT(fastest_mps, 1.0);
  EXPECT_LT(fastest_mps, 2.0 * std::sqrt(10.0) * 1.5) << "twice the fastest mean speed, along two directions at once";
}

/// Deepest overlap of free objects with given ones [m], as shares of the free object's smallest extent.
double deepest_share(const SceneRecording& recording) {
  std::map<std::string, SolidHull> hulls;
  const auto scaled = [](const RecordedObject& object) {
    ConvexPart hull = find_shape(all_shapes(), object.shape).parts[0];
    hull.vertices *= static_cast<float>(object.size);
    return SolidHull(hull);
  };
  double deepest = 0.0;
  for (const RecordedObject& free : recording.objects) {
    if (free.is_given()) continue;
    const SolidHull hull = scaled(free);
    for (const RecordedObject& given : recording.objects) {
      if (!given.is_given()) continue;
      const SolidHull slab = scaled(given);
      for (std::size_t f = 0; f < free.T_world_object.size(); f += 4) {
        const auto closest = closest_points(hull, free.T_world_object[f], slab, given.T_world_object[f]);
        if (closest) deepest = std::max(deepest, -closest->gap_m / free.size);
      }
    }
  }
  return deepest;
}

TEST(FixtureScenes, NothingPassesThroughSlabs) {
  for (const SceneRecording& recording : recordings()) {
    EXPECT_LT(deepest_share(recording), 0.06) << recording.name;
    EXPECT_TRUE(is_calm(recording, 1.0)) << recording.name;
  }
}

TEST(FixtureScenes, FreeObjectsMeetWhatThereIs) {
  int met = 0, objects = 0;
  for (const SceneRecording& recording : recordings()) {
    for (const RecordedObject& free : recording.objects) {
      if (free.is_given()) continue;
      ++objects;
      met += travelled_m(free) > 0.05 ? 1 : 0;
    }
  }
  EXPECT_GT(met, objects / 2);
}

TEST(FixtureScenes, AnObjectThatWasShotAwayIsNotCalm) {
  SceneRecording recording;
  recording.objects.resize(1);
  recording.objects[0].T_world_object.resize(3);
  EXPECT_TRUE(is_calm(recording, 1.0));
  recording.objects[0].T_world_object[2].translation.x() = 1.0;
  EXPECT_FALSE(is_calm(recording, 1.0));
  recording.objects[0].T_world_object[2].translation.x() = std::nan("");
  EXPECT_FALSE(is_calm(recording, 1.0));
}

}  // namespace
}  // namespace rigidformer
