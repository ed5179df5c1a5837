// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/doubt_fit.hpp"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

namespace rigidformer {
namespace {

TEST(DoubtFit, CrpsOfANormalDistribution) {
  EXPECT_NEAR(crps(1.0, 0.0), (std::sqrt(2.0) - 1.0) / std::sqrt(M_PI), 1e-12);
  EXPECT_NEAR(crps(0.0, -0.3), 0.3, 1e-12);
  EXPECT_NEAR(crps(2.0, 1.0), 2.0 * crps(1.0, 0.5), 1e-12);
  double numeric = 0.0;  // the integral of the squared distance of the distribution functions
  for (double x = -8.0; x < 8.0; x += 1e-3) {
    const double distribution = 0.5 * std::erfc(-x / std::sqrt(2.0));
    numeric += 1e-3 * std::pow(distribution - (x >= 0.7 ? 1.0 : 0.0), 2);
  }
  EXPECT_NEAR(crps(1.0, 0.7), numeric, 1e-3);
}

/// Errors of which the particles know a part: known standard deviations of both.
std::vector<DoubtSample> drawn_samples(double beside_m, double time_s, int count) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> spread_m(0.0, 0.3);
  std::vector<DoubtSample> samples;
  for (int i = 0; i < count; ++i) {
    DoubtSample sample;
    sample.progress = {Phase::kFree, time_s, 2.0};
    sample.spread.position_m = spread_m(random);
    const double stddev_m = std::hypot(2.0 * beside_m, 2.0 * sample.spread.position_m);
    for (double& error : sample.position_error_m) error = stddev_m * normal(random);
    for (double& error : sample.rotation_error_rad) error = 0.2 * normal(random);
    samples.push_back(sample);
  }
  return samples;
}

TEST(DoubtFit, FindsWhatWasDrawn) {
  const DoubtTable table = fit_doubt(drawn_samples(0.05, 0.22, 3000));
  const DoubtCell cell = table.at(Knowledge::kMaterial, Phase::kFree, 0.2);
  EXPECT_DOUBLE_EQ(cell.position_spread_scale, 2.0);
  EXPECT_NEAR(cell.beside.position_m, 0.05, 0.01);
  EXPECT_GT(cell.alone.position_m, 0.1);
  EXPECT_NEAR(cell.alone.rotation_rad, 0.1, 0.015);
}

TEST(DoubtFit, CoverageOfWhatWasDrawnIsAsPromised) {
  const auto samples = drawn_samples(0.05, 0.2, 3000);
  std::ostringstream text;
  print_coverage(text, fit_doubt(samples), samples);
  EXPECT_NE(text.str().find("| shape and material | free | 0.20 s | position [m] | 3000 | "), std::string::npos)
      << text.str();
  EXPECT_NE(text.str().find(" % | 9"), std::string::npos) << text.str();
}

TEST(DoubtFit, ACellWithFewSamplesTakesThoseOfAllPhases) {
  auto samples = drawn_samples(0.05, 0.2, 200);
  samples.back().progress.phase = Phase::kResting;
  const DoubtTable table = fit_doubt(samples);
  const double resting_m = table.at(Knowledge::kMaterial, Phase::kResting, 0.2).alone.position_m;
  EXPECT_NEAR(resting_m, table.at(Knowledge::kMaterial, Phase::kFree, 0.2).alone.position_m, 0.02);
}

}  // namespace
}  // namespace rigidformer
