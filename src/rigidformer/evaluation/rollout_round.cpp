// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rollout_round.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace rigidformer {
namespace {

using PoseList = std::vector<RigidTransform>;

constexpr double kRounding = 1e-9;  // [frames] of products of rates and times
constexpr int kCurveStep_ms = 20;   // between two points of a curve over milliseconds; chosen by eye
// What an object does in its last moments that counts as rest: a tracker's noise and drift on the real tosses are a
// third of that. Faces that things rest on differ by more than the tilt (those of a cube by 90 degrees).
constexpr double kSettleTime_s = 0.1, kSettledShare = 0.02, kSettledTurn_deg = 2.0;
constexpr double kRightFaceTilt_deg = 20.0;

double frames_of(int horizon, const ProtocolOptions& options, const SceneRecording& scene) {
  return options.horizon_unit == HorizonUnit::kFrames ? horizon : horizon * scene.frame_rate_hz / 1000.0;
}

/// Number of steps from the second given frame to `frames` after the first; it need not be whole.
int steps_to_reach(double frames, int step) {
  return std::max(1, static_cast<int>(std::ceil((frames - step) / step - kRounding)));
}

/// Scene error of every object on its own.
std::vector<PoseError> object_errors(const PoseList& predicted, const PoseList& truth,
                                     const std::vector<double>& sizes_m) {
  std::vector<PoseError> errors;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    errors.push_back(scene_error({predicted[i]}, {truth[i]}, {sizes_m[i]}));
  }
  return errors;
}

/// Whether all poses from `first` to `last` stay that close to the first of them.
bool stays(const PoseList& poses, int first, int last, double distance_m, double angle_rad) {
  const RigidTransform& there = poses[static_cast<std::size_t>(first)];
  return std::all_of(poses.begin() + first, poses.begin() + last + 1, [&](const RigidTransform& pose) {
    return (pose.translation - there.translation).norm() < distance_m &&
           rotation_angle(pose.rotation, there.rotation) < angle_rad;
  });
}

bool lies_still(const PoseList& poses, int first, int last) {
  // Well below the drift to be measured, well above the rounding of recorded poses.
  constexpr double kStill_m = 0.002, kStill_rad = 0.2 * M_PI / 180.0;
  return stays(poses, first, last, kStill_m, kStill_rad);
}

/// Those that somebody has to predict.
std::vector<std::size_t> free_objects(const SceneRecording& scene) {
  std::vector<std::size_t> objects;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (!scene.objects[i].is_given()) objects.push_back(i);
  }
  return objects;
}

template <typename T>
std::vector<T> select(const std::vector<T>& values, const std::vector<std::size_t>& objects) {
  std::vector<T> selected;
  for (const std::size_t i : objects) selected.push_back(values[i]);
  return selected;
}

}  // namespace

double last_horizon_frames(const ProtocolOptions& options, const SceneRecording& scene) {
  return frames_of(*std::max_element(options.horizons.begin(), options.horizons.end()), options, scene) - kRounding;
}

int steps_to_last_horizon(const ProtocolOptions& options, const SceneRecording& scene, int step) {
  const int first = *std::min_element(options.horizons.begin(), options.horizons.end());
  if (frames_of(first, options, scene) < step - kRounding) {
    throw std::invalid_argument("evaluation: a horizon of " + std::to_string(first) + " ms is shorter than a step of " +
                                std::to_string(step) + " frames of scene " + scene.name);
  }
  return steps_to_reach(last_horizon_frames(options, scene), step);
}

std::vector<std::size_t> objects_to_score(const SceneRecording& scene, const ProtocolOptions& options, int start) {
  const int last = start + static_cast<int>(std::ceil(last_horizon_frames(options, scene)));
  std::vector<std::size_t> objects;
  for (const std::size_t i : free_objects(scene)) {
    if (!options.resting_only || lies_still(scene.objects[i].T_world_object, start, last)) objects.push_back(i);
  }
  return objects;
}

std::vector<GivenTrack> recorded_tracks(const SceneRecording& scene, const std::vector<ObjectState>& objects, int now) {
  std::vector<GivenTrack> tracks;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (!scene.objects[i].is_driven) continue;
    GivenTrack track;
    track.id = objects[i].id;
    track.T_world_reference = scene.objects[i].T_world_object;
    for (int frame = 0; frame < scene.num_frames; ++frame) track.times_s.push_back((frame - now) / scene.frame_rate_hz);
    tracks.push_back(std::move(track));
  }
  return tracks;
}

std::map<std::string, double> largest_extents(const std::vector<Shape>& shapes) {
  std::map<std::string, double> extents;
  for (const Shape& shape : shapes) extents[shape.name] = shape.largest_extent();
  return extents;
}

/// Poses of all objects `frames` after the first given frame; a rollout starts one step after that frame.
RolloutRound::Poses RolloutRound::predicted_at(const SceneResult& result, double frames) const {
  Poses poses;
  for (const Poses& object : result.predicted) {
    const double last = static_cast<double>(object.size()) - 1.0;
    poses.push_back(pose_at_step(object, std::clamp((frames - step_) / step_, 0.0, last)));
  }
  return poses;
}

