// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/movi_scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "rigidformer/data/kubasic.hpp"
#include "rigidformer/geometry/random.hpp"

namespace rigidformer {
namespace {

struct Material {
  double friction;
  double restitution;
  double density_factor;
};
// Friction, restitution and density factor of the two materials of the MOVi scenes (published constants).
constexpr Material kMetal{0.4, 0.3, 2.7};
constexpr Material kRubber{0.8, 0.7, 1.1};

constexpr int kMaxSceneDraws = 1000;  // draws of a scene before it counts as impossible; chosen by eye

const Shape* find(const std::vector<Shape>& library, const std::string& name) {
  const auto found = std::find_if(library.begin(), library.end(), [&](const Shape& s) { return s.name == name; });
  return found == library.end() ? nullptr : &*found;
}

std::vector<Shape> pick(const std::vector<Shape>& library, const std::vector<std::string>& names) {
  std::vector<Shape> picked;
  for (const std::string& name : names) {
    const Shape* shape = find(library, name);
    if (shape == nullptr) throw std::invalid_argument("shape '" + name + "' is not in the shape library");
    picked.push_back(*shape);
  }
  return picked;
}

/// Axis-aligned box of the rotated and scaled shape, given as offsets from the shape's origin [m].
Eigen::AlignedBox3d rotated_bounds(const Points& vertices, double size, const Eigen::Quaterniond& rotation) {
  const Points rotated = RigidTransform{rotation, Eigen::Vector3d::Zero()}.apply(vertices);
  return {size * rotated.colwise().minCoeff().transpose().cast<double>(),
          size * rotated.colwise().maxCoeff().transpose().cast<double>()};
}

double draw_size(MoviSet set, const MoviOptions& options, Random& random) {
  if (set == MoviSet::kB) return random.uniform(options.small_size, options.large_size);
  return random.uniform_int(0, 1) == 0 ? options.small_size : options.large_size;
}

RecordedObject draw_object(MoviSet set, const std::vector<Shape>& shapes, const MoviOptions& options, Random& random,
                           const Shape*& shape) {
  shape = &shapes[static_cast<std::size_t>(random.uniform_int(0, static_cast<int>(shapes.size()) - 1))];
  const Material& material = random.uniform_int(0, 1) == 0 ? kMetal : kRubber;
  RecordedObject object;
  object.shape = shape->name;
  object.size = draw_size(set, options, random);
  object.properties = {shape->mass_kg * material.density_factor * std::pow(object.size, 3), material.friction,
                       material.restitution};
  return object;
}

BodyState draw_state(const Points& vertices, double size, const MoviOptions& options, Random& random) {
  BodyState state;
  state.T_world_object.rotation = random.rotation();
  const Eigen::AlignedBox3d bounds = rotated_bounds(vertices, size, state.T_world_object.rotation);
  for (int axis = 0; axis < 3; ++axis) {
    state.T_world_object.translation[axis] =
        random.uniform(options.region_min[axis] - bounds.min()[axis], options.region_max[axis] - bounds.max()[axis]);
  }
  return state;
}

/// Tries to place one object where it touches no other.
bool place(BulletWorld& world, const Shape& shape, const RecordedObject& object, const MoviOptions& options,
           Random& random) {
  const int body = world.add_body(shape, object.size, object.properties, {});
  const Points vertices = shape.vertices();
  for (int attempt = 0; attempt < options.placement_tries; ++attempt) {
    world.set_state(body, draw_state(vertices, object.size, options, random));
    if (!world.overlaps_any(body)) return true;
  }
  return false;
}

/// Draws a whole scene once; empty when an object found no room.
std::optional<SceneRecording> draw_scene(MoviSet set, const std::vector<Shape>& shapes, const MoviOptions& options,
                                         Random& random) {
  SceneRecording scene;
  const BulletSettings settings = movi_bullet_settings(set);
  BulletWorld world(settings);
  const int num_objects = random.uniform_int(options.min_objects, options.max_objects);
  for (int i = 0; i < num_objects; ++i) {
    const Shape* shape = nullptr;
    RecordedObject object = draw_object(set, shapes, options, random, shape);
    if (!place(world, *shape, object, options, random)) return std::nullopt;
    const RigidTransform T_world_object = world.state(i).T_world_object;
    const double v = options.max_speed_mps;
    object.T_world_object = {T_world_object};
    object.velocities = {{random.uniform(-v, v) - T_world_object.translation.x(),
                          random.uniform(-v, v) - T_world_object.translation.y(), 0.0}};
    object.angular_velocities = {Eigen::Vector3d::Zero()};
    scene.objects.push_back(std::move(object));
  }
  scene.num_frames = 1;
  scene.frame_rate_hz = settings.frame_rate_hz;
  scene.gravity = settings.gravity;
  return scene;
}

}  // namespace

MoviSet parse_movi_set(const std::string& name) {
  for (const MoviSet set : {MoviSet::kSphere, MoviSet::kA, MoviSet::kB}) {
    if (name == to_string(set)) return set;
  }
  throw std::invalid_argument("set '" + name + "' is not one of movi_sphere, movi_a, movi_b");
}

std::string to_string(MoviSet set) {
  return set == MoviSet::kSphere ? "movi_sphere" : set == MoviSet::kA ? "movi_a" : "movi_b";
}

std::vector<std::string> movi_shape_names(MoviSet set, const std::vector<std::string>& available) {
  if (set == MoviSet::kSphere) return {"sphere"};
  if (set == MoviSet::kA) return {"cube", "cylinder", "sphere"};
  const std::vector<std::string>& names = movi_b_shape_names();
  const bool complete = std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::find(available.begin(), available.end(), name) != available.end();
  });
  return complete ? names : available;
}

std::vector<Shape> movi_shapes(MoviSet set, const std::vector<Shape>& library) {
  std::vector<std::string> available;
  for (const Shape& shape : library) available.push_back(shape.name);
  return pick(library, movi_shape_names(set, available));
}

BulletSettings movi_bullet_settings(MoviSet set) {
  BulletSettings settings;
  settings.substeps = set == MoviSet::kSphere ? 5 : 10;
  return settings;
}

SceneRecording sample_movi_scene(MoviSet set, const std::vector<Shape>& shapes, std::uint64_t seed, std::uint64_t index,
                                 const MoviOptions& options) {
  if (shapes.empty()) throw std::invalid_argument("sample_movi_scene: no shapes");
  Random random(seed, index);
  for (int draw = 0; draw < kMaxSceneDraws; ++draw) {
    if (std::optional<SceneRecording> scene = draw_scene(set, shapes, options, random)) {
      scene->name = std::to_string(index);
      scene->seed = seed;
      return *scene;
    }
  }
  throw std::runtime_error("scene " + std::to_string(index) + ": the objects do not fit into the region");
}

SceneRecording generate_movi_scene(MoviSet set, const std::vector<Shape>& shapes, std::uint64_t seed,
                                   std::uint64_t index, const MoviOptions& options) {
  return simulate(sample_movi_scene(set, shapes, seed, index, options), shapes, movi_bullet_settings(set),
                  options.num_frames, options.first_frame);
}

}  // namespace rigidformer
