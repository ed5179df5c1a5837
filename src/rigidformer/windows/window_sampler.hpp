// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "rigidformer/windows/contact_events.hpp"
#include "rigidformer/windows/options.hpp"

namespace rigidformer {

/// One window: frames `frame`, `frame` + s, ..., of one scene, in the scene's own frames.
struct Window {
  int scene = 0;
  int frame = 0;
  int step_size = 1;
};

/// Draws windows of 2 + num_steps frames. Around a contact, the event lies in the predicted part.
class WindowSampler {
 public:
  /// Numbers of objects and of frames and the frame rates are those of every scene; no rates: all have 240 Hz. Step
  /// sizes count frames of 1/240 s and become as many of the scene's own. Throws std::invalid_argument naming the
  /// option at fault, or a scene that is too short.
  WindowSampler(const WindowOptions& options, ContactEvents events, std::vector<std::int64_t> object_counts,
                std::vector<std::int64_t> frame_counts, std::vector<double> frame_rates_hz = {});

  /// Steps are shortened where a window would not fit into its scene. Throws std::invalid_argument where none does.
  Window draw(int num_steps, std::mt19937_64& random) const;

  /// Draws the windows of one training iteration. Iterations come in groups whose windows are sorted by their
  /// number of objects before they are dealt out, so that a batch carries little padding. The same seed and
  /// iteration give the same windows.
  std::vector<Window> draw_batch(int batch_size, int num_steps, std::uint64_t seed, std::int64_t iteration) const;

 private:
  int draw_step_size(std::mt19937_64& random) const;
  const std::vector<ContactEvent>* draw_kind(std::mt19937_64& random) const;

  WindowOptions options_;
  ContactEvents events_;
  std::vector<std::int64_t> object_counts_, frame_counts_;  ///< Numbers of every scene
  std::vector<double> frame_rates_hz_;                      ///< Likewise
  int num_scenes_;
};

}  // namespace rigidformer
