// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "rigidformer/scene/recording.hpp"
#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// Settings of the Bullet world of the MOVi scenes. Each was checked against published scenes:
/// test/rigidformer/simulation/movi_fidelity_test.cpp follows some of them.
struct BulletSettings {
  double frame_rate_hz = 240.0;              ///< Frames per second of the recording
  int substeps = 10;                         ///< Solver steps per frame
  Eigen::Vector3d gravity{0.0, 0.0, -10.0};  ///< [m/s^2]
  double floor_friction = 0.3;               ///< Coulomb coefficient of the floor
  double floor_restitution = 0.5;
  double hull_margin_m = 0.001;          ///< Collision margin around convex hulls
  int solver_iterations = 50;            ///< Iterations of the solver per solver step
  double contact_erp = 0.08;             ///< Share of a penetration that is removed per solver step (Bullet's erp2)
  double friction_erp = 0.2;             ///< Share of a friction error that is removed per solver step
  double least_squares_residual = 1e-7;  ///< Residual below which the solver's iterations stop
  double contact_cfm = 0.0;        ///< Softness of contacts and friction (Bullet's global constraint force mixing)
  double rolling_friction = 0.0;   ///< Lever arm of the friction that stops rolling, as a share of the radius
  double spinning_friction = 0.0;  ///< The same for spinning; Bullet looks at it only where rolling has friction

  /// Throws std::invalid_argument naming field and value.
  void validate() const;
};

/// Motion of one body at one instant.
struct BodyState {
  RigidTransform T_world_object;                               ///< Pose of the body; its origin is its centre of mass
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< Velocity of the centre of mass [m/s]
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< Angular velocity in world [rad/s]
};

/// Where a body is at a time [s].
using MotionPath = std::function<RigidTransform(double time_s)>;

/// A shape made ready for collisions. Worlds only read it, so that any number of bodies in any number of worlds and
/// threads may share one: making it takes longer than simulating a body for many steps.
class CollisionShape {
 public:
  /// `shape` scaled by `size`. Throws std::invalid_argument for a shape without parts and a size that is not positive.
  CollisionShape(const Shape& shape, double size, double hull_margin_m = BulletSettings().hull_margin_m);
  ~CollisionShape();
  CollisionShape(CollisionShape&&) noexcept;

 private:
  friend class BulletWorld;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Two bodies that pressed on each other within one frame.
struct PressedBodies {
  int body_a = 0;
  int body_b = -1;                 ///< -1 = the floor
  double normal_impulse_Ns = 0.0;  ///< Sum over all contact points and solver steps of the frame
};

/// Rigid bodies above the floor plane z = 0, stepped frame by frame. A world is not thread safe; worlds
/// are independent of each other.
class BulletWorld {
 public:
  explicit BulletWorld(const BulletSettings& settings);
  ~BulletWorld();
  BulletWorld(BulletWorld&&) noexcept;
  BulletWorld& operator=(BulletWorld&&) noexcept;

  /// Adds a body of `shape` scaled by `size` and returns its index. Mass, friction and restitution must be set. Throws
  /// std::invalid_argument naming what is missing or not positive.
  int add_body(const Shape& shape, double size, const BodyProperties& properties, const BodyState& state);

  int add_body(std::shared_ptr<const CollisionShape> shape, const BodyProperties& properties, const BodyState& state);

  /// Adds a body that keeps its velocity: nothing can push it, and gravity does not act on it. Its mass is not read.
  int add_driven_body(const Shape& shape, double size, BodyProperties properties, const BodyState& state);
  int add_driven_body(std::shared_ptr<const CollisionShape> shape, BodyProperties properties, const BodyState& state);

  /// Has a driven body follow a path whose time 0 is now: it is on it before and after every solver step. From now on
  /// it passes through the floor and through what follows a path as well.
  void follow(int body, MotionPath path);

  /// Removes the body added last.
  void remove_last_body();

  int num_bodies() const;
  BodyState state(int body) const;
  void set_state(int body, const BodyState& state);

  /// A body that sleeps is left where it is, with no velocity, until something that is awake comes to touch it, be it
  /// over others that sleep. Bodies are awake unless they are told to sleep.
  void set_asleep(int body, bool asleep);

  /// True when the body touches or penetrates another body; the floor does not count.
  bool overlaps_any(int body) const;

  /// Advances the world by one frame.
  void step_frame();

  /// The pairs that pressed on each other within the last frame, in the order in which they met.
  const std::vector<PressedBodies>& pressed() const;

 private:
  void go_on_paths();

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Makes a world that holds the objects of `scene` as they are at `frame`. Velocities absent from the
/// recording are taken as zero. Static objects stay where they are, driven ones keep their velocity. Throws
/// std::invalid_argument when a shape is missing from `shapes` or `frame` lies outside the recording.
BulletWorld make_world(const SceneRecording& scene, const std::vector<Shape>& shapes, const BulletSettings& settings,
                       int frame = 0);

/// Simulates `scene` from its frame 0 and returns a copy with `num_frames` frames of poses and velocities, the first of
/// them `first_frame` frames after the start. `paths` are those of its driven objects, one per object, empty for the
/// others; their time 0 is the first recorded frame. Without them, driven objects keep their velocity.
SceneRecording simulate(const SceneRecording& scene, const std::vector<Shape>& shapes, const BulletSettings& settings,
                        int num_frames, int first_frame = 0, const std::vector<MotionPath>& paths = {});

}  // namespace rigidformer
