// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/movie.hpp"

#include <Eigen/Geometry>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "rigidformer/io/gnuplot.hpp"
#include "rollout_round.hpp"

namespace rigidformer {
namespace {

using Poses = std::vector<RigidTransform>;

constexpr double kMargin_m = 0.8;  // [m] shown around the origins of the outermost objects; chosen by eye

/// Writes one line per point: its position and the number of the object.
void write_block(std::ostream& script, const std::string& name, const std::vector<ObjectState>& objects,
                 const Poses& T_world_object) {
  script << '$' << name << " << EOD\n";
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Points points = T_world_object[i].apply(objects[i].points_reference);
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
      script << points(row, 0) << ' ' << points(row, 1) << ' ' << points(row, 2) << ' ' << i + 1 << '\n';
    }
  }
  script << "EOD\n";
}

void write_picture(std::ostream& script, const std::string& title, const std::vector<ObjectState>& objects,
                   const Poses& recorded, const Poses& predicted) {
  write_block(script, "recorded", objects, recorded);
  write_block(script, "predicted", objects, predicted);
  script << "set multiplot layout 1,2 title '" << title << "'\n";
  for (const char* side : {"recorded", "predicted"}) {
    script << "set title '" << side << "' offset 0,-1\nsplot $" << side
           << " using 1:2:3:4 with points pt 7 ps 0.45 lc variable notitle\n";
  }
  script << "unset multiplot\n";
}

/// The square on the ground over which the recorded objects move: its middle and half its side.
std::pair<Eigen::Vector2d, double> shown_square(const SceneRecording& scene, int first_frame, int last_frame) {
  Eigen::AlignedBox2d box;
  for (const RecordedObject& object : scene.objects) {
    for (int frame = first_frame; frame <= last_frame; ++frame) {
      box.extend(object.T_world_object.at(static_cast<std::size_t>(frame)).translation.head<2>());
    }
  }
  return {box.center(), 0.5 * box.sizes().maxCoeff() + kMargin_m};
}

std::string header(const std::filesystem::path& gif, const MovieOptions& options, const Eigen::Vector2d& middle,
                   double e) {
  std::ostringstream script;
  script << "set terminal gif animate delay " << options.picture_time << " loop 0 size 900,420 background '#ffffff'\n"
         << "set output " << gnuplot_string(gif) << "\nset view 65,30,1.65,1\nset view equal xyz\nset xyplane at 0\n"
         << "set xrange [" << middle.x() - e << ':' << middle.x() + e << "]\nset yrange [" << middle.y() - e << ':'
         << middle.y() + e << "]\nset zrange [0:" << e
         << "]\nset format ''\nset grid\nset border 31 lc '#bbbbbb'\nunset key\n";
  return script.str();
}

}  // namespace

bool draw_movie(const std::filesystem::path& gif, const SceneRecording& scene, const Observer& observer,
                Forecaster& forecaster, const MovieOptions& options) {
  const int last_frame = options.start + options.step * (options.num_steps + 1);
  if (last_frame >= scene.num_frames) {
    throw std::invalid_argument("movie: needs frame " + std::to_string(last_frame) + ", scene " + scene.name + " has " +
                                std::to_string(scene.num_frames) + " frames");
  }
  RolloutOptions rollout;
  rollout.num_steps = options.num_steps;
  rollout.time_step_s = options.step / scene.frame_rate_hz;
  rollout.gravity = scene.gravity.z();
  rollout.ground = observed_ground(scene, observer.options());
  rollout.control = commands_of_steps(scene, options.start + options.step, options.step, options.num_steps);
  const auto objects = observer.observe(scene, options.start + options.step, options.step);
  const auto forecast =
      forecaster.forecast(objects, rollout, recorded_tracks(scene, objects, options.start + options.step));
  std::ostringstream script;
  const auto [middle, half_side_m] = shown_square(scene, options.start, last_frame);
  script << header(gif, options, middle, half_side_m);
  for (int k = 0; k <= options.num_steps; ++k) {
    Poses recorded, predicted;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      recorded.push_back(scene.objects[i].T_world_object.at(options.start + options.step * (k + 1)));
      predicted.push_back(forecast[i][static_cast<std::size_t>(k)]);
    }
    char title[32];
    std::snprintf(title, sizeof(title), "after %.2f s", k * rollout.time_step_s);
    write_picture(script, title, objects, recorded, predicted);
  }
  return run_gnuplot(script.str());
}

}  // namespace rigidformer
