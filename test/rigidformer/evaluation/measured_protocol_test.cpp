// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/evaluation/ballistic.hpp"
#include "rigidformer/evaluation/flying_cubes.hpp"
#include "rigidformer/evaluation/protocol.hpp"
#include "rigidformer/evaluation/report.hpp"
#include "rigidformer/evaluation/scene_error_table.hpp"

namespace rigidformer {
namespace {

/// Holds everything where it was seen, turned by `turn`.
class Holding : public Forecaster {
 public:
  explicit Holding(const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity()) : turn_(turn) {}
  std::string name() const override { return "holding"; }
  std::vector<std::vector<RigidTransform>> forecast(const std::vector<ObjectState>& objects,
                                                    const RolloutOptions& rollout,
                                                    const std::vector<GivenTrack>&) override {
    std::vector<std::vector<RigidTransform>> poses;
    for (const ObjectState& object : objects) {
      const RigidTransform turned{turn_ * object.T_world_current.rotation, object.T_world_current.translation};
      poses.emplace_back(static_cast<std::size_t>(rollout.num_steps) + 1, turned);
    }
    return poses;
  }

 private:
  Eigen::Quaterniond turn_;
};

/// One cube of size 2 that moves at 1 m/s along x, at that rate.
SceneRecording sliding(double rate_hz, int num_frames) {
  SceneRecording scene = flying_cubes(1, num_frames);
  scene.frame_rate_hz = rate_hz;
  scene.objects[0].size = 2.0;
  for (int frame = 0; frame < num_frames; ++frame) {
    scene.objects[0].T_world_object[static_cast<std::size_t>(frame)] = {Eigen::Quaterniond::Identity(),
                                                                        {frame / rate_hz, 0.0, 1.0}};
  }
  return scene;
}

SceneArchive archive_of(const std::vector<SceneRecording>& scenes) {
  SceneArchive archive;
  archive.set = "toys";
  archive.shapes = {unit_cube()};
  archive.scenes = scenes;
  return archive;
}

ProtocolOptions in_milliseconds(const std::vector<int>& horizons) {
  ProtocolOptions options;
  options.starts = {0};
  options.steps = {2};
  options.horizons = horizons;
  options.horizon_unit = HorizonUnit::kMilliseconds;
  return options;
}

TEST(MeasuredProtocol, TimesCountAlikeAtEveryRate) {
  Holding holding;
  ProtocolOptions options = in_milliseconds({200, 505});
  options.curve_end = 300;
  std::vector<SceneResult> results;
  const SceneArchive archive = archive_of({sliding(100.0, 60), sliding(148.0, 90)});
  const auto scores = evaluate(archive, {&holding}, options, {}, [&](const auto& r) { results.push_back(r); });
  ASSERT_EQ(scores.size(), 2U);
  EXPECT_EQ(scores[1].horizon, 505);
  // Each is held at its second given frame, 0.02 s and 2 / 148 s after the start.
  const double mean_given_s = 0.5 * (2.0 / 100.0 + 2.0 / 148.0);
  EXPECT_NEAR(scores[0].error.position_rmse_m, 0.2 - mean_given_s, 1e-9);
  EXPECT_NEAR(scores[1].error.position_rmse_m, 0.505 - mean_given_s, 1e-9);
  EXPECT_NEAR(scores[1].error.position_rmse_sizes, (0.505 - mean_given_s) / 2.0, 1e-9);  // the edge is 2 m
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[1].curve.size(), 15U);  // every 20 ms
  EXPECT_NEAR(results[1].curve.at(300).position_rmse_m, 0.3 - 2.0 / 148.0, 1e-9);
  EXPECT_EQ(scenes_left_out(archive, in_milliseconds({595})).size(), 1U);  // the first ends after 0.59 s
  EXPECT_THROW(evaluate(archive, {&holding}, in_milliseconds({15})), std::invalid_argument);  // shorter than a step
}

TEST(MeasuredProtocol, WhatRestsAtTheEndLiesOnTheRightFaceOrNot) {
  SceneRecording settled = flying_cubes(1, 80), flying = flying_cubes(1, 80);
  for (std::size_t frame = 20; frame < 80; ++frame) {
    settled.objects[0].T_world_object[frame] = {Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.5}};
  }
  ProtocolOptions options = in_milliseconds({100});
  options.starts = {30};
  options.to_the_end = true;
  const auto about = [](const Eigen::Vector3d& axis, double degrees) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * M_PI / 180.0, axis));
  };
  Holding same, yawed(about(Eigen::Vector3d::UnitZ(), 70.0)), tilted(about(Eigen::Vector3d::UnitX(), 15.0)),
      fallen(about(Eigen::Vector3d::UnitX(), 90.0));
  const auto scores = evaluate(archive_of({settled, flying}), {&same, &yawed, &tilted, &fallen}, options);
  ASSERT_EQ(scores.size(), 4U);
  const int expected[] = {1, 1, 1, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(scores[i].settled.num_settled, 1) << i;  // the other one flies to the end
    EXPECT_EQ(scores[i].settled.num_right_face, expected[i]) << i;
  }
  std::ostringstream text;
  print_scores(text, scores, HorizonUnit::kMilliseconds);
  EXPECT_NE(text.str().find("ends on the right face: 1 of 1"), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("h = 0.1 s"), std::string::npos) << text.str();
}

TEST(MeasuredProtocol, MaterialMayBeToldInstead) {
  const SceneArchive archive = archive_of({flying_cubes(1, 30)});
  ObservationOptions options;
  options.known_properties = false;
  options.friction = 0.18;
  const BodyProperties told = Observer(archive.shapes, options).observe(archive.scenes[0], 10, 5).at(0).properties;
  EXPECT_EQ(told.friction, 0.18);
  EXPECT_FALSE(told.restitution);
  EXPECT_FALSE(told.mass_kg);
}

TEST(SceneErrorTable, HasALinePerSceneModelAndHorizon) {
  Holding holding;
  const ProtocolOptions options = in_milliseconds({200, 300});
  SceneErrorTable table(options);
  evaluate(archive_of({sliding(100.0, 60)}), {&holding}, options, {}, [&](const auto& r) { table.add(r); });
  const TemporaryFolder folder;
  table.write(folder.path() / "errors.csv");
  std::ifstream file(folder.path() / "errors.csv");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(text,
            "set,scene,start,step,model,horizon_ms,position_rmse_m,orientation_rmse_deg,position_rmse_sizes\n"
            "toys,flying_cubes,0,2,holding,200,0.18,0,0.09\n"
            "toys,flying_cubes,0,2,holding,300,0.28,0,0.14\n");
  EXPECT_THROW(table.write("/nonexistent/errors.csv"), std::runtime_error);
}

}  // namespace
}  // namespace rigidformer
