// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/protocol.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace rigidformer {
namespace {

using Poses = std::vector<RigidTransform>;

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

/// Number of steps from the second given frame to `horizon` frames after the first; it need not be whole.
int steps_to_reach(int horizon, int step) { return std::max(1, (horizon - step + step - 1) / step); }

/// Poses of all objects `horizon` frames after the first given frame; a rollout starts one step after that frame.
Poses predicted_at(const std::vector<Poses>& rollout, int horizon, int step) {
  Poses poses;
  for (const Poses& object : rollout) {
    poses.push_back(pose_at_step(object, static_cast<double>(horizon - step) / step));
  }
  return poses;
}

Poses recorded_at(const SceneRecording& scene, int frame) {
  Poses poses;
  for (const RecordedObject& object : scene.objects) {
    poses.push_back(object.T_world_object.at(frame));
  }
  return poses;
}

/// Scene error of every object on its own.
std::vector<PoseError> object_errors(const Poses& predicted, const Poses& truth) {
  std::vector<PoseError> errors;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    errors.push_back(scene_error({predicted[i]}, {truth[i]}));
  }
  return errors;
}

bool lies_still(const std::vector<RigidTransform>& poses, int first, int last) {
  // Well below the drift to be measured, well above the rounding of recorded poses.
  constexpr double kStill_m = 0.002, kStill_rad = 0.2 * M_PI / 180.0;
  return std::all_of(poses.begin() + first, poses.begin() + last + 1, [&](const RigidTransform& pose) {
    return (pose.translation - poses[static_cast<std::size_t>(first)].translation).norm() < kStill_m &&
           rotation_angle(pose.rotation, poses[static_cast<std::size_t>(first)].rotation) < kStill_rad;
  });
}

/// Indices of the objects whose errors count.
std::vector<std::size_t> objects_to_score(const SceneRecording& scene, const ProtocolOptions& options, int start) {
  const int last = start + *std::max_element(options.horizons.begin(), options.horizons.end());
  std::vector<std::size_t> objects;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (scene.objects[i].is_static) continue;  // nobody predicts it
    if (!options.resting_only || lies_still(scene.objects[i].T_world_object, start, last)) objects.push_back(i);
  }
  return objects;
}

Poses select(const Poses& poses, const std::vector<std::size_t>& objects) {
  Poses selected;
  for (const std::size_t i : objects) selected.push_back(poses[i]);
  return selected;
}

/// Rolls out all scenes of one set by one forecaster, from one start with one step size.
class Round {
 public:
  Round(const ProtocolOptions& options, int start, int step) : options_(options), start_(start), step_(step) {
    num_steps_ = steps_to_reach(*std::max_element(options.horizons.begin(), options.horizons.end()), step);
    errors_.resize(options.horizons.size());
  }

  int num_steps() const { return num_steps_; }

  SceneResult add_scene(const std::string& set, const SceneRecording& scene, const std::vector<ObjectState>& objects,
                        const std::vector<std::size_t>& scored, Forecaster& forecaster) {
    const int curve_steps = steps_of_curve(scene);
    RolloutOptions rollout;
    rollout.num_steps = std::max(num_steps_, curve_steps);
    rollout.time_step_s = step_ / scene.frame_rate_hz;
    rollout.gravity = scene.gravity.z();
    rollout.ground = observed_ground(scene, options_.observation);
    rollout.control = commands_of_steps(scene, start_ + step_, step_, rollout.num_steps);
    SceneResult result{forecaster.name(), set, start_, step_, &scene, {}, {}, {}, {}};
    const auto begin = std::chrono::steady_clock::now();
    result.predicted = forecaster.forecast(objects, rollout);
    compute_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    predicted_s_ += rollout.num_steps * rollout.time_step_s;
    for (std::size_t h = 0; h < options_.horizons.size(); ++h) {
      const Poses predicted = predicted_at(result.predicted, options_.horizons[h], step_);
      const Poses truth = recorded_at(scene, start_ + options_.horizons[h]);
      result.at_horizon.push_back(scene_error(select(predicted, scored), select(truth, scored)));
      result.object_at_horizon.push_back(object_errors(predicted, truth));
      errors_[h].push_back(result.at_horizon.back());
    }
    for (int k = 0; options_.curve_frames > 0 && k <= curve_steps; ++k) {
      const int horizon = step_ * (k + 1);
      result.after_step.push_back(
          scene_error(predicted_at(result.predicted, horizon, step_), recorded_at(scene, start_ + horizon)));
    }
    return result;
  }

