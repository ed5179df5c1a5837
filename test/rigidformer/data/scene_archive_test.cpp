// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/data/scene_archive.hpp"

#include <gtest/gtest.h>

#include "example_archive.hpp"
#include "rigidformer/io/tensor_file.hpp"

namespace rigidformer {
namespace {

TEST(SceneArchive, RoundTripKeepsEverythingStored) {
  const TemporaryFolder folder;
  const SceneArchive written = example_archive();
  write_scene_archive(folder.path() / "a.safetensors", written);
  const SceneArchive read = read_scene_archive(folder.path() / "a.safetensors");

  EXPECT_EQ(read.set, "example");
  ASSERT_EQ(read.shapes.size(), 1u);
  EXPECT_EQ(read.shapes[0].name, "tetrahedron");
  EXPECT_EQ(read.shapes[0].mass_kg, 0.5);
  ASSERT_EQ(read.shapes[0].parts.size(), 1u);
  EXPECT_EQ(read.shapes[0].parts[0].vertices, written.shapes[0].parts[0].vertices);
  EXPECT_EQ(read.shapes[0].parts[0].triangles, written.shapes[0].parts[0].triangles);
  ASSERT_EQ(read.scenes.size(), 2u);
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_EQ(read.scenes[s].name, written.scenes[s].name);
    EXPECT_EQ(read.scenes[s].seed, written.scenes[s].seed);
    EXPECT_EQ(read.scenes[s].num_frames, 5);
    EXPECT_EQ(read.scenes[s].frame_rate_hz, 120.0);
    EXPECT_EQ(read.scenes[s].gravity, written.scenes[s].gravity);
    ASSERT_EQ(read.scenes[s].objects.size(), s + 1);
    for (std::size_t i = 0; i <= s; ++i) {
      const RecordedObject& a = written.scenes[s].objects[i];
      const RecordedObject& b = read.scenes[s].objects[i];
      EXPECT_EQ(b.shape, a.shape);
      EXPECT_EQ(b.size, a.size);
      EXPECT_EQ(b.properties.mass_kg, a.properties.mass_kg);
      EXPECT_EQ(b.properties.friction, a.properties.friction);
      EXPECT_FALSE(b.properties.restitution.has_value());
      EXPECT_LT(pose_difference(a, b), 1e-6);
    }
  }
}

TEST(SceneArchive, RefusesToWriteAnUnknownShape) {
  const TemporaryFolder folder;
  SceneArchive archive = example_archive();
  archive.scenes[1].objects[0].shape = "teapot";
  const std::string error = error_of([&] { write_scene_archive(folder.path() / "a.safetensors", archive); });
  EXPECT_NE(error.find("'teapot'"), std::string::npos) << error;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.safetensors"));
}

TEST(SceneArchive, KeepsTheCommandOfEveryFrame) {
  const TemporaryFolder folder;
  SceneArchive archive = example_archive(5);
  for (SceneRecording& scene : archive.scenes) {
    for (int frame = 0; frame < 5; ++frame) scene.control.push_back({0.5 * frame, 1.0, -0.25});
    scene.control_directions = 1;
  }
  write_scene_archive(folder.path() / "a.safetensors", archive);
  const SceneArchive read = read_scene_archive(folder.path() / "a.safetensors");
  EXPECT_EQ(read.scenes[1].control, archive.scenes[1].control);
  EXPECT_EQ(read.scenes[1].control_directions, 1);

  archive.scenes[1].control.clear();
  const std::string error = error_of([&] { write_scene_archive(folder.path() / "b.safetensors", archive); });
  EXPECT_NE(error.find("commands of another width"), std::string::npos) << error;
}

TEST(SceneArchive, P45_ScenesKeepTheirOwnLengths) {
  const TemporaryFolder folder;
  SceneArchive archive = example_archive(5);
  archive.scenes.push_back(example_archive(9).scenes[1]);
  write_scene_archive(folder.path() / "a.safetensors", archive);
  const SceneArchive read = read_scene_archive(folder.path() / "a.safetensors");
  ASSERT_EQ(read.scenes.size(), 3u);
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_EQ(read.scenes[s].num_frames, archive.scenes[s].num_frames);
    EXPECT_LT(pose_difference(read.scenes[s].objects[0], archive.scenes[s].objects[0]), 1e-3);
  }
  archive.scenes[0].objects[0].T_world_object.pop_back();
  EXPECT_NE(error_of([&] { write_scene_archive(folder.path() / "a.safetensors", archive); }).find("num_frames says 5"),
            std::string::npos);
}

