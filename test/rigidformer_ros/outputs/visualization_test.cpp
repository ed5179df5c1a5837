// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/outputs/visualization.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "rigidformer_ros/forecast/forecast_messages.hpp"
#include "rigidformer_ros/test_scene.hpp"

namespace rigidformer_ros {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

SceneRollout rollout(const std::vector<std::string>& ids, int steps) {
  SceneRollout r;
  r.scene.stamp = rigidformer::stamp_at(5.0);
  r.scene.time_step_s = 0.04;
  for (int k = 0; k <= steps; ++k) {
    r.outcome.forecast.times_s.push_back(0.04 * k);
  }
  for (const std::string& id : ids) {
    ObservedObject object;
    object.state.id = id;
    object.state.points_reference = testing::blob(450);
    r.scene.objects.push_back(object);
    rigidformer::ObjectTrajectory forecast{id, rigidformer::ObjectTrajectory::Status::kOk, {}};
    for (int k = 0; k <= steps; ++k) {
      forecast.poses.push_back(testing::Flight().pose(0.04 * k));
    }
    r.outcome.forecast.objects.push_back(forecast);
  }
  return r;
}

std::map<std::pair<std::string, int>, Marker> by_key(const MarkerArray& markers) {
  std::map<std::pair<std::string, int>, Marker> map;
  for (const Marker& marker : markers.markers) {
    EXPECT_TRUE(map.emplace(std::make_pair(marker.ns, marker.id), marker).second) << marker.ns << marker.id;
  }
  return map;
}

TEST(Visualization, DrawsPathGhostsAndLabel) {
  ForecastVisualizer visualizer(DisplayParameters(), "map");
  const auto markers = by_key(visualizer.draw(rollout({"cup"}, 24)));
  ASSERT_EQ(markers.size(), 1U + 1U + 4U);
  const Marker& path = markers.at({"path/cup", 0});
  EXPECT_EQ(path.points.size(), 25U);
  EXPECT_EQ(path.header.frame_id, "map");
  EXPECT_EQ(path.header.stamp, ros::Time(5.0));
  EXPECT_EQ(markers.at({"label/cup", 0}).text, "cup");
  float alpha = 1.0F;
  for (int i = 0; i < 4; ++i) {
    const Marker& ghost = markers.at({"ghost/cup", i});
    EXPECT_LT(ghost.color.a, alpha) << "ghosts fade with time";
    EXPECT_LE(ghost.points.size(), 200U);
    EXPECT_NEAR(ghost.pose.position.z, testing::Flight().pose(0.04 * 6 * (i + 1)).translation.z(), 1e-9);
    alpha = ghost.color.a;
  }
}

TEST(Visualization, P27_updates_in_place_and_deletes_the_surplus_once) {
  ForecastVisualizer visualizer(DisplayParameters(), "map");
  const auto first = by_key(visualizer.draw(rollout({"a", "b", "c"}, 24)));
  std::set<std::pair<std::string, int>> drawn;
  for (const auto& [key, marker] : first) {
    drawn.insert(key);
  }
  const auto second = by_key(visualizer.draw(rollout({"b"}, 12)));
  EXPECT_EQ(second.size(), first.size()) << "every old marker is either updated or deleted";
  for (const auto& [key, marker] : second) {
    EXPECT_EQ(drawn.count(key), 1U);
    const bool kept = key.first == "path/b" || key.first == "label/b" || (key.first == "ghost/b" && key.second < 2);
    EXPECT_EQ(marker.action, kept ? Marker::ADD : Marker::DELETE) << key.first << key.second;
  }
  EXPECT_EQ(visualizer.draw(rollout({"b"}, 12)).markers.size(), 4U);
  for (const Marker& marker : visualizer.clear().markers) {
    EXPECT_EQ(marker.action, Marker::DELETE);
  }
  EXPECT_TRUE(visualizer.clear().markers.empty());
}

TEST(Visualization, StaticObjectsHaveNoFutureAndDoubtIsSaid) {
  ForecastVisualizer visualizer(DisplayParameters(), "map");
  SceneRollout scene = rollout({"table", "cup"}, 12);
  scene.scene.objects[0].state.mode = rigidformer::MotionMode::kStatic;
  scene.scene.objects[1].assumed_static = true;
  const auto markers = by_key(visualizer.draw(scene));
  EXPECT_EQ(markers.count({"path/table", 0}), 0U);
  EXPECT_EQ(markers.at({"label/cup", 0}).text, "cup (assumed static)");
}

// The label and the message come from one function: each status that the message knows has its words.
TEST(Visualization, EveryStatusButOkIsOnTheLabel) {
  SceneRollout scene = rollout({"ok", "unseen", "doubtful", "lost", "fast", "both", "sheet"}, 6);
  std::vector<ObservedObject>& objects = scene.scene.objects;
  objects[1].assumed_static = true;
  objects[2].low_quality = true;
  scene.outcome.forecast.objects[3].status = rigidformer::ObjectTrajectory::Status::kDiverged;
  scene.model.max_speed_mps = 1.0;
  objects[4].state.T_world_current.translation.x() = 2.0 * scene.scene.time_step_s;
  objects[5].state.T_world_current = objects[4].state.T_world_current;
  objects[5].low_quality = true;  // of two doubts the label names the same one as the message
  objects[6].state.points_reference.col(1) *= 0.01F;
  const std::map<std::string, std::pair<int, std::string>> expected = {
      {"ok", {ObjectForecast::OK, "ok"}},
      {"unseen", {ObjectForecast::ASSUMED_STATIC, "unseen (assumed static)"}},
      {"doubtful", {ObjectForecast::LOW_QUALITY, "doubtful (low quality)"}},
      {"lost", {ObjectForecast::DIVERGED, "lost (diverged)"}},
      {"fast", {ObjectForecast::OUT_OF_RANGE, "fast (out of range)"}},
      {"both", {ObjectForecast::LOW_QUALITY, "both (low quality)"}},
      {"sheet", {ObjectForecast::INCOMPLETE, "sheet (incomplete)"}}};
  const auto markers = by_key(ForecastVisualizer(DisplayParameters(), "map").draw(scene));
  scene.outcome.settled_steps.assign(objects.size(), -1);
  for (const ObjectForecast& object : to_forecast(scene, ForecastSelection(), "map").objects) {
    EXPECT_EQ(object.status, expected.at(object.id).first) << object.id;
    EXPECT_EQ(markers.at({"label/" + object.id, 0}).text, expected.at(object.id).second);
  }
}

}  // namespace
}  // namespace rigidformer_ros
