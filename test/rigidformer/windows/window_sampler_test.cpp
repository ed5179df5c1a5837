// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/window_sampler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "rigidformer/data/example_archive.hpp"
#include "window_scenes.hpp"

namespace rigidformer {
namespace {

constexpr int kFrames = 100;  // frames of every scene

bool same(const Window& a, const Window& b) {
  return a.scene == b.scene && a.frame == b.frame && a.step_size == b.step_size;
}

bool same(const std::vector<Window>& a, const std::vector<Window>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Window& x, const Window& y) { return same(x, y); });
}

WindowSampler sampler(const WindowOptions& options, ContactEvents events = {}) {
  return WindowSampler(options, std::move(events), {3, 1, 4, 2}, std::vector<std::int64_t>(4, kFrames));
}

TEST(WindowSamplerTest, WindowsFitIntoTheScene) {
  WindowOptions options;
  options.any_step_probability = 0.3;
  options.mid_air_probability = options.floor_probability = 0.3;
  const WindowSampler draws = sampler(options, {{{1, 0}, {2, 99}}, {{3, 1}, {0, 98}}, {}, {}, {}});
  std::mt19937_64 random(1);
  std::set<int> scenes, frames;
  for (const int num_steps : {1, 2, 6}) {
    for (int i = 0; i < 2000; ++i) {
      const Window window = draws.draw(num_steps, random);
      scenes.insert(window.scene);
      frames.insert(window.frame);
      ASSERT_GE(window.frame, 0);
      ASSERT_GE(window.step_size, 1);
      ASSERT_LE(window.step_size, 10);
      ASSERT_LT(window.frame + (num_steps + 1) * window.step_size, kFrames);
    }
  }
  EXPECT_EQ(scenes, (std::set<int>{0, 1, 2, 3}));
  EXPECT_EQ(*frames.begin(), 0);
  EXPECT_EQ(*frames.rbegin(), kFrames - 3);  // start of the last window of the smallest step size
}

TEST(WindowSamplerTest, P46_StepsBecomeFramesOfTheScene) {
  WindowOptions options;
  options.step_sizes = {10, 5};
  const WindowSampler draws(options, {}, {1, 1}, {100, 100}, {240.0, 53.5});
  std::mt19937_64 random(1);
  std::set<int> fast, slow;
  for (int i = 0; i < 200; ++i) {
    const Window window = draws.draw(1, random);
    (window.scene == 0 ? fast : slow).insert(window.step_size);
  }
  EXPECT_EQ(fast, (std::set<int>{5, 10}));
  EXPECT_EQ(slow, (std::set<int>{1, 2}));  // 10 frames of 1/240 s are 2.2 of the slow scene
}

TEST(WindowSamplerTest, KindsAreDrawnAsOftenAsAskedFor) {
  WindowOptions options;
  options.step_sizes = {1};
  options.mid_air_probability = 0.1;
  options.floor_probability = 0.2;
  options.rolling_probability = 0.3;
  options.resting_probability = 0.4;
  // Every kind lies in a scene of its own, so that the scene tells the kind.
  const WindowSampler draws = sampler(options, {{{0, 50}}, {{1, 50}}, {{2, 50}}, {{3, 50}}, {}});
  std::mt19937_64 random(9);
  std::vector<double> share(4, 0.0);
  for (int i = 0; i < 20000; ++i) share[static_cast<size_t>(draws.draw(1, random).scene)] += 1.0 / 20000.0;
  for (int kind = 0; kind < 4; ++kind) EXPECT_NEAR(share[static_cast<size_t>(kind)], 0.1 * (kind + 1), 0.02);
  // A kind that does not occur falls back to any time of any scene.
  std::set<int> scenes;
  const WindowSampler lacking = sampler(options, {{{0, 50}}, {{0, 50}}, {}, {}, {}});
  for (int i = 0; i < 500; ++i) scenes.insert(lacking.draw(1, random).scene);
  EXPECT_EQ(scenes, (std::set<int>{0, 1, 2, 3}));
  WindowOptions driven;
  driven.driven_probability = 1.0;
  const WindowSampler near_drivers = sampler(driven, {{{0, 50}}, {{0, 50}}, {}, {}, {{2, 50}}});
  for (int i = 0; i < 20; ++i) EXPECT_EQ(near_drivers.draw(1, random).scene, 2);
}

