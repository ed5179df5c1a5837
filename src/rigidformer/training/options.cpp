// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/options.hpp"

#include <yaml-cpp/yaml.h>

#include <set>
#include <stdexcept>
#include <type_traits>

namespace rigidformer {
namespace {

template <typename T>
std::string accepted_as() {
  if constexpr (std::is_same_v<T, bool>) return "true or false";
  if constexpr (std::is_unsigned_v<T>) return "an integer of at least 0";
  if constexpr (std::is_integral_v<T>) return "an integer";
  if constexpr (std::is_floating_point_v<T>) return "a number like 0.001 or 1e-3";
  return std::is_same_v<T, std::string> ? "a text" : "a list of integers";
}

/// Reads one YAML mapping; remembers which keys were asked for so that the others can be reported.
class Section {
 public:
  Section(const YAML::Node& node, std::string name) : node_(node), name_(std::move(name)) {
    if (node_ && !node_.IsNull() && !node_.IsMap()) throw std::invalid_argument("'" + name_ + "' must be a mapping");
  }

  template <typename T>
  void read(const std::string& key, T& value) {
    known_.insert(key);
    if (!node_ || !node_.IsMap() || !node_[key]) return;
    try {
      value = node_[key].as<T>();
    } catch (const YAML::Exception&) {
      throw std::invalid_argument("'" + name_ + key + "' has the wrong type: it is " + YAML::Dump(node_[key]) +
                                  ", accepted is " + accepted_as<T>());
    }
  }

  Section section(const std::string& key) {
    known_.insert(key);
    return Section(node_ && node_.IsMap() ? node_[key] : YAML::Node(), name_ + key + ".");
  }

  YAML::Node raw(const std::string& key) {
    known_.insert(key);
    return node_ && node_.IsMap() ? node_[key] : YAML::Node();
  }

  /// Throws when the mapping has a key that nobody read.
  void reject_unknown() const {
    if (!node_ || !node_.IsMap()) return;
    for (const auto& entry : node_) {
      const auto key = entry.first.as<std::string>();
      if (known_.count(key) == 0) {
        std::string list;
        for (const std::string& name : known_) list += (list.empty() ? "" : ", ") + name;
        throw std::invalid_argument("unknown key '" + name_ + key + "'; known: " + list);
      }
    }
  }

