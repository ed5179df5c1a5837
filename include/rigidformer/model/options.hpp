// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace rigidformer {

/// How tokens learn where they are (paper §3.3 and Tab. 7).
enum class PositionEncoding { kArope, kSinusoidal, kLearned, kObb, kPca, kSe3, kNone };

/// Every size and every switch of the network. Defaults are the `tiny` preset used in tests.
/// Switches under "Beyond the paper" are off in the `paper` preset (docs/paper_map.md lists each deviation).
struct ModelOptions {
  std::string preset = "tiny";

  // Encoder (§3.1, App. G)
  std::vector<int> encoder_widths = {16, 32};  ///< Shared point MLP, one layer per entry; last = backbone width
  int encoder_level_hidden = 0;                ///< Hidden width of one MLP per pooling level after pooling; 0 = none
  int encoder_fuse_hidden = 64;                ///< Hidden width of the MLP that fuses the four levels

  // Object decoder (§3.1)
  int embedding_dim = 64;       ///< D
  int num_heads = 2;            ///< H
  int head_dim = 32;            ///< Channels per head, even
  int rotary_dim = 24;          ///< Channels per head that ARoPE rotates; multiple of 6, at most head_dim
  int num_layers = 4;           ///< L
  int num_registers = 4;        ///< N_r
  double ffn_expansion = 2.5;   ///< SwiGLU hidden width / D
  int film_hidden = 32;         ///< Hidden width of the FiLM networks
  int block_residual_size = 4;  ///< Sublayers per block of the block attention residuals; 0 = off
  double dropout = 0.0;
  bool gated_attention = true;  ///< Tab. 6
  int control_dim = 0;          ///< Width of the control code c appended to (s, s^2), App. I
  PositionEncoding position_encoding = PositionEncoding::kArope;

  // Anchors (§3.2, App. G)
  int num_anchors = 4;                     ///< N_a
  bool random_anchors = false;             ///< Tab. 9: start farthest point sampling at a random point
  int avp_hidden = 32, avp_dim = 32;       ///< Anchor-vertex pooling MLP
  std::vector<int> scales = {0, 1, 2, 4};  ///< Decoder outputs the anchors read
  int predictor_layers_per_scale = 1;      ///< Cross-attention layers per scale
  bool predictor_ffn = true;               ///< SwiGLU after each cross-attention layer
  int head_hidden = 64;                    ///< Hidden width of the acceleration head
  bool differentiable_alignment = true;    ///< Tab. 6

  // Beyond the paper (design options)
  bool reference_offset_feature = true;  ///< The paper's x_t - x_ref; its range grows with the rollout
  bool inertial_base_motion = false;     ///< Predict the residual to free rigid motion instead of to straight lines
  bool contact_gate = false;             ///< Objects with nothing in reach keep their base motion
  double contact_gate_margin_m = 0.05;   ///< Added to the sum of bounding radii
  bool centre_of_mass_head = false;      ///< Estimate the centre of mass from the cloud (else its centroid)
  bool hidden_side_head = false;         ///< Estimate the side that no camera sees, for the physics engine
  bool position_feature = false;         ///< x - centre of mass
  bool contact_features = false;         ///< Squashed distances, ground apart, relative motion and partner's material
  bool local_planes = false;             ///< Signed gaps between the tangent planes of a vertex and its nearest one
  bool property_mask = false;            ///< Extra inputs that say which material parameters are known
  bool own_token_in_query = false;       ///< The object's own token joins its anchor queries
  bool velocity_output = false;          ///< Head predicts a velocity change (m/s) instead of an acceleration
  bool end_velocity_output = false;      ///< Head also predicts the velocity at the end of the step
  bool engine_motion = false;  ///< A physics engine's step is an input, and part of the output by a learned gate

  // How a predictor uses the network, unless it is told otherwise
  int max_points = 256;          ///< Points per object the network looks at; larger clouds are thinned evenly
  double rest_speed_mps = 0.1;   ///< What is and would stay slower than this and ...
  double rest_spin_radps = 0.3;  ///< ... this is held still; rest_speed_mps 0 = never
};

/// `paper`, `base`, `small` or `tiny`. Throws std::invalid_argument naming the preset.
ModelOptions model_preset(const std::string& name);

/// Throws std::invalid_argument naming field, value and bound.
void validate(const ModelOptions& options);

/// Lossless JSON round trip; `model_options_from_json` rejects unknown or missing keys and validates.
std::string to_json(const ModelOptions& options);
ModelOptions model_options_from_json(const std::string& json);

PositionEncoding position_encoding_from_string(const std::string& name);
std::string to_string(PositionEncoding encoding);

}  // namespace rigidformer