  void append_scores(const std::string& model, const std::string& set, std::vector<Score>& scores) const {
    if (errors_.front().empty()) {
      throw std::invalid_argument("evaluation: no object of set " + set + " rests from frame " +
                                  std::to_string(start_) + " on");
    }
    for (std::size_t h = 0; h < options_.horizons.size(); ++h) {
      scores.push_back({model, set, start_, step_, options_.horizons[h], static_cast<int>(errors_[h].size()),
                        mean_error(errors_[h]), compute_s_ / predicted_s_});
    }
  }

 private:
  /// The whole steps after the second given frame that end inside the curve and inside the recording.
  int steps_of_curve(const SceneRecording& scene) const {
    const int last_frame = std::min(options_.curve_frames, scene.num_frames - 1 - start_);
    return std::max(0, last_frame / step_ - 1);
  }

  const ProtocolOptions& options_;
  int start_, step_, num_steps_ = 0;
  std::vector<std::vector<PoseError>> errors_;  ///< [horizon][scene] errors
  double compute_s_ = 0.0, predicted_s_ = 0.0;
};

bool something_moves(const SceneRecording& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [](const RecordedObject& object) { return !object.is_static; });
}

/// Frames that a scene must have to be scored from `start`.
int frames_needed(const ProtocolOptions& options, int start) {
  return 1 + start + *std::max_element(options.horizons.begin(), options.horizons.end());
}

std::vector<const SceneRecording*> scenes_to_score(const SceneArchive& archive, const ProtocolOptions& options) {
  std::vector<const SceneRecording*> scenes;
  int longest = 0;
  for (const SceneRecording& scene : archive.scenes) {
    if (options.max_scenes > 0 && static_cast<int>(scenes.size()) == options.max_scenes) {
      break;
    }
    if (!something_moves(scene)) {
      continue;
    }
    scenes.push_back(&scene);
    longest = std::max(longest, scene.num_frames);
  }
  require(!scenes.empty(), "set " + archive.set + " has no scenes with objects that can move");
  for (const int start : options.starts) {
    require(longest >= frames_needed(options, start),
            "no scene of set " + archive.set + " can be scored from frame " + std::to_string(start) +
                ": the longest has " + std::to_string(longest) + " frames, start and horizons need " +
                std::to_string(frames_needed(options, start)));
  }
  return scenes;
}

}  // namespace

void ProtocolOptions::validate() const {
  require_each(starts, "starts", 0);
  require_each(steps, "steps", 1);
  require_each(horizons, "horizons", *std::max_element(steps.begin(), steps.end()));
  require(max_scenes >= 0, "max_scenes is " + std::to_string(max_scenes) + ", must not be negative");
  require(curve_frames >= 0, "curve_frames is " + std::to_string(curve_frames) + ", must not be negative");
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
    const int needed = frames_needed(options, start);
    add([&](const SceneRecording& scene) { return something_moves(scene) && scene.num_frames < needed; },
        "start " + std::to_string(start) + " and the horizons need " + std::to_string(needed) + " frames");
  }
  return sentences;
}

std::vector<Score> evaluate(const SceneArchive& archive, const std::vector<Forecaster*>& forecasters,
                            const ProtocolOptions& options, const EvaluationProgress& progress,
                            const ResultSink& sink) {
  options.validate();
  const std::vector<const SceneRecording*> scenes = scenes_to_score(archive, options);
  const Observer observer(archive.shapes, options.observation);
  long total = 0;
  for (const int step : options.steps) {
    total += Round(options, 0, step).num_steps();
  }
  total *= static_cast<long>(options.starts.size() * scenes.size() * forecasters.size());
  long done = 0;
  std::vector<Score> scores;
  for (const int start : options.starts) {
    for (const int step : options.steps) {
      std::vector<Round> rounds(forecasters.size(), Round(options, start, step));
      for (const SceneRecording* scene : scenes) {
        const bool reaches = scene->num_frames >= frames_needed(options, start);
        const auto scored = reaches ? objects_to_score(*scene, options, start) : std::vector<std::size_t>();
        if (scored.empty()) {
          done += static_cast<long>(forecasters.size()) * rounds.front().num_steps();
          continue;
        }
        const std::vector<ObjectState> objects = observer.observe(*scene, start + step, step);
        for (std::size_t f = 0; f < forecasters.size(); ++f) {
          const SceneResult result = rounds[f].add_scene(archive.set, *scene, objects, scored, *forecasters[f]);
          done += rounds[f].num_steps();
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
