// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/parameters/parameters.hpp"

#include <set>
#include <stdexcept>

#include "rigidformer_ros/parameters/parameter_reader.hpp"
#include "rigidformer_ros/parameters/wildcard.hpp"

namespace rigidformer_ros {

namespace {

using rigidformer::BodyProperties;

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw std::invalid_argument("parameter " + name + what);
}

std::string entry(const char* list, std::size_t index) { return std::string(list) + "[" + std::to_string(index) + "]"; }

void require_text(const std::string& name, const std::string& value) {
  if (value.empty()) {
    refuse(name, ": is missing or empty");
  }
}

void check_objects(const std::vector<ListedObject>& objects) {
  std::set<std::string> ids;
  std::set<std::string> topics;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::string name = entry("input/objects", i);
    const ListedObject& object = objects[i];
    require_text(name + "/id", object.id);
    require_text(name + "/topic", object.topic);
    if (!ids.insert(object.id).second) {
      refuse(name + "/id", ": '" + object.id + "' is listed twice, ids must be unique");
    }
    if (!topics.insert(object.topic).second) {
      refuse(name + "/topic", ": '" + object.topic + "' is listed twice, every object needs its own topic");
    }
  }
}

void check_label_names(const std::vector<NamedLabel>& names) {
  std::set<std::uint32_t> labels;
  std::set<std::string> ids;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = entry("input/label_names", i);
    require_text(name + "/id", names[i].id);
    if (names[i].label == 0) {
      refuse(name + "/label", ": is missing, must be a number from 1 on");
    }
    if (!labels.insert(names[i].label).second || !ids.insert(names[i].id).second) {
      refuse(name, ": label " + std::to_string(names[i].label) + " or id '" + names[i].id +
                       "' is listed twice, both must be unique");
    }
  }
}

/// What the table of one member cannot say.
void check(const NodeParameters& p) {
  if (p.fixed_frame.empty()) {
    refuse("fixed_frame", ": is empty, must name a tf frame with z up");
  }
  check_objects(p.input.objects);
  check_label_names(p.input.label_names);
  if (!p.input.object_topics.empty() && !is_topic_pattern(p.input.object_topics)) {
    refuse("input/object_topics",
           ": is '" + p.input.object_topics + "', must be a topic name with one '*' as a whole segment, or empty");
  }
  if (p.history.min_dt >= p.history.max_dt) {
    refuse("history/max_dt", ": is " + std::to_string(p.history.max_dt) +
                                 ", must be greater than min_dt = " + std::to_string(p.history.min_dt));
  }
  for (std::size_t i = 0; i < p.properties.objects.size(); ++i) {
    require_text(entry("properties/objects", i) + "/id", p.properties.objects[i].id);
  }
}

void overlay(BodyProperties& base, const BodyProperties& top) {
  base.mass_kg = top.mass_kg ? top.mass_kg : base.mass_kg;
  base.friction = top.friction ? top.friction : base.friction;
  base.restitution = top.restitution ? top.restitution : base.restitution;
}

}  // namespace

NodeParameters read_parameters(const XmlRpc::XmlRpcValue& tree) {
  NodeParameters parameters;
  ParameterReader(tree, "").read_group(parameters);
  check(parameters);
  return parameters;
}

PointLimit max_points_per_object(const InputParameters& input) {
  return {static_cast<std::uint64_t>(input.max_points), "input/max_points"};
}

PointLimit max_points_per_cloud(const InputParameters& input) {
  return {static_cast<std::uint64_t>(input.max_cloud_points), "input/max_cloud_points"};
}

rigidformer::TrackingOptions tracking_options(const NodeParameters& parameters) {
  return {parameters.input.min_points, parameters.input.sync_window, parameters.predict.length_scale,
          parameters.history, parameters.correspondence};
}

rigidformer::BodyProperties resolve_properties(const PropertyParameters& parameters, const std::string& id,
                                               const rigidformer::BodyProperties& known) {
  rigidformer::BodyProperties properties = parameters.defaults;
  for (const PropertyRule& rule : parameters.objects) {
    if (matches_wildcard(rule.id, id)) {
      overlay(properties, rule.properties);
    }
  }
  overlay(properties, known);
  return properties;
}

void resolve_properties(const PropertyParameters& parameters, rigidformer::ObjectObservation& observation) {
  observation.properties = resolve_properties(parameters, observation.id, observation.properties);
}

}  // namespace rigidformer_ros
