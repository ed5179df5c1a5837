// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/options.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include "rigidformer/io/member_table.hpp"

namespace rigidformer {
namespace {

void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument(message);
}

template <typename T>
std::string accepted_as() {
  if constexpr (std::is_enum_v<T>) return joined(enum_words<T>(), ", ");
  if constexpr (std::is_same_v<T, bool>) return "true or false";
  if constexpr (std::is_unsigned_v<T>) return "an integer of at least 0";
  if constexpr (std::is_integral_v<T>) return "an integer";
  if constexpr (std::is_floating_point_v<T>) return "a number like 0.001 or 1e-3";
  return std::is_same_v<T, std::string> ? "a text" : "a list of integers";
}

/// Reads one YAML mapping into a struct with a table of its members. `name` ends with a dot where it is not empty.
class Section {
 public:
  Section(const YAML::Node& node, std::string name) : node_(node), name_(std::move(name)) {
    require(!node_ || node_.IsNull() || node_.IsMap(), "'" + name_ + "' must be a mapping");
  }

  /// Throws when the mapping has a key that is no member.
  template <typename Options>
  void read(Options& options) {
    for_each_member(options, [this](const char* key, auto& value, const Accepts& accepts, const char*) {
      if (!accepts.is_fixed) {
        known_.push_back(key);
        read_member(key, value, accepts);
      }
    });
    reject_unknown();
  }

  /// The preset decides about the defaults of all others.
  void read(ModelOptions& model) {
    std::string preset = model.preset;
    read_member("preset", preset, anything());
    model = model_preset(preset);
    read<ModelOptions>(model);
    validate(model);
  }

 private:
  YAML::Node at(const std::string& key) const {
    return node_ && node_.IsMap() ? node_[key] : YAML::Node(YAML::NodeType::Undefined);
  }

  template <typename T>
  void read_member(const std::string& key, T& value, const Accepts& accepts) {
    const YAML::Node node = at(key);
    if constexpr (has_members<T>) {
      Section(node, name_ + key + ".").read(value);
    } else if constexpr (is_list<T>) {
      read_list(node, name_ + key + "[].", value);
    } else if (node) {
      read_value(key, node, value);
      require(fits(value, accepts),
              "'" + name_ + key + "' is " + value_text(value, accepts) + ", must be " + values_text(accepts));
    }
  }

  template <typename T>
  void read_value(const std::string& key, const YAML::Node& node, T& value) {
    try {
      if constexpr (std::is_enum_v<T>) {
        value = position_encoding_from_string(node.as<std::string>());
      } else {
        value = node.as<T>();
      }
    } catch (const YAML::Exception&) {
      throw std::invalid_argument("'" + name_ + key + "' has the wrong type: it is " + YAML::Dump(node) +
                                  ", accepted is " + accepted_as<T>());
    }
  }

  template <typename Element>
  static void read_list(const YAML::Node& node, const std::string& name, std::vector<Element>& list) {
    if (!node || node.IsNull()) return;
    list.clear();
    for (const YAML::Node& entry : node) {
      list.emplace_back();
      Section(entry, name).read(list.back());
    }
  }

  void reject_unknown() const {
    if (!node_ || !node_.IsMap()) return;
    for (const auto& entry : node_) {
      const auto key = entry.first.as<std::string>();
      const bool is_known = std::find(known_.begin(), known_.end(), key) != known_.end();
      require(is_known, "unknown key '" + name_ + key + "'; known: " + joined(known_, ", "));
    }
  }

  YAML::Node node_;
  std::string name_;
  std::vector<std::string> known_;
};

/// What the table of one member cannot say.
void validate(const TrainingOptions& o) {
  require(o.augmentation.min_points <= o.augmentation.max_points,
          "'augmentation.min_points' must be at most max_points");
  const auto& counts = o.augmentation.point_counts;
  require(std::all_of(counts.begin(), counts.end(),
                      [&](int count) { return count >= 4 && count <= o.augmentation.max_points; }),
          "'augmentation.point_counts' must lie between 4 and max_points");
  require(o.point_sets.sets_per_shape >= 2 && o.point_sets.points_per_set >= o.augmentation.max_points,
          "'point_sets' needs at least 2 sets per shape and points_per_set of at least augmentation.max_points");
  require(!o.unroll.empty() && o.unroll.front().from == 0.0, "'unroll' must start with from: 0");
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

/// Puts what `changes` says into the document, key by key where both are mappings.
void merge(YAML::Node document, const YAML::Node& changes) {
  for (const auto& entry : changes) {
    const auto key = entry.first.as<std::string>();
    YAML::Node before = document[key];
    if (before.IsDefined() && before.IsMap() && entry.second.IsMap()) {
      merge(before, entry.second);
    } else {
      document[key] = entry.second;
    }
  }
}

/// The file with what it extends in place of `extends`. `opened` are the files on the way to this one.
YAML::Node load_extended(const std::filesystem::path& file, std::vector<std::string> opened) {
  namespace fs = std::filesystem;
  YAML::Node changes;
  try {
    changes = YAML::LoadFile(file.string());
  } catch (const YAML::Exception& exception) {
    throw std::invalid_argument((opened.empty() ? "" : file.string() + ": ") + exception.what());
  }
  if (!changes.IsMap() || !changes["extends"]) return changes;
  const std::string name = fs::weakly_canonical(file).string();
  const bool is_open = std::find(opened.begin(), opened.end(), name) != opened.end();
  opened.push_back(name);
  require(!is_open, "'extends' leads back to where it began: " + joined(opened, " -> "));
  require(changes["extends"].IsScalar(), "'extends' must name one file");
  YAML::Node document = load_extended(file.parent_path() / changes["extends"].as<std::string>(), opened);
  require(document.IsMap(), "'extends' names a file that is no mapping");
  changes.remove("extends");
  merge(document, changes);
  return document;
}

/// The list of stages, which leaves the document.
YAML::Node take_stages(YAML::Node& document) {
  if (!document.IsMap() || !document["stages"]) return YAML::Node(YAML::NodeType::Sequence);
  const YAML::Node stages = YAML::Clone(document["stages"]);
  document.remove("stages");
  require(stages.IsSequence() && stages.size() > 0, "'stages' must be a list of mappings");
  for (const YAML::Node& stage : stages) require(stage.IsMap(), "'stages' must be a list of mappings");
  return stages;
}

}  // namespace

std::vector<TrainingOptions> load_training_stages(const std::filesystem::path& file,
                                                  const std::vector<std::string>& overrides) {
  std::vector<TrainingOptions> stages;
  try {
    YAML::Node document = load_extended(file, {});
    const YAML::Node changes = take_stages(document);
    for (std::size_t i = 0; i < std::max<std::size_t>(1, changes.size()); ++i) {
      if (i < changes.size()) merge(document, changes[i]);
      YAML::Node stage = YAML::Clone(document);
      for (const std::string& assignment : overrides) override_value(stage, assignment);
      stages.emplace_back();
      Section(stage, "").read(stages.back());
      validate(stages.back());
    }
  } catch (const YAML::Exception& exception) {
    throw std::invalid_argument("training file '" + file.string() + "': " + exception.what());
  } catch (const std::invalid_argument& exception) {
    throw std::invalid_argument("training file '" + file.string() + "': " + exception.what());
  }
  return stages;
}

TrainingOptions load_training_options(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  std::vector<TrainingOptions> stages = load_training_stages(file, overrides);
  require(stages.size() == 1, "training file '" + file.string() + "': it has " + std::to_string(stages.size()) +
                                  " stages, where one is wanted");
  return stages.front();
}

}  // namespace rigidformer
