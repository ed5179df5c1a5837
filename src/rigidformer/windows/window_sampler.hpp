// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "rigidformer/windows/contact_events.hpp"

namespace rigidformer {

/// Which moments of which scenes are learned from. Field names are the YAML keys under `windows:`.
struct WindowOptions {
  std::vector<int> step_sizes = {1, 5, 10};  ///< s drawn from here ...
  double any_step_probability = 0.0;         ///< ... or, with this probability, uniformly from 1 ... max(step_sizes)
  double mid_air_probability = 0.0;          ///< Windows around object-object contacts
  double floor_probability = 0.0;            ///< Windows around floor impacts
  double rolling_probability = 0.0;          ///< Windows in which an object rolls or slides on the floor
  double resting_probability = 0.0;          ///< Windows in which an object rests; what is left is uniform in time
};

/// One window: frames `frame`, `frame` + s, ..., of one scene.
struct Window {
  int scene = 0;
  int frame = 0;
  int step_size = 1;
};

/// Draws windows of 2 + num_steps frames; around a contact, the event lies in the predicted part.
class WindowSampler {
 public:
  /// Numbers of objects and of frames are per scene. Throws std::invalid_argument naming the option at fault, or a
  /// scene that is too short.
  WindowSampler(const WindowOptions& options, ContactEvents events, std::vector<int64_t> object_counts,
                std::vector<int64_t> frame_counts);

  /// Steps are shortened where a window would not fit into its scene. Throws std::invalid_argument where none does.
  Window draw(int num_steps, std::mt19937_64& random) const;

  /// The windows of one training iteration. Iterations come in groups whose windows are sorted by their number of
  /// objects before they are dealt out, so that a batch carries little padding. The same seed and iteration give the
  /// same windows.
  std::vector<Window> draw_batch(int batch_size, int num_steps, std::uint64_t seed, std::int64_t iteration) const;

 private:
  int draw_step_size(std::mt19937_64& random) const;
  const std::vector<ContactEvent>* draw_kind(std::mt19937_64& random) const;

  WindowOptions options_;
  ContactEvents events_;
  std::vector<int64_t> object_counts_, frame_counts_;  ///< Per scene
  int num_scenes_;
};

}  // namespace rigidformer
