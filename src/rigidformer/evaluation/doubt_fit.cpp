// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/doubt_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace rigidformer {
namespace {

constexpr std::size_t kFewSamples = 50;  // fewer say little about a cell; chosen by eye
// Distances from the middle of a normal distribution in three dimensions, in standard deviations of one coordinate,
// within which half and nine tenths of it lie: the roots of the quantiles of the chi-squared distribution.
constexpr double kHalf = 1.538, kNineTenths = 2.500;
constexpr double kSmallest = 1e-5, kLargest = 10.0;  // [m], [rad] of the search, beyond all errors
constexpr int kCandidates = 100;                     // on that logarithmic scale: 15 % apart; chosen by eye
const std::vector<double> kSpreadScales{0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0};

using Samples = std::vector<const DoubtSample*>;

/// Whether a sample belongs to the row of that time: the nearest one on a logarithmic scale.
bool is_at(const DoubtSample& sample, std::size_t row) {
  const auto distance = [&](double time_s) { return std::abs(std::log(sample.time_s / time_s)); };
  const auto& times = DoubtTable::kTimes_s;
  const auto nearest =
      std::min_element(times.begin(), times.end(), [&](double a, double b) { return distance(a) < distance(b); });
  return nearest - times.begin() == static_cast<std::ptrdiff_t>(row);
}

template <typename Belongs>
Samples select(const std::vector<DoubtSample>& samples, const Belongs& belongs) {
  Samples selected;
  for (const DoubtSample& sample : samples) {
    if (belongs(sample)) selected.push_back(&sample);
  }
  return selected;
}

/// One coordinate's worth of a sample: how far off it was, and how far particles were apart.
struct Deviation {
  Eigen::Vector3d error;
  double spread;
};

double mean_crps(const std::vector<Deviation>& deviations, double beside, double spread_scale) {
  double sum = 0.0;
  for (const Deviation& deviation : deviations) {
    const double stddev = std::hypot(beside, spread_scale * deviation.spread);
    for (const double error : deviation.error) sum += crps(stddev, error) / 3.0;
  }
  return sum / static_cast<double>(deviations.size());
}

struct Fit {
  double alone = 0.0, beside = 0.0, spread_scale = 1.0;
};

Fit fit(const std::vector<Deviation>& deviations) {
  Fit best;
  double least_alone = std::numeric_limits<double>::infinity(), least = least_alone;
  for (int i = 0; i <= kCandidates; ++i) {
    const double stddev = kSmallest * std::pow(kLargest / kSmallest, static_cast<double>(i) / kCandidates);
    for (const double scale : kSpreadScales) {
      const double score = mean_crps(deviations, stddev, scale);
      if (scale == 0.0 && score < least_alone) {
        least_alone = score;
        best.alone = stddev;
      }
      if (score >= least) continue;
      least = score;
      best.beside = stddev;
      best.spread_scale = scale;
    }
  }
  return best;
}

std::vector<Deviation> positions(const Samples& samples) {
  std::vector<Deviation> deviations;
  for (const DoubtSample* sample : samples) deviations.push_back({sample->position_error_m, sample->spread.position_m});
  return deviations;
}

std::vector<Deviation> rotations(const Samples& samples) {
  std::vector<Deviation> deviations;
  for (const DoubtSample* s : samples) deviations.push_back({s->rotation_error_rad, s->spread.rotation_rad});
  return deviations;
}

DoubtCell fit_cell(const Samples& samples) {
  if (samples.empty()) return {{kLargest, kLargest}, {kLargest, kLargest}, 1.0, 1.0};  // nothing is known: all is open
  const Fit position = fit(positions(samples)), rotation = fit(rotations(samples));
  return {{position.alone, rotation.alone},
          {position.beside, rotation.beside},
          position.spread_scale,
          rotation.spread_scale};
}

/// Share of the samples inside of a region, and mean scores, of one cell.
struct Coverage {
  double half = 0.0, nine_tenths = 0.0, score = 0.0, score_alone = 0.0;
};

Coverage coverage(const std::vector<Deviation>& deviations, double beside, double spread_scale, double alone) {
  Coverage result;
  const double share = 1.0 / static_cast<double>(deviations.size());
  for (const Deviation& deviation : deviations) {
    const double distance = deviation.error.norm() / std::hypot(beside, spread_scale * deviation.spread);
    result.half += distance < kHalf ? share : 0.0;
    result.nine_tenths += distance < kNineTenths ? share : 0.0;
  }
  result.score = mean_crps(deviations, beside, spread_scale);
  result.score_alone = mean_crps(deviations, alone, 0.0);
  return result;
}

void print_row(std::ostream& stream, const std::string& cell, const char* what, const Coverage& c, double unit) {
  char text[200];
  std::snprintf(text, sizeof(text), "| %s | %s | %.0f %% | %.0f %% | %.4f | %.4f | %.2f |\n", cell.c_str(), what,
                100.0 * c.half, 100.0 * c.nine_tenths, unit * c.score_alone, unit * c.score, c.score / c.score_alone);
  stream << text;
}

const char* name_of(Knowledge knowledge) {
  constexpr const char* kNames[] = {"shape and material", "shape", "one side"};
  return kNames[static_cast<int>(knowledge)];
}

const char* name_of(Phase phase) {
  constexpr const char* kNames[] = {"free", "in contact", "at rest"};
  return kNames[static_cast<int>(phase)];
}

/// Calls visit(knowledge, phase, row) for all cells.
template <typename Visit>
void for_each_cell(const Visit& visit) {
  for (const Knowledge knowledge : {Knowledge::kMaterial, Knowledge::kShape, Knowledge::kOneSide}) {
    for (const Phase phase : {Phase::kFree, Phase::kContact, Phase::kResting}) {
      for (std::size_t row = 0; row < DoubtTable::kTimes_s.size(); ++row) visit(knowledge, phase, row);
    }
  }
}

}  // namespace

