// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/parameters/parameter_reader.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace rigidformer_ros {

namespace {

using XmlRpc::XmlRpcValue;

std::string describe(XmlRpcValue& value) {
  std::ostringstream text;
  switch (value.getType()) {
    case XmlRpcValue::TypeStruct:
      return "a group";
    case XmlRpcValue::TypeArray:
      return "a list";
    case XmlRpcValue::TypeString:
      return "'" + static_cast<std::string&>(value) + "'";
    default:
      value.write(text);
      return text.str();
  }
}

std::string describe(Range range) {
  std::ostringstream text;
  text << "in [" << range.min << ", " << range.max << "]";
  return text.str();
}

bool contains(Range range, double value) { return value >= range.min && value <= range.max; }

}  // namespace

ParameterReader::ParameterReader(XmlRpcValue tree, std::string path) : tree_(std::move(tree)), path_(std::move(path)) {
  if (tree_.getType() != XmlRpcValue::TypeStruct && tree_.getType() != XmlRpcValue::TypeInvalid) {
    throw std::invalid_argument("parameter " + path_ + ": is " + describe(tree_) + ", must be a group of parameters");
  }
}

bool ParameterReader::has(const std::string& key) const {
  return tree_.getType() == XmlRpcValue::TypeStruct && tree_.hasMember(key);
}

std::string ParameterReader::full_name(const std::string& key) const { return path_.empty() ? key : path_ + "/" + key; }

void ParameterReader::fail(const std::string& key, const std::string& accepted) {
  throw std::invalid_argument("parameter " + full_name(key) + ": is " + describe(tree_[key]) + ", must be " + accepted);
}

double ParameterReader::number(const std::string& key, const std::string& accepted) {
  XmlRpcValue& value = tree_[key];
  if (value.getType() == XmlRpcValue::TypeInt) {
    return static_cast<int&>(value);
  }
  if (value.getType() != XmlRpcValue::TypeDouble) {
    fail(key, accepted);
  }
  return static_cast<double&>(value);
}

void ParameterReader::read(const std::string& key, bool& value) {
  read_keys_.insert(key);
  if (has(key)) {
    if (tree_[key].getType() != XmlRpcValue::TypeBoolean) {
      fail(key, "true or false");
    }
    value = static_cast<bool&>(tree_[key]);
  }
}

void ParameterReader::read(const std::string& key, std::string& value) {
  read_keys_.insert(key);
  if (has(key)) {
    if (tree_[key].getType() != XmlRpcValue::TypeString) {
      fail(key, "a string");
    }
    value = static_cast<std::string&>(tree_[key]);
  }
}

void ParameterReader::read(const std::string& key, std::string& value, const std::vector<std::string>& accepted) {
  read(key, value);
  if (std::find(accepted.begin(), accepted.end(), value) == accepted.end()) {
    std::string choices;
    for (const std::string& choice : accepted) {
      choices += (choices.empty() ? "" : " | ") + choice;
    }
    fail(key, choices);
  }
}

void ParameterReader::read(const std::string& key, int& value, Range range) {
  read_keys_.insert(key);
  if (has(key)) {
    XmlRpcValue& given = tree_[key];
    if (given.getType() != XmlRpcValue::TypeInt || !contains(range, static_cast<int&>(given))) {
      fail(key, "an integer " + describe(range));
    }
    value = static_cast<int&>(given);
  }
}

void ParameterReader::read(const std::string& key, double& value, Range range) {
  read_keys_.insert(key);
  if (has(key)) {
    const std::string accepted = "a number " + describe(range);
    const double given = number(key, accepted);
    if (!contains(range, given)) {
      fail(key, accepted);
    }
    value = given;
  }
}

void ParameterReader::read(const std::string& key, std::optional<double>& value, Range range, const std::string& word) {
  read_keys_.insert(key);
  if (!has(key)) {
    return;
  }
  const std::string accepted = "a number " + describe(range) + " or '" + word + "'";
  if (tree_[key].getType() == XmlRpcValue::TypeString) {
    if (static_cast<std::string&>(tree_[key]) != word) {
      fail(key, accepted);
    }
    value.reset();
    return;
  }
  const double given = number(key, accepted);
  if (!contains(range, given)) {
    fail(key, accepted);
  }
  value = given;
}

void ParameterReader::group(const std::string& key, const std::function<void(ParameterReader&)>& read_members) {
  read_keys_.insert(key);
  if (has(key)) {
    ParameterReader members(tree_[key], full_name(key));
    read_members(members);
    members.finish();
  }
}

void ParameterReader::list(const std::string& key, const std::function<void(ParameterReader&)>& read_element) {
  read_keys_.insert(key);
  if (!has(key)) {
    return;
  }
  if (tree_[key].getType() != XmlRpcValue::TypeArray) {
    fail(key, "a list");
  }
  for (int i = 0; i < tree_[key].size(); ++i) {
    ParameterReader element(tree_[key][i], full_name(key) + "[" + std::to_string(i) + "]");
    read_element(element);
    element.finish();
  }
}

void ParameterReader::finish() const {
  if (tree_.getType() != XmlRpcValue::TypeStruct) {
    return;
  }
  XmlRpcValue members = tree_;
  for (const auto& member : members) {
    if (read_keys_.count(member.first) == 0) {
      std::string known;
      for (const std::string& key : read_keys_) {
        known += (known.empty() ? "" : ", ") + key;
      }
      throw std::invalid_argument("parameter " + full_name(member.first) + ": unknown; known here: " + known);
    }
  }
}

}  // namespace rigidformer_ros
