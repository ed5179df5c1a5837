// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/bullet_world.hpp"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "bullet_conversion.hpp"
#include "motion_path.hpp"
#include "telling_solver.hpp"

namespace rigidformer {
namespace {

constexpr double kFloorHalfWidth = 50.0;  // [m] farther than objects can roll in a scene; chosen by eye
constexpr double kFloorHalfHeight = 1.0;  // [m] chosen by eye
constexpr double kImmovableMass = 1e6;    // [kg] so heavy that objects of a scene cannot push it; chosen by eye

void require_positive(const char* field, double value) {
  if (!(value > 0.0)) throw std::invalid_argument(std::string(field) + " = " + std::to_string(value) + " must be > 0");
}

double require_known(const char* field, const std::optional<double>& value) {
  if (!value || !(*value >= 0.0)) throw std::invalid_argument(std::string(field) + " must be known and >= 0");
  return *value;
}

struct Body {
  std::shared_ptr<const CollisionShape> shape;
  std::unique_ptr<btRigidBody> body;
  MotionPath path = {};  ///< Empty = none is followed
  long path_start = 0;   ///< Solver steps of the world before it
};

std::unique_ptr<btConvexHullShape> make_hull(const ConvexPart& part, double size, double margin) {
  auto hull = std::make_unique<btConvexHullShape>();
  for (Eigen::Index i = 0; i < part.vertices.rows(); ++i) {
    hull->addPoint(to_bullet(size * part.vertices.row(i).transpose().cast<double>()), false);
  }
  hull->recalcLocalAabb();
  hull->optimizeConvexHull();
  hull->setMargin(static_cast<btScalar>(margin));
  return hull;
}

void apply_settings(const BulletSettings& settings, btContactSolverInfo& solver) {
  solver.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS | SOLVER_DISABLE_IMPLICIT_CONE_FRICTION;
  solver.m_solverMode &= ~SOLVER_USE_WARMSTARTING;
  solver.m_splitImpulse = 1;
  solver.m_linearSlop = 0;
  solver.m_restitutionVelocityThreshold = 0;
  solver.m_numIterations = settings.solver_iterations;
  solver.m_erp2 = static_cast<btScalar>(settings.contact_erp);
  solver.m_globalCfm = static_cast<btScalar>(settings.contact_cfm);
  solver.m_frictionCFM = static_cast<btScalar>(settings.contact_cfm);
  solver.m_frictionERP = static_cast<btScalar>(settings.friction_erp);
  solver.m_leastSquaresResidualThreshold = static_cast<btScalar>(settings.least_squares_residual);
}

/// Bullet sets aside room for 4,096 contacts, 4 MB per world, unless it is told otherwise. Beyond the pools it
/// allocates.
btDefaultCollisionConstructionInfo small_pools() {
  constexpr int kPooled = 256;  // pairs of about 20 objects that touch; changes speed and memory only; chosen by eye
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = info.m_defaultMaxCollisionAlgorithmPoolSize = kPooled;
  return info;
}

struct OverlapCallback : btCollisionWorld::ContactResultCallback {
  bool overlap = false;
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    overlap = overlap || point.getDistance() <= 0;
    return 0;
  }
};

}  // namespace

struct CollisionShape::Impl {
  std::vector<std::unique_ptr<btConvexHullShape>> hulls;
  btCompoundShape compound;
  double radius_m = 0.0;  ///< Of the farthest corner from the origin
};

CollisionShape::CollisionShape(const Shape& shape, double size, double hull_margin_m)
    : impl_(std::make_unique<Impl>()) {
  require_positive("size", size);
  if (shape.parts.empty()) throw std::invalid_argument("shape '" + shape.name + "' has no parts");
  for (const ConvexPart& part : shape.parts) {
    impl_->hulls.push_back(make_hull(part, size, hull_margin_m));
    impl_->compound.addChildShape(btTransform::getIdentity(), impl_->hulls.back().get());
  }
  impl_->compound.setMargin(static_cast<btScalar>(hull_margin_m));
  impl_->radius_m = size * static_cast<double>(shape.vertices().rowwise().norm().maxCoeff());
}
CollisionShape::~CollisionShape() = default;
CollisionShape::CollisionShape(CollisionShape&&) noexcept = default;

