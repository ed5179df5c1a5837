// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace rigidformer {

/// The instant of an observation, to the nanosecond. A default-made stamp is the zero of its clock.
using Stamp = std::chrono::time_point<std::chrono::system_clock, std::chrono::nanoseconds>;

/// Converts `seconds` to the nearest nanosecond.
std::chrono::nanoseconds to_duration(double seconds);

/// The instant `seconds` >= 0 after the zero of the clock, to the nearest nanosecond.
inline Stamp stamp_at(double seconds) { return Stamp(to_duration(seconds)); }

/// Seconds from `from` to `to`, negative when `to` is the earlier one.
double seconds_between(Stamp from, Stamp to);

}  // namespace rigidformer
