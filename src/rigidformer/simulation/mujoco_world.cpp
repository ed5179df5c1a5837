// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/mujoco_world.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstring>
#include <mutex>
#include <stdexcept>
#include <string>

#include "motion_path.hpp"
#include "mujoco_scene.hpp"

namespace rigidformer {
namespace {

struct Deleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using ModelPtr = std::unique_ptr<mjModel, Deleter>;
using DataPtr = std::unique_ptr<mjData, Deleter>;

/// Compiles the model of an XML text, which is handed over as a file in memory.
ModelPtr compile(const std::string& xml) {
  static std::mutex one_at_a_time;  // the reader of XML is not thread safe
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  mju_user_warning = [](const char*) {};  // else they go to a file in the current folder
  constexpr const char* kFile = "scene.xml";
  const auto files = std::make_unique<mjVFS>();  // 2 MB: too large for the stack
  mj_defaultVFS(files.get());
  const auto size = static_cast<int>(xml.size());
  char message[500] = "no room for the scene";
  ModelPtr model;
  if (mj_makeEmptyFileVFS(files.get(), kFile, size) == 0) {
    std::memcpy(files->filedata[mj_findFileVFS(files.get(), kFile)], xml.data(), xml.size());
    model.reset(mj_loadXML(kFile, files.get(), message, sizeof message));
  }
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error(std::string("mujoco: ") + message);
  return model;
}

void require_complete(const MujocoBody& body) {
  const BodyProperties& p = body.properties;
  if (body.parts.empty()) throw std::invalid_argument("mujoco: a body has no parts");
  if ((!p.mass_kg && !body.is_given()) || !p.friction || !p.restitution) {
    throw std::invalid_argument("mujoco: mass_kg, friction and restitution must be known");
  }
}

/// Sets the state of a body whose joint is number `joint`. MuJoCo wants the velocity of the body's origin in world and
/// the spin in the body's frame.
void set_state(mjData& data, int joint, const BodyState& state) {
  const RigidTransform& T = state.T_world_object;
  const Eigen::Quaterniond& q = T.rotation;
  Eigen::Map<Eigen::Matrix<double, 7, 1>>(data.qpos + 7 * joint) << T.translation, q.w(), q.x(), q.y(), q.z();
  Eigen::Map<Eigen::Matrix<double, 6, 1>>(data.qvel + 6 * joint) << state.velocity,
      q.conjugate() * state.angular_velocity;
}

/// Gravity does not act on body `id`.
void hold_up(const mjModel& model, mjData& data, int id) {
  for (int axis = 0; axis < 3; ++axis) {
    data.xfrc_applied[6 * id + axis] = -model.body_mass[id] * model.opt.gravity[axis];
  }
}

}  // namespace

struct MujocoWorld::Impl {
  ModelPtr model;
  DataPtr data;
  int substeps;
  std::vector<MujocoBody> bodies;  ///< Without their parts
  std::vector<int> joints;         ///< Number of every body's joint, -1 = it has none
  long steps_done = 0;
};

void MujocoSettings::validate() const {
  const auto require = [](bool fits, const char* field, double value, const char* bound) {
    if (fits) return;
    throw std::invalid_argument(std::string("mujoco: ") + field + " = " + std::to_string(value) + " must be " + bound);
  };
  require(frame_rate_hz > 0.0, "frame_rate_hz", frame_rate_hz, "> 0");
  require(substeps > 0, "substeps", substeps, "> 0");
  require(impedance > 0.0 && impedance < 1.0, "impedance", impedance, "in (0, 1)");
  require(friction_impedance > 0.0, "friction_impedance", friction_impedance, "> 0");
  require(gravity.allFinite(), "gravity", gravity.sum(), "finite");
}

MujocoWorld::MujocoWorld(const MujocoSettings& settings, const std::vector<MujocoBody>& bodies) {
  settings.validate();
  for (const MujocoBody& body : bodies) require_complete(body);
  ModelPtr model = compile(mujoco_scene(bodies, settings));
  DataPtr data(mj_makeData(model.get()));
  impl_.reset(new Impl{std::move(model), std::move(data), settings.substeps, bodies, {}});
  int num_joints = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    impl_->bodies[i].parts.clear();
    impl_->joints.push_back(bodies[i].is_static ? -1 : num_joints++);
    if (!bodies[i].is_static) set_state(*impl_->data, impl_->joints[i], bodies[i].state);
    if (bodies[i].path) hold_up(*impl_->model, *impl_->data, static_cast<int>(i) + 1);
  }
  go_on_paths();
}
MujocoWorld::~MujocoWorld() = default;
MujocoWorld::MujocoWorld(MujocoWorld&&) noexcept = default;
MujocoWorld& MujocoWorld::operator=(MujocoWorld&&) noexcept = default;

void MujocoWorld::accept_overlaps() {
  mjModel& model = *impl_->model;
  mjData& data = *impl_->data;
  mj_fwdPosition(&model, &data);
  for (int c = 0; c < data.ncon; ++c) {
    const mjContact& contact = data.contact[c];
    const auto [low, high] = std::minmax(contact.geom1, contact.geom2);
    for (int pair = 0; pair < model.npair; ++pair) {
      const auto [pair_low, pair_high] = std::minmax(model.pair_geom1[pair], model.pair_geom2[pair]);
      if (pair_low == low && pair_high == high) {
        model.pair_gap[pair] = std::max(model.pair_gap[pair], -contact.dist);
      }
    }
  }
}

int MujocoWorld::num_bodies() const { return static_cast<int>(impl_->bodies.size()); }

BodyState MujocoWorld::state(int body) const {
  const int joint = impl_->joints.at(static_cast<std::size_t>(body));
  if (joint < 0) return {impl_->bodies[static_cast<std::size_t>(body)].state.T_world_object};
  const double* q = impl_->data->qpos + 7 * joint;
  const double* v = impl_->data->qvel + 6 * joint;
  BodyState state;
  state.T_world_object = {Eigen::Quaterniond(q[3], q[4], q[5], q[6]).normalized(), {q[0], q[1], q[2]}};
  state.velocity = {v[0], v[1], v[2]};
  state.angular_velocity = state.T_world_object.rotation * Eigen::Vector3d(v[3], v[4], v[5]);
  return state;
}

void MujocoWorld::step_frame() {
  for (int i = 0; i < impl_->substeps && !has_diverged(); ++i) {
    mj_step(impl_->model.get(), impl_->data.get());
    ++impl_->steps_done;
    go_on_paths();
  }
}

/// Takes what follows a path to where that is, on its way to where it will be.
void MujocoWorld::go_on_paths() {
  const double step_s = impl_->model->opt.timestep;
  for (std::size_t i = 0; i < impl_->bodies.size(); ++i) {
    const MotionPath& path = impl_->bodies[i].path;
    if (path) set_state(*impl_->data, impl_->joints[i], state_on(path, step_s * impl_->steps_done, step_s));
  }
}

/// MuJoCo resets a scene whose numbers stopped being finite, and counts a warning.
bool MujocoWorld::has_diverged() const {
  const mjWarningStat* warning = impl_->data->warning;
  return warning[mjWARN_BADQPOS].number > 0 || warning[mjWARN_BADQVEL].number > 0 || warning[mjWARN_BADQACC].number > 0;
}

}  // namespace rigidformer
