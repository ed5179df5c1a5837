// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "still_scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "rigidformer/geometry/point_rows.hpp"
#include "rigidformer/tracking/track_store.hpp"
#include "rigidformer_ros/forecast/forecast_messages.hpp"
#include "stable_labels.hpp"

namespace {

using rigidformer::Points;
using rigidformer::RigidTransform;
using rigidformer_ros::SceneRollout;

constexpr std::uint32_t kTable = 1;  // label of the table

/// Rows of the points by object.
std::map<std::uint32_t, std::vector<int>> split(const StillScene& scene) {
  std::map<std::uint32_t, std::vector<int>> objects;
  for (std::size_t i = 0; i < scene.labels.size(); ++i) {
    const auto row = static_cast<int>(i);
    if (scene.labels[i] > kTable && scene.points_camera.row(row).allFinite()) objects[scene.labels[i]].push_back(row);
  }
  return objects;
}

/// The camera, and what stands behind it up to the tracks of the node.
class StillPlay {
 public:
  StillPlay(const StillScene& scene, const StillOptions& options, const SegmentationOptions& segmentation,
            const rigidformer_ros::NodeParameters& parameters)
      : scene_(scene),
        options_(options),
        segmentation_(segmentation),
        random_(options.seed),
        labels_(/*max_distance_m=*/0.1, /*max_missed=*/5),  // the defaults of segment_cloud
        tracks_(tracking_options(parameters)) {}

  void take_cloud(int number) {
    const Points points = measure();
    for (const auto& [label, rows] : options_.use_labels ? split(scene_) : segment(points)) {
      rigidformer::ObjectObservation observation;
      observation.id = "obj_" + std::to_string(label);
      observation.stamp = rigidformer::stamp_at(1000.0 + number / options_.rate_hz);
      observation.points_world = scene_.T_world_camera.apply(rigidformer::select_rows(points, rows));
      tracks_.add(observation);
    }
  }

  const rigidformer::TrackStore& tracks() const { return tracks_; }

 private:
  /// The points with noise along their rays, which come from the origin.
  Points measure() {
    std::normal_distribution<float> noise(0.0F, static_cast<float>(options_.noise_m));
    Points points = scene_.points_camera;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      if (points.row(i).allFinite()) points.row(i) += noise(random_) * points.row(i).normalized();
    }
    return points;
  }

  std::map<std::uint32_t, std::vector<int>> segment(const Points& points) {
    const std::vector<std::vector<int>> found = find_objects(points, segmentation_);
    std::vector<Eigen::Vector3d> centroids;
    for (const std::vector<int>& rows : found) {
      centroids.push_back(rigidformer::select_rows(points, rows).cast<double>().colwise().mean().transpose());
    }
    const std::vector<std::uint32_t> labels = labels_.assign(centroids);
    std::map<std::uint32_t, std::vector<int>> objects;
    for (std::size_t i = 0; i < found.size(); ++i) objects[labels[i]] = found[i];
    return objects;
  }

  const StillScene& scene_;
  const StillOptions& options_;
  const SegmentationOptions& segmentation_;
  std::mt19937 random_;
  StableLabels labels_;
  rigidformer::TrackStore tracks_;
};

SceneRollout forecast(const rigidformer::TrackStore& tracks, const StillOptions& options,
                      const rigidformer_ros::NodeParameters& parameters, rigidformer_ros::SceneForecaster& forecaster) {
  const double wished_s = parameters.predict.time_step;
  const double time_step_s = forecaster.nearest_time_step(tracks.snapshot(wished_s), wished_s);
  rigidformer_ros::RolloutSettings settings = forecaster.default_settings();
  settings.options.time_step_s = time_step_s;
  settings.options.num_steps = static_cast<int>(std::ceil(options.horizon_s / time_step_s - 1e-6));
  return forecaster.roll_out(tracks.snapshot(time_step_s), settings);
}

void count(const SceneRollout& rollout, const StillOptions& options, StillReport& report) {
  bool all_still = true, ok_still = true;
  for (std::size_t i = 0; i < rollout.scene.objects.size(); ++i) {
    const rigidformer::ObjectTrajectory& forecast = rollout.outcome.forecast.objects[i];
    double moved_m = 0.0, turned_rad = 0.0;
    for (const RigidTransform& pose : forecast.poses) {
      const RigidTransform& first = forecast.poses.front();
      moved_m = std::max(moved_m, (pose.translation - first.translation).norm());
      turned_rad = std::max(turned_rad, rigidformer::rotation_angle(pose.rotation, first.rotation));
    }
    const std::uint8_t status = rigidformer_ros::status_of(rollout, i);
    const bool moved = moved_m >= options.still_m || turned_rad >= options.still_rad;
    StillObject& object = report.objects[forecast.id];
    ++object.num_forecasts;
    ++object.num_of_status[status];
    object.num_moved += moved;
    object.moved_m.push_back(moved_m);
    object.turned_rad.push_back(turned_rad);
    all_still = all_still && !moved;
    ok_still = ok_still && !(moved && status == rigidformer_ros::ObjectForecast::OK);
  }
  ++report.num_forecasts;
  report.num_still += all_still;
  report.num_ok_still += ok_still;
}

}  // namespace

StillReport play_still_scene(const StillScene& scene, const StillOptions& options,
                             const SegmentationOptions& segmentation, const rigidformer_ros::NodeParameters& parameters,
                             rigidformer_ros::SceneForecaster& forecaster) {
  StillPlay play(scene, options, segmentation, parameters);
  StillReport report;
  for (int number = 0; number < options.num_clouds; ++number) {
    play.take_cloud(number);
    count(forecast(play.tracks(), options, parameters, forecaster), options, report);
  }
  return report;
}
