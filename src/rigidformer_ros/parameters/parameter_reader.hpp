// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "rigidformer/io/members.hpp"

namespace rigidformer_ros {

using rigidformer::Accepts;

/// Reads one group of parameters into a struct with a table of its members, which hold their defaults. Keys that are
/// absent leave a member alone; a wrong type, a value out of range or a key that is no member throws
/// std::invalid_argument with the full name and what is accepted.
class ParameterReader {
 public:
  ParameterReader(XmlRpc::XmlRpcValue tree, std::string path);

  template <typename Group>
  void read_group(Group& group) {
    for_each_member(group, [this](const char* key, auto& value, const Accepts& accepts, const char*) {
      known_keys_.insert(key);
      if (has(key)) {
        read(key, value, accepts);
      }
    });
    refuse_unknown();
  }

 private:
  void read(const std::string& key, bool& value, const Accepts& accepts);
  void read(const std::string& key, std::string& value, const Accepts& accepts);
  void read(const std::string& key, int& value, const Accepts& accepts);
  void read(const std::string& key, std::uint32_t& value, const Accepts& accepts);
  void read(const std::string& key, double& value, const Accepts& accepts);
  void read(const std::string& key, std::vector<int>& values, const Accepts& accepts);
  void read(const std::string& key, std::optional<double>& value, const Accepts& accepts);

  template <typename Enum, std::enable_if_t<std::is_enum_v<Enum>, int> = 0>
  void read(const std::string& key, Enum& value, const Accepts&) {
    std::string word;
    read(key, word, rigidformer::one_of(rigidformer::enum_words<Enum>()));
    value = *rigidformer::enum_value<Enum>(word);
  }

  template <typename Group, std::enable_if_t<rigidformer::has_members<Group>, int> = 0>
  void read(const std::string& key, Group& group, const Accepts&) {
    ParameterReader(tree_[key], full_name(key)).read_group(group);
  }

  template <typename Element>
  void read(const std::string& key, std::vector<Element>& list, const Accepts&) {
    const int size = list_size(key);
    list.resize(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) {
      const std::string name = full_name(key) + "[" + std::to_string(i) + "]";
      ParameterReader(tree_[key][i], name).read_group(list[static_cast<std::size_t>(i)]);
    }
  }

  bool has(const std::string& key) const;
  std::string full_name(const std::string& key) const;
  [[noreturn]] void fail(const std::string& key, const std::string& accepted);
  double number(const std::string& key, const Accepts& accepts, const std::string& accepted);
  int list_size(const std::string& key);
  void refuse_unknown() const;

  XmlRpc::XmlRpcValue tree_;
  std::string path_;
  std::set<std::string> known_keys_;
};

}  // namespace rigidformer_ros
