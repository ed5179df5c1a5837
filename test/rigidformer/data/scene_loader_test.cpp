// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/data/scene_loader.hpp"

#include <gtest/gtest.h>

#include "example_archive.hpp"
#include "rigidformer/data/kubasic.hpp"
#include "rigidformer/data/kubric.hpp"

namespace rigidformer {
namespace {

const std::vector<Shape> kNoShapes;

/// Writes Kubric folders 2 and 10 into `folder`; the second one has two objects.
void write_kubric_folders(const std::filesystem::path& folder) {
  const SceneArchive archive = example_archive();
  write_kubric_scene(folder / "2", archive.scenes[0]);
  write_kubric_scene(folder / "10", archive.scenes[1]);
}

TEST(SceneLoader, ReadsOneArchiveAndAFolderOfShards) {
  const TemporaryFolder folder;
  write_scene_archive(folder.path() / "scenes_000000.safetensors", example_archive());
  write_scene_archive(folder.path() / "scenes_000002.safetensors", example_archive());
  EXPECT_EQ(load_scenes(folder.path() / "scenes_000000.safetensors", kNoShapes).scenes.size(), 2u);
  const SceneArchive all = load_scenes(folder.path(), kNoShapes);
  EXPECT_EQ(all.scenes.size(), 4u);
  EXPECT_EQ(all.shapes.size(), 1u);
  EXPECT_EQ(all.set, "example");
  EXPECT_EQ(load_scenes(folder.path(), kNoShapes, 3).scenes.size(), 3u);
}

TEST(SceneLoader, ShardsMustAgree) {
  const TemporaryFolder folder;
  SceneArchive other = example_archive();
  write_scene_archive(folder.path() / "a.safetensors", other);
  other.shapes[0].parts[0].vertices(0, 0) = 0.25F;
  write_scene_archive(folder.path() / "b.safetensors", other);
  EXPECT_NE(error_of([&] { load_scenes(folder.path(), kNoShapes); }).find("tetrahedron"), std::string::npos);
  other = example_archive();
  other.set = "another";
  write_scene_archive(folder.path() / "b.safetensors", other);
  EXPECT_NE(error_of([&] { load_scenes(folder.path(), kNoShapes); }).find("another"), std::string::npos);
}

TEST(SceneLoader, ReadsKubricFoldersInNumericOrderAtEveryLevel) {
  const TemporaryFolder folder;
  write_kubric_folders(folder.path() / "MOVi-X");
  const std::vector<Shape> shapes = {tetrahedron(), tetrahedron("unused")};
  const SceneArchive archive = load_scenes(folder.path() / "MOVi-X", shapes);
  ASSERT_EQ(archive.scenes.size(), 2u);
  EXPECT_EQ(archive.scenes[0].name, "2");
  EXPECT_EQ(archive.scenes[1].name, "10");
  EXPECT_EQ(archive.set, "MOVi-X");
  EXPECT_EQ(archive.shapes.size(), 1u);
  EXPECT_EQ(load_scenes(folder.path() / "MOVi-X" / "10", shapes).scenes.size(), 1u);
  EXPECT_EQ(load_scenes(folder.path(), shapes).scenes.size(), 2u);
  EXPECT_EQ(load_scenes(folder.path(), shapes, 1).scenes.size(), 1u);
}

TEST(SceneLoader, KubricScenesNeedTheirShapes) {
  const TemporaryFolder folder;
  write_kubric_folders(folder.path());
  EXPECT_NE(error_of([&] { load_scenes(folder.path(), kNoShapes); }).find("--shapes"), std::string::npos);
  EXPECT_NE(error_of([&] { load_scenes(folder.path(), {tetrahedron("other")}); }).find("'tetrahedron'"),
            std::string::npos);
  write_kubasic_shape(folder.path() / "shapes", tetrahedron());
  EXPECT_EQ(load_scenes(folder.path(), kNoShapes).scenes.size(), 2u);
  EXPECT_EQ(load_scenes(folder.path(), folder.path() / "shapes").scenes.size(), 2u);
}

TEST(SceneLoader, P40_AScaleBecomesASizeOnceTheMeshIsKnown) {
  const TemporaryFolder folder;
  write_kubric_folders(folder.path());
  std::string text;
  std::ifstream(folder.path() / "2" / "metadata.json") >> text;
  const std::size_t at = text.find("\"size\"");
  ASSERT_NE(at, std::string::npos);
  write_text(folder.path() / "2" / "metadata.json", text.replace(at, 6, "\"scale\""));
  Shape shape = tetrahedron();
  shape.parts[0].vertices *= 0.1F;
  const RecordedObject object = load_scenes(folder.path() / "2", {shape}).scenes[0].objects[0];
  EXPECT_NEAR(object.size, 10.0 * example_archive().scenes[0].objects[0].size, 1e-6);
  EXPECT_FALSE(object.largest_extent_m.has_value());
}

TEST(SceneLoader, P43_MeshesThatNoSceneUsesMayBeBroken) {
  const TemporaryFolder folder;
  write_kubric_folders(folder.path() / "scenes");
  write_kubasic_shape(folder.path() / "shapes", tetrahedron());
  write_text(folder.path() / "shapes" / "dome" / "collision_geometry.obj", "v 0 0\n");
  EXPECT_EQ(load_scenes(folder.path() / "scenes", folder.path() / "shapes").scenes.size(), 2u);
  // One that is used is an error that names it.
  std::filesystem::copy_file(folder.path() / "shapes" / "dome" / "collision_geometry.obj",
                             folder.path() / "shapes" / "tetrahedron" / "collision_geometry.obj",
                             std::filesystem::copy_options::overwrite_existing);
  const std::string error = error_of([&] { load_scenes(folder.path() / "scenes", folder.path() / "shapes"); });
  EXPECT_NE(error.find("tetrahedron/collision_geometry.obj': line 1"), std::string::npos) << error;
}

TEST(SceneLoader, P45_ScenesMayHaveDifferentLengths) {
  const TemporaryFolder folder;
  write_kubric_scene(folder.path() / "1", example_archive(7).scenes[0]);
  write_kubric_scene(folder.path() / "2", example_archive(4).scenes[1]);
  const SceneArchive archive = load_scenes(folder.path(), {tetrahedron()});
  ASSERT_EQ(archive.scenes.size(), 2u);
  EXPECT_EQ(archive.scenes[0].num_frames, 7);
  EXPECT_EQ(archive.scenes[1].num_frames, 4);
}

TEST(SceneLoader, MissingAndEmptyPlacesAreErrors) {
  const TemporaryFolder folder;
  EXPECT_NE(error_of([&] { load_scenes(folder.path(), kNoShapes); }).find("holds neither"), std::string::npos);
  EXPECT_NE(error_of([&] { load_scenes(folder.path() / "none", kNoShapes); }).find("no such"), std::string::npos);
}

TEST(SceneLoader, ReadsThePublishedSample) {
  const std::filesystem::path data = RIGIDFORMER_SOURCE_DIR "/../shared/data";
  if (!std::filesystem::is_directory(data / "movi_sample")) GTEST_SKIP() << "MOVi sample is not there: " << data;
  const SceneArchive archive = load_scenes(data / "movi_sample", data / "kubasic");
  ASSERT_EQ(archive.scenes.size(), 2u);
  for (const SceneRecording& scene : archive.scenes) {
    EXPECT_EQ(scene.num_frames, 480);
    EXPECT_EQ(scene.objects.size(), 3u);
    EXPECT_EQ(scene.objects[0].velocities.size(), 480u);
  }
}

}  // namespace
}  // namespace rigidformer
