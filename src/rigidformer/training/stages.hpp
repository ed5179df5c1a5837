// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/training/options.hpp"
#include "rigidformer/training/trainer.hpp"

namespace rigidformer {

/// Trains one stage after the other, each from the weights of the one before. Several stages lie in stage_1, stage_2
/// ... of the output folder, into which the models of the last one are copied at the end. With machine.resume, finished
/// stages are kept and the first unfinished one goes on; machine.max_minutes counts for all of them together. Throws
/// what train() throws.
void train_in_stages(const std::vector<TrainingOptions>& stages, const TrainingPaths& paths,
                     const TrainingMachine& machine);

}  // namespace rigidformer
