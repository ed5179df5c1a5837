// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <array>
#include <functional>
#include <vector>

/// Tensor letters, used in every shape comment of model, windows and training:
///   B scenes in a batch, K objects (padded), N points per object (padded), A anchors per object,
///   R register tokens, D token width, E encoder backbone width, F features per vertex, H heads, C channels.
namespace rigidformer {

using torch::Tensor;

/// Simulation frames per second, as in the MOVi scenes. One frame is the unit of the step size
/// s: time step = s / kFrameRateHz.
constexpr double kFrameRateHz = 240.0;

/// Ground height that stands for "no ground" [m]: far below any scene, chosen by eye.
constexpr double kNoGround = -1000.0;

/// Numbers that tell what the ground is made of: friction, restitution, and which of them is known.
constexpr std::int64_t kGroundCode = 4;

/// A batch of rigid poses T_world_reference.
struct Pose {
  Tensor rotation;     ///< [B, K, 3, 3]
  Tensor translation;  ///< [B, K, 3] m

  /// Applies the poses to points [B, K, *, 3] given in the reference frame.
  Tensor apply(const Tensor& points_reference) const;

  Pose to(const torch::Device& device) const;
};

/// What stays the same during a rollout. Points are in farthest-point order, valid ones first.
struct SceneBatch {
  Tensor points_reference;  ///< [B, K, N, 3] m
  Tensor point_mask;        ///< [B, K, N] bool, true = valid
  Tensor object_mask;       ///< [B, K] bool, true = an object is there
  Tensor surface_points;    ///< [B, K, M, 3] m, all that was seen, for the engine; undefined = points_reference
  Tensor surface_mask;      ///< [B, K, M] bool
  Tensor hidden_points;     ///< [B, K, P, 3] m, guessed on the sides that nobody sees; valid as the first points are
  Tensor anchor_index;      ///< [B, K, A] int64, which points are the anchors
  Tensor properties;        ///< [B, K, 3] mass [kg], friction, restitution; 0 where unknown
  Tensor properties_known;  ///< [B, K, 3] 1 where known, else 0
  Tensor dynamic_mask;      ///< [B, K] bool, false = motion is given (static, kinematic)
  Tensor step_size;         ///< [B] s in frames
  Tensor ground_height;     ///< [B] m, kNoGround = none
  Tensor gravity;           ///< [B] vertical acceleration [m/s^2]
  Tensor control;           ///< [B, control_dim] or undefined
  Tensor ground_material;   ///< [B, 2] friction, restitution of the ground; 0 where unknown; undefined = unknown
  Tensor ground_known;      ///< [B, 2] 1 where known, else 0

  /// [B, K, N, 3] outward unit normals, estimated from the points; undefined where no model needs them.
  Tensor normals_reference;

  std::int64_t num_scenes() const { return points_reference.size(0); }
  std::int64_t max_objects() const { return points_reference.size(1); }
  std::int64_t max_points() const { return points_reference.size(2); }

  Tensor time_step() const;          ///< [B] s
  Tensor anchors_reference() const;  ///< [B, K, A, 3]
  Tensor ground_code() const;        ///< [B, kGroundCode] material of the ground as the network reads it

  /// With every tensor on that device; what is undefined stays so.
  SceneBatch to(const torch::Device& device) const;
};

/// All tensors of a batch: whatever does the same with each of them goes through this list.
constexpr std::array kBatchTensors{
    &SceneBatch::points_reference, &SceneBatch::normals_reference, &SceneBatch::point_mask,
    &SceneBatch::object_mask,      &SceneBatch::surface_points,    &SceneBatch::surface_mask,
    &SceneBatch::hidden_points,    &SceneBatch::anchor_index,      &SceneBatch::properties,
    &SceneBatch::properties_known, &SceneBatch::dynamic_mask,      &SceneBatch::step_size,
    &SceneBatch::ground_height,    &SceneBatch::gravity,           &SceneBatch::control,
    &SceneBatch::ground_material,  &SceneBatch::ground_known};
static_assert(sizeof(SceneBatch) == kBatchTensors.size() * sizeof(Tensor), "a tensor of the batch is not in the list");

/// What changes from step to step.
struct SceneState {
  Pose first;        ///< First frame of the sequence: x_ref of the paper
  Pose previous;     ///< t - 1
  Pose current;      ///< t
  Pose coming = {};  ///< t + 1 of objects whose motion is given; undefined = they keep their twist (given_motion.hpp)

  SceneState to(const torch::Device& device) const;
};

/// For every vertex, the nearest point of another object.
struct Nearest {
  Tensor index;  ///< [B, K, N] int64 into the flattened (K * N) points of the scene
  Tensor found;  ///< [B, K, N] bool, false where there is no other object (or the vertex is padding)
};

/// Finds the nearest points of other objects for world points [B, K, N, 3]. Poses are given for searches that
/// keep one tree per rigid object.
using NearestSearch = std::function<Nearest(const SceneBatch&, const Pose& current, const Tensor& points_world)>;

/// Two objects of a scene that press on each other during a step.
struct PressedPair {
  std::int64_t scene = 0, object = 0, partner = -1;  ///< Indices b and k; partner -1 = the ground
  double normal_impulse_Ns = 0.0;                    ///< Sum over the step, with estimates of unknown masses
};

/// The next step as a physics engine makes it, with one guess of what is unknown.
struct EngineMotion {
  Pose pose;       ///< Pose at t + 1
  Pose departure;  ///< Pose at t from which free motion arrives at `pose` with the velocity that the engine gives it
  std::vector<PressedPair> pressed = {};
};

/// One step of a physics engine on the objects of a batch, as each of its advisers makes it (ModelOptions::advisers).
using EngineStep = std::function<std::vector<EngineMotion>(const SceneState&)>;

/// Where surfaces meet during a step of free motion: C contacts of all scenes of a batch, each told once per side that
/// can move. What the bodies are made of comes along, because a hull is known only to whoever searches for contacts.
struct Contacts {
  Tensor scene, object;  ///< [C] int64, indices b and k of the own side
  Tensor partner;        ///< [C] int64, index k of the other side; -1 = the ground
  Tensor point;          ///< [C, 3] m, on the own surface, seen from the own centre of mass, world axes
  Tensor partner_point;  ///< [C, 3] m, the same of the other side; 0 for the ground
  Tensor normal;         ///< [C, 3] unit, from the other side to the own one
  Tensor fraction;       ///< [C] when they meet: 0 = now, 1 = at the end of the step
  Tensor gap;            ///< [C] m between the surfaces at that time, negative = overlap
  Tensor mass;           ///< [B, K] kg; an estimate where it is unknown
  Tensor
      inverse_inertia;  ///< [B, K, 3, 3] 1/m^2 per unit of mass, about the centre of mass, axes of the reference frame

  std::int64_t count() const { return scene.size(0); }
};

/// Finds the contacts of a step that leads from one pose of every object to another by free motion.
using ContactSearch = std::function<Contacts(const Pose& from, const Pose& to)>;

/// Picks rows along dimension 2: values [B, K, N, C], index [B, K, A] -> [B, K, A, C].
Tensor gather_points(const Tensor& values, const Tensor& index);

/// Picks rows of the flattened scene: values [B, K, N, C], index [B, K, N] into K * N -> [B, K, N, C].
Tensor gather_scene_points(const Tensor& values, const Tensor& index);

}  // namespace rigidformer
