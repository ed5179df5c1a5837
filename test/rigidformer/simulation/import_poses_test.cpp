// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/import_poses.hpp"

#include <gtest/gtest.h>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/io/text_file.hpp"
#include "test_data.hpp"

namespace rigidformer {
namespace {

class ImportPosesTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string text = "toss,t,id,x,y,z,qx,qy,qz,qw\n";
    for (int toss = 0; toss < 10; ++toss) {
      for (int frame = 0; frame < 5; ++frame) {
        const std::string head = std::to_string(toss) + "," + std::to_string(0.01 * frame) + ",";
        text += head + "die,0." + std::to_string(frame) + ",0,1.5,0,0,0,1\n" + head + "table,0,0,0.5,0,0,0,1\n";
      }
    }
    write_text_file(folder_.path() / "poses.csv", text);
    options_.poses = {folder_.path() / "poses.csv"};
    options_.recording_column = "toss";
    options_.shapes = {{"die", "box:0.1x0.1x0.1"}, {"table", "box:1x1x0.5"}};
    options_.static_ids = {"table"};
  }

  std::string refusal() {
    return error_of([&] { import_poses(options_); });
  }

  const TemporaryFolder folder_;
  ImportOptions options_;
};

TEST_F(ImportPosesTest, ScenesHoldWhatWasMeasured) {
  options_.length_factor = 2.0;
  options_.ground_height_m = 1.0;
  options_.masses_kg = {{"die", 0.3}};
  const ImportedScenes imported = import_poses(options_);
  ASSERT_EQ(imported.training.scenes.size(), 10U);
  EXPECT_TRUE(imported.validation.scenes.empty());
  const SceneRecording& scene = imported.training.scenes[3];
  EXPECT_EQ(scene.name, "3");
  EXPECT_NEAR(scene.frame_rate_hz, 100.0, 1e-6);
  EXPECT_EQ(scene.gravity.z(), -9.81);
  EXPECT_EQ(scene.ground, GroundProperties());  // nothing is known of it
  ASSERT_EQ(scene.num_frames, 5);
  const RecordedObject &die = scene.objects[0], &table = scene.objects[1];
  EXPECT_LT((die.T_world_object[4].translation - Eigen::Vector3d(0.8, 0.0, 2.0)).norm(), 1e-9);
  EXPECT_EQ(die.properties.mass_kg, 0.3);
  EXPECT_FALSE(die.properties.friction);
  EXPECT_FALSE(die.is_static);
  EXPECT_TRUE(table.is_static);
  EXPECT_NE(imported.summary.find("10 recordings, 10 scenes"), std::string::npos) << imported.summary;
  EXPECT_NE(imported.summary.find("10 scenes hold the measured frames, 0 are resampled"), std::string::npos);
  const std::filesystem::path file = folder_.path() / "scenes.safetensors";
  write_scene_archive(file, imported.training);
  EXPECT_EQ(read_scene_archive(file).scenes.size(), 10U);
}

TEST_F(ImportPosesTest, RecordingsAreChosenByNumberAndSplitWhole) {
  options_.recordings = {"0-3", "7"};
  options_.validation_share = 0.4;
  const ImportedScenes imported = import_poses(options_);
  ASSERT_EQ(imported.training.scenes.size(), 3U);
  ASSERT_EQ(imported.validation.scenes.size(), 2U);
  EXPECT_EQ(imported.training.scenes[2].name, "2");
  EXPECT_EQ(imported.validation.scenes[0].name, "3");
  EXPECT_EQ(imported.validation.scenes[1].name, "7");
}

TEST_F(ImportPosesTest, ErrorsSayWhatIsWrong) {
  options_.shapes.erase("table");
  EXPECT_NE(refusal().find("recording '0': object 'table' has no shape"), std::string::npos);
  options_.shapes["table"] = "box:1x1x1";
  options_.static_ids = {"die"};
  EXPECT_NE(refusal().find("object 'die' is said to be static and moved by"), std::string::npos);
  options_.static_ids.clear();
  options_.recordings = {"300-400"};
  EXPECT_NE(refusal().find("none of the recordings"), std::string::npos);
  options_.recordings.clear();
  options_.frictions = {{"die", -1.0}};
  EXPECT_NE(refusal().find("the friction of 'die' must be >= 0"), std::string::npos);
}

TEST(ImportPoses, RealTossesAreImportedWhereTheyAre) {
  const std::filesystem::path table = published_data() / "cube_tosses" / "tosses.csv";
  if (!std::filesystem::exists(table)) GTEST_SKIP() << table << " is not there";
  ImportOptions options;
  options.poses = {table};
  options.recording_column = "toss";
  options.recordings = {"0-9"};
  options.shapes = {{"object", "box:0.1048x0.1048x0.1048"}};
  options.length_factor = 1.0215;
  const ImportedScenes imported = import_poses(options);
  ASSERT_EQ(imported.training.scenes.size(), 10U);
  for (const SceneRecording& scene : imported.training.scenes) {
    EXPECT_NEAR(scene.frame_rate_hz, 148.0, 0.1);
    EXPECT_NEAR(scene.objects[0].T_world_object.back().translation.z(), 0.0524, 0.002);  // it lies on a face
  }
}

}  // namespace
}  // namespace rigidformer
