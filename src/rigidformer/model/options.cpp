// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/options.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <type_traits>

#include "rigidformer/io/text_file.hpp"

namespace rigidformer {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMaxWeights = 1e9;  // 4 GB; the paper's model has 175 million

const std::map<std::string, PositionEncoding>& encoding_names() {
  static const std::map<std::string, PositionEncoding> names = {
      {"arope", PositionEncoding::kArope},     {"sinusoidal", PositionEncoding::kSinusoidal},
      {"learned", PositionEncoding::kLearned}, {"obb", PositionEncoding::kObb},
      {"pca", PositionEncoding::kPca},         {"se3", PositionEncoding::kSe3},
      {"none", PositionEncoding::kNone}};
  return names;
}

/// Calls visit(name, field) for every option but the encoding: the one list that reading and writing share.
template <typename Options, typename Visitor>
void visit_fields(Options& o, Visitor&& visit) {
  visit("preset", o.preset);
  visit("encoder_widths", o.encoder_widths);
  visit("encoder_level_hidden", o.encoder_level_hidden);
  visit("encoder_fuse_hidden", o.encoder_fuse_hidden);
  visit("embedding_dim", o.embedding_dim);
  visit("num_heads", o.num_heads);
  visit("head_dim", o.head_dim);
  visit("rotary_dim", o.rotary_dim);
  visit("num_layers", o.num_layers);
  visit("num_registers", o.num_registers);
  visit("ffn_expansion", o.ffn_expansion);
  visit("film_hidden", o.film_hidden);
  visit("block_residual_size", o.block_residual_size);
  visit("dropout", o.dropout);
  visit("gated_attention", o.gated_attention);
  visit("control_dim", o.control_dim);
  visit("num_anchors", o.num_anchors);
  visit("random_anchors", o.random_anchors);
  visit("avp_hidden", o.avp_hidden);
  visit("avp_dim", o.avp_dim);
  visit("scales", o.scales);
  visit("predictor_layers_per_scale", o.predictor_layers_per_scale);
  visit("predictor_ffn", o.predictor_ffn);
  visit("head_hidden", o.head_hidden);
  visit("differentiable_alignment", o.differentiable_alignment);
  visit("reference_offset_feature", o.reference_offset_feature);
  visit("inertial_base_motion", o.inertial_base_motion);
  visit("contact_gate", o.contact_gate);
  visit("contact_gate_margin_m", o.contact_gate_margin_m);
  visit("centre_of_mass_head", o.centre_of_mass_head);
  visit("position_feature", o.position_feature);
  visit("contact_features", o.contact_features);
  visit("property_mask", o.property_mask);
  visit("own_token_in_query", o.own_token_in_query);
  visit("velocity_output", o.velocity_output);
  visit("end_velocity_output", o.end_velocity_output);
  visit("engine_motion", o.engine_motion);
  visit("hidden_side_head", o.hidden_side_head);
  visit("local_planes", o.local_planes);
  visit("max_points", o.max_points);
  visit("rest_speed_mps", o.rest_speed_mps);
  visit("rest_spin_radps", o.rest_spin_radps);
}

void check(bool condition, const std::string& field, double value, const std::string& bound) {
  if (!condition) {
    throw std::invalid_argument("model option '" + field + "' is " + std::to_string(value) + ", must be " + bound);
  }
}

/// The number of weights without the smallest layers. A file's options decide how much memory a model takes before its
/// weights are looked at.
double approximate_weights(const ModelOptions& o) {
  const double D = o.embedding_dim, scales = static_cast<double>(o.scales.size());
  double count = o.encoder_widths.front();
  for (std::size_t i = 1; i < o.encoder_widths.size(); ++i) {
    count += static_cast<double>(o.encoder_widths[i - 1]) * o.encoder_widths[i];
  }
  const double width = o.encoder_widths.back();
  count += 8.0 * width * o.encoder_level_hidden + (4.0 * width + D) * o.encoder_fuse_hidden;
  const double block = 5.0 * D * o.num_heads * o.head_dim + 3.0 * o.ffn_expansion * D * D;
  count += block * (o.num_layers + scales * o.predictor_layers_per_scale);
  count += 4.0 * D * o.film_hidden * o.num_layers + scales * D * D + D * (o.num_registers + o.control_dim);
  return count + (width + o.avp_dim) * o.avp_hidden + D * o.head_hidden;
}

ModelOptions paper_preset() {
  ModelOptions o;
  o.preset = "paper";
  o.encoder_widths = {64, 128, 256, 512, 1024};
  o.encoder_level_hidden = 6912;  // open in the text: chosen so that the whole comes near 174.8 M
  o.encoder_fuse_hidden = 4096;
  o.embedding_dim = 768;
  o.num_heads = 6;
  o.head_dim = 128;
  o.rotary_dim = 96;
  o.num_registers = 16;
  o.film_hidden = 768;
  o.dropout = 0.1;
  o.avp_hidden = 256;
  o.avp_dim = 256;
  o.predictor_layers_per_scale = 2;
  o.head_hidden = 768;
  return o;
}

/// The shipped recipe: all options of the design that small experiments supported.
void use_contact_aware_recipe(ModelOptions& o) {
  o.reference_offset_feature = false;
  o.inertial_base_motion = true;
  o.contact_gate = true;
  o.centre_of_mass_head = true;
  o.position_feature = true;
  o.contact_features = true;
  o.property_mask = true;
  o.own_token_in_query = true;
  o.velocity_output = true;
  o.end_velocity_output = true;
  o.engine_motion = true;
  o.hidden_side_head = true;
}

ModelOptions small_preset() {
  ModelOptions o;
  o.preset = "small";
  o.encoder_widths = {64, 128, 256};
  o.encoder_fuse_hidden = 384;
  o.embedding_dim = 192;
  o.num_heads = 3;
  o.head_dim = 64;
  o.rotary_dim = 48;
  o.num_registers = 4;
  o.film_hidden = 64;
  o.avp_hidden = 128;
  o.avp_dim = 128;
  o.predictor_ffn = false;
  o.head_hidden = 384;
  use_contact_aware_recipe(o);
  return o;
}

ModelOptions base_preset() {
  ModelOptions o = small_preset();
  o.preset = "base";
  o.encoder_widths = {96, 192, 384, 512};
  o.encoder_fuse_hidden = 1024;
  o.embedding_dim = 384;
  o.num_heads = 3;
  o.head_dim = 128;
  o.rotary_dim = 96;
  o.num_registers = 16;
  o.film_hidden = 128;
  o.avp_hidden = 256;
  o.avp_dim = 256;
  o.predictor_ffn = true;
  o.head_hidden = 768;
  return o;
}

bool has_fraction(const Json& value) {
  if (!value.is_array()) return value.is_number_float();
  return std::any_of(value.begin(), value.end(), [](const Json& element) { return element.is_number_float(); });
}

/// Options that older files do not hold; they have their defaults there.
bool is_newer(const std::string& name) {
  static const std::set<std::string> newer = {"end_velocity_output", "engine_motion", "hidden_side_head",
                                              "local_planes",        "max_points",    "rest_speed_mps",
                                              "rest_spin_radps"};
  return newer.count(name) > 0;
}

/// Strict: neither 64.5 nor true passes for an integer.
template <typename T>
void read_option(const Json& json, const std::string& name, T& field) {
  const Json& value = json.at(name);
  constexpr bool kWhole = std::is_same_v<T, int> || std::is_same_v<T, std::vector<int>>;
  bool fits = false;
  try {
    if (!kWhole || !has_fraction(value)) {  // converting 1e300 would be undefined
      field = value.get<T>();
      fits = Json(field) == value;
    }
  } catch (const nlohmann::json::exception&) {
  }
  if (!fits) throw std::invalid_argument("model option '" + name + "' has the wrong type: " + value.dump());
}

}  // namespace

