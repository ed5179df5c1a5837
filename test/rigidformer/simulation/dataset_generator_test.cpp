// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/dataset_generator.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "rigidformer/data/kubasic.hpp"
#include "rigidformer/data/scene_loader.hpp"
#include "rigidformer/simulation/builtin_shapes.hpp"

namespace rigidformer {
namespace {

namespace fs = std::filesystem;

class DatasetGenerator : public ::testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  DatasetOptions options() const {
    DatasetOptions options;
    options.set = "movi_sphere";
    options.num_scenes = 2;
    options.seed = 9;
    options.output = folder_ / "set";
    return options;
  }

  static std::string bytes(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::stringstream content;
    content << in.rdbuf();
    return content.str();
  }

  std::ostringstream log_;
  const fs::path folder_ = fs::temp_directory_path() / ("rigidformer_generator_" + std::to_string(::getpid()));
};

TEST_F(DatasetGenerator, ArchiveIsTheSameForAnyNumberOfThreadsAndIsKeptOnARepeat) {
  DatasetOptions one = options();
  generate_dataset(one, log_);
  const fs::path shard = one.output / "scenes_000000.safetensors";
  const std::string first = bytes(shard);
  const auto time = fs::last_write_time(shard);
  generate_dataset(one, log_);
  EXPECT_EQ(fs::last_write_time(shard), time);

  DatasetOptions two = one;
  two.output = folder_ / "threads";
  two.jobs = 2;
  generate_dataset(two, log_);
  EXPECT_EQ(bytes(two.output / "scenes_000000.safetensors"), first);
  EXPECT_NE(log_.str().find("2/2 scenes"), std::string::npos) << log_.str();

  std::ofstream(shard, std::ios::binary) << first.substr(0, first.size() / 2);
  generate_dataset(one, log_);
  EXPECT_EQ(bytes(shard), first) << "a truncated shard must be made again";
}

TEST_F(DatasetGenerator, KubricFoldersHoldTheSameScenesAndResume) {
  DatasetOptions archive = options();
  generate_dataset(archive, log_);
  DatasetOptions kubric = options();
  kubric.output = folder_ / "kubric";
  kubric.format = "kubric";
  generate_dataset(kubric, log_);
  const std::string second = bytes(kubric.output / "1" / "metadata.json");
  fs::remove_all(kubric.output / "1");
  generate_dataset(kubric, log_);
  EXPECT_EQ(bytes(kubric.output / "1" / "metadata.json"), second);

  const SceneArchive a = load_scenes(archive.output, std::vector<Shape>{});
  const SceneArchive b = load_scenes(kubric.output, std::vector<Shape>{});
  EXPECT_EQ(b.set, "movi_sphere");
  ASSERT_EQ(a.scenes.size(), b.scenes.size());
  for (std::size_t s = 0; s < a.scenes.size(); ++s) {
    ASSERT_EQ(a.scenes[s].objects.size(), b.scenes[s].objects.size());
    const RigidTransform& x = a.scenes[s].objects[0].T_world_object.back();
    const RigidTransform& y = b.scenes[s].objects[0].T_world_object.back();
    EXPECT_LT((x.translation - y.translation).norm(), 1e-5);
    EXPECT_LT(rotation_angle(x.rotation, y.rotation), 1e-3);
  }
}

TEST_F(DatasetGenerator, P43_MeshesThatTheSetDoesNotDrawFromMayBeBroken) {
  DatasetOptions sphere = options();
  sphere.num_scenes = 1;
  sphere.movi.num_frames = 2;
  sphere.shapes = folder_ / "library";
  for (const Shape& shape : movi_shapes(MoviSet::kA, builtin_shapes())) write_kubasic_shape(sphere.shapes, shape);
  fs::create_directories(sphere.shapes / "dome");
  std::ofstream(sphere.shapes / "dome" / "collision_geometry.obj") << "v 0 0 1\nf 1 2 3\n";
  generate_dataset(sphere, log_);
  EXPECT_EQ(log_.str().find("dome"), std::string::npos) << log_.str();
  DatasetOptions any = sphere;
  any.set = "movi_b";
  any.output = folder_ / "any";
  generate_dataset(any, log_);
  EXPECT_NE(log_.str().find("dome/collision_geometry.obj': line 2"), std::string::npos) << log_.str();
  EXPECT_EQ(load_scenes(any.output, std::vector<Shape>{}).shapes.size(), 3u);
}

TEST_F(DatasetGenerator, EnginesMakeTwinsOfTheSameVariedScenes) {
  DatasetOptions bullet = options();
  bullet.contacts = "varied";
  bullet.movi.num_frames = 5;
  generate_dataset(bullet, log_);
  DatasetOptions mujoco = bullet;
  mujoco.engine = "mujoco";
  EXPECT_THROW(generate_dataset(mujoco, log_), std::runtime_error);  // the folder or the missing engine
  mujoco.output = folder_ / "mujoco";
  try {
    generate_dataset(mujoco, log_);
  } catch (const std::runtime_error& error) {
    GTEST_SKIP() << error.what();
  }
  const SceneArchive a = load_scenes(bullet.output, std::vector<Shape>{});
  const SceneArchive b = load_scenes(mujoco.output, std::vector<Shape>{});
  for (std::size_t s = 0; s < a.scenes.size(); ++s) {
    EXPECT_EQ(a.scenes[s].ground, b.scenes[s].ground);
    EXPECT_FALSE(a.scenes[s].ground == SceneRecording().ground);
    EXPECT_EQ(a.scenes[s].gravity, b.scenes[s].gravity);
    const RecordedObject &x = a.scenes[s].objects[0], &y = b.scenes[s].objects[0];
    EXPECT_EQ(x.properties.friction, y.properties.friction);
    EXPECT_EQ(x.T_world_object[0].translation, y.T_world_object[0].translation);
    EXPECT_LT((x.T_world_object[4].translation - y.T_world_object[4].translation).norm(), 1e-3) << "in free fall";
  }
}

TEST_F(DatasetGenerator, FixturesAreTheSameForAnyNumberOfThreadsAndLeaveOtherScenesAlone) {
  DatasetOptions plain = options();
  plain.movi.num_frames = 60;
  generate_dataset(plain, log_);
  DatasetOptions fixtures = plain;
  fixtures.fixtures = true;
  EXPECT_THROW(generate_dataset(fixtures, log_), std::runtime_error) << "the folder holds other scenes";
  fixtures.output = folder_ / "fixtures";
  generate_dataset(fixtures, log_);
  DatasetOptions threads = fixtures;
  threads.jobs = 2;
  threads.output = folder_ / "threads";
  generate_dataset(threads, log_);
  const char* shard = "scenes_000000.safetensors";
  EXPECT_EQ(bytes(threads.output / shard), bytes(fixtures.output / shard));

  const SceneArchive a = load_scenes(plain.output, std::vector<Shape>{});
  EXPECT_EQ(a.shapes.size(), 1U);
  for (const SceneRecording& scene : a.scenes) {
    for (const RecordedObject& object : scene.objects) EXPECT_FALSE(object.is_given());
  }
  const SceneArchive b = load_scenes(fixtures.output, std::vector<Shape>{});
  const auto is_given = [](const RecordedObject& object) { return object.is_given(); };
  for (const SceneRecording& scene : b.scenes) {
    EXPECT_TRUE(std::any_of(scene.objects.begin(), scene.objects.end(), is_given));
    EXPECT_FALSE(std::all_of(scene.objects.begin(), scene.objects.end(), is_given));
  }
}

TEST_F(DatasetGenerator, RefusesToMixData) {
  generate_dataset(options(), log_);
  DatasetOptions other_seed = options();
  other_seed.seed = 10;
  DatasetOptions other_set = options();
  other_set.set = "movi_a";
  DatasetOptions other_format = options();
  other_format.format = "kubric";
  DatasetOptions other_frames = options();
  other_frames.movi.first_frame = 5;
  for (const DatasetOptions& other : {other_seed, other_set, other_format, other_frames}) {
    EXPECT_THROW(generate_dataset(other, log_), std::runtime_error);
  }
  DatasetOptions foreign = options();
  foreign.output = folder_;
  EXPECT_THROW(generate_dataset(foreign, log_), std::runtime_error);
}

TEST_F(DatasetGenerator, BadOptionsAreRefusedBeforeAnythingIsWritten) {
  DatasetOptions bad = options();
  bad.num_scenes = 0;
  EXPECT_THROW(generate_dataset(bad, log_), std::invalid_argument);
  bad = options();
  bad.movi.num_frames = 0;
  EXPECT_THROW(generate_dataset(bad, log_), std::invalid_argument);
  bad = options();
  bad.contacts = "soft";
  EXPECT_THROW(generate_dataset(bad, log_), std::invalid_argument);
  bad = options();
  bad.engine = "ode";
  EXPECT_THROW(generate_dataset(bad, log_), std::invalid_argument);
  bad = options();
  bad.fixtures = true;
  bad.format = "kubric";
  EXPECT_THROW(generate_dataset(bad, log_), std::invalid_argument);
  bad = options();
  bad.fixtures = true;
  bad.set = "walker_15";
  EXPECT_THROW(generate_dataset(bad, log_), std::invalid_argument);
  bad = options();
  bad.format = "zip";
  EXPECT_THROW(generate_dataset(bad, log_), std::invalid_argument);
  EXPECT_FALSE(fs::exists(folder_));
}

}  // namespace
}  // namespace rigidformer