double crps(double stddev, double error) {
  if (stddev <= 0.0) return std::abs(error);
  const double z = error / stddev;
  const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * M_PI);
  return stddev * (z * std::erf(z / std::sqrt(2.0)) + 2.0 * density - 1.0 / std::sqrt(M_PI));
}

DoubtTable fit_doubt(const std::vector<DoubtSample>& samples) {
  DoubtTable table;
  for_each_cell([&](Knowledge knowledge, Phase phase, std::size_t row) {
    Samples of_cell = select(
        samples, [&](const DoubtSample& s) { return s.knowledge == knowledge && s.phase == phase && is_at(s, row); });
    if (of_cell.size() < kFewSamples) {
      of_cell = select(samples, [&](const DoubtSample& s) { return s.knowledge == knowledge && is_at(s, row); });
    }
    table.cells[static_cast<std::size_t>(knowledge)][static_cast<std::size_t>(phase)][row] = fit_cell(of_cell);
  });
  return table;
}

void print_coverage(std::ostream& stream, const DoubtTable& table, const std::vector<DoubtSample>& samples) {
  stream << "| known | phase | time | of | inside 50 % | inside 90 % | CRPS alone | with particles | ratio |\n"
            "|---|---|---|---|---|---|---|---|---|\n";
  for_each_cell([&](Knowledge knowledge, Phase phase, std::size_t row) {
    const Samples of_cell = select(
        samples, [&](const DoubtSample& s) { return s.knowledge == knowledge && s.phase == phase && is_at(s, row); });
    if (of_cell.size() < kFewSamples) return;
    char cell[100];
    std::snprintf(cell, sizeof(cell), "%s | %s | %.2f s", name_of(knowledge), name_of(phase),
                  DoubtTable::kTimes_s.at(row));
    const DoubtCell doubt = table.at(knowledge, phase, DoubtTable::kTimes_s.at(row));
    print_row(
        stream, cell, "position [m]",
        coverage(positions(of_cell), doubt.beside.position_m, doubt.position_spread_scale, doubt.alone.position_m),
        1.0);
    print_row(
        stream, cell, "rotation [°]",
        coverage(rotations(of_cell), doubt.beside.rotation_rad, doubt.rotation_spread_scale, doubt.alone.rotation_rad),
        180.0 / M_PI);
  });
}

}  // namespace rigidformer
