// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "rigidformer/io/members.hpp"

namespace rigidformer {

/// How tokens learn where they are (paper §3.3 and Tab. 7).
enum class PositionEncoding { kArope, kSinusoidal, kLearned, kObb, kPca, kSe3, kNone };

inline EnumNames<PositionEncoding> names_of(PositionEncoding) {
  return {{"arope", PositionEncoding::kArope},     {"sinusoidal", PositionEncoding::kSinusoidal},
          {"learned", PositionEncoding::kLearned}, {"obb", PositionEncoding::kObb},
          {"pca", PositionEncoding::kPca},         {"se3", PositionEncoding::kSe3},
          {"none", PositionEncoding::kNone}};
}

/// Guesses of unknown material that an engine can be asked with (engine/adviser_material.hpp).
constexpr int kMaxAdvisers = 3;

/// Every size and every switch of the network. Defaults are the `tiny` preset used in tests.
/// Switches under "Beyond the paper" are off in the `paper` preset (docs/paper_map.md lists each deviation).
struct ModelOptions {
  std::string preset = "tiny";

  // Encoder (§3.1, App. G)
  std::vector<int> encoder_widths = {16, 32};
  int encoder_level_hidden = 0;
  int encoder_fuse_hidden = 64;

  // Object decoder (§3.1)
  int embedding_dim = 64;  ///< D
  int num_heads = 2;       ///< H
  int head_dim = 32;
  int rotary_dim = 24;
  int num_layers = 4;     ///< L
  int num_registers = 4;  ///< N_r
  double ffn_expansion = 2.5;
  int film_hidden = 32;
  int block_residual_size = 4;
  bool residual_per_sublayer = false;
  double dropout = 0.0;
  bool gated_attention = true;
  int control_dim = 0;
  double frame_rate_hz = 240.0;
  PositionEncoding position_encoding = PositionEncoding::kArope;

  // Anchors (§3.2, App. G)
  int num_anchors = 4;  ///< N_a
  bool random_anchors = false;
  int avp_hidden = 32, avp_dim = 32;
  std::vector<int> scales = {0, 1, 2, 4};
  int predictor_layers_per_scale = 1;
  bool predictor_ffn = true;
  int head_hidden = 64;
  bool differentiable_alignment = true;

  // Beyond the paper (design options)
  bool reference_offset_feature = true;
  bool inertial_base_motion = false;
  bool contact_gate = false;
  double contact_gate_margin_m = 0.05;
  bool centre_of_mass_head = false;
  bool hidden_side_head = false;
  bool position_feature = false;
  bool contact_features = false;
  bool local_planes = false;
  bool contact_tokens = false;
  bool property_mask = false;
  bool ground_material = false;
  bool own_token_in_query = false;
  bool velocity_output = false;
  bool end_velocity_output = false;
  bool engine_motion = false;
  int advisers = 1;