TEST(WindowSamplerTest, StepSizesComeFromTheList) {
  WindowOptions options;
  options.step_sizes = {2, 7};
  std::mt19937_64 random(2);
  std::set<int> listed, any;
  for (int i = 0; i < 500; ++i) listed.insert(sampler(options).draw(1, random).step_size);
  EXPECT_EQ(listed, (std::set<int>{2, 7}));
  options.any_step_probability = 1.0;
  for (int i = 0; i < 500; ++i) any.insert(sampler(options).draw(1, random).step_size);
  EXPECT_EQ(any, (std::set<int>{1, 2, 3, 4, 5, 6, 7}));
  options.step_sizes = {40};
  options.any_step_probability = 0.0;
  EXPECT_EQ(sampler(options).draw(1, random).step_size, 40);
  EXPECT_EQ(sampler(options).draw(8, random).step_size, 11);  // ten frames must fit into the scene
}

TEST(WindowSamplerTest, EventsLieInThePredictedPart) {
  const ContactEvents events{{{2, 60}, {0, 99}}, {{3, 10}}, {}, {}, {}};
  for (const bool mid_air : {true, false}) {
    WindowOptions options;
    options.any_step_probability = 0.5;
    (mid_air ? options.mid_air_probability : options.floor_probability) = 1.0;
    const WindowSampler draws = sampler(options, events);
    std::mt19937_64 random(3);
    std::set<std::pair<int, int>> seen;  // scene and predicted step that holds the event
    for (const int num_steps : {1, 4}) {
      for (int i = 0; i < 2000; ++i) {
        const Window window = draws.draw(num_steps, random);
        ASSERT_TRUE(mid_air ? window.scene == 2 || window.scene == 0 : window.scene == 3);
        const int event = window.scene == 2 ? 60 : window.scene == 0 ? 99 : 10;
        ASSERT_GE(event, window.frame + window.step_size);
        ASSERT_LE(event, window.frame + (num_steps + 1) * window.step_size);
        if (window.scene == 2 && num_steps == 4) seen.emplace(2, (event - window.frame) / window.step_size);
      }
    }
    EXPECT_EQ(seen.size(), mid_air ? 4u : 0u);  // the event lies in any of the predicted steps
  }
}

TEST(WindowSamplerTest, WithoutEventsWindowsAreUniform) {
  WindowOptions options;
  options.mid_air_probability = 1.0;
  std::mt19937_64 random(4);
  std::set<int> scenes;
  for (int i = 0; i < 200; ++i) scenes.insert(sampler(options).draw(1, random).scene);
  EXPECT_EQ(scenes.size(), 4u);
}

TEST(WindowSamplerTest, P45_WindowsEndWithTheirOwnScene) {
  const std::vector<std::int64_t> frames = {100, 21, 50, 30};
  WindowOptions options;
  options.any_step_probability = 0.3;
  options.floor_probability = 0.5;
  const WindowSampler draws(options, {{}, {{1, 19}, {3, 28}}, {}, {}, {}}, {3, 1, 4, 2}, frames);
  std::mt19937_64 random(6);
  for (const int num_steps : {1, 4, 19}) {
    for (int i = 0; i < 1000; ++i) {
      const Window window = draws.draw(num_steps, random);
      ASSERT_GE(window.frame, 0);
      ASSERT_GE(window.step_size, 1);
      ASSERT_LT(window.frame + (num_steps + 1) * window.step_size, frames[static_cast<size_t>(window.scene)]);
    }
  }
  const std::string error = error_of([&] {
    for (int i = 0; i < 1000; ++i) draws.draw(25, random);
  });
  EXPECT_NE(error.find("a window of 27 frames does not fit into scene 1 of 21 frames"), std::string::npos) << error;
}

