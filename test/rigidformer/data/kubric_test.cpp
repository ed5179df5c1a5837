// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/data/kubric.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "example_archive.hpp"
#include "rigidformer/io/full_disk.hpp"

namespace rigidformer {
namespace {

TEST(Kubric, RoundTripKeepsTheScene) {
  const TemporaryFolder folder;
  const SceneRecording written = example_archive().scenes[1];
  write_kubric_scene(folder.path() / "1", written);
  const SceneRecording read = read_kubric_scene(folder.path() / "1");

  EXPECT_EQ(read.name, "1");
  EXPECT_EQ(read.seed, written.seed);
  EXPECT_EQ(read.num_frames, written.num_frames);
  EXPECT_EQ(read.frame_rate_hz, written.frame_rate_hz);
  EXPECT_EQ(read.gravity, written.gravity);
  ASSERT_EQ(read.objects.size(), written.objects.size());
  for (std::size_t i = 0; i < read.objects.size(); ++i) {
    EXPECT_EQ(read.objects[i].shape, written.objects[i].shape);
    EXPECT_EQ(read.objects[i].size, written.objects[i].size);
    EXPECT_EQ(read.objects[i].properties.mass_kg, written.objects[i].properties.mass_kg);
    EXPECT_FALSE(read.objects[i].properties.restitution.has_value());
    EXPECT_EQ(read.objects[i].velocities, written.objects[i].velocities);
    EXPECT_EQ(read.objects[i].angular_velocities, written.objects[i].angular_velocities);
    EXPECT_LT(pose_difference(read.objects[i], written.objects[i]), 1e-7);
  }
}

const char kScene[] = R"({
  "metadata": {"num_frames": 2, "frame_rate": 240, "gravity": [0, 0, -10]},
  "instances": [{"asset_id": "cube", "positions": [[1, 2, 3], [1, 2, 3]],
                 "quaternions": [[0.6, 0.8, 0, 0], [1, 0, 0, 0]]}]})";

