// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/training_data.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <stdexcept>

#include "rigidformer/data/scene_loader.hpp"
#include "rigidformer/length_scale.hpp"
#include "rigidformer/training/validation.hpp"
#include "rigidformer/windows/usable_scenes.hpp"

namespace rigidformer {
namespace {

constexpr int kWindowsPerKind = 256;  // validation windows of each kind; chosen by eye
constexpr int kValidationStep = 10;   // frames

/// The scale asked for, or the one that brings the objects to the sizes that the initial model was trained on.
double length_scale_of(const SceneArchive& archive, const TrainingPaths& paths) {
  if (paths.length_scale) return *paths.length_scale;
  if (paths.initial_model.empty()) {
    throw std::invalid_argument("--length-scale auto needs --init, the model whose sizes it goes by");
  }
  const TrainingFacts facts = load_checkpoint(paths.initial_model).facts;
  return automatic_length_scale(archive, facts.min_diameter_m, facts.max_diameter_m);
}

/// Scenes at the size of what a model learns from.
SceneArchive load_at_scale(const std::filesystem::path& folder, const TrainingPaths& paths, std::string& summary) {
  SceneArchive archive = load_scenes(folder, paths.shapes);
  const double scale = length_scale_of(archive, paths);
  if (scale != 1.0) summary += "set '" + archive.set + "' has length scale " + std::to_string(scale) + "\n";
  return to_model_scale(std::move(archive), scale);
}

/// Measures object diameters and speeds of centres of mass in the data: where the model can be trusted.
void measure_ranges(const SceneTensors& tensors, TrainingFacts& facts) {
  const Tensor shape_radius = tensors.shape_points.select(1, 0).norm(2, -1).amax(-1);  // [Q]
  const Tensor diameter =
      (2.0 * shape_radius.index({tensors.shape}) * tensors.size).masked_select(tensors.dynamic_mask);
  facts.min_diameter_m = diameter.min().item<double>();
  facts.max_diameter_m = diameter.max().item<double>();
  const Tensor position = tensors.poses.slice(-1, 0, 3);
  const Tensor step = position.slice(1, 1) - position.slice(1, 0, -1);
  const Tensor speed = step.norm(2, -1) * tensors.frame_rate.reshape({-1, 1, 1});
  facts.max_speed_mps = speed.max().item<double>();
}

/// The range of time steps that the scenes' own frames make of the steps asked for, in whole frames of 1/240 s.
void measure_steps(const WindowOptions& windows, const SceneTensors& tensors, TrainingFacts& facts) {
  const auto [least, most] = std::minmax_element(windows.step_sizes.begin(), windows.step_sizes.end());
  const int smallest = windows.any_step_probability > 0.0 ? 1 : *least;
  constexpr double kRounding = 0.01;  // [frames] rates are measured; steps of 8.96 frames lie between 8 and 9
  double shortest = *most, longest = 0.0;
  for (const double rate_hz : tensors.frame_rates()) {
    shortest = std::min(shortest, frames_at_rate(smallest, rate_hz) * kFrameRateHz / rate_hz);
    longest = std::max(longest, frames_at_rate(*most, rate_hz) * kFrameRateHz / rate_hz);
  }
  facts.min_step_frames = std::max(1, static_cast<int>(std::floor(shortest + kRounding)));
  facts.max_step_frames = static_cast<int>(std::ceil(longest - kRounding));
}

std::vector<Window> draw_windows(WindowOptions options, const ContactEvents& events, const SceneTensors& tensors) {
  options.step_sizes = {kValidationStep};
  options.any_step_probability = 0.0;
  const WindowSampler sampler(options, events, tensors.object_counts(), tensors.frame_counts(), tensors.frame_rates());
  std::mt19937_64 random(7);
  std::vector<Window> windows;
  for (int i = 0; i < kWindowsPerKind; ++i) windows.push_back(sampler.draw(1, random));
  return windows;
}

/// Draws one-step validation windows by kind: their errors show where learning stands.
void add_validation_windows(const SceneTensors& tensors, TrainingData& data) {
  const ContactEvents events = find_contact_events(tensors);
  const auto add = [&](const char* kind, const std::vector<ContactEvent>& list, double WindowOptions::*probability) {
    if (list.empty()) return;
    WindowOptions options;
    options.*probability = 1.0;
    data.validation_windows.emplace_back(kind, draw_windows(options, events, tensors));
  };
  add("mid-air collision", events.mid_air, &WindowOptions::mid_air_probability);
  add("floor impact", events.floor, &WindowOptions::floor_probability);
  add("rolling", events.rolling, &WindowOptions::rolling_probability);
  add("resting", events.resting, &WindowOptions::resting_probability);
  add("driven", events.driven, &WindowOptions::driven_probability);
  data.validation_windows.emplace_back("any time", draw_windows(WindowOptions(), events, tensors));
}

/// Frames of 1/240 s in as many frames of the model.
int in_frames_of_240_hz(int frames, const ModelOptions& model) {
  return static_cast<int>(std::lround(frames * kFrameRateHz / model.frame_rate_hz));
}

/// What the windows of the run need of a scene.
WindowNeeds needs_of(const WindowOptions& windows, const TrainingOptions& options) {
  const auto& sizes = windows.step_sizes;
  WindowNeeds needs;
  if (!sizes.empty()) needs.longest_step = *std::max_element(sizes.begin(), sizes.end());
  for (const UnrollStage& stage : options.unroll) needs.unrolled_steps = std::max(needs.unrolled_steps, stage.steps);
  return needs;
}

/// Scenes never learned from. Rollouts from later starts need longer ones; the first must fit.
void load_validation(const std::filesystem::path& folder, const TrainingPaths& paths, const PointSetOptions& points,
                     const torch::Device& device, TrainingData& data) {
  std::vector<SceneArchive> archives = {load_at_scale(folder, paths, data.summary)};
  const ValidationOptions rollouts;
  data.summary += leave_out_unusable_scenes(archives.front(), {kValidationStep, 1});
  const SceneTensors scenes = make_scene_tensors(archives, points);
  for (const int start : rollouts.start_frames) {
    if (!scenes_reaching(scenes, start, rollouts).empty()) continue;
    const std::string sentence = "validation '" + folder.string() + "': rollouts from frame " + std::to_string(start) +
                                 " need scenes of " + std::to_string(rollouts.last_frame(start, kFrameRateHz) + 1) +
                                 " frames at 240 Hz, the longest has " + std::to_string(scenes.num_frames());
    if (start == rollouts.start_frames.front()) throw std::invalid_argument(sentence);
    data.summary += sentence + ": this start is left out\n";
  }
  if (data.validation_windows.empty()) add_validation_windows(scenes, data);
  data.validation.emplace_back(folder.filename().string(), scenes.to(device));
}

}  // namespace

TrainingData load_training_data(const TrainingPaths& paths, const TrainingOptions& options,
                                const torch::Device& device) {
  TrainingData data;
  WindowOptions windows = options.windows;
  for (int& step : windows.step_sizes) step = in_frames_of_240_hz(step, options.model);
  std::vector<SceneArchive> archives;
  for (const auto& folder : paths.data) archives.push_back(load_at_scale(folder, paths, data.summary));
  std::ostringstream summary;
  for (SceneArchive& archive : archives) {
    summary << leave_out_unusable_scenes(archive, needs_of(windows, options));
    data.facts.data +=
        (data.facts.data.empty() ? "" : ", ") + archive.set + " " + std::to_string(archive.scenes.size());
  }
  const SceneTensors tensors = make_scene_tensors(archives, options.point_sets);
  ContactEvents events = find_contact_events(tensors);
  summary << "training scenes: " << data.facts.data << "; contact frames: " << events.mid_air.size() << " mid-air, "
          << events.floor.size() << " floor, " << events.rolling.size() << " rolling, " << events.resting.size()
          << " resting, " << events.driven.size() << " driven\n";
  measure_ranges(tensors, data.facts);
  measure_steps(windows, tensors, data.facts);
  data.sampler = std::make_shared<WindowSampler>(windows, std::move(events), tensors.object_counts(),
                                                 tensors.frame_counts(), tensors.frame_rates());
  data.training = tensors.to(device);

  PointSetOptions validation_points = options.point_sets;
  validation_points.seed += 1000003;  // other surface samples than those of training
  validation_points.points_per_set = options.model.max_points;
  data.summary += summary.str();
  for (const auto& folder : paths.validation) load_validation(folder, paths, validation_points, device, data);
  return data;
}

}  // namespace rigidformer
