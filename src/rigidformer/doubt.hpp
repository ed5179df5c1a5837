// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "rigidformer/candidate_objects.hpp"
#include "rigidformer/model/doubt_table.hpp"
#include "rigidformer/rollout.hpp"

namespace rigidformer {

struct ObservedSolid;

/// Of every object; without solids nobody knows whether more than one side was seen.
std::vector<Knowledge> knowledge_of(const std::vector<CandidateObject>& objects,
                                    const std::vector<ObservedSolid>& solids);

/// What an object has gone through up to a step: errors begin with a contact, and grow with the speed that it had.
struct MotionProgress {
  Phase phase = Phase::kFree;
  double time_s = 0.0;     ///< Since the first contact, or since the observation without one
  double speed_mps = 0.0;  ///< The largest of its origin so far, at least kLeastSpeed_mps
};
constexpr double kLeastSpeed_mps = 0.1;  ///< What is slower is held still by the shipped models

/// Of a step of a motion that touches something first at step `first_contact`, -1 = never.
MotionProgress progress_of(const std::vector<RigidTransform>& poses, int first_contact, std::size_t step,
                           double time_step_s);

/// How far poses lie apart: of each coordinate of the position and of the rotation vector from their mean. At least
/// two.
Doubt spread_of(const std::vector<RigidTransform>& poses);

/// The doubt of a forecast whose particles have that spread, at that speed; without particles, of the forecast alone.
Doubt total_doubt(const DoubtCell& cell, double speed_mps, const std::optional<Doubt>& spread);

/// Fills in the standard deviations of dynamic objects up to the last step, those that are there already stay.
/// `spread(object, step)` gives the spread of their particles, and nothing without them.
using Spread = std::function<std::optional<Doubt>(std::size_t object, std::size_t step)>;
std::optional<Doubt> nothing_spreads(std::size_t object, std::size_t step);
void add_doubt(const DoubtTable& table, const std::vector<Knowledge>& knowledge, const std::vector<MotionMode>& modes,
               const Spread& spread, Forecast& forecast);

}  // namespace rigidformer
