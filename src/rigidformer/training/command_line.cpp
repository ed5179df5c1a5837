// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/command_line.hpp"

#include <csignal>
#include <exception>
#include <type_traits>

#include "rigidformer/io/member_table.hpp"
#include "rigidformer/length_scale.hpp"
#include "rigidformer/training/options.hpp"
#include "rigidformer/training/stages.hpp"

namespace rigidformer {
namespace {

volatile std::sig_atomic_t stop_requested = 0;  // by Ctrl-C or kill

}  // namespace

std::string training_keys() {
  TrainingOptions options;
  std::string text = "Keys of a training file:\n" + help_lines(member_rows(options));
  for_each_member(options, [&text](const char* key, auto& section, const Accepts&, const char* description) {
    if constexpr (has_members<std::decay_t<decltype(section)>>) {
      text += std::string(key) + ": " + description + "\n" + help_lines(member_rows(section));
    }
  });
  return text;
}

int run_train(const TrainCommand& command, std::ostream& log) {
  try {
    std::vector<TrainingOptions> stages = load_training_stages(command.config, command.overrides);
    for (TrainingOptions& stage : stages) {
      if (command.iterations > 0) stage.iterations = command.iterations;
    }
    TrainingMachine machine = command.machine;
    std::signal(SIGINT, [](int) { stop_requested = 1; });
    std::signal(SIGTERM, [](int) { stop_requested = 1; });
    machine.should_stop = [] { return stop_requested != 0; };
    TrainingPaths paths = command.paths;
    paths.length_scale = length_scale_from(command.length_scale);
    train_in_stages(stages, paths, machine);
    return 0;
  } catch (const std::exception& exception) {
    log << "train: " << exception.what() << std::endl;
    return 1;
  }
}

}  // namespace rigidformer
