// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/batch.hpp"
#include "rigidformer/scene/rollout_options.hpp"

namespace rigidformer {

/// Throws std::invalid_argument when a model with commands of `control_dim` numbers (App. I) cannot take those of
/// `rollout`: none or another number, numbers that are not finite, or fewer steps than the rollout has.
void check_commands(const RolloutOptions& rollout, int control_dim);

/// The command of step `step` of the rollout [1, control_dim]; after the last one it goes on. Undefined without
/// commands.
Tensor command_of_step(const RolloutOptions& rollout, std::int64_t step);

}  // namespace rigidformer
