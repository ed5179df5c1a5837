// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "rigidformer/io/members.hpp"

namespace rigidformer_ros {

// The messages of dynamic_reconfigure for the tunable members of one group of parameters.

using rigidformer::Accepts;

/// Calls visit(key, member, accepts, description) for the members that may change while the node runs.
template <typename Parameters, typename Visit>
void for_each_tunable(Parameters& parameters, const Visit& visit) {
  for_each_member(parameters, [&](const char* key, auto& value, const Accepts& accepts, const char* description) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>) {
      if (accepts.is_tunable) {
        visit(key, value, accepts, description);
      }
    }
  });
}

/// The values of one type in a message.
inline auto& values_like(dynamic_reconfigure::Config& config, bool) { return config.bools; }
inline auto& values_like(dynamic_reconfigure::Config& config, int) { return config.ints; }
inline auto& values_like(dynamic_reconfigure::Config& config, double) { return config.doubles; }

inline const char* type_name(bool) { return "bool"; }
inline const char* type_name(int) { return "int"; }
inline const char* type_name(double) { return "double"; }

template <typename T>
void append(dynamic_reconfigure::Config& config, const char* key, T value) {
  auto& values = values_like(config, value);
  values.emplace_back();
  values.back().name = key;
  values.back().value = value;
}

/// A message of the one group that clients expect.
inline dynamic_reconfigure::Config empty_config() {
  dynamic_reconfigure::Config config;
  config.groups.emplace_back();
  config.groups.back().name = "Default";
  config.groups.back().state = true;
  return config;
}

template <typename Parameters>
dynamic_reconfigure::Config to_config(Parameters parameters) {
  dynamic_reconfigure::Config config = empty_config();
  for_each_tunable(
      parameters, [&config](const char* key, auto& value, const Accepts&, const char*) { append(config, key, value); });
  return config;
}

/// Names, ranges and defaults.
template <typename Parameters>
dynamic_reconfigure::ConfigDescription describe_tunable() {
  dynamic_reconfigure::ConfigDescription description;
  description.min = empty_config();
  description.max = empty_config();
  description.dflt = to_config(Parameters());
  description.groups.emplace_back();
  description.groups.back().name = "Default";
  Parameters parameters;
  for_each_tunable(parameters, [&](const char* key, auto& value, const Accepts& accepts, const char* meaning) {
    using T = std::decay_t<decltype(value)>;
    constexpr bool kIsSwitch = std::is_same_v<T, bool>;
    append(description.min, key, kIsSwitch ? T(false) : static_cast<T>(accepts.min));
    append(description.max, key, kIsSwitch ? T(true) : static_cast<T>(accepts.max));
    description.groups.back().parameters.emplace_back();
    dynamic_reconfigure::ParamDescription& parameter = description.groups.back().parameters.back();
    parameter.name = key;
    parameter.type = type_name(value);
    parameter.description = meaning;
  });
  return description;
}

/// What `change` names takes its value, or the nearest one in range. Throws std::invalid_argument for what is no
/// number, with the parameters as they were.
template <typename Parameters>
void take_over(dynamic_reconfigure::Config change, Parameters& parameters) {
  Parameters changed = parameters;
  for_each_tunable(changed, [&change](const char* key, auto& value, const Accepts& accepts, const char*) {
    using T = std::decay_t<decltype(value)>;
    for (const auto& given : values_like(change, value)) {
      if (given.name != key) {
        continue;
      }
      if constexpr (std::is_same_v<T, bool>) {
        value = given.value;
      } else if (std::isnan(static_cast<double>(given.value))) {
        throw std::invalid_argument(std::string(key) + ": must be a finite number");
      } else {
        value = static_cast<T>(std::clamp(static_cast<double>(given.value), accepts.min, accepts.max));
      }
    }
  });
  parameters = changed;
}

}  // namespace rigidformer_ros
