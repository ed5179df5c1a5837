// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace rigidformer {

// A struct of options has one table of its members beside it, a function
//
//   template <typename Visit> void for_each_member(Options& o, const Visit& visit) {
//     visit("rate", o.rate, between(0.01, 1000.0), "[Hz] wall-clock limit of the forecast rate");
//   }
//
// Everything that handles all members goes through the table: readers of files and parameters, checks of values,
// --help, and the tables in docs/interface.md. A member may be another struct with a table, or a std::vector of such
// structs.

/// The values that a member takes, and who may set it.
struct Accepts {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above_min = false;            ///< `min` itself is refused
  bool below_max = false;            ///< `max` itself is refused
  std::vector<std::string> words{};  ///< All of a string; of a std::optional the one word that stands for no value
  bool is_tunable = false;           ///< May change while the node runs
  bool is_fixed = false;             ///< Comes with a preset, not from a training file
  bool is_newer = false;             ///< Files written before the member existed are accepted

  bool holds(double value) const {
    return (above_min ? value > min : value >= min) && (below_max ? value < max : value <= max);
  }
  Accepts or_word(const char* word) const {
    Accepts copy = *this;
    copy.words = {word};
    return copy;
  }
  Accepts tunable() const {
    Accepts copy = *this;
    copy.is_tunable = true;
    return copy;
  }
  Accepts fixed() const {
    Accepts copy = *this;
    copy.is_fixed = true;
    return copy;
  }
  Accepts newer() const {
    Accepts copy = *this;
    copy.is_newer = true;
    return copy;
  }
};

inline Accepts anything() { return {}; }
inline Accepts between(double min, double max) { return {min, max}; }
inline Accepts at_least(double min) { return {min}; }
inline Accepts positive() { return {0.0, std::numeric_limits<double>::infinity(), true}; }
/// (0, max]
inline Accepts positive_up_to(double max) { return {0.0, max, true}; }
/// [0, 1]
inline Accepts share() { return {0.0, 1.0}; }
/// [0, 1)
inline Accepts less_than_all() { return {0.0, 1.0, false, true}; }
inline Accepts one_of(std::vector<std::string> words) {
  Accepts accepts;
  accepts.words = std::move(words);
  return accepts;
}

/// "in [0, 1)", ">= 0" or "> 0".
inline std::string range_text(const Accepts& accepts) {
  std::ostringstream text;
  if (accepts.max == std::numeric_limits<double>::infinity()) {
    text << (accepts.above_min ? "> " : ">= ") << accepts.min;
  } else {
    text << "in " << (accepts.above_min ? '(' : '[') << accepts.min << ", " << accepts.max
         << (accepts.below_max ? ')' : ']');
  }
  return text.str();
}

/// "a | b | c"
inline std::string joined(const std::vector<std::string>& words, const std::string& separator = " | ") {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : separator) + word;
  }
  return text;
}

/// "float32 | bfloat16", "in [0, 1)", ...
inline std::string values_text(const Accepts& accepts) {
  return accepts.words.empty() ? range_text(accepts) : joined(accepts.words);
}

/// The words for the values of an enumeration; it has a function `names_of(Enum)` that returns them.
template <typename Enum>
using EnumNames = std::vector<std::pair<std::string, Enum>>;

template <typename Enum>
std::vector<std::string> enum_words() {
  std::vector<std::string> words;
  for (const auto& [word, value] : names_of(Enum())) {
    words.push_back(word);
  }
  return words;
}

template <typename Enum>
std::optional<Enum> enum_value(const std::string& word) {
  for (const auto& [name, value] : names_of(Enum())) {
    if (name == word) {
      return value;
    }
  }
  return std::nullopt;
}

/// Empty for a value without a word.
template <typename Enum>
std::string enum_word(Enum value) {
  for (const auto& [name, named] : names_of(value)) {
    if (named == value) {
      return name;
    }
  }
  return "";
}

/// Takes every row of a table and does nothing.
struct IgnoreMember {
  template <typename T>
  void operator()(const char*, T&, const Accepts&, const char*) const {}
};

template <typename T, typename = void>
struct HasMembers : std::false_type {};
template <typename T>
struct HasMembers<T, std::void_t<decltype(for_each_member(std::declval<T&>(), IgnoreMember()))>> : std::true_type {};
/// Whether T is a struct with a table.
template <typename T>
inline constexpr bool has_members = HasMembers<T>::value;

template <typename T>
struct IsVector : std::false_type {};
template <typename T>
struct IsVector<std::vector<T>> : std::true_type {};

template <typename T>
struct IsList : std::false_type {};
template <typename T>
struct IsList<std::vector<T>> : HasMembers<T> {};
/// Whether T is a list of structs with a table.
template <typename T>
inline constexpr bool is_list = IsList<T>::value;

/// Whether a value of a number, a string, a list of numbers or a std::optional is accepted.
template <typename T>
bool fits(const T& value, const Accepts& accepts) {
  if constexpr (std::is_same_v<T, bool> || std::is_enum_v<T> || has_members<T> || is_list<T>) {
    return true;
  } else if constexpr (std::is_arithmetic_v<T>) {
    return accepts.holds(static_cast<double>(value));
  } else if constexpr (std::is_same_v<T, std::string>) {
    const auto& words = accepts.words;
    return words.empty() || std::find(words.begin(), words.end(), value) != words.end();
  } else if constexpr (std::is_same_v<T, std::optional<double>>) {
    return !value || accepts.holds(*value);
  } else {
    return std::all_of(value.begin(), value.end(), [&](const auto& element) { return fits(element, accepts); });
  }
}

}  // namespace rigidformer
