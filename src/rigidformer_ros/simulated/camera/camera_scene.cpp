// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/camera/camera_scene.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "rigidformer/data/scene_loader.hpp"
#include "rigidformer/geometry/point_rows.hpp"
#include "rigidformer/simulation/builtin_shapes.hpp"
#include "rigidformer/simulation/movi_scene.hpp"
#include "rigidformer_ros/messages/cloud_conversion.hpp"

namespace rigidformer_ros::camera {
namespace {

using rigidformer::RigidTransform;
using rigidformer::SceneArchive;

// Frames per second that generate_movi_scene() records: the default of BulletSettings.
constexpr double kSimulationRate_hz = 240.0;
// Points on the surface of each object; chosen by eye. The share of them that is seen is the visible fraction.
constexpr int kSurfacePoints = 256;

SceneArchive simulate(const CameraOptions& options, std::uint64_t index) {
  const rigidformer::MoviSet set = rigidformer::parse_movi_set(options.scene_set);
  SceneArchive archive;
  archive.set = options.scene_set;
  archive.shapes = rigidformer::movi_shapes(set, rigidformer::builtin_shapes());
  rigidformer::MoviOptions movi;
  movi.num_frames = static_cast<int>(std::lround(options.duration * kSimulationRate_hz)) + 1;
  archive.scenes.push_back(
      rigidformer::generate_movi_scene(set, archive.shapes, static_cast<std::uint64_t>(options.seed), index, movi));
  return archive;
}

SceneArchive load(const std::string& file, std::uint64_t index) {
  SceneArchive archive = rigidformer::load_scenes(file, std::vector<rigidformer::Shape>{});
  if (archive.scenes.empty()) {
    throw std::runtime_error("scene_file: '" + file + "' holds no scenes");
  }
  archive.scenes = {archive.scenes[index % archive.scenes.size()]};
  return archive;
}

Eigen::Vector3d scaled(const std::vector<double>& position, double scale) {
  return scale * Eigen::Vector3d(position.at(0), position.at(1), position.at(2));
}

}  // namespace

rigidformer::Points CameraView::points_of(int object) const {
  std::vector<int> rows;
  for (std::size_t i = 0; i < frame.body.size(); ++i) {
    if (frame.body[i] == object) {
      rows.push_back(static_cast<int>(i));
    }
  }
  return rigidformer::select_rows(frame.points_camera, rows);
}

CameraScene::CameraScene(const CameraOptions& options, std::uint64_t index) : options_(options), index_(index) {
  options.validate();
  archive_ = options.scene_file.empty() ? simulate(options, index) : load(options.scene_file, index);
  recorded_rate_hz_ = recording().frame_rate_hz / std::sqrt(options.scale);
  const double recorded_s = (recording().num_frames - 1) / recorded_rate_hz_;
  const double shown_s = std::min(options.duration * std::sqrt(options.scale), recorded_s);
  num_frames_ = static_cast<int>(std::floor(shown_s * options.frame_rate + 1e-6)) + 1;
  T_world_camera_ =
      rigidformer::look_at(scaled(options.position, options.scale), scaled(options.target, options.scale));
  for (int object = 0; object < num_objects(); ++object) {
    surfaces_.push_back(rigidformer::sample_surface(shape(object), kSurfacePoints, 1));
  }
}

const rigidformer::Shape& CameraScene::shape(int object) const {
  const std::string& name = shape_name(object);
  const auto found = std::find_if(archive_.shapes.begin(), archive_.shapes.end(),
                                  [&](const rigidformer::Shape& candidate) { return candidate.name == name; });
  if (found == archive_.shapes.end()) {
    throw std::invalid_argument("the scene holds the unknown shape '" + name + "'");
  }
  return *found;
}

RigidTransform CameraScene::T_world_object(int object, double time_s) const {
  const std::vector<RigidTransform>& poses = recording().objects.at(object).T_world_object;
  const double at = std::clamp(time_s * recorded_rate_hz_, 0.0, static_cast<double>(poses.size() - 1));
  const auto before = static_cast<std::size_t>(at);
  const std::size_t after = std::min(before + 1, poses.size() - 1);
  RigidTransform T = rigidformer::interpolate(poses[before], poses[after], at - static_cast<double>(before));
  T.translation *= options_.scale;
  return T;
}

CameraView CameraScene::view(int frame) const {
  CameraView view;
  const RigidTransform T_camera_world = T_world_camera_.inverse();
  for (int object = 0; object < num_objects(); ++object) {
    view.bodies.push_back({&shape(object), options_.scale * recording().objects[object].size,
                           T_camera_world * T_world_object(object, time_s(frame))});
  }
  const rigidformer::DepthCameraOptions camera = options_.camera();
  view.image = rigidformer::render_depth(camera.intrinsics, view.bodies, T_camera_world, 0.0);
  const std::uint64_t number = (index_ << 32U) + static_cast<std::uint64_t>(frame);
  view.frame = rigidformer::measure(view.image, camera, number);
  return view;
}

double CameraScene::visible_fraction(const CameraView& view, int object) const {
  return rigidformer::visible_fraction(view.image, view.bodies.at(object), object, surfaces_.at(object));
}

rigidformer::Points CameraScene::surface_points(int object) const {
  return surfaces_.at(object).points * static_cast<float>(options_.scale * recording().objects.at(object).size);
}

}  // namespace rigidformer_ros::camera
