// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/checkpoint.hpp"

#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "rigidformer/model/tensor_conversion.hpp"

namespace rigidformer {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kFormat[] = "rigidformer-checkpoint";
constexpr char kVersion[] = "1";

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

const std::string& metadata(const TensorFile& file, const std::string& key) {
  const auto entry = file.metadata.find(key);
  if (entry == file.metadata.end()) throw std::runtime_error("no '" + key + "' in the header: not a RigidFormer model");
  return entry->second;
}

void load_parameter(const TensorFile& file, const std::string& name, Tensor& parameter) {
  const auto entry = file.tensors.find(name);
  if (entry == file.tensors.end()) throw std::runtime_error("tensor '" + name + "' is missing");
  if (entry->second.shape != parameter.sizes().vec()) {
    std::ostringstream message;
    message << "tensor '" << name << "' has shape " << at::IntArrayRef(entry->second.shape) << ", the options ask for "
            << parameter.sizes();
    throw std::runtime_error(message.str());
  }
  const Tensor value = from_raw(entry->second).to(torch::kFloat32);
  if (!torch::isfinite(value).all().item<bool>()) {
    throw std::runtime_error("tensor '" + name + "' holds values that are not finite");
  }
  parameter.copy_(value);
}

Checkpoint parse(const TensorFile& file) {
  if (metadata(file, "format") != kFormat) throw std::runtime_error("not a RigidFormer model");
  if (metadata(file, "format_version") != kVersion) {
    throw std::runtime_error("format version " + metadata(file, "format_version") + ", this program reads version " +
                             kVersion);
  }
  Checkpoint checkpoint;
  const Json facts = Json::parse(metadata(file, "training"));
  visit_facts(checkpoint.facts,
              [&](const char* name, auto& field) { field = facts.at(name).get<std::decay_t<decltype(field)>>(); });
  checkpoint.model = RigidFormer(model_options_from_json(metadata(file, "model")));
  torch::NoGradGuard no_grad;
  std::set<std::string> known;
  for (auto& parameter : checkpoint.model->named_parameters()) {
    load_parameter(file, parameter.key(), parameter.value());
    known.insert(parameter.key());
  }
  for (const auto& [name, tensor] : file.tensors) {
    if (known.count(name) == 0) throw std::runtime_error("surplus tensor '" + name + "'");
  }
  checkpoint.sha256 = stored_sha256(file);
  return checkpoint;
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
  for (const auto& parameter : model->named_parameters()) {
    file.tensors.emplace(parameter.key(), to_raw(parameter.value(), storage));
  }
  write_tensor_file(path, file);
}

Checkpoint load_checkpoint(const std::filesystem::path& path) {
  const TensorFile file = read_tensor_file(path);  // its errors name the path
  try {
    return parse(file);
  } catch (const std::exception& exception) {
    throw std::runtime_error("model '" + path.string() + "': " + exception.what());
  }
}

}  // namespace rigidformer