TEST(WindowSamplerTest, BatchesFollowFromSeedAndIteration) {
  const WindowSampler draws = sampler({});
  for (const std::int64_t iteration : {0, 1, 8, 1000}) {
    EXPECT_TRUE(same(draws.draw_batch(6, 2, 9, iteration), draws.draw_batch(6, 2, 9, iteration)));
    EXPECT_FALSE(same(draws.draw_batch(6, 2, 9, iteration), draws.draw_batch(6, 2, 10, iteration)));
    EXPECT_FALSE(same(draws.draw_batch(6, 2, 9, iteration), draws.draw_batch(6, 2, 9, iteration + 1)));
  }
}

TEST(WindowSamplerTest, BatchesHoldScenesOfSimilarSize) {
  const std::vector<std::int64_t> counts = {3, 1, 4, 2};
  const WindowSampler draws = sampler({});
  double spread_in_batches = 0.0;
  std::set<int> scenes;
  for (std::int64_t iteration = 0; iteration < 40; ++iteration) {
    std::int64_t least = 99, most = 0;
    for (const Window& window : draws.draw_batch(10, 1, 5, iteration)) {
      scenes.insert(window.scene);
      least = std::min(least, counts[static_cast<size_t>(window.scene)]);
      most = std::max(most, counts[static_cast<size_t>(window.scene)]);
    }
    spread_in_batches += static_cast<double>(most - least) / 40.0;
  }
  EXPECT_EQ(scenes.size(), 4u);
  EXPECT_LT(spread_in_batches, 1.0);  // it is 3 for batches of ten random windows
}

TEST(WindowSamplerTest, BadOptionsAreRefusedByName) {
  const auto refusal = [](const auto& change) {
    WindowOptions options;
    change(options);
    EXPECT_THROW(sampler(options), std::invalid_argument);
    return error_of([&] { sampler(options); });
  };
  EXPECT_NE(refusal([](auto& o) { o.step_sizes = {}; }).find("step_sizes"), std::string::npos);
  EXPECT_NE(refusal([](auto& o) { o.step_sizes = {0, 5}; }).find("step_sizes"), std::string::npos);
  EXPECT_NE(refusal([](auto& o) { o.step_sizes = {50}; }).find("step_sizes"), std::string::npos);
  EXPECT_NE(refusal([](auto& o) { o.any_step_probability = 1.5; }).find("any_step_probability"), std::string::npos);
  EXPECT_NE(refusal([](auto& o) { o.mid_air_probability = -0.1; }).find("mid_air_probability"), std::string::npos);
  EXPECT_NE(refusal([](auto& o) { o.floor_probability = std::nan(""); }).find("floor_probability"), std::string::npos);
  EXPECT_NE(refusal([](auto& o) { o.mid_air_probability = o.floor_probability = 0.6; }).find("floor_probability"),
            std::string::npos);
  EXPECT_NE(refusal([](auto& o) { o.rolling_probability = o.resting_probability = 0.6; }).find("resting_probability"),
            std::string::npos);
}

class ContactEventsTest : public ::testing::Test {
 protected:
  static ContactEvents find(const std::vector<SceneRecording>& scenes) {
    SceneArchive archive;
    archive.shapes = {unit_cube()};
    archive.scenes = scenes;
    return find_contact_events(make_scene_tensors({archive}, {2, 16, 1}));
  }

  static constexpr double kImpact = 60 / 240.0;  // [s] instant of the impact
  static constexpr double kGravity = -10.0;      // [m/s^2]
};

TEST_F(ContactEventsTest, FreeFlightHasNone) {
  const ContactEvents events = find_contact_events(make_scene_tensors({flying_cubes_archive({1, 3}, 60)}, {2, 16, 1}));
  EXPECT_TRUE(events.mid_air.empty());
  EXPECT_TRUE(events.floor.empty());
  EXPECT_TRUE(events.rolling.empty());
  EXPECT_TRUE(events.resting.empty());
}

