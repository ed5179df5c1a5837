// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "rigidformer/scene/shape.hpp"
#include "rigidformer/simulation/bullet_world.hpp"

namespace rigidformer {

/// Settings of a MuJoCo world: convex meshes with elliptic friction cones. MuJoCo has no coefficient of restitution:
/// every pair of bodies gets a spring and damper that rebound with the product of the two coefficients (see
/// contact_spring.hpp), and the product of the two frictions, as in Bullet.
struct MujocoSettings {
  double frame_rate_hz = 240.0;              ///< Frames per second of the recording
  int substeps = 16;                         ///< Solver steps per frame; shorter ones make stiffer contacts; by eye
  Eigen::Vector3d gravity{0.0, 0.0, -10.0};  ///< [m/s^2]
  double floor_friction = 0.3;               ///< Coulomb coefficient of the floor
  double floor_restitution = 0.5;
  double steps_per_contact = 12.0;     ///< Solver steps that a contact takes: more are softer; as contact_spring.hpp
  double impedance = 0.99;             ///< Constant: near 1 (by eye), stiffness and damping are what they say
  double friction_impedance = 10.0;    ///< Ratio of the impedance of friction to that of normal forces; by eye
  double spinning_friction_m = 0.005;  ///< Least lever arm of the friction that stops spinning; MuJoCo's default
  double spinning_friction = 0.0;      ///< Lever arm, as a share of a body's radius
  double rolling_friction = 0.0;       ///< Lever arm of the friction that stops rolling, as a share of a body's radius

  /// Throws std::invalid_argument naming field and value.
  void validate() const;
};

/// A body, with its origin in its centre of mass.
struct MujocoBody {
  std::vector<ConvexPart> parts;  ///< Body frame [m]; of one density
  BodyProperties properties;      ///< Complete, but for the mass of what cannot be pushed
  BodyState state;
  bool is_static = false;  ///< Never moves
  MotionPath path = {};    ///< That the body follows from time 0 on, whatever it pushes; empty = none

  bool is_given() const { return is_static || path; }
};

/// Rigid bodies above the floor plane z = 0, stepped frame by frame. A world is not thread safe; worlds are independent
/// of each other.
class MujocoWorld {
 public:
  /// Throws std::invalid_argument naming what is missing, and std::runtime_error with MuJoCo's words when it refuses
  /// the scene.
  MujocoWorld(const MujocoSettings& settings, const std::vector<MujocoBody>& bodies);
  ~MujocoWorld();
  MujocoWorld(MujocoWorld&&) noexcept;
  MujocoWorld& operator=(MujocoWorld&&) noexcept;

  /// Makes every pair push only where it is deeper than now. Convex hulls of concave neighbours overlap where the
  /// objects do not, and springs that are pressed in from the start would shoot them apart.
  void accept_overlaps();

  int num_bodies() const;
  BodyState state(int body) const;

  /// Advances the world by one frame. A world whose numbers stopped being finite stands still.
  void step_frame();

  /// Whether numbers have stopped being finite: states are then meaningless.
  bool has_diverged() const;

 private:
  void go_on_paths();

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Simulates `scene` from its frame 0 as the other simulate() does; every driven object needs a path. The bodies'
/// inertia is that of one density, while Bullet's is that of their box. Also throws std::runtime_error when the numbers
/// stop being finite.
SceneRecording simulate(const SceneRecording& scene, const std::vector<Shape>& shapes, const MujocoSettings& settings,
                        int num_frames, int first_frame = 0, const std::vector<MotionPath>& paths = {});

}  // namespace rigidformer
