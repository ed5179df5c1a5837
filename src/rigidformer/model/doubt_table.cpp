// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/doubt_table.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace rigidformer {
namespace {

using Json = nlohmann::ordered_json;
using Numbers = std::array<double, 6>;

Numbers numbers_of(const DoubtCell& cell) {
  return {cell.alone.position_m,   cell.beside.position_m,   cell.position_spread_scale,
          cell.alone.rotation_rad, cell.beside.rotation_rad, cell.rotation_spread_scale};
}

DoubtCell cell_of(const Numbers& n) { return {{n[0], n[3]}, {n[1], n[4]}, n[2], n[5]}; }

/// Number by number; the scales of the spread have no unit and stay the same when times grow.
DoubtCell mixed(const DoubtCell& a, const DoubtCell& b, double share_b) {
  const Numbers x = numbers_of(a), y = numbers_of(b);
  Numbers mixture;
  for (std::size_t i = 0; i < mixture.size(); ++i) mixture[i] = (1.0 - share_b) * x[i] + share_b * y[i];
  return cell_of(mixture);
}

DoubtCell grown(DoubtCell cell, double factor) {
  for (Doubt* doubt : {&cell.alone, &cell.beside}) {
    doubt->position_m *= factor;
    doubt->rotation_rad *= factor;
  }
  return cell;
}

}  // namespace

DoubtCell DoubtTable::at(Knowledge knowledge, Phase phase, double time_s) const {
  const auto& row = cells.at(static_cast<std::size_t>(knowledge)).at(static_cast<std::size_t>(phase));
  const auto next = std::upper_bound(kTimes_s.begin(), kTimes_s.end(), time_s);
  if (next == kTimes_s.begin()) return row.front();
  if (next == kTimes_s.end()) return grown(row.back(), time_s / kTimes_s.back());
  const auto i = static_cast<std::size_t>(next - kTimes_s.begin());
  return mixed(row[i - 1], row[i], (time_s - kTimes_s[i - 1]) / (kTimes_s[i] - kTimes_s[i - 1]));
}

std::string to_json(const DoubtTable& table) {
  Json json = Json::array();
  for (const auto& phases : table.cells) {
    for (const auto& times : phases) {
      for (const DoubtCell& cell : times) json.push_back(numbers_of(cell));
    }
  }
  return json.dump();
}

DoubtTable doubt_table_from_json(const std::string& text) {
  DoubtTable table;
  try {
    const Json json = Json::parse(text);
    std::size_t row = 0;
    for (auto& phases : table.cells) {
      for (auto& times : phases) {
        for (DoubtCell& cell : times) cell = cell_of(json.at(row++).get<Numbers>());
      }
    }
    if (json.size() != row) throw std::runtime_error("it has " + std::to_string(json.size()) + " rows");
    for (const Json& numbers : json) {
      for (const Json& number : numbers) {
        if (!(number.get<double>() >= 0.0)) throw std::runtime_error("it holds " + number.dump());
      }
    }
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string("table of doubt: ") + error.what());
  }
  return table;
}

}  // namespace rigidformer