 private:
  YAML::Node node_;
  std::string name_;
  std::set<std::string> known_;
};

void read_model(Section section, ModelOptions& model) {
  std::string preset = model.preset;
  section.read("preset", preset);
  model = model_preset(preset);
  section.read("num_anchors", model.num_anchors);
  section.read("random_anchors", model.random_anchors);
  section.read("gated_attention", model.gated_attention);
  section.read("differentiable_alignment", model.differentiable_alignment);
  section.read("dropout", model.dropout);
  section.read("control_dim", model.control_dim);
  std::string encoding = to_string(model.position_encoding);
  section.read("position_encoding", encoding);
  model.position_encoding = position_encoding_from_string(encoding);
  section.read("reference_offset_feature", model.reference_offset_feature);
  section.read("inertial_base_motion", model.inertial_base_motion);
  section.read("contact_gate", model.contact_gate);
  section.read("contact_gate_margin_m", model.contact_gate_margin_m);
  section.read("centre_of_mass_head", model.centre_of_mass_head);
  section.read("position_feature", model.position_feature);
  section.read("contact_features", model.contact_features);
  section.read("property_mask", model.property_mask);
  section.read("own_token_in_query", model.own_token_in_query);
  section.read("velocity_output", model.velocity_output);
  section.read("end_velocity_output", model.end_velocity_output);
  section.read("engine_motion", model.engine_motion);
  section.read("hidden_side_head", model.hidden_side_head);
  section.reject_unknown();
  validate(model);
}

void read_windows(Section section, WindowOptions& windows) {
  section.read("step_sizes", windows.step_sizes);
  section.read("any_step_probability", windows.any_step_probability);
  section.read("mid_air_probability", windows.mid_air_probability);
  section.read("floor_probability", windows.floor_probability);
  section.read("rolling_probability", windows.rolling_probability);
  section.read("resting_probability", windows.resting_probability);
  section.reject_unknown();
}

void read_augmentation(Section section, AugmentationOptions& augmentation) {
  section.read("min_points", augmentation.min_points);
  section.read("max_points", augmentation.max_points);
  section.read("vertex_probability", augmentation.vertex_probability);
  section.read("view_probability", augmentation.view_probability);
  section.read("noise_m", augmentation.noise_m);
  section.read("unknown_probability", augmentation.unknown_probability);
  section.read("yaw_probability", augmentation.yaw_probability);
  section.read("yaw_step_deg", augmentation.yaw_step_deg);
  section.read("yaw_per_batch", augmentation.yaw_per_batch);
  section.read("shift_m", augmentation.shift_m);
  section.read("permutation_probability", augmentation.permutation_probability);
  section.reject_unknown();
}

void read_point_sets(Section section, PointSetOptions& point_sets) {
  section.read("sets_per_shape", point_sets.sets_per_shape);
  section.read("points_per_set", point_sets.points_per_set);
  section.read("seed", point_sets.seed);
  section.reject_unknown();
}

void read_loss(Section section, LossOptions& loss) {
  section.read("position_weight", loss.position_weight);
  section.read("acceleration_weight", loss.acceleration_weight);
  section.read("end_velocity_weight", loss.end_velocity_weight);
  section.read("residual_unit", loss.residual_unit);
  section.read("beta", loss.beta);
  section.read("centre_of_mass_weight", loss.centre_of_mass_weight);
  section.read("hidden_side_weight", loss.hidden_side_weight);
  section.reject_unknown();
}

void read_optimizer(Section section, OptimizerOptions& optimizer) {
  section.read("learning_rate", optimizer.learning_rate);
  section.read("final_learning_rate", optimizer.final_learning_rate);
  section.read("warmup", optimizer.warmup);
  section.read("weight_decay", optimizer.weight_decay);
  section.read("beta1", optimizer.beta1);
  section.read("beta2", optimizer.beta2);
  section.read("clip_norm", optimizer.clip_norm);
  section.read("ema_decay", optimizer.ema_decay);
  section.reject_unknown();
}

void read_unroll(const YAML::Node& node, std::vector<UnrollStage>& unroll) {
  if (!node || node.IsNull()) return;
  unroll.clear();
  for (const YAML::Node& entry : node) {
    Section section(entry, "unroll[].");
    UnrollStage stage;
    section.read("from", stage.from);
    section.read("steps", stage.steps);
    section.reject_unknown();
    unroll.push_back(stage);
  }
}

void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument(message);
}

void require_probability(double value, const std::string& key) {
  require(value >= 0.0 && value <= 1.0, "'" + key + "' must lie in [0, 1]");
}

void validate(const AugmentationOptions& o) {
  require(o.min_points >= 4 && o.min_points <= o.max_points,
          "'augmentation.min_points' must be at least 4 and at most max_points");
  require_probability(o.vertex_probability, "augmentation.vertex_probability");
  require_probability(o.view_probability, "augmentation.view_probability");
  require_probability(o.unknown_probability, "augmentation.unknown_probability");
  require_probability(o.yaw_probability, "augmentation.yaw_probability");
  require_probability(o.permutation_probability, "augmentation.permutation_probability");
  require(o.noise_m >= 0.0, "'augmentation.noise_m' must not be negative");
  require(o.shift_m >= 0.0, "'augmentation.shift_m' must not be negative");
}

void validate(const OptimizerOptions& o) {
  require(o.learning_rate > 0.0, "'optimizer.learning_rate' must be positive");
  require(o.final_learning_rate >= 0.0, "'optimizer.final_learning_rate' must not be negative");
  require_probability(o.warmup, "optimizer.warmup");
  require(o.beta1 >= 0.0 && o.beta1 < 1.0, "'optimizer.beta1' must lie in [0, 1)");
  require(o.beta2 >= 0.0 && o.beta2 < 1.0, "'optimizer.beta2' must lie in [0, 1)");
  require(o.clip_norm > 0.0, "'optimizer.clip_norm' must be positive");
  require(o.ema_decay >= 0.0 && o.ema_decay < 1.0, "'optimizer.ema_decay' must lie in [0, 1)");
}

void validate(const TrainingOptions& o) {
  require(o.iterations > 0, "'iterations' must be positive");
  require(o.batch_size > 0, "'batch_size' must be positive");
  require(o.micro_batches > 0, "'micro_batches' must be positive");
  require(o.log_every > 0, "'log_every' must be positive");
  require(o.validation_scenes > 0, "'validation_scenes' must be positive");
  require(o.precision == "float32" || o.precision == "bfloat16", "'precision' must be float32 or bfloat16");
  require(o.loss.residual_unit == "dt" || o.loss.residual_unit == "dt2", "'loss.residual_unit' must be dt or dt2");
  require(o.loss.beta > 0.0, "'loss.beta' must be positive");
  validate(o.augmentation);
  validate(o.optimizer);
  require(o.point_sets.sets_per_shape >= 2 && o.point_sets.points_per_set >= o.augmentation.max_points,
          "'point_sets' needs at least 2 sets per shape and points_per_set of at least augmentation.max_points");
  require(!o.unroll.empty() && o.unroll.front().from == 0.0, "'unroll' must start with from: 0");
  for (const UnrollStage& stage : o.unroll) require(stage.steps >= 0, "'unroll[].steps' must not be negative");
}

/// Puts "key=value" or "section.key=value" into the document.
void override_value(YAML::Node& document, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  require(equals != std::string::npos, "'" + assignment + "' must look like section.key=value");
  const std::string key = assignment.substr(0, equals);
  const std::size_t dot = key.find('.');
  const YAML::Node value = YAML::Load(assignment.substr(equals + 1));
  if (dot == std::string::npos) {
    document[key] = value;
  } else {
    document[key.substr(0, dot)][key.substr(dot + 1)] = value;
  }
}

}  // namespace

TrainingOptions load_training_options(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  TrainingOptions options;
  try {
    YAML::Node document = YAML::LoadFile(file.string());
    for (const std::string& assignment : overrides) override_value(document, assignment);
    Section root(document, "");
    read_model(root.section("model"), options.model);
    read_windows(root.section("windows"), options.windows);
    read_augmentation(root.section("augmentation"), options.augmentation);
    read_point_sets(root.section("point_sets"), options.point_sets);
    read_loss(root.section("loss"), options.loss);
    read_optimizer(root.section("optimizer"), options.optimizer);
    read_unroll(root.raw("unroll"), options.unroll);
    root.read("iterations", options.iterations);
    root.read("batch_size", options.batch_size);
    root.read("micro_batches", options.micro_batches);
    root.read("seed", options.seed);
    root.read("precision", options.precision);
    root.read("log_every", options.log_every);
    root.read("checkpoint_every_s", options.checkpoint_every_s);
    root.read("validate_every_s", options.validate_every_s);
    root.read("validation_scenes", options.validation_scenes);
    root.reject_unknown();
    validate(options);
  } catch (const YAML::Exception& exception) {
    throw std::invalid_argument("training file '" + file.string() + "': " + exception.what());
  } catch (const std::invalid_argument& exception) {
    throw std::invalid_argument("training file '" + file.string() + "': " + exception.what());
  }
  return options;
}

}  // namespace rigidformer
