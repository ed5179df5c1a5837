// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/scene_input.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "rigidformer/geometry/farthest_point_sampling.hpp"
#include "rigidformer/geometry/surface_normals.hpp"
#include "rigidformer/model/anchors.hpp"
#include "rigidformer/model/tensor_random.hpp"
#include "rigidformer/scene/mean_material.hpp"

namespace rigidformer {
namespace {

constexpr std::uint64_t kAnchorSeed = 1;          // of random anchors; any number does
constexpr std::int64_t kPointBucket = 16;         // points; padded sizes are multiples of it, as of vector units
constexpr double kMostFriction = 1000.0;          // as scene/objection.cpp accepts of objects
constexpr std::int64_t kMaxSurfacePoints = 4096;  // points of an object that the engine gets; chosen by eye
constexpr int kMostParticles = 64;                // more cost more than they tell; chosen by eye

void check_range(const char* field, double value, bool good, const char* bound) {
  if (!good) {
    throw std::invalid_argument(std::string(field) + " is " + std::to_string(value) + ", must be " + bound);
  }
}

/// The points that the network looks at, in farthest-point order.
Points select_points(const Points& cloud, int max_points) {
  const std::vector<int> order = farthest_point_order(cloud, max_points);
  Points selected(static_cast<Eigen::Index>(order.size()), 3);
  for (size_t i = 0; i < order.size(); ++i) selected.row(static_cast<Eigen::Index>(i)) = cloud.row(order[i]);
  return selected;
}

void store_properties(const ObjectState& object, bool reads_mask, SceneBatch& batch, std::int64_t k) {
  const std::optional<double> values[] = {object.properties.mass_kg, object.properties.friction,
                                          object.properties.restitution};
  const double means[] = {kMeanMass, kMeanFriction, kMeanRestitution};
  for (std::int64_t i = 0; i < 3; ++i) {
    const double stand_in = reads_mask ? 0.0 : means[i];
    batch.properties[0][k][i] = values[i].value_or(stand_in);
    batch.properties_known[0][k][i] = values[i].has_value() ? 1.0 : 0.0;
  }
}

/// Networks without these inputs do not look.
void store_ground(const GroundProperties& ground, SceneBatch& batch) {
  batch.ground_material =
      torch::tensor({ground.friction.value_or(0.0), ground.restitution.value_or(0.0)}, torch::kFloat32).unsqueeze(0);
  batch.ground_known =
      torch::tensor({ground.friction ? 1.0 : 0.0, ground.restitution ? 1.0 : 0.0}, torch::kFloat32).unsqueeze(0);
}

/// Takes every n-th point, so that at most `max_points` are left.
Points thinned(const Points& cloud, Eigen::Index max_points) {
  const Eigen::Index stride = (cloud.rows() + max_points - 1) / max_points;
  if (stride <= 1) return cloud;
  Points kept((cloud.rows() + stride - 1) / stride, 3);
  for (Eigen::Index i = 0; i < kept.rows(); ++i) kept.row(i) = cloud.row(i * stride);
  return kept;
}

/// The clouds for the physics engine, which can do with more points than the network.
void store_surfaces(const std::vector<ObjectState>& objects, SceneBatch& batch) {
  const auto K = static_cast<std::int64_t>(objects.size());
  std::int64_t longest = 1;
  for (const ObjectState& object : objects) longest = std::max<std::int64_t>(longest, object.points_reference.rows());
  const std::int64_t M = std::min(longest, kMaxSurfacePoints);
  batch.surface_points = torch::zeros({1, K, M, 3});
  batch.surface_mask = torch::zeros({1, K, M}, torch::kBool);
  for (std::int64_t k = 0; k < K; ++k) {
    Points cloud = thinned(objects[static_cast<size_t>(k)].points_reference, kMaxSurfacePoints);
    const std::int64_t n = cloud.rows();
    batch.surface_points[0][k].slice(0, 0, n).copy_(torch::from_blob(cloud.data(), {n, 3}));
    batch.surface_mask[0][k].slice(0, 0, n).fill_(true);
  }
}

void store_normals(const std::vector<Points>& clouds, SceneBatch& batch) {
  batch.normals_reference = torch::zeros_like(batch.points_reference);
  for (size_t k = 0; k < clouds.size(); ++k) {
    Points normals = estimate_normals(clouds[k]);
    batch.normals_reference[0][static_cast<std::int64_t>(k)]
        .slice(0, 0, normals.rows())
        .copy_(torch::from_blob(normals.data(), {normals.rows(), 3}));
  }
}

Pose identity_poses(std::int64_t K) {
  return {torch::eye(3).reshape({1, 1, 3, 3}).repeat({1, K, 1, 1}), torch::zeros({1, K, 3})};
}

Eigen::Vector3d scene_origin(const std::vector<ObjectState>& objects, const RolloutOptions& rollout) {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (const ObjectState& object : objects) {
    origin += object.T_world_current * object.points_reference.cast<double>().colwise().mean().transpose().eval();
  }
  origin /= static_cast<double>(std::max<size_t>(1, objects.size()));
  if (rollout.ground_height_m) origin.z() = *rollout.ground_height_m;
  return origin;
}

}  // namespace

void store_pose(const RigidTransform& T, const Eigen::Vector3d& origin, Pose& pose, std::int64_t k) {
  const Eigen::Matrix<float, 3, 3, Eigen::RowMajor> R = T.rotation.normalized().toRotationMatrix().cast<float>();
  const Eigen::Vector3f t = (T.translation - origin).cast<float>();
  pose.rotation[0][k] = torch::tensor(std::vector<float>(R.data(), R.data() + 9)).reshape({3, 3});
  pose.translation[0][k] = torch::tensor(std::vector<float>(t.data(), t.data() + 3));
}

void validate_options(const RolloutOptions& rollout) {
  check_range("num_steps", rollout.num_steps, rollout.num_steps >= 1, "at least 1");
  check_range("time_step_s", rollout.time_step_s, std::isfinite(rollout.time_step_s) && rollout.time_step_s > 0.0,
              "positive and finite");
  check_range("gravity", rollout.gravity, std::isfinite(rollout.gravity), "finite");
  const double ground = rollout.ground_height_m.value_or(0.0);
  check_range("ground_height_m", ground, std::isfinite(ground), "finite");
  const double friction = rollout.ground.friction.value_or(0.0), restitution = rollout.ground.restitution.value_or(0.0);
  check_range("ground.friction", friction, friction >= 0.0 && friction <= kMostFriction, "in [0, 1000]");
  check_range("ground.restitution", restitution, restitution >= 0.0 && restitution <= 1.0, "in [0, 1]");
  check_range("num_particles", rollout.num_particles,
              rollout.num_particles >= 1 && rollout.num_particles <= kMostParticles, "in [1, 64]");
}

SceneState make_scene_state(const std::vector<ObjectState>& objects, const Eigen::Vector3d& origin_world) {
  const auto K = static_cast<std::int64_t>(objects.size());
  SceneState state{identity_poses(K), identity_poses(K), identity_poses(K)};
  for (std::int64_t k = 0; k < K; ++k) {
    const ObjectState& object = objects[static_cast<size_t>(k)];
    const bool rests = object.mode == MotionMode::kStatic;
    store_pose(rests ? object.T_world_current : object.T_world_previous, origin_world, state.previous, k);
    store_pose(object.T_world_current, origin_world, state.current, k);
  }
  state.first = state.previous;
  return state;
}

void store_roles(const std::vector<ObjectState>& objects, const ModelOptions& model, SceneBatch& batch) {
  const auto K = static_cast<std::int64_t>(objects.size());
  batch.object_mask = torch::ones({1, K}, torch::kBool);
  batch.dynamic_mask = torch::ones({1, K}, torch::kBool);
  batch.properties = torch::zeros({1, K, 3});
  batch.properties_known = torch::zeros({1, K, 3});
  for (std::int64_t k = 0; k < K; ++k) {
    const ObjectState& object = objects[static_cast<size_t>(k)];
    batch.dynamic_mask[0][k] = object.mode == MotionMode::kDynamic;
    store_properties(object, model.property_mask, batch, k);
  }
}

SceneInput make_scene_input(const std::vector<ObjectState>& objects, const RolloutOptions& rollout,
                            const ModelOptions& model, int max_points) {
  const auto K = static_cast<std::int64_t>(objects.size());
  SceneInput input;
  std::int64_t longest = 1;
  for (const ObjectState& object : objects) {
    input.clouds.push_back(select_points(object.points_reference, max_points));
    longest = std::max<std::int64_t>(longest, input.clouds.back().rows());
  }
  const std::int64_t N = (longest + kPointBucket - 1) / kPointBucket * kPointBucket;
  input.origin_world = scene_origin(objects, rollout);
  input.state = make_scene_state(objects, input.origin_world);

  SceneBatch& batch = input.batch;
  batch.points_reference = torch::zeros({1, K, N, 3});
  batch.point_mask = torch::zeros({1, K, N}, torch::kBool);
  store_roles(objects, model, batch);
  batch.step_size = torch::full({1}, rollout.time_step_s * kFrameRateHz);
  batch.ground_height = torch::full({1}, rollout.ground_height_m ? 0.0 : kNoGround);
  batch.gravity = torch::full({1}, rollout.gravity);
  store_ground(rollout.ground, batch);
  for (std::int64_t k = 0; k < K; ++k) {
    Points& cloud = input.clouds[static_cast<size_t>(k)];
    const std::int64_t n = cloud.rows();
    batch.points_reference[0][k].slice(0, 0, n).copy_(torch::from_blob(cloud.data(), {n, 3}));
    batch.point_mask[0][k].slice(0, 0, n).fill_(true);
  }
  if (model.engine_motion || model.contact_tokens) store_surfaces(objects, batch);
  if (model.local_planes) store_normals(input.clouds, batch);
  const TensorRandom random(torch::kCPU, kAnchorSeed);  // the same scene gets the same anchors
  const Tensor start_score = model.random_anchors ? random.uniform({1, K, N}, torch::kFloat32) : Tensor();
  batch.anchor_index = farthest_anchors(batch.points_reference, batch.point_mask, model.num_anchors, start_score);
  return input;
}

std::vector<RigidTransform> to_world(const Pose& pose, const Eigen::Vector3d& origin_world) {
  const Tensor R = pose.rotation[0].to(torch::kCPU, torch::kFloat64).contiguous();
  const Tensor t = pose.translation[0].to(torch::kCPU, torch::kFloat64).contiguous();
  std::vector<RigidTransform> T_world_reference;
  for (std::int64_t k = 0; k < R.size(0); ++k) {
    const Eigen::Matrix3d rotation =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(R.data_ptr<double>() + 9 * k);
    const Eigen::Vector3d translation = Eigen::Map<const Eigen::Vector3d>(t.data_ptr<double>() + 3 * k);
    T_world_reference.push_back({Eigen::Quaterniond(rotation).normalized(), translation + origin_world});
  }
  return T_world_reference;
}

}  // namespace rigidformer