PositionEncoding position_encoding_from_string(const std::string& name) {
  const auto entry = encoding_names().find(name);
  if (entry == encoding_names().end()) {
    throw std::invalid_argument("model option 'position_encoding' is '" + name +
                                "', must be arope, sinusoidal, learned, obb, pca, se3 or none");
  }
  return entry->second;
}

std::string to_string(PositionEncoding encoding) {
  for (const auto& [name, value] : encoding_names()) {
    if (value == encoding) return name;
  }
  throw std::invalid_argument("unknown position encoding");
}

ModelOptions model_preset(const std::string& name) {
  if (name == "paper") return paper_preset();
  if (name == "base") return base_preset();
  if (name == "small") return small_preset();
  if (name == "tiny") return ModelOptions{};
  throw std::invalid_argument("model preset '" + name + "' is unknown; known: paper, base, small, tiny");
}

void validate(const ModelOptions& o) {
  check(!o.encoder_widths.empty(), "encoder_widths.size", 0, "at least 1");
  for (const int width : o.encoder_widths) check(width > 0, "encoder_widths", width, "> 0");
  check(o.encoder_level_hidden >= 0, "encoder_level_hidden", o.encoder_level_hidden, ">= 0");
  check(o.encoder_fuse_hidden > 0, "encoder_fuse_hidden", o.encoder_fuse_hidden, "> 0");
  check(o.embedding_dim > 0, "embedding_dim", o.embedding_dim, "> 0");
  check(o.num_heads > 0, "num_heads", o.num_heads, "> 0");
  check(o.head_dim > 0 && o.head_dim % 2 == 0, "head_dim", o.head_dim, "positive and even");
  check(o.rotary_dim >= 6 && o.rotary_dim % 6 == 0 && o.rotary_dim <= o.head_dim, "rotary_dim", o.rotary_dim,
        "a multiple of 6 and at most head_dim");
  check(o.num_layers > 0, "num_layers", o.num_layers, "> 0");
  check(o.num_registers >= 0, "num_registers", o.num_registers, ">= 0");
  check(o.ffn_expansion > 0.0, "ffn_expansion", o.ffn_expansion, "> 0");
  check(o.film_hidden > 0, "film_hidden", o.film_hidden, "> 0");
  check(o.block_residual_size >= 0, "block_residual_size", o.block_residual_size, ">= 0");
  check(o.dropout >= 0.0 && o.dropout < 1.0, "dropout", o.dropout, "in [0, 1)");
  check(o.control_dim >= 0, "control_dim", o.control_dim, ">= 0");
  check(o.num_anchors >= 3, "num_anchors", o.num_anchors, ">= 3");
  check(o.avp_hidden > 0 && o.avp_dim > 0, "avp_hidden/avp_dim", o.avp_dim, "> 0");
  check(!o.scales.empty(), "scales.size", 0, "at least 1");
  for (const int scale : o.scales) check(scale >= 0 && scale <= o.num_layers, "scales", scale, "in [0, num_layers]");
  check(o.predictor_layers_per_scale > 0, "predictor_layers_per_scale", o.predictor_layers_per_scale, "> 0");
  check(o.head_hidden > 0, "head_hidden", o.head_hidden, "> 0");
  check(o.contact_gate_margin_m >= 0.0, "contact_gate_margin_m", o.contact_gate_margin_m, ">= 0");
  check(!o.engine_motion || (o.inertial_base_motion && o.velocity_output && o.end_velocity_output), "engine_motion",
        o.engine_motion, "off without inertial_base_motion, velocity_output and end_velocity_output");
  check(!o.hidden_side_head || o.engine_motion, "hidden_side_head", o.hidden_side_head, "off without engine_motion");
  check(o.max_points >= 16, "max_points", o.max_points, "at least 16");
  check(o.rest_speed_mps >= 0.0, "rest_speed_mps", o.rest_speed_mps, ">= 0");
  check(o.rest_spin_radps >= 0.0, "rest_spin_radps", o.rest_spin_radps, ">= 0");
  check(approximate_weights(o) <= kMaxWeights, "number of weights", approximate_weights(o), "at most 1e9");
}

std::string to_json(const ModelOptions& options) {
  Json json;
  visit_fields(options, [&](const char* name, const auto& field) { json[name] = field; });
  json["position_encoding"] = to_string(options.position_encoding);
  return json.dump();
}

ModelOptions model_options_from_json(const std::string& text) {
  if (nests_too_deeply(text)) throw std::invalid_argument("model options are not readable: nested too deeply");
  ModelOptions options;
  try {
    const Json json = Json::parse(text);
    std::set<std::string> known = {"position_encoding"};
    visit_fields(options, [&](const char* name, auto& field) {
      known.insert(name);
      if (json.contains(name) || !is_newer(name)) read_option(json, name, field);
    });
    std::string encoding;
    read_option(json, "position_encoding", encoding);
    options.position_encoding = position_encoding_from_string(encoding);
    for (const auto& [key, value] : json.items()) {
      if (known.count(key) == 0) throw std::invalid_argument("unknown model option '" + key + "'");
    }
  } catch (const nlohmann::json::exception& exception) {
    throw std::invalid_argument(std::string("model options are not readable: ") + exception.what());
  }
  validate(options);
  return options;
}

}  // namespace rigidformer
