// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/baselines/mujoco_forecaster.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

#include "mujoco_scene.hpp"
#include "rigidformer/baselines/observed_body.hpp"
#include "rigidformer/simulation/observed_motion.hpp"

namespace rigidformer {
namespace {

constexpr int kSolverStepsPerFrame = 16;  // shorter steps make stiffer contacts (contact_spring.hpp); chosen by eye

struct Deleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using ModelPtr = std::unique_ptr<mjModel, Deleter>;
using DataPtr = std::unique_ptr<mjData, Deleter>;

/// Compiles the model of an XML text, which is handed over as a file in memory.
ModelPtr compile(const std::string& xml) {
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

/// Sets the state of a body. MuJoCo wants the velocity of the body's origin in world and the spin in the body's frame.
/// Starting half a kick of gravity back makes free flight exact, since bodies move by the velocity after the kick.
void set_state(const mjModel& model, mjData& data, int i, const BodyState& state) {
  const RigidTransform& T = state.T_world_object;
  const Eigen::Quaterniond& q = T.rotation;
  Eigen::Map<Eigen::Matrix<double, 7, 1>>(data.qpos + 7 * i) << T.translation, q.w(), q.x(), q.y(), q.z();
  const Eigen::Vector3d half_kick = 0.5 * model.opt.timestep * Eigen::Map<const Eigen::Vector3d>(model.opt.gravity);
  Eigen::Map<Eigen::Matrix<double, 6, 1>>(data.qvel + 6 * i) << state.velocity - half_kick,
      q.conjugate() * state.angular_velocity;
}

/// Makes every pair push only where it is deeper than at first. Convex hulls of concave neighbours overlap where the
/// objects do not, and springs that are pressed in from the start would shoot them apart.
void accept_overlaps(mjModel& model, mjData& data) {
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

RigidTransform pose(const mjData& data, int i) {
  const double* q = data.qpos + 7 * i;
  return {Eigen::Quaterniond(q[3], q[4], q[5], q[6]).normalized(), {q[0], q[1], q[2]}};
}

/// Tells whether numbers have stopped being finite: MuJoCo then resets the scene and counts a warning.
bool has_diverged(const mjData& data) {
  return data.warning[mjWARN_BADQPOS].number > 0 || data.warning[mjWARN_BADQVEL].number > 0 ||
         data.warning[mjWARN_BADQACC].number > 0;
}

}  // namespace

std::vector<std::vector<RigidTransform>> MujocoForecaster::forecast(const std::vector<ObjectState>& objects,
                                                                    const RolloutOptions& rollout) {
  const std::vector<ObservedBody> bodies = observe_bodies(objects, rollout);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].is_static) continue;
    throw std::invalid_argument("mujoco: object '" + objects[i].id + "' is static, which only bullet simulates");
  }
  const int substeps = kSolverStepsPerFrame * observed_world(rollout.time_step_s, rollout.gravity).substeps;
  mju_user_warning = [](const char*) {};  // else they go to a file in the current folder
  const ModelPtr model = compile(mujoco_scene(bodies, rollout.gravity, rollout.time_step_s / substeps));
  const DataPtr data(mj_makeData(model.get()));
  std::vector<std::vector<RigidTransform>> poses;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    set_state(*model, *data, static_cast<int>(i), bodies[i].state);
    poses.push_back({objects[i].T_world_current});
  }
  accept_overlaps(*model, *data);
  for (int k = 0; k < rollout.num_steps; ++k) {
    for (int substep = 0; substep < substeps && !has_diverged(*data); ++substep) mj_step(model.get(), data.get());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      poses[i].push_back(has_diverged(*data) ? poses[i].back()
                                             : reference_pose(bodies[i], pose(*data, static_cast<int>(i)), rollout));
    }
  }
  return poses;
}

}  // namespace rigidformer
