// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/usable_scenes.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>

namespace rigidformer {
namespace {

constexpr std::size_t kMaxNames = 5;

bool something_moves(const SceneRecording& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [](const RecordedObject& object) { return !object.is_static; });
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

std::string leave_out_unusable_scenes(SceneArchive& archive, int least_frames) {
  std::string sentences;
  sentences += remove_if(
      archive, [](const SceneRecording& scene) { return !something_moves(scene); },
      "they hold no object that can move (instances is empty, or all are static or background)");
  sentences += remove_if(
      archive, [&](const SceneRecording& scene) { return scene.num_frames < least_frames; },
      "they have fewer than the " + std::to_string(least_frames) +
          " frames that a window needs (three frames the longest step apart, and every unrolled step)");
  if (archive.scenes.empty()) {
    throw std::invalid_argument("no scene to learn from in set '" + archive.set + "'. " +
                                (sentences.empty() ? "It holds none" : sentences.substr(0, sentences.size() - 1)));
  }
  return sentences;
}

}  // namespace rigidformer
