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
  const auto distance = [&](double time_s) {
    return std::abs(std::log(std::max(sample.progress.time_s, DoubtTable::kTimes_s.front()) / time_s));
  };
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

/// How far off a pose was, how far particles were apart, and how fast the object had been.
struct Deviation {
  Eigen::Vector3d error;
  double spread, speed_mps;
};

/// Standard deviations are `constant` + `beside` times the speed, and the scaled spread.
struct Spreading {
  double constant = 0.0, beside = 0.0, spread_scale = 0.0;

  double stddev(const Deviation& deviation) const {
    return std::hypot(constant + beside * deviation.speed_mps, spread_scale * deviation.spread);
  }
};

double mean_crps(const std::vector<Deviation>& deviations, const Spreading& spreading, bool per_speed) {
  double sum = 0.0;
  for (const Deviation& deviation : deviations) {
    const double stddev = spreading.stddev(deviation), unit = per_speed ? deviation.speed_mps : 1.0;
    for (const double error : deviation.error) sum += crps(stddev, error) / (3.0 * unit);
  }
  return sum / static_cast<double>(deviations.size());
}

double candidate(int i) { return kSmallest * std::pow(kLargest / kSmallest, static_cast<double>(i) / kCandidates); }

Spreading best_with(const std::vector<Deviation>& deviations, const std::vector<double>& spread_scales) {
  Spreading best;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kCandidates; ++i) {
    for (const double scale : spread_scales) {
      const Spreading spreading{0.0, candidate(i), scale};
      const double score = mean_crps(deviations, spreading, true);
      if (score >= least) continue;
      least = score;
      best = spreading;
    }
  }
  return best;
}

/// The least score that one standard deviation can have.
double score_of_constant(const std::vector<Deviation>& deviations) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kCandidates; ++i) {
    least = std::min(least, mean_crps(deviations, {candidate(i), 0.0, 0.0}, false));
  }
  return least;
}

std::vector<Deviation> positions(const Samples& samples) {
  std::vector<Deviation> deviations;
  for (const DoubtSample* sample : samples) {
    deviations.push_back({sample->position_error_m, sample->spread.position_m, sample->progress.speed_mps});
  }
  return deviations;
}

std::vector<Deviation> rotations(const Samples& samples) {
  std::vector<Deviation> deviations;
  for (const DoubtSample* sample : samples) {
    deviations.push_back({sample->rotation_error_rad, sample->spread.rotation_rad, sample->progress.speed_mps});
  }
  return deviations;
}

DoubtCell fit_cell(const Samples& samples) {
  if (samples.empty()) return {{kLargest, kLargest}, {kLargest, kLargest}, 1.0, 1.0};  // nothing is known: all is open
  const std::vector<Deviation> position = positions(samples), rotation = rotations(samples);
  const Spreading with = best_with(position, kSpreadScales), turn_with = best_with(rotation, kSpreadScales);
  return {{best_with(position, {0.0}).beside, best_with(rotation, {0.0}).beside},
          {with.beside, turn_with.beside},
          with.spread_scale,
          turn_with.spread_scale};
}

void print_row(std::ostream& stream, const std::string& cell, const char* what,
               const std::vector<Deviation>& deviations, const Spreading& alone, const Spreading& with, double unit) {
  int half = 0, nine_tenths = 0;
  for (const Deviation& deviation : deviations) {
    const double distance = deviation.error.norm() / with.stddev(deviation);
    half += distance < kHalf ? 1 : 0;
    nine_tenths += distance < kNineTenths ? 1 : 0;
  }
  const double count = static_cast<double>(deviations.size()), constant = score_of_constant(deviations);
  const double score_alone = mean_crps(deviations, alone, false), score_with = mean_crps(deviations, with, false);
  char text[300];
  std::snprintf(text, sizeof(text), "| %s | %s | %zu | %.0f %% | %.0f %% | %.4f | %.4f | %.4f | %.2f |\n", cell.c_str(),
                what, deviations.size(), 100.0 * half / count, 100.0 * nine_tenths / count, unit * constant,
                unit * score_alone, unit * score_with, score_with / constant);
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
    Samples of_cell = select(samples, [&](const DoubtSample& s) {
      return s.knowledge == knowledge && s.progress.phase == phase && is_at(s, row);
    });
    if (of_cell.size() < kFewSamples) {
      of_cell = select(samples, [&](const DoubtSample& s) { return s.knowledge == knowledge && is_at(s, row); });
    }
    table.cells[static_cast<std::size_t>(knowledge)][static_cast<std::size_t>(phase)][row] = fit_cell(of_cell);
  });
  return table;
}

void print_coverage(std::ostream& stream, const DoubtTable& table, const std::vector<DoubtSample>& samples) {
  stream << "| known | phase | time | of | poses | inside 50 % | inside 90 % | CRPS of one number | alone | with "
            "particles "
            "| ratio |\n|---|---|---|---|---|---|---|---|---|---|---|\n";
  for_each_cell([&](Knowledge knowledge, Phase phase, std::size_t row) {
    const Samples of_cell = select(samples, [&](const DoubtSample& s) {
      return s.knowledge == knowledge && s.progress.phase == phase && is_at(s, row);
    });
    if (of_cell.size() < kFewSamples) return;
    char cell[100];
    std::snprintf(cell, sizeof(cell), "%s | %s | %.2f s", name_of(knowledge), name_of(phase),
                  DoubtTable::kTimes_s.at(row));
    const DoubtCell doubt = table.at(knowledge, phase, DoubtTable::kTimes_s.at(row));
    print_row(stream, cell, "position [m]", positions(of_cell), {0.0, doubt.alone.position_m, 0.0},
              {0.0, doubt.beside.position_m, doubt.position_spread_scale}, 1.0);
    print_row(stream, cell, "rotation [°]", rotations(of_cell), {0.0, doubt.alone.rotation_rad, 0.0},
              {0.0, doubt.beside.rotation_rad, doubt.rotation_spread_scale}, 180.0 / M_PI);
  });
}

}  // namespace rigidformer
