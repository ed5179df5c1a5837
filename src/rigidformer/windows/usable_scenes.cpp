// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/usable_scenes.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "rigidformer/model/batch.hpp"
#include "rigidformer/windows/scene_tensors.hpp"

namespace rigidformer {
namespace {

constexpr std::size_t kMaxNames = 5;
constexpr double kLongestStepInFrames = 0.95;  // rates are measured: what is nearly a frame is one; chosen by eye

bool something_moves(const SceneRecording& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [](const RecordedObject& object) { return !object.is_given(); });
}

/// Removes the scenes of which `defect` is true and says so.
std::string remove_if(SceneArchive& archive, const std::function<bool(const SceneRecording&)>& defect,
                      const std::string& reason) {
  std::string names;
  std::size_t count = 0;
  for (const SceneRecording& scene : archive.scenes) {
    if (!defect(scene) || ++count > kMaxNames) continue;
    names += (names.empty() ? "'" : ", '") + scene.name + "'";
  }
  if (count == 0) return "";
  archive.scenes.erase(std::remove_if(archive.scenes.begin(), archive.scenes.end(), defect), archive.scenes.end());
  return "set '" + archive.set + "': " + std::to_string(count) + " scenes left out, because " + reason + ": " + names +
         (count > kMaxNames ? ", ...\n" : "\n");
}

}  // namespace

int WindowNeeds::least_frames(double frame_rate_hz) const {
  return std::max(1 + 2 * frames_at_rate(longest_step, frame_rate_hz), unrolled_steps + 2);
}

std::string leave_out_unusable_scenes(SceneArchive& archive, const WindowNeeds& needs) {
  std::string sentences;
  sentences += remove_if(
      archive, [](const SceneRecording& scene) { return !something_moves(scene); },
      "they hold no object that can move (instances is empty, or all are static, driven or background)");
  sentences += remove_if(
      archive, [&](const SceneRecording& scene) { return scene.num_frames < needs.least_frames(scene.frame_rate_hz); },
      "they have fewer frames than a window needs (three frames the longest step apart, and every unrolled step: " +
          std::to_string(needs.least_frames(kFrameRateHz)) + " at 240 Hz)");
  sentences += remove_if(
      archive,
      [&](const SceneRecording& scene) {
        return needs.longest_step * scene.frame_rate_hz < kLongestStepInFrames * kFrameRateHz;
      },
      "one of their frames is longer than the longest step of " + std::to_string(needs.longest_step) +
          " frames of 1/240 s");
  if (archive.scenes.empty()) {
    throw std::invalid_argument("no scene to learn from in set '" + archive.set + "'. " +
                                (sentences.empty() ? "It holds none" : sentences.substr(0, sentences.size() - 1)));
  }
  return sentences;
}

}  // namespace rigidformer
