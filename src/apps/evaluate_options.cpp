// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "rigidformer/baselines/physics_engine.hpp"
#include "rigidformer/length_scale.hpp"

namespace rigidformer {
namespace {

/// The checkpoint that comes with the package: of the installation that holds this program, else of the source tree.
std::string shipped_model() {
  namespace fs = std::filesystem;
  const fs::path file = fs::path("models") / "hybrid.safetensors";
  const fs::path program = fs::read_symlink("/proc/self/exe");
  for (fs::path folder = program.parent_path(); folder != folder.parent_path(); folder = folder.parent_path()) {
    const fs::path installed = folder / "share" / "rigidformer_ros" / file;
    if (fs::exists(installed)) {
      return installed.string();
    }
  }
  return (fs::path(RIGIDFORMER_SOURCE_DIR) / file).string();
}

std::vector<std::string> baseline_names() {
  std::vector<std::string> names{"none", "ballistic"};
  names.insert(names.end(), physics_engine_names().begin(), physics_engine_names().end());
  return names;
}

void add_model_options(CLI::App& app, EvaluateOptions& options) {
  app.add_option("--model", options.model.file, "Checkpoint; 'none' scores the baselines alone [the shipped one]");
  app.add_option("--device", options.model.device, "auto, cpu, cuda or cuda:N")->capture_default_str();
  app.add_option("--precision", options.model.precision, "float32 or bfloat16")->capture_default_str();
  app.add_option("--rest-speed", options.model.rest_speed,
                 "Objects slower than this [m/s] are held still, 0 = never; negative = as the model says")
      ->capture_default_str();
  app.add_option("--engine-share", options.model.engine_share,
                 "Share of the physics engine's step instead of the learned one: 0 = network alone, 1 = engine alone");
  app.add_option("--threads", options.model.num_threads, "CPU threads")->capture_default_str();
  app.add_option("--baselines", options.baselines,
                 "Scored beside the model: ballistic (no contact), bullet, mujoco (on the hull of the same points), "
                 "bullet_parts")
      ->delimiter(',')
      ->check(CLI::IsMember(baseline_names()))
      ->capture_default_str();
}

void add_protocol_options(CLI::App& app, EvaluateOptions& options) {
  ProtocolOptions& protocol = options.protocol;
  app.add_option("--data", options.data, "One set of scenes each: archive, archive shards or Kubric folders")
      ->required();
  app.add_option("--shapes", options.shapes_dir, "Meshes of the shapes in KuBasic layout, for Kubric folders");
  app.add_option("--starts", protocol.starts, "First given frames")->delimiter(',')->capture_default_str();
  app.add_option("--steps", protocol.steps, "Frames per step")->delimiter(',')->capture_default_str();
  auto* horizons = app.add_option("--horizons", protocol.horizons, "Frames after the start that are scored")
                       ->delimiter(',')
                       ->capture_default_str();
  app.add_option("--horizons-s", options.horizons_s, "Instead: times after the start that are scored [s]")
      ->delimiter(',')
      ->check(CLI::PositiveNumber)
      ->excludes(horizons);
  app.add_flag("--to-the-end", protocol.to_the_end,
               "Roll out to the end of each recording: which objects that rest there lie on the right face");
  app.add_flag("--resting", protocol.resting_only,
               "Score only objects that lie still from the start to the last horizon: their error is drift");
  app.add_option("--scenes", protocol.max_scenes, "Scenes per set, 0 = all")->capture_default_str();
}

void add_observation_options(CLI::App& app, EvaluateOptions& options) {
  ObservationOptions& observation = options.protocol.observation;
  app.add_option("--points", options.points, "Surface samples per object, or 'vertices'")
      ->check(CLI::Range(4, 1000000) | CLI::IsMember({"vertices"}))
      ->capture_default_str();
  app.add_option("--properties", options.properties, "Mass, friction and restitution are known or unknown")
      ->check(CLI::IsMember({"known", "unknown"}))
      ->capture_default_str();
  app.add_option("--friction", observation.friction, "Told of every object instead of what is recorded")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--restitution", observation.restitution, "Likewise")->check(CLI::Range(0.0, 1.0));
  app.add_option("--noise", observation.noise_m, "Standard deviation of the points [m]")->capture_default_str();
  app.add_option("--mask", observation.masked_fraction, "Share of the points dropped at random")->capture_default_str();
  app.add_option("--mask-box", observation.boxed_fraction,
                 "Share of the points dropped inside a random box of every object")
      ->capture_default_str();
  app.add_flag("--view", observation.one_view, "Keep only points that face one camera");
}

/// Options whose text is not their value.
void resolve(EvaluateOptions& options) {
  ObservationOptions& observation = options.protocol.observation;
  observation.num_points = options.points == "vertices" ? 0 : std::stoi(options.points);
  observation.known_properties = options.properties == "known";
  if (options.model.file.empty()) {
    options.model.file = shipped_model();
  }
  options.length_scale = length_scale_from(options.length_scale_text);
  if (!options.horizons_s.empty()) {
    options.protocol.horizon_unit = HorizonUnit::kMilliseconds;
    options.protocol.horizons.clear();
    for (const double time_s : options.horizons_s) {
      options.protocol.horizons.push_back(static_cast<int>(std::lround(1000.0 * time_s)));
    }
  }
  options.protocol.validate();
}

}  // namespace

EvaluateOptions read_command_line(int argc, char** argv) {
  CLI::App app("Scores a model on recorded scenes beside what simpler forecasters make of the same observations.");
  EvaluateOptions options;
  add_model_options(app, options);
  add_protocol_options(app, options);
  add_observation_options(app, options);
  app.add_option("--length-scale", options.length_scale_text,
                 "Real lengths over trained ones: forecasters see lengths divided by it and times by its root; auto = "
                 "from the objects of each set and the sizes that the model was trained on")
      ->capture_default_str();
  app.add_option("--json", options.json_file, "Also write the scores to this file");
  app.add_option("--scene-errors", options.scene_errors_file, "Also write the errors of every scene to this CSV");
  app.add_option("--report", options.report_dir,
                 "Also write tables, plots, breakdowns and worst scenes to this folder");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  resolve(options);
  return options;
}

}  // namespace rigidformer
