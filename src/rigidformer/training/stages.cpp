// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/stages.hpp"

#include <chrono>
#include <iostream>

#include "rigidformer/model/checkpoint.hpp"

namespace rigidformer {
namespace {

namespace fs = std::filesystem;

bool has_state(const fs::path& folder) { return fs::exists(folder / "state.safetensors"); }

bool is_finished(const fs::path& folder, const TrainingOptions& stage) {
  const fs::path model = folder / "model.safetensors";
  return has_state(folder) && fs::exists(model) && load_checkpoint(model).facts.iterations >= stage.iterations;
}

double minutes_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / 60.0;
}

}  // namespace

void train_in_stages(const std::vector<TrainingOptions>& stages, const TrainingPaths& paths,
                     const TrainingMachine& machine) {
  if (stages.size() == 1) return train(stages.front(), paths, machine);
  const auto start = std::chrono::steady_clock::now();
  TrainingPaths stage_paths = paths;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    stage_paths.output = paths.output / ("stage_" + std::to_string(i + 1));
    const bool is_kept = machine.resume && is_finished(stage_paths.output, stages[i]);
    std::cerr << "stage " << i + 1 << " of " << stages.size() << (is_kept ? ": finished before\n" : "\n");
    if (!is_kept) {
      TrainingMachine stage_machine = machine;
      stage_machine.resume = machine.resume && has_state(stage_paths.output);
      if (machine.max_minutes > 0.0) {
        stage_machine.max_minutes = machine.max_minutes - minutes_since(start);
        if (stage_machine.max_minutes <= 0.0) return;
      }
      train(stages[i], stage_paths, stage_machine);
      if (!is_finished(stage_paths.output, stages[i])) return;
    }
    stage_paths.initial_model = stage_paths.output / "model.safetensors";
  }
  for (const char* name : {"model.safetensors", "model_bfloat16.safetensors"}) {
    fs::copy_file(stage_paths.output / name, paths.output / name, fs::copy_options::overwrite_existing);
  }
}

}  // namespace rigidformer
