// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene_error_table.hpp"

#include <cstdio>

#include "report_tables.hpp"
#include "rigidformer/io/text_file.hpp"

namespace rigidformer {

SceneErrorTable::SceneErrorTable(const ProtocolOptions& options)
    : options_(options),
      text_("set,scene,start,step,model,horizon_" + unit_name(options.horizon_unit) +
            ",position_rmse_m,orientation_rmse_deg,position_rmse_sizes\n") {}

void SceneErrorTable::add(const SceneResult& result) {
  for (std::size_t h = 0; h < result.at_horizon.size(); ++h) {
    const PoseError& error = result.at_horizon[h];
    char numbers[96];
    std::snprintf(numbers, sizeof numbers, "%d,%.6g,%.6g,%.6g\n", options_.horizons[h], error.position_rmse_m,
                  error.orientation_rmse_deg, error.position_rmse_sizes);
    text_ += result.set + ',' + result.scene->name + ',' + std::to_string(result.start) + ',' +
             std::to_string(result.step) + ',' + result.model + ',' + numbers;
  }
}

void SceneErrorTable::write(const std::filesystem::path& path) const { save_text_file(path, text_); }

}  // namespace rigidformer
