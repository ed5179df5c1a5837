// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/import_poses.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

/// Splits "ID=VALUE" at the first equals sign.
std::pair<std::string, std::string> split(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw std::invalid_argument("'" + text + "' must look like ID=VALUE");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

std::map<std::string, double> numbers(const std::vector<std::string>& list) {
  std::map<std::string, double> values;
  for (const std::string& text : list) {
    const auto [id, number] = split(text);
    const char* const end = number.data() + number.size();
    const auto [rest, error] = std::from_chars(number.data(), end, values[id]);
    if (error != std::errc() || rest != end) throw std::invalid_argument("'" + text + "' must look like ID=NUMBER");
  }
  return values;
}

struct CommandLine {
  rigidformer::ImportOptions import;
  std::vector<std::string> shapes, masses, frictions, restitutions, static_ids;
  std::string output, validation_output;
};

void add_options(CLI::App& app, CommandLine& c) {
  app.add_option("--poses", c.import.poses, "Tables of poses (CSV): t or time, x, y, z, qx, qy, qz, qw, perhaps id")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--recording-column", c.import.recording_column,
                 "Column that tells recordings apart; a file without it is one recording")
      ->capture_default_str();
  app.add_option("--recordings", c.import.recordings, "Those taken: names, or ranges of numbers like 0-63 [all]")
      ->delimiter(',');
  app.add_option("--shape", c.shapes,
                 "ID=SHAPE: box:LxWxH, sphere:D, cylinder:DxH (about the origin of the poses) or an OBJ file, in "
                 "metres; the id is 'object' where the table has no column id")
      ->required();
  app.add_option("--mass", c.masses, "ID=VALUE [kg]; not known where not given");
  app.add_option("--friction", c.frictions, "ID=VALUE, likewise");
  app.add_option("--restitution", c.restitutions, "ID=VALUE, likewise");
  app.add_option("--static", c.static_ids, "Ids of objects that never move");
  app.add_option("--rate", c.import.frames.frame_rate_hz, "Frames per second [as measured]; never more than measured");
  app.add_option("--max-gap", c.import.frames.max_gap_frames, "Frames without a pose that part a recording in two")
      ->capture_default_str();
  app.add_option("--gravity", c.import.gravity, "[m/s^2] along z")->capture_default_str();
  app.add_option("--length-factor", c.import.length_factor, "Corrects measured positions, which are multiplied by it")
      ->capture_default_str();
  app.add_option("--ground", c.import.ground_height_m, "Height of the floor in the corrected positions [m]")
      ->capture_default_str();
  app.add_option("--set", c.import.set, "Name of the set")->capture_default_str();
  app.add_option("--out", c.output, "Archive to write (*.safetensors)")->required();
  auto* share = app.add_option("--validation-share", c.import.validation_share,
                               "Share of the recordings, the last ones, that goes to --validation-out");
  app.add_option("--validation-out", c.validation_output, "Archive of the recordings that are kept apart")
      ->needs(share);
  share->needs("--validation-out");
}

void run(CommandLine& c) {
  for (const std::string& text : c.shapes) c.import.shapes.insert(split(text));
  c.import.masses_kg = numbers(c.masses);
  c.import.frictions = numbers(c.frictions);
  c.import.restitutions = numbers(c.restitutions);
  c.import.static_ids = {c.static_ids.begin(), c.static_ids.end()};
  const rigidformer::ImportedScenes imported = rigidformer::import_poses(c.import);
  rigidformer::write_scene_archive(c.output, imported.training);
  if (!c.validation_output.empty()) rigidformer::write_scene_archive(c.validation_output, imported.validation);
  std::cerr << imported.summary;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Makes scenes to learn from and to score on of measured poses."};
  CommandLine command_line;
  add_options(app, command_line);
  CLI11_PARSE(app, argc, argv);
  try {
    run(command_line);
  } catch (const std::exception& exception) {
    std::cerr << "import_poses: " << exception.what() << '\n';
    return 1;
  }
  return 0;
}