TEST_F(ContactEventsTest, P45_NothingHappensAfterTheEndOfAShortScene) {
  const SceneRecording rest = moving_cube(20, [](double) { return Eigen::Vector3d(1.0, 2.0, 0.5); });
  const ContactEvents events = find({rest, flying_cubes(1, 120)});
  ASSERT_EQ(events.resting.size(), 2u);  // frames 8 and 16
  EXPECT_TRUE(events.mid_air.empty());   // the padding does not look like a stop
}

TEST_F(ContactEventsTest, P41_StaticObjectsAreNoEvents) {
  SceneRecording rest = moving_cube(20, [](double) { return Eigen::Vector3d(1.0, 2.0, 0.5); });
  rest.objects[0].is_static = true;
  EXPECT_TRUE(find({rest}).resting.empty());
}

TEST_F(ContactEventsTest, DrivenBodiesCountWhileTheyMoveNearAnObject) {
  const auto scene_with = [](double speed_mps, bool is_driven) {
    SceneRecording scene = moving_cube(60, [](double) { return Eigen::Vector3d(0.0, 0.0, 0.5); });
    const SceneRecording other =
        moving_cube(60, [&](double t) { return Eigen::Vector3d(2.2 - speed_mps * t, 0.0, 0.5); });
    scene.objects.push_back(other.objects[0]);
    scene.objects[1].is_driven = is_driven;
    return scene;
  };
  const ContactEvents events =
      find({scene_with(0.0, true), scene_with(4.0, false), scene_with(4.0, true), scene_with(0.01, true)});
  ASSERT_EQ(events.driven.size(), 4u);  // spheres around cubes of 1 m meet at 1.73 m: from frame 29 on
  for (const ContactEvent& event : events.driven) {
    EXPECT_EQ(event.scene, 2);
    EXPECT_GE(event.frame, 29);
  }
}

TEST_F(ContactEventsTest, RestAndRollingAreToldApart) {
  const SceneRecording rest = moving_cube(60, [](double) { return Eigen::Vector3d(1.0, 2.0, 0.5); });
  const SceneRecording slide = moving_cube(60, [](double t) { return Eigen::Vector3d(1.0 * t, 0.0, 0.5); });
  const ContactEvents events = find({rest, slide});
  ASSERT_EQ(events.resting.size(), 7u);  // frames 8, 16, ..., 56
  for (const ContactEvent& event : events.resting) EXPECT_EQ(event.scene, 0);
  ASSERT_EQ(events.rolling.size(), 7u);
  for (const ContactEvent& event : events.rolling) EXPECT_EQ(event.scene, 1);
  EXPECT_TRUE(events.mid_air.empty());
  EXPECT_TRUE(events.floor.empty());
}

TEST_F(ContactEventsTest, BounceOnTheFloorIsOneFloorEvent) {
  const SceneRecording bounce = moving_cube(120, [](double time) {
    const double t = time - kImpact, velocity = t < 0.0 ? -5.0 : 3.0;
    return Eigen::Vector3d(t, 0.0, 0.5 + velocity * t + 0.5 * kGravity * t * t);
  });
  const ContactEvents events = find({flying_cubes(1, 120), bounce});
  EXPECT_TRUE(events.mid_air.empty());
  ASSERT_EQ(events.floor.size(), 1u);
  EXPECT_EQ(events.floor[0].scene, 1);
  EXPECT_EQ(events.floor[0].frame, 60);
}

TEST_F(ContactEventsTest, CollisionInTheAirIsAMidAirEvent) {
  const SceneRecording hit = moving_cube(120, [](double time) {
    const double t = time - kImpact, velocity = t < 0.0 ? -2.0 : 2.0;
    return Eigen::Vector3d(velocity * t, 0.0, 8.0 + 0.5 * kGravity * t * t);
  });
  const ContactEvents events = find({hit, flying_cubes(2, 120)});
  EXPECT_TRUE(events.floor.empty());
  ASSERT_EQ(events.mid_air.size(), 1u);
  EXPECT_EQ(events.mid_air[0].scene, 0);
  EXPECT_EQ(events.mid_air[0].frame, 60);
}

}  // namespace
}  // namespace rigidformer
