// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/summary.hpp"

#include <iomanip>
#include <sstream>

#include "rigidformer/model/checkpoint.hpp"

namespace rigidformer {
namespace {

void write_parameters(std::ostream& out, const RigidFormer& model) {
  out << "parameters: " << count_parameters(*model) << '\n';
  for (const auto& part : model->named_children()) {
    out << "  " << std::left << std::setw(24) << part.key() << std::right << std::setw(12)
        << count_parameters(*part.value()) << '\n';
  }
}

}  // namespace

std::string summarize_checkpoint(const std::filesystem::path& file) {
  const Checkpoint checkpoint = load_checkpoint(file);
  const TrainingFacts& facts = checkpoint.facts;
  std::ostringstream out;
  out << "model: " << file.string() << "\nsha256: " << checkpoint.sha256 << '\n';
  write_parameters(out, checkpoint.model);
  out << "trained on: " << facts.data << " scenes, " << facts.iterations << " iterations, " << facts.windows
      << " windows, seed " << facts.seed << ", source " << (facts.source_revision.empty() ? "?" : facts.source_revision)
      << "\nstep size: " << facts.min_step_frames << " to " << facts.max_step_frames << " frames of 1/240 s ("
      << facts.min_step_frames / kFrameRateHz << " to " << facts.max_step_frames / kFrameRateHz << " s)"
      << "\nobject diameter: " << facts.min_diameter_m << " to " << facts.max_diameter_m << " m"
      << "\nspeed: up to " << facts.max_speed_mps << " m/s"
      << "\npoints per object: " << facts.min_points << " to " << facts.max_points
      << "\noptions: " << to_json(checkpoint.model->options) << '\n';
  return out.str();
}

std::string summarize_preset(const std::string& preset) {
  std::ostringstream out;
  out << "preset: " << preset << '\n';
  write_parameters(out, RigidFormer(model_preset(preset)));
  return out.str();
}

}  // namespace rigidformer
