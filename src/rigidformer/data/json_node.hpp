// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>

namespace rigidformer {

/// A JSON value of a Kubric scene that knows its place in the file, so that every error names file and key.
class JsonNode {
 public:
  JsonNode(const std::filesystem::path& file, std::string key, const nlohmann::json& value)
      : file_(file), key_(std::move(key)), value_(value) {}

  [[noreturn]] void fail(const std::string& defect) const {
    throw std::runtime_error("Kubric scene '" + file_.string() + "': " + key_ + " " + defect);
  }

  /// Fails with what was read.
  [[noreturn]] void refuse(const std::string& accepted) const {
    constexpr std::size_t kMaxQuoted = 60, kMaxListed = 8;
    // dump() calls itself once per level, so that it must not meet what is nested.
    const bool nested = std::any_of(value_.begin(), value_.end(), [](const auto& v) { return v.is_structured(); });
    const bool shown = value_.is_primitive() || (value_.is_array() && value_.size() <= kMaxListed && !nested);
    const std::string text = shown ? value_.dump() : value_.is_array() ? "a list" : "a group";
    fail("= " + text.substr(0, kMaxQuoted) + " " + accepted);
  }

  bool has(const char* name) const { return value_.is_object() && value_.contains(name) && !value_.at(name).is_null(); }

  JsonNode at(const char* name) const {
    if (!has(name)) JsonNode(file_, child_key(name), value_).fail("is missing");
    return {file_, child_key(name), value_.at(name)};
  }

  JsonNode at(std::size_t index) const { return {file_, key_ + '[' + std::to_string(index) + ']', value_.at(index)}; }

  std::size_t array_size() const {
    if (!value_.is_array()) fail("is not a list");
    return value_.size();
  }

  double number() const {
    if (!value_.is_number()) refuse("is not a number");
    return value_.get<double>();
  }

  std::uint64_t natural() const {
    if (!value_.is_number_unsigned()) refuse("is not an integer >= 0");
    return value_.get<std::uint64_t>();
  }

  bool is_list() const { return value_.is_array(); }

  /// true and false, or 1 and 0 as some writers of JSON have it; `absent` where the key is missing.
  bool flag(const char* name, bool absent) const {
    if (!has(name)) return absent;
    const JsonNode node = at(name);
    if (node.value_.is_boolean()) return node.value_.get<bool>();
    if (node.value_ != 0 && node.value_ != 1) node.refuse("is neither true nor false");
    return node.value_ == 1;
  }

  std::string text() const {
    if (!value_.is_string()) refuse("is not a text");
    return value_.get<std::string>();
  }

  template <int Size>
  Eigen::Matrix<double, Size, 1> vector() const {
    if (array_size() != Size) fail("does not have " + std::to_string(Size) + " numbers");
    Eigen::Matrix<double, Size, 1> result;
    for (std::size_t i = 0; i < Size; ++i) result[static_cast<Eigen::Index>(i)] = at(i).number();
    return result;
  }

 private:
  std::string child_key(const char* name) const { return key_.empty() ? name : key_ + '.' + name; }

  const std::filesystem::path& file_;
  std::string key_;
  const nlohmann::json& value_;
};

}  // namespace rigidformer
