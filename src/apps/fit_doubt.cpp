// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "rigidformer/data/scene_loader.hpp"
#include "rigidformer/evaluation/doubt_fit.hpp"
#include "rigidformer/evaluation/observation.hpp"
#include "rigidformer/model/doubt_table.hpp"
#include "rigidformer/predictor.hpp"

namespace {

using namespace rigidformer;

struct Options {
  std::string model, output;
  std::vector<std::string> data, check;
  std::vector<int> starts{0, 60, 120, 240};
  int step = 10, num_steps = 20, num_scenes = 0, num_particles = 8;
};

/// A table with which standard deviations are the particles' spread.
DoubtTable plain_spread() {
  DoubtTable table;
  for (auto& phases : table.cells) {
    for (auto& cells : phases) cells.fill(DoubtCell());
  }
  return table;
}

/// What is seen of a scene: all of it, all but the material, one side with 2 mm of noise.
std::vector<ObservationOptions> observations() {
  std::vector<ObservationOptions> all(3);
  all[1].known_properties = all[2].known_properties = false;
  all[2].one_view = true;
  all[2].noise_m = 0.002;
  return all;
}

void add_samples(const CandidateOutcome& outcome, const SceneRecording& scene, int first_frame, int step,
                 std::vector<DoubtSample>& samples) {
  const Forecast& forecast = outcome.forecast;
  for (std::size_t k = 0; k < forecast.objects.size(); ++k) {
    const ObjectTrajectory& object = forecast.objects[k];
    if (object.position_stddev_m.size() != object.poses.size()) continue;  // its motion is given
    const int first_contact = first_contact_step(forecast, static_cast<int>(k));
    for (std::size_t i = 1; i < object.poses.size(); ++i) {
      const auto frame = static_cast<std::size_t>(first_frame) + i * static_cast<std::size_t>(step);
      const RigidTransform& truth = scene.objects[k].T_world_object.at(frame);
      DoubtSample sample;
      sample.knowledge = outcome.knowledge[k];
      sample.progress = progress_of(object.poses, first_contact, i, forecast.times_s[1]);
      sample.position_error_m = truth.translation - object.poses[i].translation;
      sample.rotation_error_rad = rotation_vector(truth.rotation * object.poses[i].rotation.conjugate());
      sample.spread = {object.position_stddev_m[i], object.rotation_stddev_rad[i]};
      samples.push_back(sample);
    }
  }
}

void add_rollout(const Options& options, Predictor& predictor, const Observer& observer, const SceneRecording& scene,
                 int start, std::vector<DoubtSample>& samples) {
  BatchOptions batch;
  batch.rollout.num_steps = options.num_steps;
  batch.rollout.time_step_s = options.step / scene.frame_rate_hz;
  batch.rollout.gravity = scene.gravity.z();
  batch.rollout.ground = observed_ground(scene, observer.options());
  batch.rollout.num_particles = options.num_particles;
  const int now = start + options.step;
  const auto rollout = predictor.start_batch(observer.observe(scene, now, options.step), {Candidate()}, batch);
  while (rollout->advance()) {
  }
  add_samples(rollout->outcomes().front(), scene, now, options.step, samples);
}

std::vector<DoubtSample> samples_of(const Options& options, const std::vector<std::string>& folders,
                                    Predictor& predictor) {
  std::vector<DoubtSample> samples;
  for (const std::string& folder : folders) {
    const SceneArchive archive = load_scenes(folder, std::filesystem::path(), options.num_scenes);
    for (const ObservationOptions& observation : observations()) {
      const Observer observer(archive.shapes, observation);
      for (std::size_t i = 0; i < archive.scenes.size(); ++i) {
        const SceneRecording& scene = archive.scenes[i];
        for (const int start : options.starts) {
          if (start + options.step * (options.num_steps + 1) >= scene.num_frames) continue;
          add_rollout(options, predictor, observer, scene, start, samples);
        }
        std::fprintf(stderr, "%s: scene %zu of %zu, %zu poses\n", folder.c_str(), i + 1, archive.scenes.size(),
                     samples.size());
      }
    }
  }
  return samples;
}

void run(const Options& options) {
  store_doubt(options.model, plain_spread(), options.output);
  PredictorOptions predictor_options;
  predictor_options.file = options.output;
  predictor_options.device = "cpu";
  Predictor predictor(predictor_options);
  const DoubtTable table = fit_doubt(samples_of(options, options.data, predictor));
  store_doubt(options.model, table, options.output);
  if (!options.check.empty()) print_coverage(std::cout, table, samples_of(options, options.check, predictor));
}

}  // namespace

int main(int argc, char** argv) try {
  Options options;
  CLI::App app("Measures how far a model's forecasts are from recorded motion, and stores it beside the weights.");
  app.add_option("--model", options.model, "Checkpoint")->required()->check(CLI::ExistingFile);
  app.add_option("--data", options.data, "Scenes to measure on, never learned from")->required();
  app.add_option("--check", options.check, "Other scenes: prints how often the truth lies inside of the regions");
  app.add_option("--starts", options.starts, "First given frames")->delimiter(',')->capture_default_str();
  app.add_option("--step", options.step, "Frames per step")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--steps", options.num_steps, "Predicted steps")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--scenes", options.num_scenes, "Scenes per folder, 0 = all")->capture_default_str();
  app.add_option("--particles", options.num_particles, "Worlds per forecast")
      ->check(CLI::Range(2, 64))
      ->capture_default_str();
  app.add_option("--out", options.output, "The checkpoint with its doubt, stored as bfloat16")->required();
  CLI11_PARSE(app, argc, argv);
  run(options);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "fit_doubt: " << error.what() << '\n';
  return 1;
}
