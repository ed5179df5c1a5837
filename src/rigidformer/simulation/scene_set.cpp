// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/scene_set.hpp"

#include <algorithm>
#include <stdexcept>

#include "rigidformer/simulation/walker_scene.hpp"
#include "rigidformer/simulation/wrecking_ball_scene.hpp"

namespace rigidformer {
namespace {

constexpr int kWreckingBallFrames = 600;  // App. H.1

}  // namespace

const std::vector<std::string>& scene_set_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"movi_sphere", "movi_a", "movi_b"};
    all.insert(all.end(), wrecking_ball_set_names().begin(), wrecking_ball_set_names().end());
    all.insert(all.end(), walker_set_names().begin(), walker_set_names().end());
    return all;
  }();
  return names;
}

void check_scene_set(const std::string& set) {
  const auto& names = scene_set_names();
  if (std::find(names.begin(), names.end(), set) != names.end()) return;
  std::string accepted;
  for (const std::string& name : names) accepted += (accepted.empty() ? "" : ", ") + name;
  throw std::invalid_argument("set '" + set + "' is not one of " + accepted);
}

bool draws_from_library(const std::string& set) { return !wrecking_ball_set(set) && walker_set(set) == nullptr; }

bool has_commands(const std::string& set) { return walker_set(set) != nullptr; }

int usual_num_frames(const std::string& set) {
  if (walker_set(set) != nullptr) return kWalkerFrames;
  return wrecking_ball_set(set) ? kWreckingBallFrames : MoviOptions().num_frames;
}

int max_num_objects(const std::string& set) {
  if (const WalkerDesign* walker = walker_set(set)) return static_cast<int>(walker->parts.size());
  const auto wrecking_ball = wrecking_ball_set(set);
  if (!wrecking_ball) return MoviOptions().max_objects;
  const int n = wrecking_ball->cubes_per_edge;
  return n * n * n + 1;
}

std::vector<Shape> scene_set_shapes(const std::string& set, const std::vector<Shape>& library) {
  check_scene_set(set);
  if (const WalkerDesign* walker = walker_set(set)) return walker_shapes(*walker);
  return draws_from_library(set) ? movi_shapes(parse_movi_set(set), library) : wrecking_ball_shapes();
}

SceneRecording generate_scene(const std::string& set, const std::vector<Shape>& shapes, std::uint64_t seed,
                              std::uint64_t index, const MoviOptions& options) {
  check_scene_set(set);
  if (const WalkerDesign* walker = walker_set(set)) {
    const auto commands = draw_walker_commands(*walker, seed, index, options.num_frames);
    return simulate_walker(*walker, commands, seed, index, options.first_frame);
  }
  const auto wrecking_ball = wrecking_ball_set(set);
  if (!wrecking_ball) return generate_movi_scene(parse_movi_set(set), shapes, seed, index, options);
  return simulate(sample_wrecking_ball_scene(*wrecking_ball, seed, index), shapes, wrecking_ball_settings(),
                  options.num_frames, options.first_frame);
}

}  // namespace rigidformer
