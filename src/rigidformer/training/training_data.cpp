// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/training_data.hpp"

#include <algorithm>
#include <random>
#include <sstream>
#include <stdexcept>

#include "rigidformer/data/scene_loader.hpp"
#include "rigidformer/training/validation.hpp"
#include "rigidformer/windows/usable_scenes.hpp"

namespace rigidformer {
namespace {

constexpr int kWindowsPerKind = 256;  // validation windows of each kind; chosen by eye
constexpr int kValidationStep = 10;   // frames

std::vector<SceneArchive> load_all(const std::vector<std::filesystem::path>& folders,
                                   const std::filesystem::path& shapes) {
  std::vector<SceneArchive> archives;
  for (const auto& folder : folders) archives.push_back(load_scenes(folder, shapes));
  return archives;
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
  facts.max_speed_mps = tensors.frame_rate_hz * step.norm(2, -1).max().item<double>();
}

std::vector<Window> draw_windows(WindowOptions options, const ContactEvents& events, const SceneTensors& tensors) {
  options.step_sizes = {kValidationStep};
  options.any_step_probability = 0.0;
  const WindowSampler sampler(options, events, tensors.object_counts(), tensors.frame_counts());
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
  data.validation_windows.emplace_back("any time", draw_windows(WindowOptions(), events, tensors));
}

/// The shortest scene that every window of the run fits into.
int least_frames(const TrainingOptions& options) {
  const auto& sizes = options.windows.step_sizes;
  int least = sizes.empty() ? 1 : 1 + 2 * *std::max_element(sizes.begin(), sizes.end());
  for (const UnrollStage& stage : options.unroll) least = std::max(least, stage.steps + 2);
  return least;
}

/// Scenes never learned from. Rollouts from later starts need longer ones; the first must fit.
void load_validation(const std::filesystem::path& folder, const TrainingPaths& paths, const PointSetOptions& points,
                     double frame_rate_hz, const torch::Device& device, TrainingData& data) {
  std::vector<SceneArchive> archives = {load_scenes(folder, paths.shapes)};
  const ValidationOptions rollouts;
  data.summary += leave_out_unusable_scenes(archives.front(), 1 + 2 * kValidationStep);
  const SceneTensors scenes = make_scene_tensors(archives, points, frame_rate_hz);
  for (const int start : rollouts.start_frames) {
    if (!scenes_reaching(scenes, start, rollouts).empty()) continue;
    const std::string sentence = "validation '" + folder.string() + "': rollouts from frame " + std::to_string(start) +
                                 " need scenes of " + std::to_string(rollouts.last_frame(start) + 1) +
                                 " frames, the longest has " + std::to_string(scenes.num_frames());
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
  std::ostringstream summary;
  std::vector<SceneArchive> archives = load_all(paths.data, paths.shapes);
  for (SceneArchive& archive : archives) {
    summary << leave_out_unusable_scenes(archive, least_frames(options));
    data.facts.data +=
        (data.facts.data.empty() ? "" : ", ") + archive.set + " " + std::to_string(archive.scenes.size());
  }
  const SceneTensors tensors = make_scene_tensors(archives, options.point_sets, options.model.frame_rate_hz);
  ContactEvents events = find_contact_events(tensors);
  summary << "training scenes: " << data.facts.data << "; contact frames: " << events.mid_air.size() << " mid-air, "
          << events.floor.size() << " floor, " << events.rolling.size() << " rolling, " << events.resting.size()
          << " resting\n";
  measure_ranges(tensors, data.facts);
  const auto [smallest, largest] =
      std::minmax_element(options.windows.step_sizes.begin(), options.windows.step_sizes.end());
  const double unit = kFrameRateHz / options.model.frame_rate_hz;
  data.facts.min_step_frames = unit * (options.windows.any_step_probability > 0.0 ? 1 : *smallest);
  data.facts.max_step_frames = unit * *largest;
  data.sampler = std::make_shared<WindowSampler>(options.windows, std::move(events), tensors.object_counts(),
                                                 tensors.frame_counts());
  data.training = tensors.to(device);

  PointSetOptions validation_points = options.point_sets;
  validation_points.seed += 1000003;  // other surface samples than those of training
  validation_points.points_per_set = options.model.max_points;
  data.summary = summary.str();
  for (const auto& folder : paths.validation) {
    load_validation(folder, paths, validation_points, options.model.frame_rate_hz, device, data);
  }
  return data;
}

}  // namespace rigidformer
