// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/window_batch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rigidformer/model/centre_of_mass.hpp"
#include "rigidformer/windows/free_motion.hpp"
#include "rigidformer/windows/window_commands.hpp"

namespace rigidformer {
namespace {

// The random camera of one-sided clouds: its distance from the middle of the arena and its elevation. Chosen by eye.
constexpr double kCameraDistance = 10.0;                     // [m]
constexpr double kMinElevation = 0.15, kMaxElevation = 1.2;  // [rad]
constexpr std::int64_t kMinVisiblePoints = 8;  // fewer points tell too little: then all stay; chosen by eye

Tensor to_index(const std::vector<std::int64_t>& values, const torch::Device& device) {
  return torch::tensor(values, torch::kInt64).to(device, /*non_blocking=*/true);
}

/// Yaw per window [B, 3, 3] (identity with the complementary probability).
Tensor draw_yaw(std::int64_t B, const AugmentationOptions& options, const torch::TensorOptions& like,
                const TensorRandom& random) {
  const std::int64_t count = options.yaw_per_batch ? 1 : B;
  Tensor angle = random.uniform({count}, like) * 2.0 * M_PI;
  if (options.yaw_step_deg > 0.0) {
    const double step = options.yaw_step_deg * M_PI / 180.0;
    angle = (angle / step).floor() * step;
  }
  angle = torch::where(random.uniform({count}, like) < options.yaw_probability, angle, torch::zeros_like(angle));
  const Tensor c = angle.cos(), s = angle.sin(), zero = torch::zeros_like(c), one = torch::ones_like(c);
  return torch::stack({c, -s, zero, s, c, zero, zero, zero, one}, -1).unflatten(-1, {3, 3}).expand({B, 3, 3});
}

/// Horizontal shift per window [B, 1, 3].
Tensor draw_shift(std::int64_t B, double reach, const torch::TensorOptions& like, const TensorRandom& random) {
  const Tensor horizontal = reach * (2.0 * random.uniform({B, 1, 2}, like) - 1.0);
  return torch::cat({horizontal, torch::zeros({B, 1, 1}, like)}, -1);
}

/// Which objects stand where, [B, K]: those that exist first, in recorded or (with `probability`) random order.
/// K is the largest number of objects of any window, so that a batch of small scenes carries little padding.
Tensor draw_object_order(const Tensor& object_mask, double probability, const torch::TensorOptions& like,
                         const TensorRandom& random) {
  const std::int64_t B = object_mask.size(0), K_all = object_mask.size(1);
  const Tensor shuffled = random.uniform({B, K_all}, like);
  const Tensor straight = torch::arange(K_all, like).expand({B, K_all}) / static_cast<double>(K_all);
  const Tensor key = torch::where(random.uniform({B, 1}, like) < probability, shuffled, straight);
  const Tensor order = std::get<1>((key + object_mask.logical_not().to(key.scalar_type())).sort(-1));
  return order.slice(1, 0, object_mask.sum(-1).max().item<std::int64_t>());
}

struct PointCandidates {
  Tensor points;             ///< [B, K, M, 3] body frame
  Tensor normals;            ///< [B, K, M, 3] of the mesh
  Tensor estimated_normals;  ///< [B, K, M, 3]
  Tensor usable;             ///< [B, K, M] bool
};

PointCandidates draw_point_sets(const SceneTensors& tensors, const Tensor& shape, const Tensor& size,
                                double vertex_probability, const TensorRandom& random) {
  const std::int64_t B = shape.size(0), K = shape.size(1);
  const std::int64_t P = tensors.shape_points.size(1), M = tensors.shape_points.size(2);
  const auto like = size.options();
  const Tensor use_surface = random.uniform({B, 1}, like) >= vertex_probability;
  const Tensor set = random.integer(std::min<std::int64_t>(1, P - 1), P, {B, K}, shape.options()) * use_surface;
  const Tensor row = shape * P + set;
  PointCandidates candidates;
  candidates.points = tensors.shape_points.flatten(0, 1).index({row}) * size.unsqueeze(-1).unsqueeze(-1);
  candidates.normals = tensors.shape_normals.flatten(0, 1).index({row});
  candidates.estimated_normals = tensors.estimated_normals.flatten(0, 1).index({row});
  const Tensor count = tensors.shape_point_count.flatten(0, 1).index({row}).unsqueeze(-1);
  candidates.usable = torch::arange(M, shape.options()) < count;
  return candidates;
}

/// Keeps the points whose outward normal faces a camera, which is drawn per window.
Tensor facing_camera(const PointCandidates& candidates, const Pose& pose, const TensorRandom& random) {
  const std::int64_t B = candidates.points.size(0);
  const auto like = candidates.points.options();
  const Tensor azimuth = random.uniform({B}, like) * 2.0 * M_PI;
  const Tensor elevation = kMinElevation + random.uniform({B}, like) * (kMaxElevation - kMinElevation);
  const Tensor camera =
      kCameraDistance *
      torch::stack({elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin(), elevation.sin()}, -1);
  const Tensor points_world = pose.apply(candidates.points);
  const Tensor normals_world = torch::matmul(candidates.normals, pose.rotation.transpose(-1, -2));
  const Tensor facing = ((camera.reshape({B, 1, 1, 3}) - points_world) * normals_world).sum(-1) > 0.0;
  const Tensor enough = facing.sum(-1, true) >= kMinVisiblePoints;
  return facing.logical_or(enough.logical_not());
}

/// Drops a share of each object's points: at random, or those inside a box around a random point, whose proportions
/// are drawn and whose size follows from the share. At least kMinVisiblePoints stay.
Tensor unmasked(const PointCandidates& candidates, const Tensor& usable, const AugmentationOptions& options,
                const TensorRandom& random) {
  const std::int64_t B = usable.size(0), K = usable.size(1), M = usable.size(2);
  const auto like = candidates.points.options();
  const Tensor is_masked = random.uniform({B, 1, 1}, like) < options.mask_probability;
  const Tensor in_box = random.uniform({B, 1, 1}, like) < 0.5;
  const Tensor draw = random.uniform({B, K, M}, like).masked_fill(usable.logical_not(), -1.0);
  const Tensor middle = gather_points(candidates.points, draw.argmax(-1, true));  // [B, K, 1, 3]
  const Tensor edges = 0.5 + 0.5 * random.uniform({B, K, 1, 3}, like);
  const Tensor box_size = ((candidates.points - middle) / edges).abs().amax(-1);  // that reaches each point
  const Tensor score = torch::where(in_box, box_size, draw).masked_fill(usable.logical_not(), 1e9);
  const auto order = [](const Tensor& values) { return std::get<1>(values.sort(-1)); };
  const Tensor rank = order(order(score));
  const Tensor count = usable.sum(-1, true);
  const Tensor dropped = (options.masked_share * count).to(torch::kInt64);
  const Tensor limit = torch::minimum(dropped, (count - kMinVisiblePoints).clamp_min(0));
  return usable.logical_and((rank < limit).logical_and(is_masked).logical_not());
}

/// How many points [B, K] are wanted of each object.
Tensor draw_counts(std::int64_t B, std::int64_t K, const AugmentationOptions& options, const torch::TensorOptions& like,
                   const TensorRandom& random) {
  const Tensor fraction = random.uniform({B, K}, like);
  if (options.point_counts.empty()) {
    return (options.min_points + fraction * (options.max_points - options.min_points)).round().to(torch::kInt64);
  }
  const Tensor counts = torch::tensor(options.point_counts, torch::kInt64).to(like.device());
  return counts.index({(fraction * static_cast<double>(counts.size(0))).to(torch::kInt64)});
}

/// Moves the first `count` usable points of every object to the front, keeping farthest-point order.
void keep_points(const PointCandidates& candidates, const Tensor& usable, const AugmentationOptions& options,
                 const TensorRandom& random, SceneBatch& scene) {
  const std::int64_t B = usable.size(0), K = usable.size(1), M = usable.size(2);
  const Tensor wanted = draw_counts(B, K, options, candidates.points.options(), random);
  const Tensor count = torch::minimum(wanted, usable.sum(-1));
  const std::int64_t N = std::clamp<std::int64_t>(count.max().item<std::int64_t>(), 1, M);
  const Tensor rank = torch::arange(M, torch::TensorOptions(torch::kInt64).device(usable.device()));
  const Tensor order = std::get<1>((rank + M * usable.logical_not()).sort(-1)).slice(-1, 0, N);
  scene.points_reference = gather_points(candidates.points, order);
  scene.normals_reference = gather_points(candidates.estimated_normals, order);
  scene.point_mask = (rank.slice(0, 0, N) < count.unsqueeze(-1)).logical_and(scene.object_mask.unsqueeze(-1));
}

/// The rows of the scene tensors that a batch is made of.
struct WindowRows {
  Tensor scene;       ///< [B] int64
  Tensor frame;       ///< [B * T] int64 into flattened (scene, frame)
  Tensor step_size;   ///< [B] frames of 1/240 s; not whole where the scene has other frames
  Tensor frame_rate;  ///< [B] frames of the scene per second
  Tensor order;       ///< [B, K] which object stands where
};

WindowRows draw_rows(const SceneTensors& tensors, const std::vector<Window>& windows, std::int64_t T,
                     double permutation, const TensorRandom& random) {
  std::vector<std::int64_t> scenes, frames, steps;
  for (const Window& window : windows) {
    scenes.push_back(window.scene);
    steps.push_back(window.step_size);
    for (std::int64_t t = 0; t < T; ++t) {
      frames.push_back(window.scene * tensors.num_frames() + window.frame + t * window.step_size);
    }
  }
  const auto device = tensors.poses.device();
  WindowRows rows{to_index(scenes, device), to_index(frames, device), {}, {}, {}};
  const Tensor frame_rate = tensors.frame_rate.index({rows.scene});
  rows.frame_rate = frame_rate.to(torch::kFloat32);
  rows.step_size = (to_index(steps, device) * kFrameRateHz / frame_rate).to(torch::kFloat32);
  rows.order = draw_object_order(tensors.object_mask.index({rows.scene}), permutation, tensors.poses.options(), random);
  return rows;
}

/// [S, K_all, ...] -> [B, K, ...] in drawn order.
Tensor per_object(const Tensor& values, const WindowRows& rows) {
  const Tensor of_scene = values.index({rows.scene});
  if (of_scene.dim() == 2) return of_scene.gather(1, rows.order);
  return of_scene.gather(1, rows.order.unsqueeze(-1).expand({-1, -1, of_scene.size(2)}));
}

/// The true poses `offset` frames away from the T frames of the windows, turned by yaw [B, 1, 3, 3].
std::vector<Pose> window_poses(const SceneTensors& tensors, const WindowRows& rows, const Tensor& yaw,
                               std::int64_t offset) {
  const std::int64_t B = rows.order.size(0), K = rows.order.size(1), T = rows.frame.size(0) / B;
  const Tensor frame = (rows.frame + offset).clamp_min(0);
  Tensor frames = tensors.poses.flatten(0, 1).index({frame}).unflatten(0, {B, T});
  frames = frames.gather(2, rows.order.reshape({B, 1, K, 1}).expand({B, T, K, 7}));
  std::vector<Pose> poses;
  for (std::int64_t t = 0; t < T; ++t) {
    const Tensor row = frames.select(1, t);
    const Tensor translation = torch::matmul(yaw, row.slice(-1, 0, 3).unsqueeze(-1)).squeeze(-1);
    poses.push_back({torch::matmul(yaw, rotation_matrix(row.slice(-1, 3))), translation});
  }
  return poses;
}

/// True motion of the windows, turned as a whole.
void draw_motion(const SceneTensors& tensors, const WindowRows& rows, const AugmentationOptions& options,
                 const TensorRandom& random, WindowBatch& batch) {
  const auto like = tensors.poses.options();
  const std::int64_t B = rows.order.size(0);
  const Tensor yaw = draw_yaw(B, options, like, random).unsqueeze(1);
  batch.poses = window_poses(tensors, rows, yaw, 0);
  batch.controls = window_commands(tensors, rows.frame.unflatten(0, {B, -1}), yaw.squeeze(1));
  const std::vector<Pose> before = window_poses(tensors, rows, yaw, -1);
  const std::vector<Pose> earlier = window_poses(tensors, rows, yaw, -2);
  for (size_t t = 2; t < batch.poses.size(); ++t) {
    batch.departures.push_back(
        free_motion_departure(earlier[t], before[t], batch.poses[t], batch.scene, rows.frame_rate));
  }
}

/// The clouds as observed at `pose`: a surface sampling, perhaps from one side only, perhaps noisy.
void observe_points(const SceneTensors& tensors, const WindowRows& rows, const Pose& pose,
                    const AugmentationOptions& options, const TensorRandom& random, WindowBatch& batch) {
  const std::int64_t B = rows.order.size(0);
  SceneBatch& scene = batch.scene;
  const auto like = tensors.poses.options();
  PointCandidates candidates = draw_point_sets(tensors, per_object(tensors.shape, rows), per_object(tensors.size, rows),
                                               options.vertex_probability, random);
  batch.whole_surface = candidates.points;
  batch.whole_mask = candidates.usable.logical_and(scene.object_mask.unsqueeze(-1));
  Tensor usable = candidates.usable;
  if (options.view_probability > 0.0) {
    const Tensor whole = random.uniform({B, 1, 1}, like) >= options.view_probability;
    usable = usable.logical_and(facing_camera(candidates, pose, random).logical_or(whole));
  }
  if (options.mask_probability > 0.0) usable = unmasked(candidates, usable, options, random);
  if (options.noise_m > 0.0) {
    const Tensor deviation = random.uniform({B, 1, 1, 1}, like) * options.noise_m;
    candidates.points = candidates.points + deviation * random.normal(candidates.points.sizes(), like);
  }
  scene.surface_points = candidates.points;
  scene.surface_mask = usable.logical_and(scene.object_mask.unsqueeze(-1));
  keep_points(candidates, usable, options, random, scene);
}

/// Moves the windows horizontally, so that the middle of what is observed is where it is at prediction
/// (scene_origin() in model/scene_input.cpp), but for the drawn shift.
void centre(const AugmentationOptions& options, const TensorRandom& random, WindowBatch& batch) {
  const SceneBatch& scene = batch.scene;
  const Tensor cloud_middle = centroid(scene.points_reference, scene.point_mask).unsqueeze(2);
  const Tensor middle_world = batch.poses[1].apply(cloud_middle).squeeze(2);  // [B, K, 3]
  const Tensor there = scene.object_mask.unsqueeze(-1).to(middle_world.scalar_type());
  const Tensor middle = (middle_world * there).sum(1, true) / there.sum(1, true).clamp_min(1.0);
  const Tensor shift = draw_shift(there.size(0), options.shift_m, middle.options(), random);
  const Tensor horizontal = torch::tensor({1.0, 1.0, 0.0}, middle.options());
  for (std::vector<Pose>* poses : {&batch.poses, &batch.departures}) {
    for (Pose& pose : *poses) pose.translation = pose.translation - middle * horizontal + shift;
  }
}

/// What the ground is made of is hidden as often as what the objects are made of, but not at the same time: a robot may
/// know its floor and not what lies there, or the other way round.
void hide_ground(const SceneTensors& tensors, const WindowRows& rows, const AugmentationOptions& options,
                 const TensorRandom& random, SceneBatch& scene) {
  const std::int64_t B = rows.scene.size(0);
  const Tensor known = random.uniform({B, 1}, tensors.poses.options()) >= options.unknown_probability;
  scene.ground_known = tensors.ground_known.index({rows.scene}) * known;
  scene.ground_material = tensors.ground_material.index({rows.scene}) * known;
}

}  // namespace

AugmentationOptions no_augmentation(int num_points) {
  AugmentationOptions options;
  if (num_points == kAllVertices) {
    options.vertex_probability = 1.0;
    num_points = std::numeric_limits<int>::max();
  }
  options.min_points = options.max_points = num_points;
  options.yaw_probability = options.permutation_probability = 0.0;
  return options;
}

WindowBatch make_window_batch(const SceneTensors& tensors, const std::vector<Window>& windows, int num_steps,
                              int num_anchors, const AugmentationOptions& options, bool random_anchors,
                              const TensorRandom& random) {
  torch::NoGradGuard no_grad;
  const auto like = tensors.poses.options();
  const auto B = static_cast<std::int64_t>(windows.size());
  const WindowRows rows = draw_rows(tensors, windows, num_steps + 2, options.permutation_probability, random);

  WindowBatch batch;
  SceneBatch& scene = batch.scene;
  scene.object_mask = per_object(tensors.object_mask, rows);
  scene.dynamic_mask = per_object(tensors.dynamic_mask, rows);
  const Tensor known = random.uniform({B, 1, 1}, like) >= options.unknown_probability;
  scene.properties_known = per_object(tensors.properties_known, rows) * known;
  scene.properties = per_object(tensors.properties, rows) * known;
  scene.step_size = rows.step_size;
  scene.ground_height = torch::zeros({B}, like);
  scene.gravity = tensors.gravity.index({rows.scene});
  draw_motion(tensors, rows, options, random, batch);
  observe_points(tensors, rows, batch.poses[1], options, random, batch);
  centre(options, random, batch);
  const Tensor start_score = random_anchors ? random.uniform(scene.point_mask.sizes(), like) : Tensor();
  scene.anchor_index = farthest_anchors(scene.points_reference, scene.point_mask, num_anchors, start_score);
  hide_ground(tensors, rows, options, random, scene);
  return batch;
}

}  // namespace rigidformer