struct BulletWorld::Impl {
  explicit Impl(const BulletSettings& world_settings)
      : settings(world_settings),
        configuration(small_pools()),
        dispatcher(&configuration),
        world(&dispatcher, &broadphase, &solver, &configuration),
        floor_shape(btVector3(kFloorHalfWidth, kFloorHalfWidth, kFloorHalfHeight)),
        floor(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &floor_shape)) {
    world.setGravity(to_bullet(settings.gravity));
    apply_settings(settings, world.getSolverInfo());
    floor.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, -kFloorHalfHeight)));
    floor.setFriction(static_cast<btScalar>(settings.floor_friction));
    floor.setRestitution(static_cast<btScalar>(settings.floor_restitution));
    floor.setContactProcessingThreshold(0);
    world.addRigidBody(&floor);
  }

  ~Impl() {
    for (const Body& body : bodies) world.removeRigidBody(body.body.get());
    world.removeRigidBody(&floor);
  }

  BulletSettings settings;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  btDbvtBroadphase broadphase;
  TellingSolver solver;
  mutable btDiscreteDynamicsWorld world;
  btBoxShape floor_shape;
  btRigidBody floor;
  /// Bullet leaves whom it wakes about to sleep again, even in motion; here nobody falls asleep unasked.
  void keep_awake() {
    for (const Body& body : bodies) {
      if (body.body->getActivationState() != ISLAND_SLEEPING) body.body->forceActivationState(DISABLE_DEACTIVATION);
    }
  }

  std::vector<Body> bodies;
  long steps_done = 0;  ///< Of the solver
};

void BulletSettings::validate() const {
  require_positive("frame_rate_hz", frame_rate_hz);
  require_positive("substeps", substeps);
  require_positive("solver_iterations", solver_iterations);
  if (!gravity.allFinite()) throw std::invalid_argument("gravity must be finite");
}

BulletWorld::BulletWorld(const BulletSettings& settings) {
  settings.validate();
  impl_ = std::make_unique<Impl>(settings);
}
BulletWorld::~BulletWorld() = default;
BulletWorld::BulletWorld(BulletWorld&&) noexcept = default;
BulletWorld& BulletWorld::operator=(BulletWorld&&) noexcept = default;

int BulletWorld::add_body(const Shape& shape, double size, const BodyProperties& properties, const BodyState& state) {
  return add_body(std::make_shared<CollisionShape>(shape, size, impl_->settings.hull_margin_m), properties, state);
}

int BulletWorld::add_body(std::shared_ptr<const CollisionShape> shape, const BodyProperties& properties,
                          const BodyState& state) {
  const auto mass = static_cast<btScalar>(require_known("mass_kg", properties.mass_kg));
  require_positive("mass_kg", mass);
  btCompoundShape& compound = shape->impl_->compound;
  btVector3 inertia(0, 0, 0);
  compound.calculateLocalInertia(mass, inertia);
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &compound, inertia);
  info.m_friction = static_cast<btScalar>(require_known("friction", properties.friction));
  info.m_restitution = static_cast<btScalar>(require_known("restitution", properties.restitution));
  info.m_linearDamping = info.m_angularDamping = 0;
  info.m_rollingFriction = static_cast<btScalar>(impl_->settings.rolling_friction * shape->impl_->radius_m);
  info.m_spinningFriction = static_cast<btScalar>(impl_->settings.spinning_friction * shape->impl_->radius_m);
  Body body{std::move(shape), std::make_unique<btRigidBody>(info)};
  body.body->setActivationState(DISABLE_DEACTIVATION);
  body.body->setContactProcessingThreshold(0);
  body.body->setUserIndex(num_bodies());
  impl_->world.addRigidBody(body.body.get());
  impl_->bodies.push_back(std::move(body));
  set_state(num_bodies() - 1, state);
  return num_bodies() - 1;
}

