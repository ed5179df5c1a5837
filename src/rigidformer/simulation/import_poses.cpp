// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "import_poses.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <utility>

#include "measured_shape.hpp"

namespace rigidformer {
namespace {

constexpr double kStaticSlack_m = 0.01;  // [m] noise of a tracker on what stands; chosen by eye

using Shapes = std::map<std::string, MeasuredShape>;

bool is_number(const std::string& text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return !text.empty() && text.size() < 10 && std::all_of(text.begin(), text.end(), is_digit);
}

/// Whether `choice`, a name or a range of numbers, stands for that recording.
bool chooses(const std::string& choice, const std::string& name) {
  const std::size_t dash = choice.find('-');
  if (dash != std::string::npos && is_number(name)) {
    const std::string first = choice.substr(0, dash), last = choice.substr(dash + 1);
    if (is_number(first) && is_number(last)) {
      return std::stol(first) <= std::stol(name) && std::stol(name) <= std::stol(last);
    }
  }
  return choice == name;
}

std::vector<MeasuredRecording> chosen_recordings(const ImportOptions& options) {
  std::vector<MeasuredRecording> recordings;
  for (const std::filesystem::path& path : options.poses) {
    for (MeasuredRecording& recording : read_pose_csv(path, options.recording_column)) {
      const auto is_it = [&](const std::string& choice) { return chooses(choice, recording.name); };
      const bool is_taken =
          options.recordings.empty() || std::any_of(options.recordings.begin(), options.recordings.end(), is_it);
      if (is_taken) recordings.push_back(std::move(recording));
    }
  }
  if (recordings.empty()) throw std::invalid_argument("none of the recordings asked for is in the tables");
  return recordings;
}

std::optional<double> value_of(const std::map<std::string, double>& values, const std::string& id) {
  const auto found = values.find(id);
  return found == values.end() ? std::nullopt : std::make_optional(found->second);
}

const MeasuredShape& shape_of(const Shapes& shapes, const std::string& id, const std::string& recording) {
  const auto found = shapes.find(id);
  if (found != shapes.end()) return found->second;
  throw std::invalid_argument("recording '" + recording + "': object '" + id + "' has no shape: name one for it");
}

/// Makes the first pose the only one; refuses what was seen to move.
void hold_still(const std::string& id, RecordedObject& object) {
  const RigidTransform first = object.T_world_object.front();
  for (RigidTransform& pose : object.T_world_object) {
    const double moved_m = (pose.translation - first.translation).norm();
    if (moved_m > kStaticSlack_m) {
      throw std::invalid_argument("object '" + id + "' is said to be static and moved by " + std::to_string(moved_m) +
                                  " m");
    }
    pose = first;
  }
}

RecordedObject make_object(const ImportOptions& options, const Shapes& shapes, const MeasuredFrames& frames,
                           std::size_t index) {
  const std::string& id = frames.ids[index];
  const MeasuredShape& measured = shape_of(shapes, id, frames.name);
  RecordedObject object;
  object.shape = id;
  object.properties = {value_of(options.masses_kg, id), value_of(options.frictions, id),
                       value_of(options.restitutions, id)};
  const RigidTransform T_object_centre{Eigen::Quaterniond::Identity(), measured.centre_object};
  for (RigidTransform pose : frames.T_world_object[index]) {
    pose.translation *= options.length_factor;
    pose.translation.z() -= options.ground_height_m;
    object.T_world_object.push_back(pose * T_object_centre);
  }
  object.is_static = options.static_ids.count(id) > 0;
  if (object.is_static) hold_still(id, object);
  return object;
}

SceneRecording make_scene(const ImportOptions& options, const Shapes& shapes, const MeasuredFrames& frames) {
  SceneRecording scene;
  scene.name = frames.name;
  scene.frame_rate_hz = frames.frame_rate_hz;
  scene.gravity = {0.0, 0.0, options.gravity};
  scene.ground = {};  // a table of poses says nothing about the floor under them
  scene.num_frames = static_cast<int>(frames.T_world_object.front().size());
  for (std::size_t k = 0; k < frames.ids.size(); ++k) {
    scene.objects.push_back(make_object(options, shapes, frames, k));
  }
  return scene;
}

Shapes make_shapes(const ImportOptions& options, std::string& summary) {
  Shapes shapes;
  for (const auto& [id, text] : options.shapes) {
    MeasuredShape shape = measured_shape(id, text);
    shape.shape.mass_kg = value_of(options.masses_kg, id).value_or(shape.shape.mass_kg);
    if (!shape.remark.empty()) summary += shape.remark + '\n';
    shapes.emplace(id, std::move(shape));
  }
  return shapes;
}

void require(bool condition, const std::string& what, double value) {
  if (!condition) throw std::invalid_argument("import_poses: " + what + " is " + std::to_string(value));
}

void check(const ImportOptions& options) {
  require(options.gravity <= 0.0, "gravity must not be above 0 and", options.gravity);
  require(options.length_factor > 0.0, "the length factor must be above 0 and", options.length_factor);
  require(options.validation_share >= 0.0 && options.validation_share < 1.0,
          "the validation share must lie in [0, 1) and", options.validation_share);
  require(options.frames.frame_rate_hz >= 0.0, "the rate must not be negative and", options.frames.frame_rate_hz);
  for (const auto& [id, mass] : options.masses_kg) {
    require(mass > 0.0, "the mass of '" + id + "' must be > 0 and", mass);
  }
  for (const auto& [id, friction] : options.frictions) {
    require(friction >= 0.0, "the friction of '" + id + "' must be >= 0 and", friction);
  }
  for (const auto& [id, e] : options.restitutions) {
    require(e >= 0.0 && e <= 1.0, "the restitution of '" + id + "' must lie in [0, 1] and", e);
  }
}

std::string line(const char* pattern, std::size_t a, std::size_t b, double least, double most) {
  char text[160];
  std::snprintf(text, sizeof text, pattern, a, b, least, most);
  return text;
}

}  // namespace

ImportedScenes import_poses(const ImportOptions& options) {
  check(options);
  ImportedScenes imported;
  const std::vector<MeasuredRecording> recordings = chosen_recordings(options);
  const Shapes shapes = make_shapes(options, imported.summary);
  for (SceneArchive* archive : {&imported.training, &imported.validation}) {
    archive->set = options.set;
    for (const auto& [id, measured] : shapes) archive->shapes.push_back(measured.shape);
  }
  const auto num_validation =
      static_cast<std::size_t>(std::lround(options.validation_share * static_cast<double>(recordings.size())));
  std::size_t num_resampled = 0;
  double least_hz = 0.0, most_hz = 0.0;
  for (std::size_t r = 0; r < recordings.size(); ++r) {
    SceneArchive& archive = r + num_validation < recordings.size() ? imported.training : imported.validation;
    for (const MeasuredFrames& frames : to_frames(recordings[r], options.frames)) {
      archive.scenes.push_back(make_scene(options, shapes, frames));
      num_resampled += frames.is_resampled ? 1 : 0;
      least_hz = least_hz == 0.0 ? frames.frame_rate_hz : std::min(least_hz, frames.frame_rate_hz);
      most_hz = std::max(most_hz, frames.frame_rate_hz);
    }
  }
  const std::size_t num_scenes = imported.training.scenes.size() + imported.validation.scenes.size();
  imported.summary +=
      line("%zu recordings, %zu scenes, frames of %.2f to %.2f Hz\n", recordings.size(), num_scenes, least_hz, most_hz);
  imported.summary += std::to_string(num_scenes - num_resampled) + " scenes hold the measured frames, " +
                      std::to_string(num_resampled) + " are resampled\n";
  return imported;
}

}  // namespace rigidformer
