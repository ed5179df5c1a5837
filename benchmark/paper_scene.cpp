// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper_scene.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "rigidformer/geometry/farthest_point_sampling.hpp"

namespace rigidformer {
namespace {

constexpr int kNumPoints[] = {64, 51, 1142, 64, 64, 682, 682, 647, 51, 569};  // points per object; paper, App. F.1
constexpr int kNumAnchors = 4;                                                // per object, as in the paper

Points sphere_cloud(int count, double radius_m, std::mt19937& random) {
  std::normal_distribution<float> coordinate;
  Points points(count, 3);
  for (Eigen::Index row = 0; row < count; ++row) {
    points.row(row) << coordinate(random), coordinate(random), coordinate(random);
    points.row(row) *= static_cast<float>(radius_m) / points.row(row).norm();
  }
  return points;
}

RigidTransform small_motion(std::size_t object, int step) {
  const double phase = 0.7 * static_cast<double>(object);
  const Eigen::Vector3d axis = Eigen::Vector3d(std::sin(phase), std::cos(phase), 0.5).normalized();
  return {Eigen::Quaterniond(Eigen::AngleAxisd(0.05 * step, axis)),
          0.05 * step * Eigen::Vector3d(std::cos(phase), std::sin(2.0 * phase), -0.2)};
}

Pose as_pose(const std::vector<RigidTransform>& transforms) {
  const auto K = static_cast<std::int64_t>(transforms.size());
  Pose pose{torch::zeros({1, K, 3, 3}), torch::zeros({1, K, 3})};
  for (std::int64_t k = 0; k < K; ++k) {
    const Eigen::Matrix3d R = transforms[k].rotation.toRotationMatrix();
    for (int i = 0; i < 3; ++i) {
      pose.translation[0][k][i] = transforms[k].translation[i];
      for (int j = 0; j < 3; ++j) {
        pose.rotation[0][k][i][j] = R(i, j);
      }
    }
  }
  return pose;
}

}  // namespace

std::vector<ObjectState> paper_scene() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> horizontal(-2.5, 2.5), height(0.7, 4.0), radius(0.35, 0.7);
  std::vector<ObjectState> objects;
  for (const int count : kNumPoints) {
    ObjectState object;
    object.id = "object_" + std::to_string(objects.size());
    object.points_reference = sphere_cloud(count, radius(random), random);
    object.T_world_previous.translation = {horizontal(random), horizontal(random), height(random)};
    object.T_world_current = small_motion(objects.size(), 1) * object.T_world_previous;
    object.properties = {1.0, 0.4, 0.5};
    objects.push_back(object);
  }
  return objects;
}

std::vector<RigidTransform> moved_poses(const std::vector<ObjectState>& objects, int step) {
  std::vector<RigidTransform> poses;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    RigidTransform moved = objects[i].T_world_current;
    const RigidTransform motion = small_motion(i, step);
    moved.rotation = (motion.rotation * moved.rotation).normalized();
    moved.translation += motion.translation;
    poses.push_back(moved);
  }
  return poses;
}

SceneBatch as_batch(const std::vector<ObjectState>& objects) {
  const auto K = static_cast<std::int64_t>(objects.size());
  std::int64_t N = 0;
  for (const ObjectState& object : objects) {
    N = std::max<std::int64_t>(N, object.points_reference.rows());
  }
  SceneBatch batch;
  batch.points_reference = torch::zeros({1, K, N, 3});
  batch.point_mask = torch::zeros({1, K, N}, torch::kBool);
  for (std::int64_t k = 0; k < K; ++k) {
    const Points& points = objects[k].points_reference;
    const Points ordered = points(farthest_point_order(points, static_cast<int>(points.rows())), Eigen::all);
    const auto rows = torch::from_blob(const_cast<float*>(ordered.data()), {ordered.rows(), 3});
    batch.points_reference[0][k].slice(0, 0, ordered.rows()).copy_(rows);
    batch.point_mask[0][k].slice(0, 0, ordered.rows()).fill_(true);
  }
  batch.object_mask = torch::ones({1, K}, torch::kBool);
  batch.anchor_index = torch::arange(kNumAnchors).expand({1, K, kNumAnchors}).contiguous();
  batch.properties = torch::tensor({1.0F, 0.4F, 0.5F}).expand({1, K, 3}).contiguous();
  batch.properties_known = torch::ones({1, K, 3});
  batch.dynamic_mask = torch::ones({1, K}, torch::kBool);
  batch.step_size = torch::full({1}, 10.0F);
  batch.ground_height = torch::zeros({1});
  batch.gravity = torch::full({1}, -10.0F);
  return batch;
}

SceneState as_state(const std::vector<ObjectState>& objects) {
  std::vector<RigidTransform> previous, current;
  for (const ObjectState& object : objects) {
    previous.push_back(object.T_world_previous);
    current.push_back(object.T_world_current);
  }
  const Pose first = as_pose(previous);
  return {first, first, as_pose(current)};
}

}  // namespace rigidformer
