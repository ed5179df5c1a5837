// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/window_batch.hpp"

#include <algorithm>
#include <cmath>

#include "rigidformer/model/centre_of_mass.hpp"

namespace rigidformer {
namespace {

constexpr double kCameraDistance = 10.0;                     // [m] from the middle of the arena
constexpr double kMinElevation = 0.15, kMaxElevation = 1.2;  // [rad]
constexpr int64_t kMinVisiblePoints = 8;

/// Rotation matrices [..., 3, 3] from unit quaternions x y z w [..., 4].
Tensor rotation_matrix(const Tensor& quaternion) {
  const Tensor q = quaternion / quaternion.norm(2, -1, true).clamp_min(1e-12);
  const auto part = q.unbind(-1);
  const Tensor &x = part[0], &y = part[1], &z = part[2], &w = part[3];
  return torch::stack({1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 2 * (x * y + z * w),
                       1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 2 * (x * z - y * w), 2 * (y * z + x * w),
                       1 - 2 * (x * x + y * y)},
                      -1)
      .unflatten(-1, {3, 3});
}

Tensor to_index(const std::vector<int64_t>& values, const torch::Device& device) {
  return torch::tensor(values, torch::kInt64).to(device, /*non_blocking=*/true);
}

/// Yaw per window [B, 3, 3] (identity with the complementary probability).
Tensor draw_yaw(int64_t B, const AugmentationOptions& options, const torch::TensorOptions& like) {
  const int64_t count = options.yaw_per_batch ? 1 : B;
  Tensor angle = torch::rand({count}, like) * 2.0 * M_PI;
  if (options.yaw_step_deg > 0.0) {
    const double step = options.yaw_step_deg * M_PI / 180.0;
    angle = (angle / step).floor() * step;
  }
  angle = torch::where(torch::rand({count}, like) < options.yaw_probability, angle, torch::zeros_like(angle));
  const Tensor c = angle.cos(), s = angle.sin(), zero = torch::zeros_like(c), one = torch::ones_like(c);
  return torch::stack({c, -s, zero, s, c, zero, zero, zero, one}, -1).unflatten(-1, {3, 3}).expand({B, 3, 3});
}

/// Horizontal shift per window [B, 1, 3].
Tensor draw_shift(int64_t B, double reach, const torch::TensorOptions& like) {
  const Tensor horizontal = reach * (2.0 * torch::rand({B, 1, 2}, like) - 1.0);
  return torch::cat({horizontal, torch::zeros({B, 1, 1}, like)}, -1);
}

/// Which objects stand where, [B, K]: those that exist first, in recorded or (with `probability`) random order.
/// K is the largest number of objects of any window, so that a batch of small scenes carries little padding.
Tensor draw_object_order(const Tensor& object_mask, double probability, const torch::TensorOptions& like) {
  const int64_t B = object_mask.size(0), K_all = object_mask.size(1);
  const Tensor shuffled = torch::rand({B, K_all}, like);
  const Tensor straight = torch::arange(K_all, like).expand({B, K_all}) / static_cast<double>(K_all);
  const Tensor key = torch::where(torch::rand({B, 1}, like) < probability, shuffled, straight);
  const Tensor order = std::get<1>((key + object_mask.logical_not().to(key.scalar_type())).sort(-1));
  return order.slice(1, 0, object_mask.sum(-1).max().item<int64_t>());
}

struct PointCandidates {
  Tensor points;       ///< [B, K, M, 3] body frame
  Tensor normals;      ///< [B, K, M, 3]
  Tensor usable;       ///< [B, K, M] bool
  Tensor has_normals;  ///< [B, 1, 1] bool, false for vertex sets
};

PointCandidates draw_point_sets(const SceneTensors& tensors, const Tensor& shape, const Tensor& size,
                                double vertex_probability) {
  const int64_t B = shape.size(0), K = shape.size(1);
  const int64_t P = tensors.shape_points.size(1), M = tensors.shape_points.size(2);
  const auto like = size.options();
  const Tensor use_surface = torch::rand({B, 1}, like) >= vertex_probability;
  const Tensor set = torch::randint(std::min<int64_t>(1, P - 1), P, {B, K}, shape.options()) * use_surface;
  const Tensor row = shape * P + set;
  PointCandidates candidates;
  candidates.points = tensors.shape_points.flatten(0, 1).index({row}) * size.unsqueeze(-1).unsqueeze(-1);
  candidates.normals = tensors.shape_normals.flatten(0, 1).index({row});
  const Tensor count = tensors.shape_point_count.flatten(0, 1).index({row}).unsqueeze(-1);
  candidates.usable = torch::arange(M, shape.options()) < count;
  candidates.has_normals = use_surface.unsqueeze(-1);
  return candidates;
}

/// Points whose outward normal faces a camera drawn per window.
Tensor facing_camera(const PointCandidates& candidates, const Pose& pose) {
  const int64_t B = candidates.points.size(0);
  const auto like = candidates.points.options();
  const Tensor azimuth = torch::rand({B}, like) * 2.0 * M_PI;
  const Tensor elevation = kMinElevation + torch::rand({B}, like) * (kMaxElevation - kMinElevation);
  const Tensor camera =
      kCameraDistance *
      torch::stack({elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin(), elevation.sin()}, -1);
  const Tensor points_world = pose.apply(candidates.points);
  const Tensor normals_world = torch::matmul(candidates.normals, pose.rotation.transpose(-1, -2));
  const Tensor facing = ((camera.reshape({B, 1, 1, 3}) - points_world) * normals_world).sum(-1) > 0.0;
  const Tensor enough = facing.sum(-1, true) >= kMinVisiblePoints;
  return facing.logical_or(enough.logical_not());
}

/// Moves the first `count` usable points of every object to the front, keeping farthest-point order.
void keep_points(const PointCandidates& candidates, const Tensor& usable, const AugmentationOptions& options,
                 SceneBatch& scene) {
  const int64_t B = usable.size(0), K = usable.size(1), M = usable.size(2);
  const int64_t N = std::min<int64_t>(options.max_points, M);
  const Tensor rank = torch::arange(M, torch::TensorOptions(torch::kInt64).device(usable.device()));
  const Tensor order = std::get<1>((rank + M * usable.logical_not()).sort(-1)).slice(-1, 0, N);
  scene.points_reference = gather_points(candidates.points, order);
  const Tensor fraction = torch::rand({B, K}, candidates.points.options());
  const Tensor wanted = (options.min_points + fraction * (options.max_points - options.min_points)).round();
  const Tensor count = torch::minimum(wanted.to(torch::kInt64), usable.sum(-1)).unsqueeze(-1);
  scene.point_mask = (rank.slice(0, 0, N) < count).logical_and(scene.object_mask.unsqueeze(-1));
}

}  // namespace

Tensor farthest_anchors(const Tensor& points, const Tensor& point_mask, int num_anchors) {
  torch::NoGradGuard no_grad;
  const Tensor middle = centroid(points, point_mask).unsqueeze(2);
  const Tensor invalid = point_mask.logical_not();
  Tensor distance = (points - middle).square().sum(-1).masked_fill(invalid, -1.0);
  std::vector<Tensor> chosen = {distance.argmax(-1)};
  distance = torch::full_like(distance, 1e9).masked_fill(invalid, -1.0);
  while (static_cast<int>(chosen.size()) < num_anchors) {
    const Tensor newest = gather_points(points, chosen.back().unsqueeze(-1));  // [B, K, 1, 3]
    distance = torch::minimum(distance, (points - newest).square().sum(-1));
    distance = distance.masked_fill(invalid, -1.0);
    chosen.push_back(distance.argmax(-1));
  }
  return torch::stack(chosen, -1);
}

AugmentationOptions no_augmentation(int num_points) {
  AugmentationOptions options;
  options.min_points = options.max_points = num_points;
  options.yaw_probability = options.permutation_probability = 0.0;
  return options;
}

WindowBatch make_window_batch(const SceneTensors& tensors, const std::vector<Window>& windows, int num_steps,
                              int num_anchors, const AugmentationOptions& options) {
  torch::NoGradGuard no_grad;
  const auto device = tensors.poses.device();
  const auto like = tensors.poses.options();
  const auto B = static_cast<int64_t>(windows.size());
  const int64_t F = tensors.num_frames(), T = num_steps + 2;
  std::vector<int64_t> scene_rows, frame_rows, steps;
  for (const Window& window : windows) {
    scene_rows.push_back(window.scene);
    steps.push_back(window.step_size);
    for (int64_t t = 0; t < T; ++t) frame_rows.push_back(window.scene * F + window.frame + t * window.step_size);
  }
  const Tensor scene_index = to_index(scene_rows, device);
  const Tensor order =
      draw_object_order(tensors.object_mask.index({scene_index}), options.permutation_probability, like);
  const int64_t K = order.size(1);
  const auto per_object = [&](const Tensor& values) {  // [S, K, ...] -> [B, K, ...] in drawn order
    const Tensor rows = values.index({scene_index});
    return rows.dim() == 2 ? rows.gather(1, order) : rows.gather(1, order.unsqueeze(-1).expand({B, K, rows.size(2)}));
  };

  WindowBatch batch;
  SceneBatch& scene = batch.scene;
  scene.object_mask = per_object(tensors.object_mask);
  scene.dynamic_mask = scene.object_mask;
  scene.properties_known = torch::ones({B, K, 3}, like) * (torch::rand({B, 1, 1}, like) >= options.unknown_probability);
  scene.properties = per_object(tensors.properties) * scene.properties_known;
  scene.step_size = to_index(steps, device).to(torch::kFloat32);
  scene.ground_height = torch::zeros({B}, like);
  scene.gravity = tensors.gravity.index({scene_index});

  const Tensor yaw = draw_yaw(B, options, like).unsqueeze(1);  // [B, 1, 3, 3]
  const Tensor shift = draw_shift(B, options.shift_m, like);
  Tensor rows = tensors.poses.flatten(0, 1).index({to_index(frame_rows, device)}).unflatten(0, {B, T});
  rows = rows.gather(2, order.reshape({B, 1, K, 1}).expand({B, T, K, 7}));
  for (int64_t t = 0; t < T; ++t) {
    const Tensor row = rows.select(1, t);
    const Tensor translation = torch::matmul(yaw, row.slice(-1, 0, 3).unsqueeze(-1)).squeeze(-1) + shift;
    batch.poses.push_back({torch::matmul(yaw, rotation_matrix(row.slice(-1, 3))), translation});
  }

  const PointCandidates candidates =
      draw_point_sets(tensors, per_object(tensors.shape), per_object(tensors.size), options.vertex_probability);
  Tensor usable = candidates.usable;
  if (options.view_probability > 0.0) {
    const Tensor whole =
        (torch::rand({B, 1, 1}, like) >= options.view_probability).logical_or(candidates.has_normals.logical_not());
    usable = usable.logical_and(facing_camera(candidates, batch.poses[1]).logical_or(whole));
  }
  keep_points(candidates, usable, options, scene);
  if (options.noise_m > 0.0) {
    const Tensor deviation = torch::rand({B, 1, 1, 1}, like) * options.noise_m;
    scene.points_reference = scene.points_reference + deviation * torch::randn_like(scene.points_reference);
  }
  scene.anchor_index = farthest_anchors(scene.points_reference, scene.point_mask, num_anchors);
  return batch;
}

}  // namespace rigidformer