int BulletWorld::add_driven_body(const Shape& shape, double size, BodyProperties properties, const BodyState& state) {
  return add_driven_body(std::make_shared<CollisionShape>(shape, size, impl_->settings.hull_margin_m), properties,
                         state);
}

int BulletWorld::add_driven_body(std::shared_ptr<const CollisionShape> shape, BodyProperties properties,
                                 const BodyState& state) {
  properties.mass_kg = kImmovableMass;
  const int body = add_body(std::move(shape), properties, state);
  impl_->bodies.back().body->setGravity(btVector3(0, 0, 0));
  return body;
}

void BulletWorld::follow(int body, MotionPath path) {
  Body& follower = impl_->bodies.at(static_cast<std::size_t>(body));
  follower.path = std::move(path);
  follower.path_start = impl_->steps_done;
  btBroadphaseProxy& proxy = *follower.body->getBroadphaseProxy();
  proxy.m_collisionFilterGroup = btBroadphaseProxy::StaticFilter;
  proxy.m_collisionFilterMask = btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter;
  go_on_paths();
}

/// Takes what follows a path to where that is, on its way to where it will be.
void BulletWorld::go_on_paths() {
  const double step_s = 1.0 / (impl_->settings.frame_rate_hz * impl_->settings.substeps);
  for (int i = 0; i < num_bodies(); ++i) {
    const Body& body = impl_->bodies[static_cast<std::size_t>(i)];
    if (body.path) set_state(i, state_on(body.path, step_s * (impl_->steps_done - body.path_start), step_s));
  }
}

void BulletWorld::remove_last_body() {
  if (impl_->bodies.empty()) throw std::invalid_argument("remove_last_body: the world has no bodies");
  impl_->world.removeRigidBody(impl_->bodies.back().body.get());
  impl_->bodies.pop_back();
}

int BulletWorld::num_bodies() const { return static_cast<int>(impl_->bodies.size()); }

BodyState BulletWorld::state(int body) const {
  const btRigidBody& rigid = *impl_->bodies.at(static_cast<std::size_t>(body)).body;
  return {from_bullet(rigid.getWorldTransform()), from_bullet(rigid.getLinearVelocity()),
          from_bullet(rigid.getAngularVelocity())};
}

void BulletWorld::set_state(int body, const BodyState& state) {
  btRigidBody& rigid = *impl_->bodies.at(static_cast<std::size_t>(body)).body;
  rigid.setCenterOfMassTransform(to_bullet(state.T_world_object));
  rigid.setLinearVelocity(to_bullet(state.velocity));
  rigid.setAngularVelocity(to_bullet(state.angular_velocity));
  impl_->world.updateSingleAabb(&rigid);
}

void BulletWorld::set_asleep(int body, bool asleep) {
  impl_->bodies.at(static_cast<std::size_t>(body))
      .body->forceActivationState(asleep ? ISLAND_SLEEPING : DISABLE_DEACTIVATION);
}

bool BulletWorld::overlaps_any(int body) const {
  btRigidBody* rigid = impl_->bodies.at(static_cast<std::size_t>(body)).body.get();
  for (const Body& other : impl_->bodies) {
    if (other.body.get() == rigid) continue;
    OverlapCallback callback;
    impl_->world.contactPairTest(rigid, other.body.get(), callback);
    if (callback.overlap) return true;
  }
  return false;
}

void BulletWorld::step_frame() {
  const double time_step_s = 1.0 / (impl_->settings.frame_rate_hz * impl_->settings.substeps);
  impl_->solver.pressed.clear();
  for (int i = 0; i < impl_->settings.substeps; ++i) {
    impl_->world.stepSimulation(static_cast<btScalar>(time_step_s), 0);
    impl_->keep_awake();
    ++impl_->steps_done;
    go_on_paths();
  }
}

const std::vector<PressedBodies>& BulletWorld::pressed() const { return impl_->solver.pressed; }

}  // namespace rigidformer
