// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/checkpoint.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <type_traits>

#include "rigidformer/model/tensor_conversion.hpp"

namespace rigidformer {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kFormat[] = "rigidformer-checkpoint";
constexpr char kVersion[] = "1";  // version of the layout; readers refuse others

template <typename Facts, typename Visitor>
void visit_facts(Facts& f, Visitor&& visit) {
  visit("data", f.data);
  visit("iterations", f.iterations);
  visit("windows", f.windows);
  visit("seed", f.seed);
  visit("source_revision", f.source_revision);
  visit("min_step_frames", f.min_step_frames);
  visit("max_step_frames", f.max_step_frames);
  visit("min_diameter_m", f.min_diameter_m);
  visit("max_diameter_m", f.max_diameter_m);
  visit("max_speed_mps", f.max_speed_mps);
  visit("min_points", f.min_points);
  visit("max_points", f.max_points);
}

using Metadata = std::map<std::string, std::string>;

const std::string& value_of(const Metadata& metadata, const std::string& key) {
  const auto entry = metadata.find(key);
  if (entry == metadata.end()) throw std::runtime_error("no '" + key + "' in the header: not a RigidFormer model");
  return entry->second;
}

/// Reads a number strictly: what get() would cut to size (1.5, or 2^40 points) is refused.
template <typename T>
void read_fact(const Json& facts, const char* name, T& field) {
  const Json& value = facts.at(name);
  const bool not_integer = std::is_integral_v<T> && !value.is_number_integer();
  if (!not_integer) field = value.get<T>();
  if (not_integer || (std::is_integral_v<T> && Json(field).dump() != value.dump())) {
    throw std::runtime_error(std::string("training fact '") + name + "' is " + value.dump() +
                             ", must be an integer of its range");
  }
}

/// Makes a model of the stored options, still without its weights.
Checkpoint parse_metadata(const Metadata& metadata) {
  if (value_of(metadata, "format") != kFormat) throw std::runtime_error("not a RigidFormer model");
  const std::string& version = value_of(metadata, "format_version");
  if (version != kVersion) {
    throw std::runtime_error("format version " + version + ", this program reads version " + kVersion);
  }
  Checkpoint checkpoint;
  const Json facts = Json::parse(value_of(metadata, "training"));
  visit_facts(checkpoint.facts, [&](const char* name, auto& field) { read_fact(facts, name, field); });
  if (metadata.count("doubt") > 0) checkpoint.facts.doubt = doubt_table_from_json(metadata.at("doubt"));
  checkpoint.model = RigidFormer(model_options_from_json(value_of(metadata, "model")));
  checkpoint.sha256 = value_of(metadata, "sha256");
  return checkpoint;
}

void load_parameter(const NamedTensor& entry, Tensor& parameter) {
  if (entry.tensor.shape != parameter.sizes().vec()) {
    std::ostringstream message;
    message << "tensor '" << entry.name << "' has shape " << at::IntArrayRef(entry.tensor.shape)
            << ", the options ask for " << parameter.sizes();
    throw std::runtime_error(message.str());
  }
  const Tensor value = from_raw(entry.tensor).to(torch::kFloat32);
  if (!torch::isfinite(value).all().item<bool>()) {
    throw std::runtime_error("tensor '" + entry.name + "' holds values that are not finite");
  }
  parameter.copy_(value);
}

void load_parameters(TensorFileReader& reader, RigidFormer& model) {
  torch::NoGradGuard no_grad;
  std::map<std::string, Tensor> missing;
  for (const auto& parameter : model->named_parameters()) missing.emplace(parameter.key(), parameter.value());
  while (const auto entry = reader.next()) {
    auto parameter = missing.extract(entry->name);
    if (parameter.empty()) throw std::runtime_error("surplus tensor '" + entry->name + "'");
    load_parameter(*entry, parameter.mapped());
  }
  if (!missing.empty()) throw std::runtime_error("tensor '" + missing.begin()->first + "' is missing");
}

}  // namespace

void save_checkpoint(const std::filesystem::path& path, const RigidFormer& model, const TrainingFacts& facts,
                     TensorType storage) {
  Json training;
  visit_facts(facts, [&](const char* name, const auto& field) { training[name] = field; });
  TensorFile file;
  file.metadata = {{"format", kFormat},
                   {"format_version", kVersion},
                   {"model", to_json(model->options)},
                   {"training", training.dump()}};
  if (facts.doubt) file.metadata["doubt"] = to_json(*facts.doubt);
  for (const auto& parameter : model->named_parameters()) {
    file.tensors.emplace(parameter.key(), to_raw(parameter.value(), storage));
  }
  write_tensor_file(path, file);
}

void store_doubt(const std::filesystem::path& model, const DoubtTable& table, const std::filesystem::path& output) {
  Checkpoint checkpoint = load_checkpoint(model);
  checkpoint.facts.doubt = table;
  save_checkpoint(output, checkpoint.model, checkpoint.facts, TensorType::kBFloat16);
}

Checkpoint load_checkpoint(const std::filesystem::path& path) {
  try {
    TensorFileReader reader(path);
    Checkpoint checkpoint = parse_metadata(reader.metadata());
    load_parameters(reader, checkpoint.model);
    return checkpoint;
  } catch (const std::exception& exception) {
    throw std::runtime_error("model '" + path.string() + "': " + exception.what());
  }
}

}  // namespace rigidformer
