// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <set>
#include <string>
#include <utility>

#include "rigidformer_ros/forecast/scene_forecaster.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

/// Draws forecasts for rviz: per object a path, ghosts that fade with time, the doubt of
/// each of them where it is known, and a label. Markers keep their namespace
/// and number from one forecast to the next, so they are updated in place; those no longer needed are deleted.
class ForecastVisualizer {
 public:
  ForecastVisualizer(const DisplayParameters& display, std::string fixed_frame);

  void set_display(const DisplayParameters& display) { display_ = display; }

  visualization_msgs::MarkerArray draw(const SceneRollout& rollout);

  /// Deletes everything drawn so far; empty when nothing is.
  visualization_msgs::MarkerArray clear();

 private:
  using MarkerKey = std::pair<std::string, int>;  ///< Namespace, id

  void draw_object(const SceneRollout& rollout, std::size_t object, visualization_msgs::MarkerArray& markers) const;
  visualization_msgs::Marker make_label(const SceneRollout& rollout, std::size_t object) const;
  visualization_msgs::Marker make_path(const SceneRollout& rollout, std::size_t object) const;
  visualization_msgs::Marker make_ghost(const SceneRollout& rollout, std::size_t object, std::size_t step) const;
  visualization_msgs::Marker make_doubt(const SceneRollout& rollout, std::size_t object, std::size_t step) const;
  visualization_msgs::Marker make_marker(rigidformer::Stamp stamp, const std::string& ns, int id, int type) const;
  visualization_msgs::MarkerArray replace(visualization_msgs::MarkerArray markers);

  DisplayParameters display_;
  std::string fixed_frame_;
  std::set<MarkerKey> drawn_;
};

}  // namespace rigidformer_ros
