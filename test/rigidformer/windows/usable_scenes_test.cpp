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
  const std::string sentences = leave_out_unusable_scenes(archive, 21);
  EXPECT_EQ(archive.scenes.size(), 2u);
  EXPECT_NE(sentences.find("'empty', 'shelf'"), std::string::npos) << sentences;
  EXPECT_NE(sentences.find("fewer than the 21 frames"), std::string::npos) << sentences;
  EXPECT_NE(sentences.find("'short'"), std::string::npos) << sentences;
  EXPECT_EQ(leave_out_unusable_scenes(archive, 21), "");
}

TEST(UsableScenes, P45_NothingLeftIsAnErrorThatSaysWhy) {
  SceneArchive archive = flying_cubes_archive({1, 2}, 20);
  const std::string error = error_of([&] { leave_out_unusable_scenes(archive, 21); });
  EXPECT_NE(error.find("no scene to learn from in set 'flying_cubes'"), std::string::npos) << error;
  EXPECT_NE(error.find("2 scenes left out"), std::string::npos) << error;
}

}  // namespace
}  // namespace rigidformer
