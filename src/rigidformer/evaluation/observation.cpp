// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/observation.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <stdexcept>

namespace rigidformer {
namespace {

constexpr std::size_t kMinPoints = 4;  // points of an object at least, as ObjectState asks for

/// Hashes a name by FNV-1a. Unlike std::hash it is the same everywhere, so that a shape has the
/// same samples on every machine.
std::uint64_t stable_hash(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  return hash;
}

/// Gives the rows in the order of falling `rank` as long as it is positive, and at least kMinPoints of them.
std::vector<Eigen::Index> best_rows(const std::vector<float>& rank) {
  std::vector<Eigen::Index> rows(rank.size());
  std::iota(rows.begin(), rows.end(), 0);
  std::stable_sort(rows.begin(), rows.end(), [&](Eigen::Index a, Eigen::Index b) { return rank[a] > rank[b]; });
  const auto num_positive = std::count_if(rank.begin(), rank.end(), [](float r) { return r > 0.0F; });
  rows.resize(std::min(rank.size(), std::max<std::size_t>(num_positive, kMinPoints)));
  return rows;
}

/// Drops the points that face away from the camera; points and camera are in the body frame.
Points facing_camera(const Points& points, const Points& normals, const Eigen::Vector3d& camera_body) {
  std::vector<float> facing(points.rows());
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    facing[row] = normals.row(row).dot((camera_body.transpose().cast<float>() - points.row(row)).normalized());
  }
  return points(best_rows(facing), Eigen::all);
}

Points masked(const Points& points, double fraction, std::mt19937_64& random) {
  std::vector<Eigen::Index> rows(points.rows());
  std::iota(rows.begin(), rows.end(), 0);
  std::shuffle(rows.begin(), rows.end(), random);
  const auto num_kept = static_cast<std::size_t>(static_cast<double>(rows.size()) * (1.0 - fraction) + 0.5);
  rows.resize(std::min(rows.size(), std::max(num_kept, kMinPoints)));
  return points(rows, Eigen::all);
}

/// Drops the points inside a box around a random point, whose proportions are random and whose size follows from the
/// share that is dropped.
Points without_box(const Points& points, double fraction, std::mt19937_64& random) {
  std::uniform_int_distribution<Eigen::Index> any_row(0, points.rows() - 1);
  std::uniform_real_distribution<float> edge(0.5F, 1.0F);
  const Eigen::RowVector3f middle = points.row(any_row(random));
  const Eigen::RowVector3f edges(edge(random), edge(random), edge(random));
  const Eigen::VectorXf box_size =
      ((points.rowwise() - middle).array().rowwise() / edges.array()).abs().rowwise().maxCoeff();
  std::vector<Eigen::Index> rows(points.rows());
  std::iota(rows.begin(), rows.end(), 0);
  std::stable_sort(rows.begin(), rows.end(), [&](auto a, auto b) { return box_size[a] > box_size[b]; });
  const auto num_kept = static_cast<std::size_t>(static_cast<double>(rows.size()) * (1.0 - fraction) + 0.5);
  rows.resize(std::min(rows.size(), std::max(num_kept, kMinPoints)));
  return points(rows, Eigen::all);
}

void check_share(const char* name, double value) {
  if (value >= 0.0 && value < 1.0) return;
  throw std::invalid_argument(std::string("observation: ") + name + " is " + std::to_string(value) +
                              ", must lie in [0, 1)");
}

void add_noise(Points& points, double standard_deviation_m, std::mt19937_64& random) {
  std::normal_distribution<float> noise(0.0F, static_cast<float>(standard_deviation_m));
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    points.data()[i] += noise(random);
  }
}

}  // namespace

void ObservationOptions::validate() const {
  if (num_points != 0 && num_points < static_cast<int>(kMinPoints)) {
    throw std::invalid_argument("observation: num_points is " + std::to_string(num_points) +
                                ", must be 0 (vertices) or at least " + std::to_string(kMinPoints));
  }
  if (!(noise_m >= 0.0)) {
    throw std::invalid_argument("observation: noise_m is " + std::to_string(noise_m) + ", must not be negative");
  }
  check_share("masked_fraction", masked_fraction);
  check_share("boxed_fraction", boxed_fraction);
}

GroundProperties observed_ground(const SceneRecording& scene, const ObservationOptions& options) {
  return options.known_properties ? scene.ground : GroundProperties();
}

Observer::Observer(const std::vector<Shape>& shapes, const ObservationOptions& options) : options_(options) {
  options_.validate();
  for (const Shape& shape : shapes) {
    samples_[shape.name] = options_.num_points == 0
                               ? vertices_with_normals(shape)
                               : sample_surface(shape, options_.num_points, stable_hash(shape.name));
  }
}

Points Observer::observed_points(const RecordedObject& object, int frame, std::uint64_t seed) const {
  const auto found = samples_.find(object.shape);
  if (found == samples_.end()) {
    throw std::invalid_argument("observation: no shape named '" + object.shape + "'");
  }
  Points points = found->second.points * static_cast<float>(object.size);
  if (options_.one_view) {
    const Eigen::Vector3d camera_body = object.T_world_object[frame].inverse() * options_.camera_world;
    points = facing_camera(points, found->second.normals, camera_body);
  }
  std::mt19937_64 random(seed);
  if (options_.masked_fraction > 0.0) {
    points = masked(points, options_.masked_fraction, random);
  }
  if (options_.boxed_fraction > 0.0) {
    points = without_box(points, options_.boxed_fraction, random);
  }
  if (options_.noise_m > 0.0) {
    add_noise(points, options_.noise_m, random);
  }
  return points;
}

std::vector<ObjectState> Observer::observe(const SceneRecording& scene, int frame, int step) const {
  if (step < 1 || frame < step || frame >= scene.num_frames) {
    throw std::invalid_argument("observation: frames " + std::to_string(frame - step) + " and " +
                                std::to_string(frame) + " must be increasing and inside the " +
                                std::to_string(scene.num_frames) + " frames of scene " + scene.name);
  }
  std::vector<ObjectState> objects;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const RecordedObject& recorded = scene.objects[i];
    ObjectState object;
    object.id = recorded.shape + "_" + std::to_string(i);
    object.mode = recorded.is_static   ? MotionMode::kStatic
                  : recorded.is_driven ? MotionMode::kKinematic
                                       : MotionMode::kDynamic;
    const std::string place = scene.name + "/" + std::to_string(i) + "/" + std::to_string(frame);
    object.points_reference = observed_points(recorded, frame, stable_hash(place));
    object.T_world_previous = recorded.T_world_object[frame - step];
    object.T_world_current = recorded.T_world_object[frame];
    if (options_.known_properties) {
      object.properties = recorded.properties;
    }
    if (options_.friction) object.properties.friction = options_.friction;
    if (options_.restitution) object.properties.restitution = options_.restitution;
    objects.push_back(std::move(object));
  }
  return objects;
}

}  // namespace rigidformer
