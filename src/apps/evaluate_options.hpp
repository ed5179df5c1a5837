// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rigidformer/evaluation/protocol.hpp"
#include "rigidformer/predictor.hpp"

namespace rigidformer {

/// What the command line of `evaluate` says.
struct EvaluateOptions {
  PredictorOptions model;  ///< model.file "none" = baselines alone
  std::vector<std::string> data;
  std::string shapes_dir;
  std::vector<std::string> baselines{"ballistic"};
  std::string points = "256";
  std::string properties = "known";
  std::string length_scale_text = "1";
  std::vector<double> horizons_s;
  std::optional<double> length_scale = 1.0;  ///< Real over trained length; none = from the objects of each set
  std::string json_file;
  std::string scene_errors_file;
  std::string report_dir;
  ProtocolOptions protocol;
};

/// Reads the command line; help and mistakes in it end the program. Throws std::invalid_argument for values that do
/// not fit together.
EvaluateOptions read_command_line(int argc, char** argv);

}  // namespace rigidformer
