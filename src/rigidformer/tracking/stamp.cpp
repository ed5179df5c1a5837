// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/stamp.hpp"

#include <cmath>

namespace rigidformer {

std::chrono::nanoseconds to_duration(double seconds) {
  const double whole = std::floor(seconds);
  return std::chrono::seconds(static_cast<std::chrono::seconds::rep>(whole)) +
         std::chrono::nanoseconds(std::llround((seconds - whole) * 1e9));
}

double seconds_between(Stamp from, Stamp to) {
  const std::chrono::nanoseconds difference = to - from;
  // Whole seconds are converted apart from the rest: one double cannot hold a long time together with its nanoseconds.
  const auto whole = std::chrono::floor<std::chrono::seconds>(difference);
  return static_cast<double>(whole.count()) + 1e-9 * static_cast<double>((difference - whole).count());
}

}  // namespace rigidformer