TEST(Kubric, QuaternionsAreStoredWithTheScalarFirstAndOptionalKeysMayBeAbsent) {
  const TemporaryFolder folder;
  write_text(folder.path() / "7" / "metadata.json", kScene);
  const SceneRecording scene = read_kubric_scene(folder.path() / "7");
  ASSERT_EQ(scene.objects.size(), 1u);
  const RecordedObject& object = scene.objects[0];
  EXPECT_NEAR(object.T_world_object[0].rotation.w(), 0.6, 1e-12);
  EXPECT_NEAR(object.T_world_object[0].rotation.x(), 0.8, 1e-12);
  EXPECT_EQ(object.T_world_object[0].translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(object.size, 1.0);
  EXPECT_FALSE(object.properties.mass_kg.has_value());
  EXPECT_TRUE(object.velocities.empty());
}

/// The example scene with one key of its only instance (or, from the root on, another place) set to JSON text.
SceneRecording scene_with(const std::string& pointer, const std::string& value) {
  const TemporaryFolder folder;
  nlohmann::json scene = nlohmann::json::parse(kScene);
  scene[nlohmann::json::json_pointer(pointer)] = nlohmann::json::parse(value);
  write_text(folder.path() / "metadata.json", scene.dump());
  return read_kubric_scene(folder.path());
}

TEST(Kubric, P40_ScaleIsAnExtentAsANumberAndAFactorPerAxis) {
  const RecordedObject extent = scene_with("/instances/0/scale", "2.5").objects.at(0);
  EXPECT_EQ(extent.largest_extent_m, 2.5);
  const RecordedObject factors = scene_with("/instances/0/scale", "[2.5, 2.5, 2.5]").objects.at(0);
  EXPECT_FALSE(factors.largest_extent_m.has_value());
  EXPECT_EQ(factors.size, 2.5);
  EXPECT_EQ(scene_with("/instances/0/size", "[0.5, 0.5, 0.5]").objects.at(0).size, 0.5);
}

TEST(Kubric, P41_BackgroundsAreLeftOutWhateverElseTheyHold) {
  EXPECT_TRUE(scene_with("/instances/0", R"({"background": true, "asset_id": "dome"})").objects.empty());
  EXPECT_EQ(scene_with("/instances/0/background", "false").objects.size(), 1u);
}

TEST(Kubric, P41_WhatIsSaidToBeStaticAndStaysIsStatic) {
  const std::string still = R"([[0.6, 0.8, 0, 0], [0.6, 0.8, 0, 0]])";
  nlohmann::json instance = nlohmann::json::parse(kScene)["instances"][0];
  instance["quaternions"] = nlohmann::json::parse(still);
  const auto is_static = [&](const char* key, const nlohmann::json& value) {
    nlohmann::json marked = instance;
    marked[key] = value;
    return scene_with("/instances/0", marked.dump()).objects.at(0).is_static;
  };
  EXPECT_FALSE(is_static("is_dynamic", true));
  EXPECT_TRUE(is_static("is_dynamic", false));
  EXPECT_TRUE(is_static("static", true));
  EXPECT_TRUE(is_static("is_static", 1));
  EXPECT_TRUE(is_static("mass", 0));
  EXPECT_FALSE(is_static("mass", 2.0));
  EXPECT_FALSE(is_static("mass", nullptr));
  // MOVi-D to F: lies about at first, and is hit later.
  EXPECT_FALSE(scene_with("/instances/0/is_dynamic", "false").objects.at(0).is_static);
}

TEST(Kubric, P42_AnyFrameRateIsCarried) {
  EXPECT_EQ(scene_with("/metadata/frame_rate", "12").frame_rate_hz, 12.0);
  EXPECT_EQ(scene_with("/metadata/gravity", "[0, 0, 0]").gravity.norm(), 0.0);
}

TEST(Kubric, TheGroundIsThatOfMoviUnlessTheFileSaysOtherwise) {
  EXPECT_EQ(scene_with("/metadata/seed", "1").ground, (GroundProperties{0.3, 0.5}));
  EXPECT_EQ(scene_with("/metadata/ground", "{}").ground, GroundProperties());
  const SceneRecording steel = scene_with("/metadata/ground", R"({"friction": 0.15, "restitution": 0.9})");
  EXPECT_EQ(steel.ground, (GroundProperties{0.15, 0.9}));
  const TemporaryFolder folder;
  write_kubric_scene(folder.path(), steel);
  EXPECT_EQ(read_kubric_scene(folder.path()).ground, steel.ground);
}

struct Defect {
  const char* pointer;      ///< JSON pointer to what is replaced
  const char* replacement;  ///< JSON text that replaces it; empty = it is removed
  const char* expected;     ///< Part of the error that reading gives
};

class BrokenKubric : public ::testing::TestWithParam<Defect> {};

TEST_P(BrokenKubric, ErrorNamesFileAndKey) {
  const TemporaryFolder folder;
  nlohmann::json scene = nlohmann::json::parse(kScene);
  const nlohmann::json::json_pointer pointer(GetParam().pointer);
  if (GetParam().replacement == nullptr) {
    scene.at(pointer.parent_pointer()).erase(pointer.back());
  } else {
    scene[pointer] = nlohmann::json::parse(GetParam().replacement);
  }
  write_text(folder.path() / "metadata.json", scene.dump());
  const std::string error = error_of([&] { read_kubric_scene(folder.path()); });
  EXPECT_NE(error.find("metadata.json"), std::string::npos) << error;
  EXPECT_NE(error.find(GetParam().expected), std::string::npos) << error;
}

INSTANTIATE_TEST_SUITE_P(
    Defects, BrokenKubric,
    ::testing::Values(Defect{"/metadata", nullptr, "metadata is missing"},
                      Defect{"/metadata/num_frames", "3", "instances[0].positions has 2 entries"},
                      Defect{"/metadata/num_frames", "-1", "metadata.num_frames"},
                      Defect{"/metadata/frame_rate", "\"fast\"", "metadata.frame_rate = \"fast\" is not a number"},
                      Defect{"/metadata/seed", "-1e300", "is not an integer >= 0"},
                      Defect{"/metadata/frame_rate", "\"240\"", "= \"240\" is not a number"},
                      Defect{"/metadata/frame_rate", "0", "metadata.frame_rate = 0 must be > 0"},
                      Defect{"/metadata/num_frames", "1.5", "metadata.num_frames = 1.5 must be a whole number"},
                      Defect{"/metadata/gravity", "[0, -10]", "metadata.gravity"},
                      Defect{"/metadata/gravity", "[0, -9.81, 0]", "does not point along -z"},
                      Defect{"/metadata/gravity", "[0, 0, 9.81]", "does not point along -z"},
                      Defect{"/metadata/ground", R"({"restitution": 2})", "accepted is 0 to 1"},
                      Defect{"/instances/0/scale", "[1, 1, 2]", "instances[0].scale = [1,1,2] of 'cube' differs"},
                      Defect{"/instances/0/scale", "\"big\"", "instances[0].scale = \"big\" is not a number"},
                      Defect{"/instances/0/scale", "-1", "instances[0].scale = -1 of 'cube' must be > 0"},
                      Defect{"/instances/0/static", "true", "instances[0].static = true but the object moves"},
                      Defect{"/instances/0/static", "\"no\"", "is neither true nor false"},
                      Defect{"/instances/0/mass", "0", "instances[0].mass = 0 but the object moves"},
                      Defect{"/instances/0/mass", "\"2 kg\"", "instances[0].mass = \"2 kg\" is not a number"},
                      Defect{"/instances/0/restitution", "1.5", "accepted is 0 to 1"},
                      Defect{"/instances", "{}", "instances is not a list"},
                      Defect{"/instances/0/asset_id", nullptr, "instances[0].asset_id is missing"},
                      Defect{"/instances/0/mass", "-1", "instances[0].mass"},
                      Defect{"/instances/0/size", "0", "instances[0].size"},
                      Defect{"/instances/0/positions/1", "[1, null, 3]", "instances[0].positions[1][1]"},
                      Defect{"/instances/0/quaternions/1", "[2, 0, 0, 0]", "instances[0].quaternions[1]"},
                      Defect{"/instances/0/velocities", "[[0, 0, 0]]", "instances[0].velocities"}));

TEST(Kubric, MissingAndTruncatedFilesAreErrors) {
  const TemporaryFolder folder;
  EXPECT_NE(error_of([&] { read_kubric_scene(folder.path() / "none"); }).find("cannot read"), std::string::npos);
  write_text(folder.path() / "metadata.json", std::string(kScene).substr(0, 90));
  EXPECT_NE(error_of([&] { read_kubric_scene(folder.path()); }).find("not valid JSON"), std::string::npos);
}

TEST(Kubric, AnEndlessFileIsRefusedWithoutReadingIt) {
  const TemporaryFolder folder;
  write_text(folder.path() / "metadata.json", kScene);
  std::filesystem::resize_file(folder.path() / "metadata.json", std::uintmax_t{1} << 32);
  EXPECT_NE(error_of([&] { read_kubric_scene(folder.path()); }).find("accepted are at most"), std::string::npos);
}

TEST(Kubric, AFullDiskIsAClearErrorAndKeepsTheOldScene) {
  const TemporaryFolder folder;
  write_kubric_scene(folder.path(), example_archive(1).scenes[0]);
  const std::string message = on_a_full_disk([&] { write_kubric_scene(folder.path(), example_archive(50).scenes[1]); });
  EXPECT_NE(message.find("metadata.json': cannot write"), std::string::npos) << message;
  EXPECT_EQ(read_kubric_scene(folder.path()).num_frames, 1);
  EXPECT_EQ(count_files(folder.path()), 1);
}

}  // namespace
}  // namespace rigidformer
