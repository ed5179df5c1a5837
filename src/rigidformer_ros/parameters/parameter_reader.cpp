// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/parameters/parameter_reader.hpp"

#include <sstream>
#include <stdexcept>
#include <utility>

namespace rigidformer_ros {

namespace {

using XmlRpc::XmlRpcValue;

// YAML takes 1e-3 for a text, because it has no point: that cannot be seen from the value alone.
std::string describe_text(const std::string& text) {
  std::istringstream stream(text);
  double number = 0.0;
  const bool looks_like_a_number = (stream >> number) && stream.eof();
  return "'" + text + "'" + (looks_like_a_number ? " (a text; a number is written without quotes and as 1.0e-3)" : "");
}

std::string describe(XmlRpcValue& value) {
  std::ostringstream text;
  switch (value.getType()) {
    case XmlRpcValue::TypeStruct:
      return "a group";
    case XmlRpcValue::TypeArray:
      return "a list";
    case XmlRpcValue::TypeString:
      return describe_text(static_cast<std::string&>(value));
    case XmlRpcValue::TypeDouble:
      text << static_cast<double&>(value);
      return text.str() + (text.str().find_first_of(".en") == std::string::npos ? ".0" : "");
    default:
      value.write(text);
      return text.str();
  }
}

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

double ParameterReader::number(const std::string& key, const Accepts& accepts, const std::string& accepted) {
  XmlRpcValue& given = tree_[key];
  const bool is_number = given.getType() == XmlRpcValue::TypeInt || given.getType() == XmlRpcValue::TypeDouble;
  if (!is_number) {
    fail(key, accepted);
  }
  const double value = given.getType() == XmlRpcValue::TypeInt ? static_cast<int&>(given) : static_cast<double&>(given);
  if (!accepts.holds(value)) {
    fail(key, accepted);
  }
  return value;
}

int ParameterReader::list_size(const std::string& key) {
  if (tree_[key].getType() != XmlRpcValue::TypeArray) {
    fail(key, "a list");
  }
  return tree_[key].size();
}

void ParameterReader::read(const std::string& key, bool& value, const Accepts&) {
  if (tree_[key].getType() != XmlRpcValue::TypeBoolean) {
    fail(key, "true or false");
  }
  value = static_cast<bool&>(tree_[key]);
}

void ParameterReader::read(const std::string& key, std::string& value, const Accepts& accepts) {
  if (tree_[key].getType() != XmlRpcValue::TypeString) {
    fail(key, accepts.words.empty() ? "a string" : rigidformer::joined(accepts.words));
  }
  const auto& given = static_cast<std::string&>(tree_[key]);
  if (!rigidformer::fits(given, accepts)) {
    fail(key, rigidformer::joined(accepts.words));
  }
  value = given;
}

void ParameterReader::read(const std::string& key, int& value, const Accepts& accepts) {
  XmlRpcValue& given = tree_[key];
  if (given.getType() != XmlRpcValue::TypeInt || !accepts.holds(static_cast<int&>(given))) {
    fail(key, "an integer " + rigidformer::range_text(accepts));
  }
  value = static_cast<int&>(given);
}

void ParameterReader::read(const std::string& key, std::uint32_t& value, const Accepts& accepts) {
  int given = 0;
  read(key, given, accepts);
  value = static_cast<std::uint32_t>(given);
}

void ParameterReader::read(const std::string& key, double& value, const Accepts& accepts) {
  value = number(key, accepts, "a number " + rigidformer::range_text(accepts));
}

void ParameterReader::read(const std::string& key, std::vector<int>& values, const Accepts& accepts) {
  values.clear();
  for (int i = 0; i < list_size(key); ++i) {
    XmlRpcValue& given = tree_[key][i];
    if (given.getType() != XmlRpcValue::TypeInt || !accepts.holds(static_cast<int&>(given))) {
      throw std::invalid_argument("parameter " + full_name(key) + "[" + std::to_string(i) + "]: is " + describe(given) +
                                  ", must be an integer " + rigidformer::range_text(accepts));
    }
    values.push_back(static_cast<int&>(given));
  }
}

void ParameterReader::read(const std::string& key, std::optional<double>& value, const Accepts& accepts) {
  const std::string& word = accepts.words.front();
  const bool is_word = tree_[key].getType() == XmlRpcValue::TypeString && std::string(tree_[key]) == word;
  if (is_word) {
    value.reset();
  } else {
    value = number(key, accepts, "a number " + rigidformer::range_text(accepts) + " or '" + word + "'");
  }
}

void ParameterReader::refuse_unknown() const {
  if (tree_.getType() != XmlRpcValue::TypeStruct) {
    return;
  }
  XmlRpcValue members = tree_;
  for (const auto& member : members) {
    if (known_keys_.count(member.first) == 0) {
      const std::vector<std::string> known(known_keys_.begin(), known_keys_.end());
      throw std::invalid_argument("parameter " + full_name(member.first) +
                                  ": unknown; known here: " + rigidformer::joined(known, ", "));
    }
  }
}

}  // namespace rigidformer_ros
