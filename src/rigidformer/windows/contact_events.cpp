// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/contact_events.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <thread>

#include "rigidformer/model/batch.hpp"

namespace rigidformer {
namespace {

constexpr double kMinVelocityJump = 0.5;  // [m/s]
constexpr double kFloorDistance = 0.08;   // [m] higher than this is not the floor
constexpr int64_t kHeightPoints = 64;     // vertices looked at for the lowest point

using PoseRows = at::TensorAccessor<float, 3>;  // [F, K, 7]

Eigen::Vector3f position(const PoseRows& poses, int64_t frame, int64_t k) {
  return {poses[frame][k][0], poses[frame][k][1], poses[frame][k][2]};
}

/// Height of the lowest of an object's vertices.
double lowest_point(const SceneTensors& tensors, const PoseRows& poses, int64_t scene, int64_t frame, int64_t k) {
  const int64_t shape = tensors.shape[scene][k].item<int64_t>();
  const float size = tensors.size[scene][k].item<float>();
  const Tensor vertices = tensors.shape_points[shape][0];
  const auto points = vertices.accessor<float, 2>();
  const int64_t count = std::min(kHeightPoints, tensors.shape_point_count[shape][0].item<int64_t>());
  const auto row = poses[frame][k];
  const Eigen::Matrix3f R = Eigen::Quaternionf(row[6], row[3], row[4], row[5]).toRotationMatrix();
  float lowest = 1e9f;
  for (int64_t i = 0; i < count; ++i) {
    lowest = std::min(lowest, R.row(2).dot(Eigen::Vector3f(points[i][0], points[i][1], points[i][2])));
  }
  return row[2] + size * lowest;
}

void find_in_scene(const SceneTensors& tensors, int64_t scene, ContactEvents& events) {
  const Tensor scene_poses = tensors.poses[scene], scene_objects = tensors.object_mask[scene];
  const PoseRows poses = scene_poses.accessor<float, 3>();
  const auto present = scene_objects.accessor<bool, 1>();
  const float gravity_per_frame = tensors.gravity[scene].item<float>() / static_cast<float>(kFrameRateHz);
  for (int64_t k = 0; k < present.size(0); ++k) {
    if (!present[k]) continue;
    for (int64_t frame = 1; frame + 1 < poses.size(0); ++frame) {
      Eigen::Vector3f jump =
          position(poses, frame + 1, k) - 2.0f * position(poses, frame, k) + position(poses, frame - 1, k);
      jump *= static_cast<float>(kFrameRateHz);
      jump.z() -= gravity_per_frame;
      if (jump.norm() < kMinVelocityJump) continue;
      const bool on_floor = lowest_point(tensors, poses, scene, frame, k) < kFloorDistance;
      auto& list = on_floor ? events.floor : events.mid_air;
      list.push_back({static_cast<std::int32_t>(scene), static_cast<std::int32_t>(frame)});
    }
  }
}

}  // namespace

ContactEvents find_contact_events(const SceneTensors& tensors) {
  const int64_t S = tensors.num_scenes();
  const int64_t num_workers = std::min<int64_t>(S, std::max(1u, std::thread::hardware_concurrency()));
  std::vector<ContactEvents> found(static_cast<size_t>(num_workers));
  std::vector<std::thread> workers;
  for (int64_t worker = 0; worker < num_workers; ++worker) {
    workers.emplace_back([&, worker] {
      const int64_t begin = S * worker / num_workers, end = S * (worker + 1) / num_workers;
      for (int64_t scene = begin; scene < end; ++scene)
        find_in_scene(tensors, scene, found[static_cast<size_t>(worker)]);
    });
  }
  for (std::thread& worker : workers) worker.join();
  ContactEvents all;
  for (const ContactEvents& part : found) {
    all.mid_air.insert(all.mid_air.end(), part.mid_air.begin(), part.mid_air.end());
    all.floor.insert(all.floor.end(), part.floor.begin(), part.floor.end());
  }
  return all;
}

}  // namespace rigidformer
