// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/plots.hpp"

#include <sstream>

#include "report_tables.hpp"
#include "rigidformer/io/gnuplot.hpp"

namespace rigidformer {
namespace {

/// Draws two panels side by side into one file.
std::string two_panels(const std::filesystem::path& svg, const std::string& title) {
  return "set terminal svg size 1000,460 background 'white'\nset output " + gnuplot_string(svg) +
         "\nset multiplot layout 1,2 title " + gnuplot_string(title) + " noenhanced\nset grid\nset key noenhanced\n";
}

std::string data_block(const std::string& name, const std::vector<Eigen::Vector3d>& rows) {
  std::ostringstream text;
  text << '$' << name << " << EOD\n";
  for (const Eigen::Vector3d& row : rows) {
    text << row.x() << ' ' << row.y() << ' ' << row.z() << '\n';
  }
  text << "EOD\n";
  return text.str();
}

/// Writes "plot a, b, c" with one part per index.
template <typename Part>
std::string plot_command(std::size_t count, Part part) {
  std::string command = "plot ";
  for (std::size_t i = 0; i < count; ++i) {
    command += (i == 0 ? "" : ", ") + part(i);
  }
  return command + '\n';
}

}  // namespace

bool plot_error_curves(const std::filesystem::path& svg, const std::string& title, const ErrorCurves& curves, int end,
                       HorizonUnit unit) {
  std::string script = two_panels(svg, title);
  std::vector<std::string> models;
  for (const auto& [model, frames] : curves) {
    std::vector<Eigen::Vector3d> rows;
    for (const auto& [frame, score] : frames) {
      rows.emplace_back(frame, score.error.position_rmse_m, score.error.orientation_rmse_deg);
    }
    script += data_block("model" + std::to_string(models.size()), rows);
    models.push_back(model);
  }
  script += "set key top left\nset xlabel '" + unit_name(unit) +
            " after the start'\nset xrange [0:" + std::to_string(end) + "]\n";
  for (const auto& [column, label] : {std::pair("2", "position RMSE [m]"), std::pair("3", "orientation RMSE [deg]")}) {
    script += "set ylabel '" + std::string(label) + "'\n" + plot_command(models.size(), [&](std::size_t i) {
                return "$model" + std::to_string(i) + " using 1:" + column + " with lines lw 2 title " +
                       gnuplot_string(models[i]);
              });
  }
  return run_gnuplot(script);
}

bool plot_paths(const std::filesystem::path& svg, const ScenePaths& scene) {
  std::string script = two_panels(svg, scene.set + ", scene " + scene.scene + ": recorded solid, predicted dashed");
  for (std::size_t i = 0; i < scene.recorded.size(); ++i) {
    script += data_block("recorded" + std::to_string(i), scene.recorded[i]);
    script += data_block("predicted" + std::to_string(i), scene.predicted[i]);
  }
  script += "set xlabel 'x [m]'\nset key outside bottom\n";
  for (const auto& [column, label] : {std::pair("2", "y [m], from above"), std::pair("3", "z [m], from the side")}) {
    script += "set ylabel '" + std::string(label) + "'\n" + plot_command(scene.recorded.size(), [&](std::size_t i) {
                const std::string index = std::to_string(i);
                const std::string style =
                    " using 1:" + std::string(column) + " with lines lw 2 lc " + std::to_string(i + 1);
                return "$recorded" + index + style + " title " + gnuplot_string(scene.shapes[i]) + ", $predicted" +
                       index + style + " dt 2 notitle";
              });
  }
  return run_gnuplot(script);
}

}  // namespace rigidformer
