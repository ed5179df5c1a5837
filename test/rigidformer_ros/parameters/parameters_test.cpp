// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/parameters/parameters.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "rigidformer_ros/yaml_tree.hpp"

namespace rigidformer_ros {
namespace {

using testing::to_tree;

NodeParameters read_yaml(const std::string& text) { return read_parameters(to_tree(YAML::Load(text))); }

std::string error_of(const std::string& text) {
  try {
    read_yaml(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "' lacks '" << part << "'";
}

// Collects every scalar of the file by its full name, for example /predict/rate. A list counts as its length.
void flatten(const YAML::Node& node, const std::string& name, std::map<std::string, std::string>& values) {
  if (node.IsMap()) {
    for (const auto& member : node) {
      flatten(member.second, name + "/" + member.first.as<std::string>(), values);
    }
  } else {
    values[name] = node.IsSequence() ? "[" + std::to_string(node.size()) + "]" : node.Scalar();
  }
}

// Every parameter, as name=value.
template <class Group>
void list_members(Group group, const std::string& path, std::map<std::string, std::string>& values) {
  for_each_member(group, [&](const char* key, auto& value, const Accepts& accepts, const char*) {
    using T = std::decay_t<decltype(value)>;
    const std::string name = path + "/" + key;
    if constexpr (rigidformer::has_members<T>) {
      list_members(value, name, values);
    } else if constexpr (rigidformer::IsVector<T>::value) {
      values[name] = "[" + std::to_string(value.size()) + "]";
    } else if constexpr (std::is_same_v<T, std::optional<double>>) {
      values[name] = value ? std::to_string(*value) : accepts.words.front();
    } else if constexpr (std::is_enum_v<T>) {
      values[name] = rigidformer::enum_word(value);
    } else if constexpr (std::is_same_v<T, std::string>) {
      values[name] = value;
    } else if constexpr (std::is_same_v<T, bool>) {
      values[name] = value ? "true" : "false";
    } else {
      values[name] = std::to_string(static_cast<double>(value));
    }
  });
}

TEST(Parameters, TheYamlFileListsEveryParameterWithItsDefault) {
  const YAML::Node file = YAML::LoadFile(RIGIDFORMER_SOURCE_DIR "/config/node.yaml");
  std::map<std::string, std::string> written;
  flatten(file, "", written);
  for (auto& [name, value] : written) {
    double number = 0.0;
    if (YAML::convert<double>::decode(YAML::Node(value), number)) {
      value = std::to_string(number);
    }
  }
  std::map<std::string, std::string> defaults;
  list_members(NodeParameters(), "", defaults);
  EXPECT_EQ(written, defaults);
  EXPECT_NO_THROW(read_parameters(to_tree(file)));
}

TEST(Parameters, AnEmptyTreeGivesTheDefaults) {
  EXPECT_EQ(read_parameters({}).predict.num_steps, NodeParameters().predict.num_steps);
  EXPECT_TRUE(read_yaml("{input: {objects: []}, properties: {objects: []}}").input.objects.empty());
}

TEST(Parameters, ReadsValues) {
  const NodeParameters p = read_yaml(
      "{fixed_frame: map, input: {objects: [{id: cup, topic: /cup, mode: kinematic, mass: 2}], min_points: 9},"
      " predict: {ground_height: none, length_scale: auto, gravity: -9.81}, properties: {friction: 0.3,"
      " objects: [{id: 'cu*', restitution: 0.5}]}}");
  EXPECT_EQ(p.fixed_frame, "map");
  ASSERT_EQ(p.input.objects.size(), 1U);
  EXPECT_EQ(p.input.objects[0].mode, rigidformer::MotionMode::kKinematic);
  EXPECT_EQ(p.input.objects[0].properties.mass_kg, 2.0);
  EXPECT_EQ(p.input.min_points, 9);
  EXPECT_FALSE(p.predict.ground_height);
  EXPECT_FALSE(p.predict.length_scale);
  const auto cup = resolve_properties(p.properties, "cup", p.input.objects[0].properties);
  EXPECT_EQ(cup.mass_kg, 2.0);
  EXPECT_EQ(cup.friction, 0.3);
  EXPECT_EQ(cup.restitution, 0.5);
  EXPECT_FALSE(resolve_properties(p.properties, "mug", {}).restitution);
}

TEST(Parameters, ReadsWhatLabelsMean) {
  const NodeParameters p = read_yaml("{input: {label_names: [{label: 7, id: table, mode: static, friction: 0.4}]}}");
  ASSERT_EQ(p.input.label_names.size(), 1U);
  EXPECT_EQ(p.input.label_names[0].label, 7U);
  EXPECT_EQ(p.input.label_names[0].id, "table");
  EXPECT_EQ(p.input.label_names[0].mode, rigidformer::MotionMode::kStatic);
  EXPECT_EQ(p.input.label_names[0].properties.friction, 0.4);
}

TEST(Parameters, P31_ErrorsNameTheParameterAndWhatIsAccepted) {
  const std::pair<const char*, std::pair<const char*, const char*>> cases[] = {
      {"{predict: {num_steps: '10'}}", {"predict/num_steps", "an integer in [1, 10000]"}},
      {"{predict: {num_steps: 2.5}}", {"predict/num_steps", "an integer"}},
      {"{predict: {num_steps: 0}}", {"predict/num_steps", "[1, 10000]"}},
      {"{predict: {time_step: -1}}", {"predict/time_step", "a number in"}},
      {"{predict: {ground_height: auto}}", {"predict/ground_height", "'none'"}},
      {"{predict: {gravity: 9.81}}", {"predict/gravity", "[-100, 0]"}},
      {"{predict: {gravity: [0, 0, -9.81]}}", {"predict/gravity", "a number"}},
      {"{predict: {gravity: down}}", {"predict/gravity", "a number"}},
      {"{predict: 3}", {"predict", "group"}},
      {"{predict: {time_stp: 0.01}}", {"predict/time_stp", "unknown; known here"}},
      {"{fixd_frame: world}", {"fixd_frame", "unknown"}},
      {"{fixed_frame: ''}", {"fixed_frame", "must name a tf frame"}},
      {"{model: {precision: half}}", {"model/precision", "float32 | bfloat16"}},
      {"{correspondence: {method: icp}}", {"correspondence/method", "ordered | registration | pose"}},
      {"{correspondence: {min_inlier_ratio: 60}}", {"correspondence/min_inlier_ratio", "[0, 1]"}},
      {"{display: {markers: 1}}", {"display/markers", "true or false"}},
      {"{history: {min_dt: 0.2, max_dt: 0.1}}", {"history/max_dt", "greater than min_dt"}},
      {"{input: {objects: {id: cup}}}", {"input/objects", "a list"}},
      {"{input: {objects: [{id: cup}]}}", {"input/objects[0]/topic", "missing"}},
      {"{input: {objects: [{id: a, topic: x}, {id: b, topic: x}]}}", {"input/objects[1]/topic", "listed twice"}},
      {"{input: {objects: [{id: a, topic: x}, {id: a, topic: z}]}}", {"input/objects[1]/id", "listed twice"}},
      {"{input: {objects: [{id: a, topic: x, mode: fixed}]}}", {"input/objects[0]/mode", "dynamic | kinematic"}},
      {"{input: {object_topics: /objects/points}}", {"input/object_topics", "one '*'"}},
      {"{input: {label_names: [{id: cup}]}}", {"input/label_names[0]/label", "missing"}},
      {"{input: {label_names: [{label: 3}]}}", {"input/label_names[0]/id", "missing"}},
      {"{input: {label_names: [{label: 0, id: a}]}}", {"input/label_names[0]/label", "an integer in [1,"}},
      {"{input: {label_names: [{label: 1, id: a}, {label: 1, id: b}]}}", {"input/label_names[1]", "listed twice"}},
      {"{input: {label_names: [{label: 1, id: a}, {label: 2, id: a}]}}", {"input/label_names[1]", "listed twice"}},
      {"{input: {queue_size: -1}}", {"input/queue_size", "[1, 1000]"}},
      {"{properties: {restitution: 1.5}}", {"properties/restitution", "[0, 1]"}}};
  for (const auto& [text, parts] : cases) {
    expect_contains(error_of(text), std::string("parameter ") + parts.first);
    expect_contains(error_of(text), parts.second);
  }
}

// YAML takes 1e-3 for a text and 24.0 for no integer. Whoever wrote them sees a number and needs to be told.
TEST(Parameters, P51_AnIllNumberIsShownAsItWasRead) {
  const std::pair<const char*, const char*> cases[] = {
      {"{predict: {time_step: '1e-3'}}", "is '1e-3' (a text; a number is written without quotes and as 1.0e-3)"},
      {"{predict: {gravity: down}}", "is 'down', must be a number"},
      {"{predict: {num_steps: 24.0}}", "is 24.0, must be an integer"},
      {"{predict: {num_steps: true}}", "is 1, must be an integer"},
      {"{predict: {num_steps: [24]}}", "is a list, must be an integer"}};
  for (const auto& [text, part] : cases) {
    expect_contains(error_of(text), part);
  }
}

}  // namespace
}  // namespace rigidformer_ros