TEST(SceneArchive, P41_ObjectsThatNeverMoveStayStatic) {
  const TemporaryFolder folder;
  SceneArchive archive = example_archive();
  archive.scenes[1].objects[1].is_static = true;
  write_scene_archive(folder.path() / "a.safetensors", archive);
  const SceneArchive read = read_scene_archive(folder.path() / "a.safetensors");
  EXPECT_FALSE(read.scenes[1].objects[0].is_static);
  EXPECT_TRUE(read.scenes[1].objects[1].is_static);
}

TEST(SceneArchive, DrivenObjectsAreToldAndOnlyTheyNeedTheNewVersion) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.safetensors";
  SceneArchive archive = example_archive();
  write_scene_archive(path, archive);
  EXPECT_EQ(read_tensor_file(path).tensors.count("object_driven"), 0U);
  archive.scenes[1].objects[0].is_driven = true;
  archive.scenes[1].objects[1].is_static = true;
  write_scene_archive(path, archive);
  EXPECT_EQ(read_tensor_file(path).metadata.at("format_version"), "4");
  const SceneArchive read = read_scene_archive(path);
  EXPECT_FALSE(read.scenes[0].objects[0].is_given());
  EXPECT_TRUE(read.scenes[1].objects[0].is_driven && !read.scenes[1].objects[0].is_static);
  EXPECT_TRUE(read.scenes[1].objects[1].is_static && !read.scenes[1].objects[1].is_driven);
  archive.scenes[1].objects[0].is_static = true;
  write_scene_archive(path, archive);
  EXPECT_NE(file_error_of(path, [&] { read_scene_archive(path); }).find("static and driven"), std::string::npos);
}

TEST(SceneArchive, TheGroundIsKeptAndThatOfMoviGoesWithoutSaying) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.safetensors";
  SceneArchive archive = example_archive();
  write_scene_archive(path, archive);
  EXPECT_EQ(read_tensor_file(path).metadata.at("format_version"), "1");
  EXPECT_EQ(read_tensor_file(path).metadata.at("scenes").find("ground"), std::string::npos);
  EXPECT_EQ(read_scene_archive(path).scenes[0].ground, (GroundProperties{0.3, 0.5}));
  archive.scenes[0].ground = {0.85, std::nullopt};
  write_scene_archive(path, archive);
  EXPECT_EQ(read_tensor_file(path).metadata.at("format_version"), "3");
  const SceneArchive read = read_scene_archive(path);
  EXPECT_EQ(read.scenes[0].ground, archive.scenes[0].ground);
  EXPECT_EQ(read.scenes[1].ground, archive.scenes[1].ground);
}

TEST(SceneArchive, AFloorMayBeTiltedByTwoDegrees) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.safetensors";
  SceneArchive archive = example_archive();
  archive.scenes[1].gravity = {0.3, 0.0, -9.8};
  write_scene_archive(path, archive);
  EXPECT_EQ(read_scene_archive(path).scenes[1].gravity, archive.scenes[1].gravity);
  archive.scenes[1].gravity = {0.0, -0.5, -9.8};
  write_scene_archive(path, archive);
  EXPECT_NE(error_of([&] { read_scene_archive(path); }).find("does not point along -z"), std::string::npos);
}

