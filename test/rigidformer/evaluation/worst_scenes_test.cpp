// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/worst_scenes.hpp"

#include <gtest/gtest.h>

#include "rigidformer/evaluation/scene_results.hpp"

namespace rigidformer {
namespace {

class WorstScenesTest : public testing::Test {
 protected:
  void add(const std::string& model, const std::string& scene, double error_m, int start = 120, int step = 10) {
    const SceneRecording recording = resting_scene(scene, {"cube"}, 400);
    SceneResult result = result_of(model, recording, {error_m, 1.0}, {{error_m, 1.0}}, step);
    result.start = start;
    worst_.add(result);
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const ScenePaths& scene : worst_.list()) names.push_back(scene.scene);
    return names;
  }

  WorstScenes worst_{"bullet", 100, 2};
};

TEST_F(WorstScenesTest, KeepsTheWorstOfOneModelInOrder) {
  add("bullet", "a", 0.3);
  add("bullet", "b", 0.1);
  add("bullet", "c", 0.5);
  add("mujoco", "d", 9.0);
  EXPECT_EQ(names(), (std::vector<std::string>{"c", "a"}));
}

TEST_F(WorstScenesTest, EveryStartHasItsOwn) {
  add("bullet", "a", 0.3, 120);
  add("bullet", "b", 0.1, 0);
  EXPECT_EQ(names(), (std::vector<std::string>{"b", "a"}));
}

TEST_F(WorstScenesTest, ASceneCountsOnceWithItsWorstStep) {
  add("bullet", "a", 0.3, 120, 5);
  add("bullet", "b", 0.4);
  add("bullet", "a", 0.5, 120, 10);
  add("bullet", "a", 0.1, 120, 1);
  const auto list = worst_.list();
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0].scene, "a");
  EXPECT_EQ(list[0].step, 10);
  EXPECT_EQ(list[0].error.position_rmse_m, 0.5);
  EXPECT_EQ(list[1].scene, "b");
}

TEST_F(WorstScenesTest, PathsStartAtTheSecondGivenFrameAndMeetTheRecording) {
  SceneRecording scene = resting_scene("a", {"cube", "ball"}, 400);
  for (int frame = 0; frame < 400; ++frame) scene.objects[1].T_world_object[frame].translation.y() = frame;
  SceneResult result = result_of("bullet", scene, {0.5, 1.0}, {{}, {}});
  for (auto& object : result.predicted) object.assign(20, {Eigen::Quaterniond::Identity(), {7.0, 0.0, 0.0}});
  worst_.add(result);
  const ScenePaths paths = worst_.list().at(0);
  EXPECT_EQ(paths.shapes, (std::vector<std::string>{"cube", "ball"}));
  ASSERT_EQ(paths.recorded[1].size(), 10U);  // the 100 frames after frame 120 in steps of 10: from frame 130 to 220
  ASSERT_EQ(paths.predicted[1].size(), 10U);
  EXPECT_EQ(paths.recorded[1].front().y(), 130.0);
  EXPECT_EQ(paths.recorded[1].back().y(), 220.0);
  EXPECT_EQ(paths.predicted[1].back().x(), 7.0);
}

}  // namespace
}  // namespace rigidformer
