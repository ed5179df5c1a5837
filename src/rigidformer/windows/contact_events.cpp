// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/contact_events.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <thread>

namespace rigidformer {
namespace {

constexpr double kMinVelocityJump = 0.5;    // [m/s]
constexpr double kFloorDistance = 0.08;     // [m] higher than this is not the floor
constexpr double kRestingSpeed_mps = 0.03;  // recordings have no noise: what is slower does not even rock
constexpr double kRestingSpin_radps = 0.1;  // likewise
constexpr double kRollingSpeed = 0.15;      // [m/s]
constexpr double kDrivenSpeed = 0.02;       // [m/s] a driven body that is slower stands; chosen by eye
constexpr std::int64_t kLastingStride = 8;  // frames between two entries of a lasting contact
constexpr std::int64_t kHeightPoints = 64;  // vertices looked at for the lowest point

using PoseRows = at::TensorAccessor<float, 3>;  // [F, K, 7]

Eigen::Vector3f position(const PoseRows& poses, std::int64_t frame, std::int64_t k) {
  return {poses[frame][k][0], poses[frame][k][1], poses[frame][k][2]};
}

Eigen::Quaternionf rotation(const PoseRows& poses, std::int64_t frame, std::int64_t k) {
  return {poses[frame][k][6], poses[frame][k][3], poses[frame][k][4], poses[frame][k][5]};
}

/// Height of the lowest of an object's vertices.
double lowest_point(const SceneTensors& tensors, const PoseRows& poses, std::int64_t scene, std::int64_t frame,
                    std::int64_t k) {
  const std::int64_t shape = tensors.shape[scene][k].item<std::int64_t>();
  const float size = tensors.size[scene][k].item<float>();
  const Tensor vertices = tensors.shape_points[shape][0];
  const auto points = vertices.accessor<float, 2>();
  const std::int64_t count = std::min(kHeightPoints, tensors.shape_point_count[shape][0].item<std::int64_t>());
  const Eigen::Matrix3f R = rotation(poses, frame, k).toRotationMatrix();
  float lowest = 1e9f;
  for (std::int64_t i = 0; i < count; ++i) {
    lowest = std::min(lowest, R.row(2).dot(Eigen::Vector3f(points[i][0], points[i][1], points[i][2])));
  }
  return poses[frame][k][2] + size * lowest;
}

struct SceneFrames {
  double gravity;  ///< [m/s^2] along z
  double frame_rate_hz;
};

/// Change of velocity at a frame that gravity does not explain [m/s].
double velocity_jump(const PoseRows& poses, std::int64_t frame, std::int64_t k, const SceneFrames& scene) {
  Eigen::Vector3f jump =
      position(poses, frame + 1, k) - 2.0f * position(poses, frame, k) + position(poses, frame - 1, k);
  jump *= static_cast<float>(scene.frame_rate_hz);
  jump.z() -= static_cast<float>(scene.gravity / scene.frame_rate_hz);
  return jump.norm();
}

/// The list that the moment belongs to, or none. `on_floor` is asked only where it matters, because it is costly.
template <typename OnFloor>
std::vector<ContactEvent>* list_for(const PoseRows& poses, std::int64_t frame, std::int64_t k, const SceneFrames& scene,
                                    const OnFloor& on_floor, ContactEvents& events) {
  if (velocity_jump(poses, frame, k, scene) >= kMinVelocityJump) {
    return on_floor() ? &events.floor : &events.mid_air;
  }
  if (frame % kLastingStride != 0) return nullptr;
  const double speed = scene.frame_rate_hz * (position(poses, frame + 1, k) - position(poses, frame, k)).norm();
  const double spin = scene.frame_rate_hz * rotation(poses, frame + 1, k).angularDistance(rotation(poses, frame, k));
  if (speed < kRestingSpeed_mps && spin < kRestingSpin_radps) return &events.resting;
  return speed > kRollingSpeed && on_floor() ? &events.rolling : nullptr;
}

/// Radii of the objects of a scene about their origins, [K].
std::vector<float> radii(const SceneTensors& tensors, std::int64_t scene) {
  const Tensor corners = tensors.shape_points.select(1, 0).index({tensors.shape[scene]});  // [K, M, 3]
  const Tensor radius = corners.norm(2, -1).amax(-1) * tensors.size[scene];
  return {radius.data_ptr<float>(), radius.data_ptr<float>() + radius.numel()};
}

/// Whether a body of given motion goes where an object that can move may be.
bool is_driven_at(const PoseRows& poses, std::int64_t frame, double frame_rate_hz, const Tensor& moves_tensor,
                  const std::vector<float>& radius) {
  const auto moves = moves_tensor.accessor<bool, 1>();
  const auto K = static_cast<std::int64_t>(radius.size());
  for (std::int64_t given = 0; given < K; ++given) {
    if (moves[given]) continue;
    const double speed = frame_rate_hz * (position(poses, frame + 1, given) - position(poses, frame, given)).norm();
    if (speed < kDrivenSpeed) continue;
    for (std::int64_t k = 0; k < K; ++k) {
      const float between = (position(poses, frame, k) - position(poses, frame, given)).norm();
      const float reach = radius[static_cast<size_t>(k)] + radius[static_cast<size_t>(given)];
      if (moves[k] && between < reach) return true;
    }
  }
  return false;
}

void find_in_scene(const SceneTensors& tensors, std::int64_t scene, ContactEvents& events) {
  const Tensor scene_poses = tensors.poses[scene], scene_objects = tensors.dynamic_mask[scene];
  const PoseRows poses = scene_poses.accessor<float, 3>();
  const auto moves = scene_objects.accessor<bool, 1>();
  const SceneFrames of_scene{tensors.gravity[scene].item<double>(), tensors.frame_rate[scene].item<double>()};
  const std::int64_t num_frames = tensors.frame_count[scene].item<std::int64_t>();
  const std::vector<float> radius = radii(tensors, scene);
  for (std::int64_t frame = kLastingStride; frame + 1 < num_frames; frame += kLastingStride) {
    if (!is_driven_at(poses, frame, of_scene.frame_rate_hz, scene_objects, radius)) continue;
    events.driven.push_back({static_cast<std::int32_t>(scene), static_cast<std::int32_t>(frame)});
  }
  for (std::int64_t k = 0; k < moves.size(0); ++k) {
    if (!moves[k]) continue;
    for (std::int64_t frame = 1; frame + 1 < num_frames; ++frame) {
      const auto on_floor = [&] { return lowest_point(tensors, poses, scene, frame, k) < kFloorDistance; };
      std::vector<ContactEvent>* list = list_for(poses, frame, k, of_scene, on_floor, events);
      if (list) list->push_back({static_cast<std::int32_t>(scene), static_cast<std::int32_t>(frame)});
    }
  }
}

void append(std::vector<ContactEvent>& all, const std::vector<ContactEvent>& part) {
  all.insert(all.end(), part.begin(), part.end());
}

}  // namespace

ContactEvents find_contact_events(const SceneTensors& tensors) {
  const std::int64_t S = tensors.num_scenes();
  const std::int64_t num_workers = std::min<std::int64_t>(S, std::max(1u, std::thread::hardware_concurrency()));
  std::vector<ContactEvents> found(static_cast<size_t>(num_workers));
  std::vector<std::thread> workers;
  for (std::int64_t worker = 0; worker < num_workers; ++worker) {
    workers.emplace_back([&, worker] {
      const std::int64_t begin = S * worker / num_workers, end = S * (worker + 1) / num_workers;
      for (std::int64_t scene = begin; scene < end; ++scene) {
        find_in_scene(tensors, scene, found[static_cast<size_t>(worker)]);
      }
    });
  }
  for (std::thread& worker : workers) worker.join();
  ContactEvents all;
  for (const ContactEvents& part : found) {
    append(all.mid_air, part.mid_air);
    append(all.floor, part.floor);
    append(all.rolling, part.rolling);
    append(all.resting, part.resting);
    append(all.driven, part.driven);
  }
  return all;
}

}  // namespace rigidformer
