// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/features.hpp"

#include <stdexcept>
#include <vector>

namespace rigidformer {
namespace {

constexpr double kSpeedUnit = 5.0;                // [m/s] unit of velocities; chosen by eye
constexpr double kSquashLengths[] = {0.05, 0.5};  // [m] for resolution near contact and reach far away; by eye
constexpr double kFarDisplacement = 100.0;        // [m] stands for "nothing there"; chosen by eye

/// d / (|d| + l): linear near contact (and continuous through it), bounded far away. [..., 3] -> [..., 3 per length].
Tensor squash(const Tensor& displacement) {
  const Tensor length = (displacement.square().sum(-1, true) + 1e-12).sqrt();
  std::vector<Tensor> scales;
  for (const double unit : kSquashLengths) scales.push_back(displacement / (length + unit));
  return torch::cat(scales, -1);
}

/// The same for numbers [..., 1] -> [..., 1 per length].
Tensor squash_height(const Tensor& height) {
  std::vector<Tensor> scales;
  for (const double unit : kSquashLengths) scales.push_back(height / (height.abs() + unit));
  return torch::cat(scales, -1);
}

/// The paper's d: nearest object point or foot point on the ground, whichever is closer.
Tensor nearest_displacement(const Tensor& to_object, const Tensor& height) {
  const Tensor to_ground = torch::cat({torch::zeros_like(to_object.slice(-1, 0, 2)), -height}, -1);
  const Tensor object_closer = to_object.square().sum(-1, true) < height.square();
  return torch::where(object_closer, to_object, to_ground);
}

/// [B, K, 3] -> [B, K, N, 3]
Tensor per_vertex(const Tensor& per_object, std::int64_t N) { return per_object.unsqueeze(2).expand({-1, -1, N, -1}); }

/// Material as the network reads it: mass on a logarithmic scale, unknown values at zero.
Tensor material_code(const SceneBatch& batch) {
  const Tensor log_mass = (batch.properties.slice(-1, 0, 1) + 1e-3).log();
  return torch::cat({log_mass, batch.properties.slice(-1, 1)}, -1) * batch.properties_known;
}

Tensor material_features(const ModelOptions& options, const SceneBatch& batch) {
  if (options.property_mask) return torch::cat({material_code(batch), batch.properties_known}, -1);
  return batch.properties;
}

/// Everything about contact that a vertex can know without attention: its gap now and after free motion to the nearest
/// vertex of another object and to the ground, the relative velocity there, and what the other object is made of.
Tensor contact_features(const SceneBatch& batch, const Tensor& to_object, const Tensor& height, const Tensor& base_step,
                        const Tensor& other_base_step, const Tensor& other_material, const Tensor& found) {
  const Tensor dt = batch.time_step().reshape({-1, 1, 1, 1});
  const Tensor relative_step = other_base_step - base_step;
  const Tensor there = found.unsqueeze(-1).to(to_object.scalar_type());
  const Tensor next_height = height + base_step.slice(-1, 2);
  return torch::cat(
      {squash(to_object) * there, squash(to_object + relative_step) * there, relative_step / (dt * kSpeedUnit) * there,
       other_material * there, there, squash_height(height), squash_height(next_height)},
      -1);
}

constexpr std::int64_t kContactFeatures = 6 + 6 + 3 + 1 + 2 + 2;  // without the partner's material

/// Points and their normals, both [B, K, N, 3], world.
struct TangentPlanes {
  Tensor points, normals;
};

/// How far each point lies above the plane of its counterpart, [B, K, N, 1].
Tensor gap(const Tensor& points, const TangentPlanes& planes) {
  return ((points - planes.points) * planes.normals).sum(-1, true);
}

/// Where two surfaces meet, the gap between them is that between their tangent planes, however far apart the nearest
/// vertices lie: for each vertex and its nearest one of another object the gap to the other's plane and of the other to
/// the own plane, now and after free motion, both normals and the speed of approach. Zero where there is no other.
Tensor plane_features(const SceneBatch& batch, const SceneState& state, const BaseMotion& base, const Tensor& x,
                      const Nearest& nearest) {
  if (!batch.normals_reference.defined()) throw std::invalid_argument("this model needs normals of the points");
  const auto turned = [&](const Pose& pose) {
    return torch::matmul(batch.normals_reference, pose.rotation.transpose(-1, -2));
  };
  const auto at_nearest = [&](const TangentPlanes& planes) {
    return TangentPlanes{gather_scene_points(planes.points, nearest.index),
                         gather_scene_points(planes.normals, nearest.index)};
  };
  const TangentPlanes own{x, turned(state.current)};
  const TangentPlanes own_next{base.apply(batch.points_reference), turned(base.inertial ? base.pose : state.current)};
  const TangentPlanes other = at_nearest(own), other_next = at_nearest(own_next);
  const Tensor gap_to_other = gap(own.points, other), next_gap_to_other = gap(own_next.points, other_next);
  const Tensor dt = batch.time_step().reshape({-1, 1, 1, 1});
  const Tensor relative_step = (other_next.points - other.points) - (own_next.points - own.points);
  const Tensor approach = (relative_step * other.normals).sum(-1, true) / (dt * kSpeedUnit);
  return torch::cat(
             {squash_height(gap_to_other), squash_height(gap(other.points, own)), squash_height(next_gap_to_other),
              squash_height(gap(other_next.points, own_next)), own.normals, other.normals, approach},
             -1)
      .masked_fill(nearest.found.logical_not().unsqueeze(-1), 0.0);
}

constexpr std::int64_t kPlaneFeatures = 4 * 2 + 3 + 3 + 1;

}  // namespace

std::int64_t num_vertex_features(const ModelOptions& options) {
  const std::int64_t material = options.property_mask ? 6 : 3;
  std::int64_t count = 3 + material;  // v and material
  count += options.contact_features ? kContactFeatures + material : 3;
  if (options.reference_offset_feature) count += 3;
  if (options.position_feature) count += 3;
  if (options.local_planes) count += kPlaneFeatures;
  return count;
}

std::int64_t num_engine_features(const ModelOptions& options) {
  return options.engine_motion ? 6 * options.advisers : 0;
}

std::int64_t num_ground_features(const ModelOptions& options) { return options.ground_material ? kGroundCode : 0; }

Tensor ground_features(const ModelOptions& options, const SceneBatch& batch, std::int64_t count) {
  const Tensor code = batch.ground_code().slice(-1, 0, num_ground_features(options));
  return code.reshape({batch.num_scenes(), 1, 1, -1}).expand({-1, batch.max_objects(), count, -1});
}

Tensor engine_features(const SceneBatch& batch, const SceneState& state, const BaseMotion& base,
                       const std::vector<EngineMotion>& advice, const Tensor& points_reference) {
  const Tensor unit = batch.time_step().reshape({-1, 1, 1, 1}) * kSpeedUnit;
  const Tensor moved_freely = base.apply(points_reference), points_world = state.current.apply(points_reference);
  std::vector<Tensor> features;
  for (const EngineMotion& motion : advice) {
    features.push_back(motion.pose.apply(points_reference) - moved_freely);
    features.push_back(points_world - motion.departure.apply(points_reference));
  }
  return torch::cat(features, -1) / unit;
}

Tensor vertex_features(const ModelOptions& options, const SceneBatch& batch, const SceneState& state,
                       const BaseMotion& base, const Tensor& x, const Nearest& nearest) {
  const std::int64_t N = batch.max_points();
  const Tensor height = (x.slice(-1, 2) - batch.ground_height.reshape({-1, 1, 1, 1})).clamp_max(kFarDisplacement);
  const Tensor far = torch::full_like(x, kFarDisplacement);
  const Tensor to_object =
      torch::where(nearest.found.unsqueeze(-1), gather_scene_points(x, nearest.index) - x, far);  // d
  const Tensor v = x - state.previous.apply(batch.points_reference);
  const Tensor material = per_vertex(material_features(options, batch), N);

  std::vector<Tensor> features;
  if (options.contact_features) {
    const Tensor dt = batch.time_step().reshape({-1, 1, 1, 1});
    const Tensor base_step = base.apply(batch.points_reference) - x;
    features = {contact_features(batch, to_object, height, base_step, gather_scene_points(base_step, nearest.index),
                                 gather_scene_points(material, nearest.index), nearest.found),
                v / (dt * kSpeedUnit)};
  } else {
    features = {nearest_displacement(to_object, height), v};
  }
  if (options.reference_offset_feature) features.push_back(x - state.first.apply(batch.points_reference));  // r
  if (options.position_feature) features.push_back(x - base.centre.unsqueeze(2));
  if (options.local_planes) features.push_back(plane_features(batch, state, base, x, nearest));
  features.push_back(material);
  return torch::cat(features, -1).masked_fill(batch.point_mask.logical_not().unsqueeze(-1), 0.0);
}

}  // namespace rigidformer