  // How a predictor uses the network, unless it is told otherwise
  int max_points = 256;
  double rest_speed_mps = 0.1;
  double rest_spin_radps = 0.3;
};

/// The sizes of encoder, decoder and anchors.
template <typename Visit>
void for_each_size(ModelOptions& o, const Visit& visit) {
  visit("preset", o.preset, anything(), "paper, base, small or tiny: all sizes and the defaults of switches");
  visit("encoder_widths", o.encoder_widths, positive().fixed(), "shared point MLP; the last is the backbone's width");
  visit("encoder_level_hidden", o.encoder_level_hidden, at_least(0).fixed(),
        "hidden width of one MLP per pooling level after pooling; 0 = none");
  visit("encoder_fuse_hidden", o.encoder_fuse_hidden, positive().fixed(),
        "hidden width of the MLP that fuses the four levels");
  visit("embedding_dim", o.embedding_dim, positive().fixed(), "D");
  visit("num_heads", o.num_heads, positive().fixed(), "H");
  visit("head_dim", o.head_dim, positive().fixed(), "channels per head, even");
  visit("rotary_dim", o.rotary_dim, at_least(6).fixed(), "channels per head that ARoPE rotates; a multiple of 6");
  visit("num_layers", o.num_layers, positive().fixed(), "L");
  visit("num_registers", o.num_registers, at_least(0).fixed(), "N_r");
  visit("ffn_expansion", o.ffn_expansion, positive().fixed(), "SwiGLU hidden width / D");
  visit("film_hidden", o.film_hidden, positive().fixed(), "hidden width of the FiLM networks");
  visit("block_residual_size", o.block_residual_size, at_least(0).fixed(),
        "sublayers per block of the block attention residuals; 0 = off");
  visit("residual_per_sublayer", o.residual_per_sublayer, anything().fixed().newer(),
        "every sublayer chooses its input from block sums (ref. [20]); else one choice at the end of each block");
  visit("dropout", o.dropout, less_than_all(), "in the decoder, when learning");
  visit("gated_attention", o.gated_attention, anything(), "Tab. 6");
  visit("control_dim", o.control_dim, at_least(0), "width of the control code appended to (s, s^2), App. I");
  visit("frame_rate_hz", o.frame_rate_hz, positive().newer(),
        "of the recordings that it learns from: s in (s, s^2) counts their frames");
  visit("num_anchors", o.num_anchors, at_least(3), "N_a");
  visit("random_anchors", o.random_anchors, anything(), "Tab. 9: farthest point sampling starts at a random point");
  visit("avp_hidden", o.avp_hidden, positive().fixed(), "hidden width of the anchor-vertex pooling MLP");
  visit("avp_dim", o.avp_dim, positive().fixed(), "output width of the anchor-vertex pooling MLP");
  visit("scales", o.scales, at_least(0).fixed(), "decoder outputs the anchors read");
  visit("predictor_layers_per_scale", o.predictor_layers_per_scale, positive().fixed(),
        "cross-attention layers per scale");
  visit("predictor_ffn", o.predictor_ffn, anything().fixed(), "SwiGLU after each cross-attention layer");
  visit("head_hidden", o.head_hidden, positive().fixed(), "hidden width of the acceleration head");
  visit("differentiable_alignment", o.differentiable_alignment, anything(), "Tab. 6");
}

/// The switches beyond the paper.
template <typename Visit>
void for_each_switch(ModelOptions& o, const Visit& visit) {
  visit("reference_offset_feature", o.reference_offset_feature, anything(),
        "the paper's x_t - x_ref; its range grows with the rollout");
  visit("inertial_base_motion", o.inertial_base_motion, anything(),
        "predict the residual to free rigid motion instead of to straight lines");
  visit("contact_gate", o.contact_gate, anything(), "objects with nothing in reach keep their base motion");
  visit("contact_gate_margin_m", o.contact_gate_margin_m, at_least(0.0), "added to the sum of bounding radii");
  visit("centre_of_mass_head", o.centre_of_mass_head, anything(),
        "estimate the centre of mass from the cloud (else its centroid)");
  visit("position_feature", o.position_feature, anything(), "x - centre of mass");
  visit("contact_features", o.contact_features, anything(),
        "squashed distances, ground apart, relative motion and partner's material");
  visit("property_mask", o.property_mask, anything(), "extra inputs that say which material parameters are known");
  visit("own_token_in_query", o.own_token_in_query, anything(), "the object's own token joins its anchor queries");
  visit("velocity_output", o.velocity_output, anything(),
        "the head predicts a velocity change (m/s) instead of an acceleration");
  visit("end_velocity_output", o.end_velocity_output, anything().newer(),
        "the head also predicts the velocity at the end of the step");
  visit("engine_motion", o.engine_motion, anything().newer(),
        "a physics engine's step is an input, and part of the output by a learned gate");
  visit("advisers", o.advisers, between(1, kMaxAdvisers).newer(),
        "steps of the engine, each with its own guess of unknown material; the first takes the means of MOVi");
  visit("hidden_side_head", o.hidden_side_head, anything().newer(),
        "estimate the side that no camera sees, for the physics engine");
  visit("local_planes", o.local_planes, anything().newer(),
        "signed gaps between the tangent planes of a vertex and its nearest one");
  visit("contact_tokens", o.contact_tokens, anything().newer(),
        "where and when hulls meet is computed, and one token per contact reads it");
  visit("ground_material", o.ground_material, anything().newer(),
        "extra inputs that say what the ground is made of, as far as it is known");
  visit("max_points", o.max_points, at_least(16).newer(),
        "points per object the network looks at; larger clouds are thinned evenly");
  visit("rest_speed_mps", o.rest_speed_mps, at_least(0.0).newer(),
        "a predictor holds what is and would stay slower; 0 = never");
  visit("rest_spin_radps", o.rest_spin_radps, at_least(0.0).newer(), "and turns slower than this");
}

/// In the order of the JSON text, by which a resumed run knows its model.
template <typename Visit>
void for_each_member(ModelOptions& o, const Visit& visit) {
  for_each_size(o, visit);
  for_each_switch(o, visit);
  visit("position_encoding", o.position_encoding, anything(), "how tokens learn where they are");
}

/// `paper`, `base`, `small` or `tiny`. Throws std::invalid_argument naming the preset.
ModelOptions model_preset(const std::string& name);

/// Throws std::invalid_argument naming field, value and bound.
void validate(const ModelOptions& options);

/// Lossless JSON round trip; `model_options_from_json` rejects unknown or missing keys and validates.
std::string to_json(const ModelOptions& options);
ModelOptions model_options_from_json(const std::string& json);

/// Whether weights of one fit the other. How a predictor uses the network may differ.
bool is_same_network(ModelOptions a, const ModelOptions& b);

PositionEncoding position_encoding_from_string(const std::string& name);
std::string to_string(PositionEncoding encoding);

}  // namespace rigidformer
