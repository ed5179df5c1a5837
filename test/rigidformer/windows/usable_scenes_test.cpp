// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/usable_scenes.hpp"

#include <gtest/gtest.h>

#include <string>

#include "rigidformer/data/example_archive.hpp"
#include "window_scenes.hpp"

namespace rigidformer {
namespace {

SceneRecording named(SceneRecording scene, const std::string& name) {
  scene.name = name;
  return scene;
}

TEST(UsableScenes, P45_ScenesOfWhichNothingCanBeLearnedAreLeftOutByName) {
  SceneArchive archive = flying_cubes_archive({1, 2}, 60);
  SceneRecording shelf = named(flying_cubes(1, 60), "shelf");
  shelf.objects[0].is_static = true;
  archive.scenes.push_back(named(flying_cubes(0, 60), "empty"));
  archive.scenes.push_back(named(flying_cubes(1, 20), "short"));
  archive.scenes.push_back(shelf);
  const std::string sentences = leave_out_unusable_scenes(archive, {10, 3});
  EXPECT_EQ(archive.scenes.size(), 2u);
  EXPECT_NE(sentences.find("'empty', 'shelf'"), std::string::npos) << sentences;
  EXPECT_NE(sentences.find("21 at 240 Hz"), std::string::npos) << sentences;
  EXPECT_NE(sentences.find("'short'"), std::string::npos) << sentences;
  EXPECT_EQ(leave_out_unusable_scenes(archive, {10, 3}), "");
}

TEST(UsableScenes, P46_AtALowerRateFewerFramesAreEnough) {
  SceneArchive archive = flying_cubes_archive({1, 2}, 6);
  for (SceneRecording& scene : archive.scenes) scene.frame_rate_hz = 60.0;
  EXPECT_EQ(leave_out_unusable_scenes(archive, {10, 3}), "");  // three frames two apart; three steps of one frame
  EXPECT_EQ(archive.scenes.size(), 2u);
  archive.scenes[0].frame_rate_hz = 240.0;
  EXPECT_NE(leave_out_unusable_scenes(archive, {10, 3}), "");
}

TEST(UsableScenes, P46_ScenesWhoseFramesAreLongerThanAnyStepAreLeftOutByName) {
  SceneArchive archive = flying_cubes_archive({1, 2}, 60);
  archive.scenes[0].name = "slow";
  archive.scenes[0].frame_rate_hz = 12.0;
  const std::string sentences = leave_out_unusable_scenes(archive, {10, 3});
  EXPECT_NE(sentences.find("longer than the longest step of 10 frames of 1/240 s: 'slow'"), std::string::npos)
      << sentences;
  EXPECT_EQ(archive.scenes.size(), 1u);
}

TEST(UsableScenes, P45_NothingLeftIsAnErrorThatSaysWhy) {
  SceneArchive archive = flying_cubes_archive({1, 2}, 20);
  const std::string error = error_of([&] { leave_out_unusable_scenes(archive, {10, 3}); });
  EXPECT_NE(error.find("no scene to learn from in set 'flying_cubes'"), std::string::npos) << error;
  EXPECT_NE(error.find("2 scenes left out"), std::string::npos) << error;
}

}  // namespace
}  // namespace rigidformer
