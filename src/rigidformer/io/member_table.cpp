// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/io/member_table.hpp"

#include <cmath>
#include <iomanip>

namespace rigidformer {
namespace {

std::string code(const std::string& text) { return "`" + text + "`"; }

}  // namespace

std::string number_text(double value) {
  std::ostringstream text;
  const double exponent = std::log10(std::abs(value));
  const bool is_power_of_ten = exponent == std::floor(exponent);
  if (is_power_of_ten && std::isfinite(exponent) && std::abs(exponent) >= 4.0) {
    text << (value < 0.0 ? "-" : "") << "1e" << exponent;
  } else if (value == std::floor(value) && std::abs(value) < 1e15) {
    text << std::fixed << std::setprecision(0) << value;
  } else {
    text << value;
  }
  return text.str();
}

std::string accepted_text(const Accepts& accepts, const std::string& kind) {
  std::string text = kind;
  if (std::isfinite(accepts.min) && std::isfinite(accepts.max)) {
    text = number_text(accepts.min) + " to " + number_text(accepts.max);
  } else if (std::isfinite(accepts.min)) {
    text = (accepts.above_min ? "above " : "from ") + number_text(accepts.min);
  } else if (!accepts.words.empty()) {
    return joined(accepts.words, ", ");
  }
  text += accepts.above_min && std::isfinite(accepts.max) ? ", not " + number_text(accepts.min) : "";
  text += accepts.below_max ? ", not " + number_text(accepts.max) : "";
  return text + (accepts.words.empty() ? "" : ", or " + accepts.words.front());
}

std::string markdown_table(const std::vector<MemberRow>& rows) {
  std::string text = "| name | default | range | meaning |\n|---|---|---|---|\n";
  for (const MemberRow& row : rows) {
    const bool is_path = row.value.find_first_of("/*_") != std::string::npos;
    text += "| " + code(row.key) + " | " + (is_path ? code(row.value) : row.value) + " | " + row.accepted + " | " +
            row.description + " |\n";
  }
  return text;
}

std::string help_lines(const std::vector<MemberRow>& rows) {
  std::ostringstream text;
  for (const MemberRow& row : rows) {
    text << "  " << std::left << std::setw(24) << row.key << ' ' << row.description << " (" << row.accepted << ") ["
         << row.value << "]\n";
  }
  return text.str();
}

}  // namespace rigidformer
