// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/protocol.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "rollout_round.hpp"

namespace rigidformer {
namespace {

void require(bool condition, const std::string& message) {
  if (!condition) {
    throw std::invalid_argument("evaluation: " + message);
  }
}

void require_each(const std::vector<int>& values, const std::string& field, int least) {
  require(!values.empty(), field + " is empty");
  const int smallest = *std::min_element(values.begin(), values.end());
  require(smallest >= least,
          field + " contains " + std::to_string(smallest) + ", must be at least " + std::to_string(least));
}

bool something_moves(const SceneRecording& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [](const RecordedObject& object) { return !object.is_given(); });
}

/// Frames that a scene must have to be scored from `start`.
int frames_needed(const ProtocolOptions& options, int start, const SceneRecording& scene) {
  return 1 + start + static_cast<int>(std::ceil(last_horizon_frames(options, scene)));
}

bool reaches(const ProtocolOptions& options, int start, const SceneRecording& scene) {
  return scene.num_frames >= frames_needed(options, start, scene);
}

std::vector<const SceneRecording*> scenes_to_score(const SceneArchive& archive, const ProtocolOptions& options) {
  std::vector<const SceneRecording*> scenes;
  for (const SceneRecording& scene : archive.scenes) {
    if (options.max_scenes > 0 && static_cast<int>(scenes.size()) == options.max_scenes) {
      break;
    }
    if (!something_moves(scene)) {
      continue;
    }
    scenes.push_back(&scene);
  }
  require(!scenes.empty(), "set " + archive.set + " has no scenes with objects that can move");
  const auto lacks = [&](int start, const SceneRecording* scene) {
    return frames_needed(options, start, *scene) - scene->num_frames;
  };
  for (const int start : options.starts) {
    const SceneRecording& longest = **std::min_element(
        scenes.begin(), scenes.end(), [&](const auto* a, const auto* b) { return lacks(start, a) < lacks(start, b); });
    require(reaches(options, start, longest),
            "no scene of set " + archive.set + " can be scored from frame " + std::to_string(start) +
                ": the longest has " + std::to_string(longest.num_frames) + " frames, start and horizons need " +
                std::to_string(frames_needed(options, start, longest)));
  }
  return scenes;
}

}  // namespace

void ProtocolOptions::validate() const {
  require_each(starts, "starts", 0);
  require_each(steps, "steps", 1);
  const bool in_frames = horizon_unit == HorizonUnit::kFrames;
  require_each(horizons, "horizons", in_frames ? *std::max_element(steps.begin(), steps.end()) : 1);
  require(max_scenes >= 0, "max_scenes is " + std::to_string(max_scenes) + ", must not be negative");
  require(curve_end >= 0, "curve_end is " + std::to_string(curve_end) + ", must not be negative");
  observation.validate();
}

std::vector<std::string> scenes_left_out(const SceneArchive& archive, const ProtocolOptions& options) {
  std::vector<std::string> sentences;
  const auto add = [&](const auto& is_left_out, const std::string& reason) {
    std::string first;
    int count = 0;
    for (const SceneRecording& scene : archive.scenes) {
      if (is_left_out(scene) && count++ == 0) first = scene.name;
    }
    if (count == 0) return;
    sentences.push_back("set " + archive.set + ": " + std::to_string(count) + " scenes left out (the first is '" +
                        first + "'): " + reason);
  };
  add([](const SceneRecording& scene) { return !something_moves(scene); }, "no object in them can move");
  for (const int start : options.starts) {
    add([&](const SceneRecording& scene) { return something_moves(scene) && !reaches(options, start, scene); },
        "they end before the last horizon from start " + std::to_string(start));
  }
  return sentences;
}

std::vector<Score> evaluate(const SceneArchive& archive, const std::vector<Forecaster*>& forecasters,
                            const ProtocolOptions& options, const EvaluationProgress& progress,
                            const ResultSink& sink) {
  options.validate();
  const std::vector<const SceneRecording*> scenes = scenes_to_score(archive, options);
  const Observer observer(archive.shapes, options.observation);
  const std::map<std::string, double> extents = largest_extents(archive.shapes);
  long total = 0;
  for (const int step : options.steps) {
    for (const SceneRecording* scene : scenes) total += steps_to_last_horizon(options, *scene, step);
  }
  total *= static_cast<long>(options.starts.size() * forecasters.size());
  long done = 0;
  std::vector<Score> scores;
  for (const int start : options.starts) {
    for (const int step : options.steps) {
      std::vector<RolloutRound> rounds(forecasters.size(), RolloutRound(options, extents, start, step));
      for (const SceneRecording* scene : scenes) {
        const auto scored =
            reaches(options, start, *scene) ? objects_to_score(*scene, options, start) : std::vector<std::size_t>();
        const long steps = steps_to_last_horizon(options, *scene, step);
        if (scored.empty()) {
          done += static_cast<long>(forecasters.size()) * steps;
          continue;
        }
        const std::vector<ObjectState> objects = observer.observe(*scene, start + step, step);
        for (std::size_t f = 0; f < forecasters.size(); ++f) {
          const SceneResult result = rounds[f].add_scene(archive.set, *scene, objects, scored, *forecasters[f]);
          done += steps;
          if (sink) {
            sink(result);
          }
        }
        if (progress) {
          progress(done, total);
        }
      }
      for (std::size_t f = 0; f < forecasters.size(); ++f) {
        rounds[f].append_scores(forecasters[f]->name(), archive.set, scores);
      }
    }
  }
  return scores;
}

}  // namespace rigidformer
