// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/window_sampler.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "rigidformer/model/batch.hpp"

namespace rigidformer {
namespace {

constexpr std::int64_t kIterationsPerGroup = 8;  // iterations sorted together; chosen by eye

int uniform_int(int low, int high, std::mt19937_64& random) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

void check_probability(double value, const std::string& name) {
  if (!(value >= 0.0 && value <= 1.0)) {
    throw std::invalid_argument("windows." + name + " is " + std::to_string(value) + ", must lie in [0, 1]");
  }
}

}  // namespace

WindowSampler::WindowSampler(const WindowOptions& options, ContactEvents events,
                             std::vector<std::int64_t> object_counts, std::vector<std::int64_t> frame_counts,
                             std::vector<double> frame_rates_hz)
    : options_(options),
      events_(std::move(events)),
      object_counts_(std::move(object_counts)),
      frame_counts_(std::move(frame_counts)),
      frame_rates_hz_(std::move(frame_rates_hz)),
      num_scenes_(static_cast<int>(object_counts_.size())) {
  check_probability(options.any_step_probability, "any_step_probability");
  check_probability(options.mid_air_probability, "mid_air_probability");
  check_probability(options.floor_probability, "floor_probability");
  check_probability(options.rolling_probability, "rolling_probability");
  check_probability(options.resting_probability, "resting_probability");
  check_probability(options.driven_probability, "driven_probability");
  check_probability(
      options.mid_air_probability + options.floor_probability + options.rolling_probability +
          options.resting_probability + options.driven_probability,
      "mid_air_probability + floor_probability + rolling_probability + resting_probability + driven_probability");
  if (options.step_sizes.empty()) throw std::invalid_argument("windows.step_sizes is empty");
  const auto [smallest, largest] = std::minmax_element(options.step_sizes.begin(), options.step_sizes.end());
  frame_rates_hz_.resize(frame_counts_.size(), kFrameRateHz);
  for (std::size_t scene = 0; scene < frame_counts_.size(); ++scene) {
    if (*smallest < 1 || 2 * frames_at_rate(*largest, frame_rates_hz_[scene]) >= frame_counts_[scene]) {
      throw std::invalid_argument("windows.step_sizes must be at least 1 and fit three frames into a scene of " +
                                  std::to_string(frame_counts_[scene]) + " frames");
    }
  }
}

int WindowSampler::draw_step_size(std::mt19937_64& random) const {
  const auto& sizes = options_.step_sizes;
  const bool any = std::uniform_real_distribution<>()(random) < options_.any_step_probability;
  return any ? uniform_int(1, *std::max_element(sizes.begin(), sizes.end()), random)
             : sizes[static_cast<size_t>(uniform_int(0, static_cast<int>(sizes.size()) - 1, random))];
}

/// Draws the kind of moment to choose from; null = any time. A kind that the scenes lack falls back to any time.
const std::vector<ContactEvent>* WindowSampler::draw_kind(std::mt19937_64& random) const {
  const std::pair<double, const std::vector<ContactEvent>*> kinds[] = {{options_.mid_air_probability, &events_.mid_air},
                                                                       {options_.floor_probability, &events_.floor},
                                                                       {options_.rolling_probability, &events_.rolling},
                                                                       {options_.resting_probability, &events_.resting},
                                                                       {options_.driven_probability, &events_.driven}};
  double kind = std::uniform_real_distribution<>()(random);
  for (const auto& [probability, list] : kinds) {
    if (kind < probability) return list->empty() ? nullptr : list;
    kind -= probability;
  }
  return nullptr;
}

Window WindowSampler::draw(int num_steps, std::mt19937_64& random) const {
  const int wanted = draw_step_size(random);
  const std::vector<ContactEvent>* list = draw_kind(random);
  const ContactEvent* event =
      list ? &(*list)[static_cast<size_t>(uniform_int(0, static_cast<int>(list->size()) - 1, random))] : nullptr;
  const int scene = event ? event->scene : uniform_int(0, num_scenes_ - 1, random);
  const auto last_frame = static_cast<int>(frame_counts_[static_cast<size_t>(scene)]) - 1;
  const int s =
      std::min(frames_at_rate(wanted, frame_rates_hz_[static_cast<size_t>(scene)]), last_frame / (num_steps + 1));
  if (s < 1) {
    throw std::invalid_argument("a window of " + std::to_string(num_steps + 2) + " frames does not fit into scene " +
                                std::to_string(scene) + " of " + std::to_string(last_frame + 1) + " frames");
  }
  const int last_start = last_frame - s * (num_steps + 1);
  if (!event) return {scene, uniform_int(0, last_start, random), s};
  const int lead = s + uniform_int(0, std::max(s * num_steps - 1, 0), random);
  return {scene, std::clamp(event->frame - lead, 0, last_start), s};
}

std::vector<Window> WindowSampler::draw_batch(int batch_size, int num_steps, std::uint64_t seed,
                                              std::int64_t iteration) const {
  const std::int64_t group = iteration / kIterationsPerGroup;
  std::mt19937_64 random(seed * 0x9E3779B97F4A7C15ull + static_cast<std::uint64_t>(group));
  std::vector<Window> windows;
  for (std::int64_t i = 0; i < batch_size * kIterationsPerGroup; ++i) windows.push_back(draw(num_steps, random));
  std::stable_sort(windows.begin(), windows.end(), [this](const Window& a, const Window& b) {
    return object_counts_[static_cast<size_t>(a.scene)] < object_counts_[static_cast<size_t>(b.scene)];
  });
  std::vector<int> deal(kIterationsPerGroup);
  std::iota(deal.begin(), deal.end(), 0);
  std::shuffle(deal.begin(), deal.end(), random);
  const auto first = windows.begin() + deal[static_cast<size_t>(iteration % kIterationsPerGroup)] * batch_size;
  return {first, first + batch_size};
}

}  // namespace rigidformer