/// Writes a good archive, lets `damage` change its tensors, and returns the error of reading it.
template <typename Damage>
std::string error_after(const Damage& damage) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.safetensors";
  write_scene_archive(path, example_archive());
  TensorFile file = read_tensor_file(path);
  damage(file);
  write_tensor_file(path, file);
  return error_of([&] { read_scene_archive(path); });
}

void expect_mentions(const std::string& error, const std::string& word) {
  EXPECT_NE(error.find("a.safetensors"), std::string::npos) << error;
  EXPECT_NE(error.find(word), std::string::npos) << error;
}

TEST(SceneArchive, UntouchedFileReads) {
  EXPECT_EQ(error_after([](TensorFile&) {}), "");
}

TEST(SceneArchive, NamesTheDefect) {
  expect_mentions(error_after([](TensorFile& f) { f.metadata["format"] = "other"; }), "not a scene archive");
  expect_mentions(error_after([](TensorFile& f) { f.metadata["format_version"] = "99"; }), "version 99");
  expect_mentions(error_after([](TensorFile& f) { f.metadata["scenes"] = "[{"; }), "metadata");
  const auto with_scene = [](const std::string& from, const std::string& to) {
    return error_after([&](TensorFile& f) {
      std::string& scenes = f.metadata["scenes"];
      scenes.replace(scenes.find(from), from.size(), to);
    });
  };
  expect_mentions(with_scene("[0.0,0.0,-9.0]", "[0.0,-9.0,0.0]"), "does not point along -z");
  expect_mentions(with_scene("\"seed\"", "\"ground\":{\"friction\":-1,\"restitution\":null},\"seed\""), "friction");
  expect_mentions(with_scene("\"seed\"", "\"ground\":{\"friction\":1,\"restitution\":2},\"seed\""), "above 1");
  expect_mentions(with_scene("\"seed\"", "\"ground\":{\"friction\":1},\"seed\""), "metadata is not valid");
  expect_mentions(with_scene("\"seed\"", "\"num_frames\":6,\"seed\""), "no num_frames in 1...5");
  expect_mentions(error_after([](TensorFile& f) { f.metadata["scenes"] = "[]"; }), "object_scene");
  expect_mentions(error_after([](TensorFile& f) { f.tensors.erase("poses"); }), "'poses' is missing");
  expect_mentions(error_after([](TensorFile& f) { f.tensors["object_size"].shape = {1, 3}; }), "object_size");
  expect_mentions(error_after([](TensorFile& f) {
                    f.tensors["object_shape"] = make_raw_tensor(TensorType::kInt32, {3}, std::vector<int>{0, 7, 0});
                  }),
                  "object_shape");
  expect_mentions(error_after([](TensorFile& f) {
                    f.tensors["triangles"] = make_raw_tensor(TensorType::kInt32, {4, 3}, std::vector<int>(12, 4));
                  }),
                  "triangle");
  expect_mentions(
      error_after([](TensorFile& f) {
        f.tensors["poses"] = make_raw_tensor(TensorType::kFloat32, {3, 5, 7}, std::vector<float>(3 * 5 * 7, 2.0F));
      }),
      "pose");
}

TEST(SceneArchive, A1200SceneSetStaysBelow150Megabytes) {
  const TemporaryFolder folder;
  SceneArchive archive = example_archive(480);
  const std::filesystem::path path = folder.path() / "a.safetensors";
  write_scene_archive(path, archive);
  const auto two_scenes = static_cast<double>(std::filesystem::file_size(path));
  archive.scenes.insert(archive.scenes.end(), archive.scenes.begin(), archive.scenes.end());
  write_scene_archive(path, archive);
  const double bytes_per_object = (static_cast<double>(std::filesystem::file_size(path)) - two_scenes) / 3.0;
  EXPECT_LT(bytes_per_object * 1200 * 6.5 / 1e6, 150.0);  // a scene has 6.5 objects on average
}

}  // namespace
}  // namespace rigidformer
