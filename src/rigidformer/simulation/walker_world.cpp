// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "walker_world.hpp"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>

#include "bullet_conversion.hpp"

namespace rigidformer {
namespace {

constexpr double kGravity_mps2 = -10.0;  // as in the MOVi scenes
constexpr double kStartGap_m = 0.03;     // between feet and floor at the start
constexpr int kSolverIterations = 60;    // chosen by eye: joints open by less than a millimetre
// The motors; chosen by eye so that ten kilograms are carried with ease.
constexpr double kMaxTorque_Nm = 80.0, kGain_hz = 30.0, kMaxSpeed_radps = 15.0;
constexpr int kFloorGroup = 1, kPartGroup = 2;

struct PartBody {
  std::unique_ptr<btBoxShape> shape;
  std::unique_ptr<btRigidBody> body;
};

PartBody make_part(const WalkerPart& part, const RigidTransform& T_world_torso) {
  PartBody made;
  made.shape = std::make_unique<btBoxShape>(to_bullet(part.half_extents_m));
  const auto mass = static_cast<btScalar>(part.mass_kg);
  btVector3 inertia(0, 0, 0);
  made.shape->calculateLocalInertia(mass, inertia);
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, made.shape.get(), inertia);
  info.m_friction = static_cast<btScalar>(kWalkerFriction);
  info.m_restitution = static_cast<btScalar>(kWalkerRestitution);
  info.m_startWorldTransform = to_bullet(T_world_torso * part.T_torso_part);
  made.body = std::make_unique<btRigidBody>(info);
  made.body->setActivationState(DISABLE_DEACTIVATION);
  return made;
}

/// Frame whose z axis is the hinge's.
RigidTransform hinge_frame(const WalkerHinge& hinge) {
  return {Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), hinge.axis), hinge.point};
}

}  // namespace

struct WalkerWorld::Impl {
  Impl() : dispatcher(&configuration), world(&dispatcher, &broadphase, &solver, &configuration) {
    world.setGravity(btVector3(0, 0, static_cast<btScalar>(kGravity_mps2)));
    world.getSolverInfo().m_numIterations = kSolverIterations;
    floor.setFriction(1);
    world.addRigidBody(&floor, kFloorGroup, kPartGroup);
  }
  ~Impl() {
    for (const auto& hinge : hinges) world.removeConstraint(hinge.get());
    for (const PartBody& part : parts) world.removeRigidBody(part.body.get());
    world.removeRigidBody(&floor);
  }

  void add_hinge(const WalkerDesign& design, const WalkerHinge& hinge) {
    const auto parent = static_cast<std::size_t>(hinge.parent), child = static_cast<std::size_t>(hinge.child);
    const RigidTransform frame = hinge_frame(hinge);
    // Of the two conventions of Bullet, this one counts angles as the child turns against the parent.
    constexpr bool kUseReferenceFrameA = true;
    hinges.push_back(std::make_unique<btHingeConstraint>(
        *parts[parent].body, *parts[child].body, to_bullet(design.parts[parent].T_torso_part.inverse() * frame),
        to_bullet(design.parts[child].T_torso_part.inverse() * frame), kUseReferenceFrameA));
    world.addConstraint(hinges.back().get(), true);
  }

  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world;
  btStaticPlaneShape floor_shape{btVector3(0, 0, 1), 0};
  btRigidBody floor{btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &floor_shape)};
  std::vector<PartBody> parts;
  std::vector<std::unique_ptr<btHingeConstraint>> hinges;
};

WalkerWorld::WalkerWorld(const WalkerDesign& design, double yaw_rad) : impl_(std::make_unique<Impl>()) {
  const RigidTransform T_world_torso{Eigen::Quaterniond(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ())),
                                     {0.0, 0.0, design.height_m + kStartGap_m}};
  for (const WalkerPart& part : design.parts) {
    impl_->parts.push_back(make_part(part, T_world_torso));
    impl_->world.addRigidBody(impl_->parts.back().body.get(), kPartGroup, kFloorGroup);
  }
  for (const WalkerHinge& hinge : design.hinges) impl_->add_hinge(design, hinge);
}
WalkerWorld::~WalkerWorld() = default;

void WalkerWorld::step(const std::vector<double>& angles, double time_step_s) {
  for (std::size_t i = 0; i < impl_->hinges.size(); ++i) {
    btHingeConstraint& hinge = *impl_->hinges[i];
    const double speed = std::clamp(kGain_hz * (angles.at(i) - static_cast<double>(hinge.getHingeAngle())),
                                    -kMaxSpeed_radps, kMaxSpeed_radps);
    hinge.enableAngularMotor(true, static_cast<btScalar>(speed), static_cast<btScalar>(kMaxTorque_Nm * time_step_s));
  }
  impl_->world.stepSimulation(static_cast<btScalar>(time_step_s), 0);
}

RigidTransform WalkerWorld::T_world_part(std::size_t part) const {
  return from_bullet(impl_->parts.at(part).body->getWorldTransform());
}

double WalkerWorld::yaw_rad() const {
  const Eigen::Vector3d ahead = T_world_part(0).rotation * Eigen::Vector3d::UnitX();
  return std::atan2(ahead.y(), ahead.x());
}

}  // namespace rigidformer
