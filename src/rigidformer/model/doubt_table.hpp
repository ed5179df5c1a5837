// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "rigidformer/scene/object.hpp"

namespace rigidformer {

/// What an object has gone through up to a predicted step.
enum class Phase { kFree, kContact, kResting };  ///< Nothing touched; touched and moving; touched and slower than rest

/// How far a forecast is from what happens: standard deviations of one coordinate of position and rotation vector.
struct Doubt {
  double position_m = 0.0, rotation_rad = 0.0;
};

/// The doubt of a forecast without particles (`alone`), and with them: `spread_scale` times their spread and `beside`
/// it, both squared and added. `alone` and `beside` are those of a speed of 1 m/s.
struct DoubtCell {
  Doubt alone, beside;
  double position_spread_scale = 1.0, rotation_spread_scale = 1.0;
};

/// Measured doubt of one model by knowledge, phase and time (doubt.hpp), as fit_doubt.cpp finds it on scenes never
/// learned from.
struct DoubtTable {
  static constexpr std::array<double, 5> kTimes_s{0.05, 0.1, 0.2, 0.4, 0.8};  ///< Of the rows; about a factor of two

  std::array<std::array<std::array<DoubtCell, kTimes_s.size()>, 3>, 3> cells;  ///< [knowledge][phase][time]

  /// Linear between times, constant before the first one, and proportional to the time after the last one.
  DoubtCell at(Knowledge knowledge, Phase phase, double time_s) const;
};

/// Lossless round trip; reading throws std::runtime_error for anything else than a table of finite numbers of at least
/// 0.
std::string to_json(const DoubtTable& table);
DoubtTable doubt_table_from_json(const std::string& text);

/// Writes the model of one checkpoint with that table into another one, its weights stored as bfloat16. Throws
/// std::runtime_error naming the file.
void store_doubt(const std::filesystem::path& model, const DoubtTable& table, const std::filesystem::path& output);

}  // namespace rigidformer
