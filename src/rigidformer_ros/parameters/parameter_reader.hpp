// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rigidformer_ros {

/// Closed interval of accepted values.
struct Range {
  double min;
  double max;
};

/// Reads one group of parameters into variables that already hold their defaults. Keys that are absent leave the
/// variable alone; a wrong type, a value out of range or a key that nobody read throws std::invalid_argument with the
/// full name and what is accepted.
class ParameterReader {
 public:
  ParameterReader(XmlRpc::XmlRpcValue tree, std::string path);

  void read(const std::string& key, bool& value);
  void read(const std::string& key, std::string& value);
  void read(const std::string& key, std::string& value, const std::vector<std::string>& accepted);
  void read(const std::string& key, int& value, Range range);
  void read(const std::string& key, double& value, Range range);
  /// A number, or `word` for the empty value.
  void read(const std::string& key, std::optional<double>& value, Range range, const std::string& word);

  /// Reads the nested group `key`, if present, through `read_members`.
  void group(const std::string& key, const std::function<void(ParameterReader&)>& read_members);
  /// Reads a list of groups.
  void list(const std::string& key, const std::function<void(ParameterReader&)>& read_element);

  /// Throws when a key was given that nothing read.
  void finish() const;

  bool has(const std::string& key) const;
  const std::string& path() const { return path_; }

 private:
  std::string full_name(const std::string& key) const;
  [[noreturn]] void fail(const std::string& key, const std::string& accepted);
  double number(const std::string& key, const std::string& accepted);

  XmlRpc::XmlRpcValue tree_;
  std::string path_;
  std::set<std::string> read_keys_;
};

}  // namespace rigidformer_ros