RolloutRound::Poses RolloutRound::recorded_at(const SceneRecording& scene, double frames) const {
  Poses poses;
  const double last = scene.num_frames - 1.0;
  for (const RecordedObject& object : scene.objects) {
    poses.push_back(pose_at_step(object.T_world_object, std::min(start_ + frames, last)));
  }
  return poses;
}

std::vector<double> RolloutRound::sizes(const SceneRecording& scene) const {
  std::vector<double> sizes_m;
  for (const RecordedObject& object : scene.objects) sizes_m.push_back(extents_.at(object.shape) * object.size);
  return sizes_m;
}

int RolloutRound::steps_of_rollout(const SceneRecording& scene) const {
  const int frames_left = scene.num_frames - 1 - start_;
  const auto steps_to = [&](double frames) { return static_cast<int>((frames + kRounding) / step_) - 1; };
  int steps = steps_to_last_horizon(options_, scene, step_);
  if (options_.curve_end > 0) {
    const double end = std::min<double>(frames_of(options_.curve_end, options_, scene), frames_left);
    steps = std::max(steps, options_.horizon_unit == HorizonUnit::kFrames ? steps_to(end) : steps_to_reach(end, step_));
  }
  return options_.to_the_end ? std::max(steps, steps_to(frames_left)) : steps;
}

void RolloutRound::add_curve(SceneResult& result) const {
  const SceneRecording& scene = *result.scene;
  const std::vector<std::size_t> free = free_objects(scene);
  const bool in_frames = options_.horizon_unit == HorizonUnit::kFrames;
  const int stride = in_frames ? step_ : kCurveStep_ms;
  for (int horizon = stride; horizon <= options_.curve_end; horizon += stride) {
    const double frames = frames_of(horizon, options_, scene);
    if (frames > scene.num_frames - 1 - start_) return;
    if (frames < step_) continue;  // before the second given frame
    result.curve[horizon] = scene_error(select(predicted_at(result, frames), free),
                                        select(recorded_at(scene, frames), free), select(sizes(scene), free));
  }
}

void RolloutRound::add_settled(const std::vector<std::size_t>& scored, SceneResult& result) const {
  const SceneRecording& scene = *result.scene;
  const int last = scene.num_frames - 1;
  const int first = last - static_cast<int>(std::ceil(kSettleTime_s * scene.frame_rate_hz));
  if (first < 0) return;
  const Poses predicted = predicted_at(result, last - start_);
  for (const std::size_t i : scored) {
    const Poses& recorded = scene.objects[i].T_world_object;
    if (!stays(recorded, first, last, kSettledShare * sizes(scene)[i], kSettledTurn_deg * M_PI / 180.0)) continue;
    ++result.settled.num_settled;
    const double tilt_deg = tilt_between(predicted[i].rotation, recorded.back().rotation) * 180.0 / M_PI;
    result.settled.num_right_face += tilt_deg < kRightFaceTilt_deg ? 1 : 0;
  }
}

SceneResult RolloutRound::add_scene(const std::string& set, const SceneRecording& scene,
                                    const std::vector<ObjectState>& objects, const std::vector<std::size_t>& scored,
                                    Forecaster& forecaster) {
  RolloutOptions rollout;
  rollout.num_steps = steps_of_rollout(scene);
  rollout.time_step_s = step_ / scene.frame_rate_hz;
  rollout.gravity = scene.gravity.z();
  rollout.ground = observed_ground(scene, options_.observation);
  rollout.control = commands_of_steps(scene, start_ + step_, step_, rollout.num_steps);
  SceneResult result{forecaster.name(), set, start_, step_, &scene, {}, {}, {}, {}};
  const std::vector<GivenTrack> tracks = recorded_tracks(scene, objects, start_ + step_);
  const auto begin = std::chrono::steady_clock::now();
  result.predicted = forecaster.forecast(objects, rollout, tracks);
  compute_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  predicted_s_ += rollout.num_steps * rollout.time_step_s;
  const std::vector<double> sizes_m = sizes(scene);
  for (std::size_t h = 0; h < options_.horizons.size(); ++h) {
    const double frames = frames_of(options_.horizons[h], options_, scene);
    const Poses predicted = predicted_at(result, frames), truth = recorded_at(scene, frames);
    result.at_horizon.push_back(scene_error(select(predicted, scored), select(truth, scored), select(sizes_m, scored)));
    result.object_at_horizon.push_back(object_errors(predicted, truth, sizes_m));
    errors_[h].push_back(result.at_horizon.back());
  }
  add_curve(result);
  if (options_.to_the_end) add_settled(scored, result);
  settled_.num_settled += result.settled.num_settled;
  settled_.num_right_face += result.settled.num_right_face;
  return result;
}

void RolloutRound::append_scores(const std::string& model, const std::string& set, std::vector<Score>& scores) const {
  if (errors_.front().empty()) {
    throw std::invalid_argument("evaluation: no object of set " + set + " rests from frame " + std::to_string(start_) +
                                " on");
  }
  for (std::size_t h = 0; h < options_.horizons.size(); ++h) {
    scores.push_back({model, set, start_, step_, options_.horizons[h], static_cast<int>(errors_[h].size()),
                      mean_error(errors_[h]), compute_s_ / predicted_s_, settled_});
  }
}

}  // namespace rigidformer
