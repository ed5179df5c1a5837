// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <vector>

#include "rigidformer/doubt.hpp"

namespace rigidformer {

/// How far one predicted pose was from the truth, and how far its particles were from each other.
struct DoubtSample {
  Knowledge knowledge = Knowledge::kMaterial;
  MotionProgress progress;
  Eigen::Vector3d position_error_m = Eigen::Vector3d::Zero(), rotation_error_rad = Eigen::Vector3d::Zero();
  Doubt spread;
};

/// Continuous ranked probability score of a normal distribution around 0 for what turned out to be `error`, in the unit
/// of both: Gneiting and Raftery, Strictly Proper Scoring Rules (2007), Eq. (21). A standard deviation of 0 gives
/// |error|.
double crps(double stddev, double error);

/// The doubts with the least mean score, cell by cell. A cell with few samples takes those of all phases.
DoubtTable fit_doubt(const std::vector<DoubtSample>& samples);

/// A table in Markdown by knowledge, phase and time: how often the truth lay inside of the regions of 50 and of 90 %,
/// and the scores of the best single standard deviation of these very samples, of the table without particles and with
/// them.
void print_coverage(std::ostream& stream, const DoubtTable& table, const std::vector<DoubtSample>& samples);

}  // namespace rigidformer
