// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/doubt.hpp"

#include <algorithm>
#include <cmath>

#include "rigidformer/engine/observed_solid.hpp"

namespace rigidformer {
namespace {

constexpr int kFixedPoints = 3;  // rounds in which a mean rotation settles; the angles between particles are small

Eigen::Quaterniond mean_rotation(const std::vector<RigidTransform>& poses) {
  Eigen::Quaterniond mean = poses.front().rotation;
  for (int round = 0; round < kFixedPoints; ++round) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const RigidTransform& pose : poses) sum += rotation_vector(pose.rotation * mean.conjugate());
    mean = (rotation_about(sum / static_cast<double>(poses.size())) * mean).normalized();
  }
  return mean;
}

bool is_known(const BodyProperties& properties) { return properties.friction && properties.restitution; }

}  // namespace

std::vector<Knowledge> knowledge_of(const std::vector<CandidateObject>& objects,
                                    const std::vector<ObservedSolid>& solids) {
  std::vector<Knowledge> knowledge;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const bool is_seen = k < solids.size() && solids[k].complete;
    const bool is_of_known_material = is_known(objects[k].state.properties);
    knowledge.push_back(!is_seen               ? Knowledge::kOneSide
                        : is_of_known_material ? Knowledge::kMaterial
                                               : Knowledge::kShape);
  }
  return knowledge;
}

MotionProgress progress_of(const std::vector<RigidTransform>& poses, int first_contact, std::size_t step,
                           double time_step_s) {
  MotionProgress progress{Phase::kFree, static_cast<double>(step) * time_step_s, kLeastSpeed_mps};
  for (std::size_t i = 1; i <= std::max<std::size_t>(step, 1) && i < poses.size(); ++i) {
    const double speed_mps = (poses[i].translation - poses[i - 1].translation).norm() / time_step_s;
    progress.speed_mps = std::max(progress.speed_mps, speed_mps);
  }
  if (first_contact < 0 || static_cast<std::size_t>(first_contact) > step) return progress;
  progress.time_s -= first_contact * time_step_s;
  SettleCriterion rest;
  rest.duration_s = 0.0;
  const bool rests = step > 0 && settled_step({poses[step - 1], poses[step]}, time_step_s, rest) == 0;
  progress.phase = rests ? Phase::kResting : Phase::kContact;
  return progress;
}

Doubt spread_of(const std::vector<RigidTransform>& poses) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const RigidTransform& pose : poses) mean += pose.translation / static_cast<double>(poses.size());
  const Eigen::Quaterniond mean_turn = mean_rotation(poses);
  double position = 0.0, rotation = 0.0;
  for (const RigidTransform& pose : poses) {
    position += (pose.translation - mean).squaredNorm();
    rotation += rotation_vector(pose.rotation * mean_turn.conjugate()).squaredNorm();
  }
  const double coordinates = 3.0 * (static_cast<double>(poses.size()) - 1.0);
  return {std::sqrt(position / coordinates), std::sqrt(rotation / coordinates)};
}

Doubt total_doubt(const DoubtCell& cell, double speed_mps, const std::optional<Doubt>& spread) {
  if (!spread) return {cell.alone.position_m * speed_mps, cell.alone.rotation_rad * speed_mps};
  return {std::hypot(cell.beside.position_m * speed_mps, cell.position_spread_scale * spread->position_m),
          std::hypot(cell.beside.rotation_rad * speed_mps, cell.rotation_spread_scale * spread->rotation_rad)};
}

std::optional<Doubt> nothing_spreads(std::size_t, std::size_t) { return {}; }

void add_doubt(const DoubtTable& table, const std::vector<Knowledge>& knowledge, const std::vector<MotionMode>& modes,
               const Spread& spread, Forecast& forecast) {
  if (forecast.times_s.size() < 2) return;
  for (std::size_t k = 0; k < forecast.objects.size(); ++k) {
    ObjectTrajectory& object = forecast.objects[k];
    if (modes[k] != MotionMode::kDynamic) continue;  // nobody doubts what is given
    const int first_contact = first_contact_step(forecast, static_cast<int>(k));
    for (std::size_t step = object.position_stddev_m.size(); step < object.poses.size(); ++step) {
      const MotionProgress progress = progress_of(object.poses, first_contact, step, forecast.times_s[1]);
      const DoubtCell cell = table.at(knowledge[k], progress.phase, progress.time_s);
      const Doubt doubt = total_doubt(cell, progress.speed_mps, spread(k, step));
      object.position_stddev_m.push_back(doubt.position_m);
      object.rotation_stddev_rad.push_back(doubt.rotation_rad);
    }
  }
}

}  // namespace rigidformer
