// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/options.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "random_scene.hpp"
#include "rigidformer/data/example_archive.hpp"

namespace rigidformer {
namespace {

using Json = nlohmann::json;
using Change = std::function<void(ModelOptions&)>;

std::int64_t parameters_of(const std::string& preset) { return count_parameters(*RigidFormer(model_preset(preset))); }

/// Every option away from its default, one at a time and in the combinations that interact.
const std::vector<std::pair<std::string, Change>>& changes() {
  static const std::vector<std::pair<std::string, Change>> list = {
      {"nothing", [](ModelOptions&) {}},
      {"no gate", [](ModelOptions& o) { o.gated_attention = false; }},
      {"constant alignment", [](ModelOptions& o) { o.differentiable_alignment = false; }},
      {"3 anchors", [](ModelOptions& o) { o.num_anchors = 3; }},
      {"8 anchors", [](ModelOptions& o) { o.num_anchors = 8; }},
      {"random anchors", [](ModelOptions& o) { o.random_anchors = true; }},
      {"control", [](ModelOptions& o) { o.control_dim = 2; }},
      {"no registers", [](ModelOptions& o) { o.num_registers = 0; }},
      {"residual per sublayer", [](ModelOptions& o) { o.residual_per_sublayer = true; }},
      {"no block residual", [](ModelOptions& o) { o.block_residual_size = 0; }},
      {"short blocks", [](ModelOptions& o) { o.block_residual_size = 2; }},
      {"dropout", [](ModelOptions& o) { o.dropout = 0.3; }},
      {"level networks", [](ModelOptions& o) { o.encoder_level_hidden = 8; }},
      {"one scale", [](ModelOptions& o) { o.scales = {4}; }},
      {"deep predictor", [](ModelOptions& o) { o.predictor_layers_per_scale = 2; }},
      {"no predictor ffn", [](ModelOptions& o) { o.predictor_ffn = false; }},
      {"no reference offset", [](ModelOptions& o) { o.reference_offset_feature = false; }},
      {"inertial", [](ModelOptions& o) { o.inertial_base_motion = true; }},
      {"contact gate", [](ModelOptions& o) { o.contact_gate = true; }},
      {"centre of mass head", [](ModelOptions& o) { o.centre_of_mass_head = true; }},
      {"position feature", [](ModelOptions& o) { o.position_feature = true; }},
      {"contact features", [](ModelOptions& o) { o.contact_features = true; }},
      {"property mask", [](ModelOptions& o) { o.property_mask = true; }},
      {"own token", [](ModelOptions& o) { o.own_token_in_query = true; }},
      {"velocity output", [](ModelOptions& o) { o.velocity_output = true; }},
      {"end velocity", [](ModelOptions& o) { o.end_velocity_output = true; }},
      {"local planes", [](ModelOptions& o) { o.local_planes = true; }},
      {"contact tokens", [](ModelOptions& o) { o = token_options(); }},
      {"more points", [](ModelOptions& o) { o.max_points = 1200; }},
      {"no rest", [](ModelOptions& o) { o.rest_speed_mps = 0.0; }},
      {"restful", [](ModelOptions& o) { o.rest_spin_radps = 1.0 / 3.0; }},
      {"everything", [](ModelOptions& o) { o = contact_aware(o); }}};
  return list;
}

/// Two unrolled steps of a padded batch, then back: everything must stay finite.
void expect_finite_training_step(const ModelOptions& options, torch::ScalarType compute_type,
                                 const std::vector<std::vector<std::int64_t>>& points = {{20, 9}, {12}}) {
  torch::manual_seed(1);
  const RandomScene scene = random_scene(3, points, options.num_anchors, options.control_dim, torch::kFloat32);
  RigidFormer model(options);
  model->set_compute_type(compute_type);
  model->train();
  const Tensor centre = model->centre_of_mass(scene.batch, scene.state.current);
  SceneState state = scene.state;
  Tensor loss = centre.square().sum();
  for (int step = 0; step < 2; ++step) {
    const StepPrediction prediction = model->forward(scene.batch, state, centre, nearest_by_distance_matrix,
                                                     make_engine_step(options, scene.batch, centre),
                                                     make_contact_search(options, scene.batch, centre));
    ASSERT_EQ(prediction.anchors_raw.sizes(),
              (std::vector<std::int64_t>{static_cast<std::int64_t>(points.size()), 2, options.num_anchors, 3}));
    loss = loss + prediction.anchors_raw.square().sum() + prediction.pose.apply(scene.batch.points_reference).sum();
    state = advance(scene.batch, state, prediction);
  }
  EXPECT_TRUE(torch::isfinite(loss).item<bool>());
  loss.backward();
  double largest = 0.0;
  for (const auto& parameter : model->named_parameters()) {
    const Tensor gradient = parameter.value().grad();
    if (!gradient.defined()) continue;  // not every parameter takes part in every variant
    ASSERT_TRUE(torch::isfinite(gradient).all().item<bool>()) << parameter.key();
    largest = std::max(largest, gradient.abs().sum().item<double>());
  }
  EXPECT_GT(largest, 0.0);
}

TEST(ModelOptionsTest, PresetsHaveTheirPromisedSizes) {
  EXPECT_NEAR(static_cast<double>(parameters_of("paper")), 174.8e6, 1.748e6);
  EXPECT_NEAR(static_cast<double>(parameters_of("base")), 20e6, 10e6);
  EXPECT_NEAR(static_cast<double>(parameters_of("small")), 4e6, 2e6);
  EXPECT_LT(parameters_of("tiny"), 1'000'000);
  EXPECT_NE(error_of([] { model_preset("huge"); }).find("'huge'"), std::string::npos);
}

TEST(ModelOptionsTest, PaperPresetHasTheNumbersOfTheText) {
  const ModelOptions o = model_preset("paper");
  EXPECT_EQ(o.embedding_dim, 768);
  EXPECT_EQ(o.num_heads * o.head_dim, 768);
  EXPECT_EQ(o.rotary_dim, 96);
  EXPECT_EQ(o.num_layers, 4);
  EXPECT_EQ(o.num_registers, 16);
  EXPECT_EQ(o.encoder_widths.back(), 1024);
  EXPECT_EQ(o.num_anchors, 4);
  EXPECT_EQ(o.scales, (std::vector<int>{0, 1, 2, 4}));
  EXPECT_EQ(o.dropout, 0.1);
  for (const bool beyond :
       {o.inertial_base_motion, o.contact_gate, o.centre_of_mass_head, o.position_feature, o.contact_features,
        o.property_mask, o.own_token_in_query, o.velocity_output, o.end_velocity_output, o.engine_motion,
        o.hidden_side_head, o.local_planes, o.contact_tokens}) {
    EXPECT_FALSE(beyond);
  }
}

TEST(ModelOptionsTest, PaperPresetLearnsOneStep) {
  ModelOptions options = model_preset("paper");
  EXPECT_TRUE(options.residual_per_sublayer);
  EXPECT_EQ(options.rest_speed_mps, 0.0);
  EXPECT_EQ(options.max_points, 1200);
  expect_finite_training_step(options, torch::kFloat32, {{20, 9}});
}

TEST(ModelOptionsTest, TheSameNetworkMayBeUsedDifferently) {
  ModelOptions other = model_preset("tiny");
  other.max_points = 1200;
  other.rest_speed_mps = other.rest_spin_radps = 0.0;
  EXPECT_TRUE(is_same_network(model_preset("tiny"), other));
  other.gated_attention = false;
  EXPECT_FALSE(is_same_network(model_preset("tiny"), other));
}

TEST(ModelOptionsTest, JsonRoundTripIsLossless) {
  for (const std::string name : {"paper", "base", "small", "tiny"}) {
    const std::string text = to_json(model_preset(name));
    EXPECT_EQ(to_json(model_options_from_json(text)), text);
  }
  for (const auto& [name, change] : changes()) {
    SCOPED_TRACE(name);
    ModelOptions options = model_preset("tiny");
    options.contact_gate_margin_m = 1.0 / 3.0;
    const std::string before = to_json(options);
    change(options);
    EXPECT_EQ(to_json(model_options_from_json(to_json(options))), to_json(options));
    if (name != "nothing") {
      EXPECT_NE(to_json(options), before);
    }
  }
  for (const std::string& name : encoding_names()) {
    EXPECT_EQ(to_string(position_encoding_from_string(name)), name);
  }
  EXPECT_NE(error_of([] { position_encoding_from_string("rope"); }).find("'rope'"), std::string::npos);
}

TEST(ModelOptionsTest, JsonRefusesMissingUnknownAndIllTypedKeys) {
  const Json good = Json::parse(to_json(model_preset("tiny")));
  const auto refusal = [](const Json& json) {
    const std::string text = json.dump();
    EXPECT_THROW(model_options_from_json(text), std::invalid_argument) << text;
    return error_of([&] { model_options_from_json(text); });
  };
  const std::set<std::string> newer = {"end_velocity_output", "engine_motion",   "hidden_side_head",
                                       "local_planes",        "contact_tokens",  "residual_per_sublayer",
                                       "max_points",          "rest_speed_mps",  "rest_spin_radps",
                                       "frame_rate_hz",       "ground_material", "advisers"};
  for (const auto& [key, value] : good.items()) {
    Json json = good;
    json.erase(key);
    if (newer.count(key) > 0) {
      EXPECT_EQ(Json::parse(to_json(model_options_from_json(json.dump()))), good) << "older files do not hold " << key;
    } else {
      EXPECT_NE(refusal(json).find(key), std::string::npos) << key;
    }
  }
  Json json = good;
  json["colour"] = 3;
  EXPECT_NE(refusal(json).find("colour"), std::string::npos);
  const std::vector<std::pair<std::string, Json>> ill_typed = {{"embedding_dim", "64"},
                                                               {"embedding_dim", 64.5},
                                                               {"embedding_dim", 1e300},
                                                               {"embedding_dim", true},
                                                               {"embedding_dim", std::int64_t{1} << 50},
                                                               {"num_heads", nullptr},
                                                               {"scales", 3},
                                                               {"scales", {0, 1.5}},
                                                               {"gated_attention", 1},
                                                               {"dropout", "0.1"},
                                                               {"preset", 7},
                                                               {"position_encoding", 1}};
  for (const auto& [key, value] : ill_typed) {
    json = good;
    json[key] = value;
    EXPECT_NE(refusal(json).find(key), std::string::npos) << key << " = " << value << ": " << refusal(json);
  }
  for (const std::string text : {"", "{", "[]", "7", "null", "{}"}) {
    EXPECT_THROW(model_options_from_json(text), std::invalid_argument) << text;
  }
}

TEST(ModelOptionsTest, ValuesOutOfRangeAreRefusedByName) {
  const std::vector<std::pair<std::string, Change>> wrong = {
      {"encoder_widths", [](ModelOptions& o) { o.encoder_widths.clear(); }},
      {"encoder_widths",
       [](ModelOptions& o) {
         o.encoder_widths = {16, 0};
       }},
      {"encoder_level_hidden", [](ModelOptions& o) { o.encoder_level_hidden = -1; }},
      {"encoder_fuse_hidden", [](ModelOptions& o) { o.encoder_fuse_hidden = 0; }},
      {"number of weights", [](ModelOptions& o) { o.embedding_dim = 1 << 20; }},
      {"number of weights", [](ModelOptions& o) { o.num_layers = 1 << 30; }},
      {"embedding_dim", [](ModelOptions& o) { o.embedding_dim = 0; }},
      {"num_heads", [](ModelOptions& o) { o.num_heads = -1; }},
      {"head_dim", [](ModelOptions& o) { o.head_dim = 33; }},
      {"rotary_dim", [](ModelOptions& o) { o.rotary_dim = 36; }},
      {"rotary_dim", [](ModelOptions& o) { o.rotary_dim = 20; }},
      {"num_layers", [](ModelOptions& o) { o.num_layers = 0; }},
      {"num_registers", [](ModelOptions& o) { o.num_registers = -1; }},
      {"ffn_expansion", [](ModelOptions& o) { o.ffn_expansion = 0.0; }},
      {"film_hidden", [](ModelOptions& o) { o.film_hidden = 0; }},
      {"block_residual_size", [](ModelOptions& o) { o.block_residual_size = -2; }},
      {"dropout", [](ModelOptions& o) { o.dropout = 1.0; }},
      {"dropout", [](ModelOptions& o) { o.dropout = std::nan(""); }},
      {"control_dim", [](ModelOptions& o) { o.control_dim = -1; }},
      {"num_anchors", [](ModelOptions& o) { o.num_anchors = 2; }},
      {"avp_dim", [](ModelOptions& o) { o.avp_dim = 0; }},
      {"scales", [](ModelOptions& o) { o.scales.clear(); }},
      {"scales", [](ModelOptions& o) { o.scales = {5}; }},
      {"predictor_layers_per_scale", [](ModelOptions& o) { o.predictor_layers_per_scale = 0; }},
      {"head_hidden", [](ModelOptions& o) { o.head_hidden = 0; }},
      {"contact_gate_margin_m", [](ModelOptions& o) { o.contact_gate_margin_m = -0.1; }},
      {"engine_motion", [](ModelOptions& o) { o.engine_motion = true; }},
      {"hidden_side_head", [](ModelOptions& o) { o.hidden_side_head = true; }},
      {"advisers", [](ModelOptions& o) { o.advisers = 4; }},
      {"max_points", [](ModelOptions& o) { o.max_points = 15; }},
      {"rest_speed_mps", [](ModelOptions& o) { o.rest_speed_mps = -0.1; }},
      {"rest_spin_radps", [](ModelOptions& o) { o.rest_spin_radps = std::nan(""); }}};
  for (const auto& [field, change] : wrong) {
    ModelOptions options = model_preset("tiny");
    change(options);
    const std::string message = error_of([&] { validate(options); });
    EXPECT_NE(message.find(field), std::string::npos) << field << ": " << message;
  }
}

TEST(ModelOptionsTest, EveryPositionEncodingLearns) {
  for (const std::string& name : encoding_names()) {
    for (ModelOptions options : tiny_variants()) {
      SCOPED_TRACE(name);
      options.position_encoding = position_encoding_from_string(name);
      expect_finite_training_step(options, torch::kFloat32);
    }
  }
}

TEST(ModelOptionsTest, BoxesAndAxesOfSymmetricCloudsHaveFiniteGradients) {
  RandomScene scene = random_scene(3, {{8}}, 4, 0, torch::kFloat32);
  const Tensor corners = (torch::arange(8, torch::kInt64).unsqueeze(-1).bitwise_and(torch::tensor({1, 2, 4})) > 0);
  const Tensor cube = (corners.to(torch::kFloat32) - 0.5).view({1, 1, 8, 3}).set_requires_grad(true);
  for (const char* name : {"obb", "pca"}) {
    ModelOptions options = model_preset("tiny");
    options.position_encoding = position_encoding_from_string(name);
    TokenPositionEncoder encoder(options);
    const Tensor anchors = gather_points(cube, scene.batch.anchor_index);
    const Tensor embedding = encoder(scene.batch, scene.state.current, cube, anchors).object_embedding;
    const Tensor gradient = torch::autograd::grad({embedding.sum()}, {cube})[0];
    EXPECT_TRUE(torch::isfinite(gradient).all().item<bool>()) << name;
  }
}

TEST(ModelOptionsTest, EveryOptionLearns) {
  for (const auto& [name, change] : changes()) {
    SCOPED_TRACE(name);
    ModelOptions options = model_preset("tiny");
    change(options);
    expect_finite_training_step(options, torch::kFloat32);
    if (name == "nothing" || name == "everything") expect_finite_training_step(options, torch::kBFloat16);
  }
}

TEST(ModelOptionsTest, DropoutActsInTrainingOnly) {
  ModelOptions options = model_preset("tiny");
  options.dropout = 0.3;
  RigidFormer model = random_model(options);
  const RandomScene scene = random_scene(3, {{20, 9}});
  EXPECT_TRUE(torch::equal(predict(model, scene).anchors_raw, predict(model, scene).anchors_raw));
  model->train();
  EXPECT_FALSE(torch::equal(predict(model, scene).anchors_raw, predict(model, scene).anchors_raw));
}

}  // namespace
}  // namespace rigidformer
