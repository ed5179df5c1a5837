// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/scene_tensors.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "rigidformer/geometry/farthest_point_sampling.hpp"
#include "rigidformer/geometry/surface_normals.hpp"
#include "rigidformer/model/batch.hpp"
#include "rigidformer/scene/mean_material.hpp"
#include "rigidformer/scene/surface_sampling.hpp"

namespace rigidformer {
namespace {

/// Writes one point set in farthest-point order into the row (shape, set).
void store_point_set(SceneTensors& tensors, std::int64_t shape, std::int64_t set, const SurfaceSamples& samples) {
  const auto capacity = static_cast<int>(tensors.shape_points.size(2));
  const std::vector<int> order = farthest_point_order(samples.points, capacity);
  const auto store = [&](Points rows, const Tensor& place) {
    place[shape][set].slice(0, 0, rows.rows()).copy_(torch::from_blob(rows.data(), {rows.rows(), 3}));
  };
  const Points points = samples.points(order, Eigen::all);
  store(points, tensors.shape_points);
  store(samples.normals(order, Eigen::all), tensors.shape_normals);
  store(estimate_normals(points), tensors.estimated_normals);
  tensors.shape_point_count[shape][set] = static_cast<std::int64_t>(order.size());
}

void store_shape(SceneTensors& tensors, std::int64_t index, const Shape& shape, const PointSetOptions& options) {
  store_point_set(tensors, index, 0, vertices_with_normals(shape));
  for (int set = 1; set < options.sets_per_shape; ++set) {
    const auto seed = options.seed * 1000 + static_cast<std::uint64_t>(set);
    store_point_set(tensors, index, set, sample_surface(shape, options.points_per_set, seed));
  }
}

void store_shapes(SceneTensors& tensors, const std::vector<const Shape*>& shapes, const PointSetOptions& options) {
  const auto Q = static_cast<std::int64_t>(shapes.size());
  tensors.shape_points = torch::zeros({Q, options.sets_per_shape, options.points_per_set, 3});
  tensors.shape_normals = torch::zeros_like(tensors.shape_points);
  tensors.estimated_normals = torch::zeros_like(tensors.shape_points);
  tensors.shape_point_count = torch::zeros({Q, options.sets_per_shape}, torch::kInt64);
  std::vector<std::thread> workers;
  const std::int64_t num_workers = std::min<std::int64_t>(Q, std::max(1u, std::thread::hardware_concurrency()));
  for (std::int64_t worker = 0; worker < num_workers; ++worker) {
    workers.emplace_back([&, worker] {
      for (std::int64_t q = worker; q < Q; q += num_workers) {
        store_shape(tensors, q, *shapes[static_cast<size_t>(q)], options);
      }
    });
  }
  for (std::thread& worker : workers) worker.join();
}

/// Mass, friction and restitution, and which of them the recording says.
void store_properties(SceneTensors& tensors, std::int64_t s, std::int64_t k, const BodyProperties& p) {
  const std::optional<double> values[] = {p.mass_kg, p.friction, p.restitution};
  const double means[] = {kMeanMass, kMeanFriction, kMeanRestitution};
  for (std::int64_t i = 0; i < 3; ++i) {
    tensors.properties[s][k][i] = values[i].value_or(means[i]);
    tensors.properties_known[s][k][i] = values[i].has_value() ? 1.0 : 0.0;
  }
}

void store_ground(SceneTensors& tensors, std::int64_t s, const GroundProperties& ground) {
  const std::optional<double> values[] = {ground.friction, ground.restitution};
  for (std::int64_t i = 0; i < 2; ++i) {
    tensors.ground_material[s][i] = values[i].value_or(0.0);
    tensors.ground_known[s][i] = values[i].has_value() ? 1.0 : 0.0;
  }
}

void store_object(SceneTensors& tensors, std::int64_t s, std::int64_t k, const RecordedObject& object,
                  std::int64_t shape) {
  tensors.object_mask[s][k] = true;
  tensors.shape[s][k] = shape;
  tensors.size[s][k] = object.size;
  tensors.dynamic_mask[s][k] = !object.is_given();
  store_properties(tensors, s, k, object.properties);
  const Tensor scene_poses = tensors.poses[s];
  auto poses = scene_poses.accessor<float, 3>();
  for (std::int64_t frame = 0; frame < poses.size(0); ++frame) {
    const RigidTransform& T = object.T_world_object[std::min<size_t>(frame, object.T_world_object.size() - 1)];
    auto row = poses[frame][k];
    for (int axis = 0; axis < 3; ++axis) row[axis] = static_cast<float>(T.translation[axis]);
    for (int part = 0; part < 4; ++part) row[3 + part] = static_cast<float>(T.rotation.coeffs()[part]);
  }
}

/// The commands of scene `s`; all scenes have them of one width, or none has any.
void store_control(SceneTensors& tensors, std::int64_t s, const SceneArchive& archive, const SceneRecording& scene) {
  const auto width = static_cast<std::int64_t>(scene.control.empty() ? 0 : scene.control.front().size());
  if (s == 0 && width > 0) {
    tensors.control = torch::zeros({tensors.num_scenes(), tensors.num_frames(), width});
    tensors.control_directions = scene.control_directions;
  }
  const std::int64_t wanted = tensors.control.defined() ? tensors.control.size(2) : 0;
  if (width != wanted || scene.control_directions != tensors.control_directions) {
    throw std::invalid_argument("scene '" + scene.name + "' of set '" + archive.set + "' has commands of " +
                                std::to_string(width) + " numbers, the first scene of " + std::to_string(wanted) +
                                ", or other directions in them");
  }
  for (std::int64_t frame = 0; width > 0 && frame < tensors.num_frames(); ++frame) {
    const std::vector<double>& command = scene.control[std::min<size_t>(frame, scene.control.size() - 1)];
    tensors.control[s][frame] = torch::tensor(command, torch::kFloat32);
  }
}

/// Makes the tensors of all scenes, without objects yet.
SceneTensors allocate(const std::vector<SceneArchive>& archives) {
  std::int64_t S = 0, F = 0, K = 0;
  for (const SceneArchive& archive : archives) {
    for (const SceneRecording& scene : archive.scenes) {
      F = std::max<std::int64_t>(F, scene.num_frames);
      K = std::max<std::int64_t>(K, static_cast<std::int64_t>(scene.objects.size()));
      ++S;
    }
  }
  if (S == 0) throw std::invalid_argument("no scenes to learn from: the data folders are empty");

  SceneTensors tensors;
  tensors.poses = torch::zeros({S, F, K, 7});
  tensors.poses.select(-1, 6).fill_(1.0);  // identity where there is no object
  tensors.object_mask = torch::zeros({S, K}, torch::kBool);
  tensors.shape = torch::zeros({S, K}, torch::kInt64);
  tensors.size = torch::ones({S, K});
  tensors.properties = torch::zeros({S, K, 3});
  tensors.gravity = torch::zeros({S});
  tensors.frame_count = torch::zeros({S}, torch::kInt64);
  tensors.dynamic_mask = torch::zeros({S, K}, torch::kBool);
  tensors.properties_known = torch::zeros({S, K, 3});
  tensors.ground_material = torch::zeros({S, 2});
  tensors.ground_known = torch::zeros({S, 2});
  tensors.frame_rate = torch::zeros({S}, torch::kFloat64);
  return tensors;
}

}  // namespace

std::vector<std::int64_t> SceneTensors::object_counts() const {
  const Tensor counts = object_mask.sum(-1).to(torch::kCPU);
  return {counts.data_ptr<std::int64_t>(), counts.data_ptr<std::int64_t>() + counts.numel()};
}

std::vector<std::int64_t> SceneTensors::frame_counts() const {
  const Tensor counts = frame_count.to(torch::kCPU);
  return {counts.data_ptr<std::int64_t>(), counts.data_ptr<std::int64_t>() + counts.numel()};
}

std::vector<double> SceneTensors::frame_rates() const {
  const Tensor rates = frame_rate.to(torch::kCPU);
  return {rates.data_ptr<double>(), rates.data_ptr<double>() + rates.numel()};
}

int frames_at_rate(int frames, double frame_rate_hz) {
  constexpr double kTolerance = 0.05;  // [frames] rates are measured: 9.99 frames are ten
  return std::max(1, static_cast<int>(std::floor(frames * frame_rate_hz / kFrameRateHz + kTolerance)));
}

SceneTensors SceneTensors::to(const torch::Device& device) const {
  return {poses.to(device),
          object_mask.to(device),
          shape.to(device),
          size.to(device),
          properties.to(device),
          gravity.to(device),
          shape_points.to(device),
          shape_normals.to(device),
          estimated_normals.to(device),
          shape_point_count.to(device),
          frame_count.to(device),
          dynamic_mask.to(device),
          properties_known.to(device),
          frame_rate.to(device),
          ground_material.to(device),
          ground_known.to(device),
          control.defined() ? control.to(device) : control,
          control_directions};
}

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

SceneTensors make_scene_tensors(const std::vector<SceneArchive>& archives, const PointSetOptions& options) {
  SceneTensors tensors = allocate(archives);
  std::vector<const Shape*> shapes;
  std::int64_t s = 0;
  for (const SceneArchive& archive : archives) {
    std::map<std::string, std::int64_t> index_of;
    for (const Shape& shape : archive.shapes) {
      index_of[shape.name] = static_cast<std::int64_t>(shapes.size());
      shapes.push_back(&shape);
    }
    for (const SceneRecording& scene : archive.scenes) {
      tensors.gravity[s] = scene.gravity.z();
      tensors.frame_count[s] = scene.num_frames;
      store_ground(tensors, s, scene.ground);
      store_control(tensors, s, archive, scene);
      tensors.frame_rate[s] = scene.frame_rate_hz;
      for (size_t k = 0; k < scene.objects.size(); ++k) {
        store_object(tensors, s, static_cast<std::int64_t>(k), scene.objects[k], index_of.at(scene.objects[k].shape));
      }
      ++s;
    }
  }
  store_shapes(tensors, shapes, options);
  return tensors;
}

}  // namespace rigidformer
