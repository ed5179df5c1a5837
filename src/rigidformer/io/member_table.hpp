// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rigidformer/io/members.hpp"

namespace rigidformer {

/// One member as a reader of documents sees it.
struct MemberRow {
  std::string key, value, accepted, description;
};

/// 1e6, 200000, 0.0416667: as short as it can be read.
std::string number_text(double value);

/// What is accepted, in words; `kind` where every value is.
std::string accepted_text(const Accepts& accepts, const std::string& kind);

/// A table of GitHub's Markdown.
std::string markdown_table(const std::vector<MemberRow>& rows);

/// For --help: a line per member.
std::string help_lines(const std::vector<MemberRow>& rows);

template <typename T>
std::string value_text(const T& value, const Accepts& accepts) {
  if constexpr (std::is_same_v<T, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_arithmetic_v<T>) {
    return number_text(static_cast<double>(value));
  } else if constexpr (std::is_same_v<T, std::string>) {
    return value.empty() ? "\"\"" : value;
  } else if constexpr (std::is_enum_v<T>) {
    return enum_word(value);
  } else if constexpr (std::is_same_v<T, std::optional<double>>) {
    return value ? number_text(*value) : accepts.words.front();
  } else if constexpr (has_members<T>) {
    std::vector<std::string> members;
    T copy = value;
    for_each_member(copy, [&members](const char* key, auto& member, const Accepts& its, const char*) {
      members.push_back(std::string(key) + ": " + value_text(member, its));
    });
    return "{" + joined(members, ", ") + "}";
  } else {
    std::vector<std::string> elements;
    for (const auto& element : value) {
      elements.push_back(value_text(element, accepts));
    }
    return elements.empty() ? "none" : joined(elements, ", ");
  }
}

/// The rows of all members but the nested structs, which have tables of their own, and of what comes with a preset.
/// `value` is what `options` holds.
template <typename Options>
std::vector<MemberRow> member_rows(Options options) {
  std::vector<MemberRow> rows;
  for_each_member(options, [&](const char* key, auto& value, const Accepts& accepts, const char* description) {
    using T = std::decay_t<decltype(value)>;
    if (has_members<T> || accepts.is_fixed) {
      return;
    }
    if constexpr (std::is_enum_v<T>) {
      rows.push_back({key, value_text(value, accepts), joined(enum_words<T>(), ", "), description});
    } else {
      const char* kind = std::is_same_v<T, bool>          ? "true, false"
                         : std::is_same_v<T, std::string> ? "text"
                         : is_list<T>                     ? "list"
                         : IsVector<T>::value             ? "numbers"
                                                          : "number";
      rows.push_back({key, value_text(value, accepts), accepted_text(accepts, kind), description});
    }
  });
  return rows;
}

}  // namespace rigidformer
