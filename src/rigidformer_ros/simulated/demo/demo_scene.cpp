// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/demo/demo_scene.hpp"

#include <algorithm>
#include <stdexcept>

#include "rigidformer/scene/surface_sampling.hpp"
#include "rigidformer/simulation/builtin_shapes.hpp"
#include "rigidformer/simulation/scene_set.hpp"

namespace rigidformer_ros::demo {
namespace {

const rigidformer::Shape& find_shape(const std::vector<rigidformer::Shape>& shapes, const std::string& name) {
  const auto found = std::find_if(shapes.begin(), shapes.end(), [&](const auto& shape) { return shape.name == name; });
  if (found == shapes.end()) {
    throw std::invalid_argument("the simulated scene holds the unknown shape '" + name + "'");
  }
  return *found;
}

rigidformer::Points surface_points(const rigidformer::Shape& shape, const DemoSceneOptions& options) {
  if (options.points_per_object == 0) return shape.vertices();
  return rigidformer::sample_surface(shape, options.points_per_object, options.seed).points;
}

}  // namespace

DemoScene::DemoScene(const DemoSceneOptions& options) {
  const auto shapes = rigidformer::scene_set_shapes(options.set, rigidformer::builtin_shapes());
  rigidformer::MoviOptions movi;
  movi.num_frames = options.num_frames;
  recording_ = rigidformer::generate_scene(options.set, shapes, options.seed, options.index, movi);
  for (const auto& object : recording_.objects) {
    rigidformer::Points cloud =
        surface_points(find_shape(shapes, object.shape), options) * static_cast<float>(object.size);
    const Eigen::RowVector3f centroid = cloud.colwise().mean();
    cloud.rowwise() -= centroid;
    clouds_.push_back(cloud);
    centroids_in_body_.push_back(centroid.transpose().cast<double>());
  }
}

std::string DemoScene::object_id(int object) { return "object_" + std::to_string(object); }

rigidformer::Points DemoScene::cloud_world(int object, int frame) const {
  return T_world_cloud(object, frame).apply(clouds_.at(object));
}

rigidformer::RigidTransform DemoScene::T_world_cloud(int object, int frame) const {
  const rigidformer::RigidTransform& T_world_body = recording_.objects.at(object).T_world_object.at(frame);
  return T_world_body * rigidformer::RigidTransform{Eigen::Quaterniond::Identity(), centroids_in_body_.at(object)};
}

}  // namespace rigidformer_ros::demo
