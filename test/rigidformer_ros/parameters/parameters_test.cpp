// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/parameters/parameters.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <map>
#include <optional>
#include <stdexcept>
#include <string>

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

std::string text_of(double value) { return std::to_string(value); }
std::string text_of(const std::optional<double>& value, const std::string& word) {
  return value ? text_of(*value) : word;
}

std::map<std::string, std::string> defaults() {
  const NodeParameters p;
  return {{"/fixed_frame", p.fixed_frame},
          {"/tf_timeout", text_of(p.tf_timeout)},
          {"/max_stamp_skew", text_of(p.max_stamp_skew)},
          {"/input/objects", "[0]"},
          {"/input/object_topics", p.input.object_topics},
          {"/input/discovery_period", text_of(p.input.discovery_period)},
          {"/input/queue_size", text_of(p.input.queue_size)},
          {"/input/min_points", text_of(p.input.min_points)},
          {"/input/max_points", text_of(p.input.max_points)},
          {"/input/sync_window", text_of(p.input.sync_window)},
          {"/input/cloud", p.input.cloud},
          {"/input/max_cloud_points", text_of(p.input.max_cloud_points)},
          {"/input/label_names", "[0]"},
          {"/input/object_clouds", p.input.object_clouds},
          {"/input/pose_frame_prefix", p.input.pose_frame_prefix},
          {"/history/min_dt", text_of(p.history.min_dt)},
          {"/history/max_dt", text_of(p.history.max_dt)},
          {"/history/object_timeout", text_of(p.history.object_timeout)},
          {"/history/jump_threshold", text_of(p.history.jump_threshold)},
          {"/history/max_speed", text_of(p.history.max_speed)},
          {"/history/max_angular_speed", text_of(p.history.max_angular_speed)},
          {"/correspondence/method", "ordered"},
          {"/correspondence/max_rmse", text_of(p.correspondence.max_rmse)},
          {"/correspondence/noise", text_of(p.correspondence.noise)},
          {"/correspondence/min_inlier_ratio", text_of(p.correspondence.min_inlier_ratio)},
          {"/correspondence/voxel_size", text_of(p.correspondence.voxel_size)},
          {"/correspondence/max_reference_points", text_of(p.correspondence.max_reference_points)},
          {"/correspondence/max_correspondence_distance", text_of(p.correspondence.max_correspondence_distance)},
          {"/correspondence/max_iterations", text_of(p.correspondence.max_iterations)},
          {"/correspondence/max_registered_points", text_of(p.correspondence.max_registered_points)},
          {"/correspondence/max_rotation", text_of(p.correspondence.max_rotation)},
          {"/correspondence/max_failures", text_of(p.correspondence.max_failures)},
          {"/model/file", p.model.file},
          {"/model/device", p.model.device},
          {"/model/precision", p.model.precision},
          {"/model/num_threads", text_of(p.model.num_threads)},
          {"/model/warmup_runs", text_of(p.model.warmup_runs)},
          {"/model/rest_speed", text_of(p.model.rest_speed)},
          {"/model/rest_spin", text_of(p.model.rest_spin)},
          {"/predict/rate", text_of(p.predict.rate)},
          {"/predict/num_steps", text_of(p.predict.num_steps)},
          {"/predict/time_step", text_of(p.predict.time_step)},
          {"/predict/gravity", text_of(p.predict.gravity)},
          {"/predict/ground_height", text_of(p.predict.ground_height, "none")},
          {"/predict/length_scale", text_of(p.predict.length_scale, "auto")},
          {"/service/max_steps", text_of(p.service.max_steps)},
          {"/service/max_wall_time", text_of(p.service.max_wall_time)},
          {"/service/max_state_age", text_of(p.service.max_state_age)},
          {"/service/max_clients_queued", text_of(p.service.max_clients_queued)},
          {"/service/max_returned_points", text_of(p.service.max_returned_points)},
          {"/service/settle_linear_speed", text_of(p.service.settle_linear_speed)},
          {"/service/settle_angular_speed", text_of(p.service.settle_angular_speed)},
          {"/service/settle_duration", text_of(p.service.settle_duration)},
          {"/properties/mass", text_of(p.properties.defaults.mass_kg, "unknown")},
          {"/properties/friction", text_of(p.properties.defaults.friction, "unknown")},
          {"/properties/restitution", text_of(p.properties.defaults.restitution, "unknown")},
          {"/properties/objects", "[0]"},
          {"/display/markers", p.display.markers ? "true" : "false"},
          {"/display/ghost_every", text_of(p.display.ghost_every)},
          {"/display/max_ghost_points", text_of(p.display.max_ghost_points)},
          {"/display/point_size", text_of(p.display.point_size)},
          {"/display/path_width", text_of(p.display.path_width)},
          {"/display/label_size", text_of(p.display.label_size)},
          {"/display/marker_lifetime", text_of(p.display.marker_lifetime)},
          {"/diagnostics/report_period", text_of(p.diagnostics.report_period)},
          {"/diagnostics/period", text_of(p.diagnostics.period)},
          {"/diagnostics/max_input_age", text_of(p.diagnostics.max_input_age)},
          {"/diagnostics/max_processing_time", text_of(p.diagnostics.max_processing_time)},
          {"/diagnostics/max_consecutive_delay", text_of(p.diagnostics.max_consecutive_delay)},
          {"/diagnostics/check_window", text_of(p.diagnostics.check_window)},
          {"/diagnostics/trusted_position_error", text_of(p.diagnostics.trusted_position_error)},
          {"/diagnostics/trusted_rotation_error", text_of(p.diagnostics.trusted_rotation_error)}};
}

TEST(Parameters, TheYamlFileListsEveryParameterWithItsDefault) {
  const YAML::Node file = YAML::LoadFile(RIGIDFORMER_SOURCE_DIR "/config/node.yaml");
  std::map<std::string, std::string> written;
  flatten(file, "", written);
  for (auto& [name, value] : written) {
    double number = 0.0;
    if (YAML::convert<double>::decode(YAML::Node(value), number)) {
      value = text_of(number);
    }
  }
  EXPECT_EQ(written, defaults());
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

}  // namespace
}  // namespace rigidformer_ros
