// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "rigidformer/data/scene_archive.hpp"

namespace rigidformer {

/// A folder that vanishes with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::temp_directory_path() /
            (std::string("rigidformer_") + info->test_suite_name() + '_' + info->name() + std::to_string(::getpid()));
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

/// Returns the message of the exception that `call` throws; empty when it throws none.
template <typename Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const std::exception& exception) {
    return exception.what();
  }
  return "";
}

/// Returns the message of the std::runtime_error that `call` must throw about the file at `path`, which it names.
template <typename Call>
std::string file_error_of(const std::filesystem::path& path, const Call& call) {
  try {
    call();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no std::runtime_error about " << path;
  return "";
}

/// A tetrahedron with its corners at the origin and at 1 on each axis.
inline Shape tetrahedron(const std::string& name = "tetrahedron") {
  ConvexPart part;
  part.vertices.resize(4, 3);
  part.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  part.triangles.resize(4, 3);
  part.triangles << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  return {name, 0.5, {part}};
}

inline RecordedObject example_object(double offset, int num_frames) {
  RecordedObject object;
  object.shape = "tetrahedron";
  object.size = 0.7 + offset;
  object.properties = {1.25 + offset, 0.4, std::nullopt};
  for (int frame = 0; frame < num_frames; ++frame) {
    const Eigen::AngleAxisd turn(0.1 * frame + offset, Eigen::Vector3d(1, 2, 3).normalized());
    object.T_world_object.push_back({Eigen::Quaterniond(turn), Eigen::Vector3d(offset, 0.01 * frame, 2.0)});
    object.velocities.emplace_back(0.0, 2.4, offset);
    object.angular_velocities.emplace_back(offset, 0.0, 1.0);
  }
  return object;
}

/// Two scenes, with one and two objects.
inline SceneArchive example_archive(int num_frames = 5) {
  SceneArchive archive;
  archive.set = "example";
  archive.shapes = {tetrahedron()};
  for (int s = 0; s < 2; ++s) {
    SceneRecording scene;
    scene.name = std::to_string(s);
    scene.seed = 40 + static_cast<std::uint64_t>(s);
    scene.num_frames = num_frames;
    scene.frame_rate_hz = 120.0;
    scene.gravity = {0.0, 0.0, -9.0};
    for (int i = 0; i <= s; ++i) scene.objects.push_back(example_object(s + 0.5 * i, num_frames));
    archive.scenes.push_back(scene);
  }
  return archive;
}

/// Largest difference of positions [m] or rotations [rad] over all frames.
inline double pose_difference(const RecordedObject& a, const RecordedObject& b) {
  double largest = a.T_world_object.size() == b.T_world_object.size() ? 0.0 : 1e9;
  for (std::size_t f = 0; largest < 1e9 && f < a.T_world_object.size(); ++f) {
    const RigidTransform& x = a.T_world_object[f];
    const RigidTransform& y = b.T_world_object[f];
    largest = std::max({largest, (x.translation - y.translation).norm(), rotation_angle(x.rotation, y.rotation)});
  }
  return largest;
}

}  // namespace rigidformer
