// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "rigidformer/candidate_objects.hpp"
#include "rigidformer/engine/solid_scene.hpp"

namespace rigidformer {

// Bullet keeps a margin of 1 mm around every hull: bodies that rest on each other are 2 mm apart, give or take what its
// solver leaves. What is nearer than this [m] touches.
constexpr double kContact_m = 0.004;

/// Two objects; the second may be -1, the ground.
using ObjectPair = std::pair<std::int64_t, std::int64_t>;

/// The contacts of a step: what is closer than kContact_m at its end (`gaps`), what the engine let press on each other
/// (`pressed`), and what free motion brought together (`met`). Contacts between bodies of given motion do not count.
std::vector<StepContact> find_contacts(int step, const std::vector<CandidateObject>& objects,
                                       const std::vector<SolidGap>& gaps, const std::vector<PressedPair>& pressed,
                                       const std::vector<ObjectPair>& met);

}  // namespace rigidformer
