// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/wrecking_ball_scene.hpp"

#include <algorithm>

#include "rigidformer/geometry/random.hpp"
#include "rigidformer/simulation/builtin_shapes.hpp"
#include "rigidformer/simulation/convex_hull.hpp"

namespace rigidformer {
namespace {

// App. H.1: the same for all cubes; here the floor and the ball have it too.
constexpr double kCubeMass_kg = 1.0, kFriction = 0.5, kRestitution = 0.3;
constexpr int kSolverSteps = 1;  // per frame: App. H.1 records every frame of the simulation
// The ball aims at this part of the wall, in shares of its half width and of its height. Chosen by eye.
constexpr double kAimAside = 0.5, kAimLow = 0.35, kAimHigh = 0.8;
constexpr double kStartAside = 0.3;  // [m] the ball starts beside the line through its aim by up to this

Shape make_block() {
  Points corners(8, 3);
  for (int i = 0; i < 8; ++i) {
    for (int axis = 0; axis < 3; ++axis) corners(i, axis) = (i >> axis & 1) != 0 ? 0.5F : -0.5F;
  }
  return {"block", kCubeMass_kg, {convex_hull(corners)}};
}

RecordedObject make_object(const std::string& shape, double size, double mass_kg, const BodyState& state) {
  RecordedObject object;
  object.shape = shape;
  object.size = size;
  object.properties = {mass_kg, kFriction, kRestitution};
  object.T_world_object = {state.T_world_object};
  object.velocities = {state.velocity};
  object.angular_velocities = {state.angular_velocity};
  return object;
}

RecordedObject draw_cube(const WreckingBallOptions& options, const Eigen::Vector3i& cell, Random& random) {
  const double middle = 0.5 * (options.cubes_per_edge - 1);
  const double shift = options.max_shift_m;
  BodyState state;
  state.T_world_object.translation = {
      options.spacing_m * (cell.x() - middle) + random.uniform(-shift, shift),
      options.spacing_m * (cell.y() - middle) + random.uniform(-shift, shift),
      0.5 * options.cube_edge_m + options.layer_gap_m + (options.cube_edge_m + options.layer_gap_m) * cell.z()};
  const double yaw = random.uniform(-options.max_yaw_rad, options.max_yaw_rad);
  state.T_world_object.rotation = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
  return make_object("block", options.cube_edge_m, kCubeMass_kg, state);
}

/// The ball comes along x, somewhat obliquely.
RecordedObject draw_ball(const WreckingBallOptions& options, Random& random) {
  const double half_width_m = 0.5 * options.spacing_m * options.cubes_per_edge;
  const double height_m = options.cube_edge_m * options.cubes_per_edge;
  const Eigen::Vector3d aim(-half_width_m, half_width_m * random.uniform(-kAimAside, kAimAside),
                            std::max(height_m * random.uniform(kAimLow, kAimHigh), options.ball_size));
  const double gap_m = random.uniform(options.min_gap_m, options.max_gap_m);
  BodyState state;
  state.T_world_object.translation =
      aim + Eigen::Vector3d(-gap_m - 0.5 * options.ball_size, random.uniform(-kStartAside, kStartAside), 0.0);
  state.T_world_object.rotation = random.rotation();
  const double speed_mps = random.uniform(options.min_speed_mps, options.max_speed_mps);
  state.velocity = speed_mps * (aim - state.T_world_object.translation).normalized();
  return make_object("sphere", options.ball_size, options.ball_mass_kg, state);
}

}  // namespace

std::optional<WreckingBallOptions> wrecking_ball_set(const std::string& name) {
  const auto& names = wrecking_ball_set_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  WreckingBallOptions options;
  options.cubes_per_edge = 3 + static_cast<int>(found - names.begin());
  return options;
}

const std::vector<std::string>& wrecking_ball_set_names() {
  static const std::vector<std::string> names{"wrecking_ball_28", "wrecking_ball_65", "wrecking_ball_126",
                                              "wrecking_ball_217"};
  return names;
}

const std::vector<Shape>& wrecking_ball_shapes() {
  static const std::vector<Shape> shapes = [] {
    const auto& library = builtin_shapes();
    const auto is_sphere = [](const Shape& shape) { return shape.name == "sphere"; };
    return std::vector<Shape>{make_block(), *std::find_if(library.begin(), library.end(), is_sphere)};
  }();
  return shapes;
}

BulletSettings wrecking_ball_settings() {
  BulletSettings settings;
  settings.substeps = kSolverSteps;
  settings.floor_friction = kFriction;
  settings.floor_restitution = kRestitution;
  return settings;
}

SceneRecording sample_wrecking_ball_scene(const WreckingBallOptions& options, std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index);
  SceneRecording scene;
  scene.name = std::to_string(index);
  scene.seed = seed;
  scene.num_frames = 1;
  for (int z = 0; z < options.cubes_per_edge; ++z) {
    for (int y = 0; y < options.cubes_per_edge; ++y) {
      for (int x = 0; x < options.cubes_per_edge; ++x) scene.objects.push_back(draw_cube(options, {x, y, z}, random));
    }
  }
  scene.objects.push_back(draw_ball(options, random));
  return scene;
}

}  // namespace rigidformer
