// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/options.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <type_traits>

#include "rigidformer/io/member_table.hpp"
#include "rigidformer/io/text_file.hpp"

namespace rigidformer {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMaxWeights = 1e9;  // 4 GB; the paper's model has 175 million

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
  o.residual_per_sublayer = true;
  o.film_hidden = 768;
  o.dropout = 0.1;
  o.avp_hidden = 256;
  o.avp_dim = 256;
  o.predictor_layers_per_scale = 2;
  o.head_hidden = 768;
  o.max_points = 1200;
  o.rest_speed_mps = 0.0;
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

void read_option(const Json& json, const std::string& name, PositionEncoding& field) {
  std::string word;
  read_option(json, name, word);
  field = position_encoding_from_string(word);
}

}  // namespace

PositionEncoding position_encoding_from_string(const std::string& name) {
  const auto encoding = enum_value<PositionEncoding>(name);
  if (!encoding) {
    throw std::invalid_argument("model option 'position_encoding' is '" + name +
                                "', must be arope, sinusoidal, learned, obb, pca, se3 or none");
  }
  return *encoding;
}

std::string to_string(PositionEncoding encoding) {
  const std::string name = enum_word(encoding);
  if (name.empty()) throw std::invalid_argument("unknown position encoding");
  return name;
}

ModelOptions model_preset(const std::string& name) {
  if (name == "paper") return paper_preset();
  if (name == "base") return base_preset();
  if (name == "small") return small_preset();
  if (name == "tiny") return ModelOptions{};
  throw std::invalid_argument("model preset '" + name + "' is unknown; known: paper, base, small, tiny");
}

void validate(const ModelOptions& options) {
  ModelOptions o = options;
  for_each_member(o, [](const char* key, const auto& value, const Accepts& accepts, const char*) {
    if (!fits(value, accepts)) {
      throw std::invalid_argument(std::string("model option '") + key + "' is " + value_text(value, accepts) +
                                  ", must be " + range_text(accepts));
    }
  });
  check(!o.encoder_widths.empty(), "encoder_widths.size", 0, "at least 1");
  check(o.head_dim % 2 == 0, "head_dim", o.head_dim, "even");
  check(o.rotary_dim % 6 == 0 && o.rotary_dim <= o.head_dim, "rotary_dim", o.rotary_dim,
        "a multiple of 6 and at most head_dim");
  check(!o.scales.empty(), "scales.size", 0, "at least 1");
  for (const int scale : o.scales) check(scale <= o.num_layers, "scales", scale, "in [0, num_layers]");
  check(!o.engine_motion || (o.inertial_base_motion && o.velocity_output && o.end_velocity_output), "engine_motion",
        o.engine_motion, "off without inertial_base_motion, velocity_output and end_velocity_output");
  check(!o.contact_tokens || (o.inertial_base_motion && o.velocity_output && o.end_velocity_output), "contact_tokens",
        o.contact_tokens, "off without inertial_base_motion, velocity_output and end_velocity_output");
  check(!o.hidden_side_head || o.engine_motion || o.contact_tokens, "hidden_side_head", o.hidden_side_head,
        "off without engine_motion and contact_tokens, which alone ask for hulls");
  check(approximate_weights(o) <= kMaxWeights, "number of weights", approximate_weights(o), "at most 1e9");
}

bool is_same_network(ModelOptions a, const ModelOptions& b) {
  a.max_points = b.max_points;
  a.rest_speed_mps = b.rest_speed_mps;
  a.rest_spin_radps = b.rest_spin_radps;
  return to_json(a) == to_json(b);
}

std::string to_json(const ModelOptions& options) {
  Json json;
  ModelOptions o = options;
  for_each_member(o, [&](const char* key, const auto& field, const Accepts&, const char*) {
    if constexpr (std::is_enum_v<std::decay_t<decltype(field)>>) {
      json[key] = to_string(field);
    } else {
      json[key] = field;
    }
  });
  return json.dump();
}

ModelOptions model_options_from_json(const std::string& text) {
  if (nests_too_deeply(text)) throw std::invalid_argument("model options are not readable: nested too deeply");
  ModelOptions options;
  try {
    const Json json = Json::parse(text);
    std::set<std::string> known;
    for_each_member(options, [&](const char* key, auto& field, const Accepts& accepts, const char*) {
      known.insert(key);
      if (json.contains(key) || !accepts.is_newer) read_option(json, key, field);
    });
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
