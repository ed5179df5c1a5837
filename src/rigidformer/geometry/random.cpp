// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/random.hpp"

#include <cmath>

namespace rigidformer {
namespace {

/// The finaliser of SplitMix64: with it neighbouring seeds give unrelated states of the engine.
std::uint64_t mix(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15ULL;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31);
}

}  // namespace

Random::Random(std::uint64_t seed, std::uint64_t stream) : engine_(mix(mix(seed) + stream)) {}

double Random::uniform(double low, double high) {
  constexpr double kUnit = 1.0 / 9007199254740992.0;  // 2^-53: one step of a double in [0, 1)
  return low + (high - low) * static_cast<double>(engine_() >> 11) * kUnit;
}

int Random::uniform_int(int low, int high) {
  return low + static_cast<int>(uniform(0.0, static_cast<double>(high - low) + 1.0));
}

Eigen::Quaterniond Random::rotation() {
  // Three uniform numbers place a point uniformly on the unit 3-sphere.
  const double u = uniform(0.0, 1.0);
  const double a = uniform(0.0, 2.0 * M_PI);
  const double b = uniform(0.0, 2.0 * M_PI);
  const double s = std::sqrt(1.0 - u);
  const double c = std::sqrt(u);
  return {c * std::cos(b), s * std::sin(a), s * std::cos(a), c * std::sin(b)};
}

}  // namespace rigidformer
