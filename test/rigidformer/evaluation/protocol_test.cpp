// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/protocol.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "rigidformer/evaluation/ballistic.hpp"
#include "rigidformer/evaluation/flying_cubes.hpp"

namespace rigidformer {
namespace {

SceneArchive flying_set(int num_scenes, int num_frames) {
  SceneArchive archive;
  archive.set = "flying";
  archive.shapes = {unit_cube()};
  archive.scenes.assign(num_scenes, flying_cubes(2, num_frames));
  return archive;
}

/// A forecaster that is right at k = 0 and drifts along y by one metre per step.
class DriftingForecaster : public Forecaster {
 public:
  std::string name() const override { return "drifting"; }

  std::vector<std::vector<RigidTransform>> forecast(const std::vector<ObjectState>& objects,
                                                    const RolloutOptions& rollout,
                                                    const std::vector<GivenTrack>& tracks) override {
    auto poses = BallisticForecaster().forecast(objects, rollout, tracks);
    for (auto& object : poses) {
      for (std::size_t k = 0; k < object.size(); ++k) {
        object[k].translation.y() += static_cast<double>(k);
      }
    }
    return poses;
  }
};

TEST(Protocol, BallisticIsRightInFreeFlightFromEveryStart) {
  BallisticForecaster ballistic;
  ProtocolOptions options;
  options.starts = {0, 30};
  const auto scores = evaluate(flying_set(2, 140), {&ballistic}, options);
  ASSERT_EQ(scores.size(), 2U * 3U * 3U);
  for (const Score& score : scores) {
    EXPECT_EQ(score.num_scenes, 2);
    // The guess is exact on steps. Between two steps, 10 / 240 s apart, the chord of the parabola
    // is off by g dt^2 / 8 = 2.2 mm.
    const bool between_steps = score.horizon % score.step != 0;
    EXPECT_NEAR(score.error.position_rmse_m, between_steps ? 10.0 / 8.0 * std::pow(10.0 / 240.0, 2) : 0.0, 1e-6);
    EXPECT_LT(score.error.orientation_rmse_deg, 1e-4);
  }
}

TEST(Protocol, CountsHorizonsFromTheFirstGivenFrame) {
  DriftingForecaster drifting;
  ProtocolOptions options;
  options.starts = {20};
  options.steps = {5, 10};
  options.horizons = {50, 75};
  const auto scores = evaluate(flying_set(1, 100), {&drifting}, options);
  ASSERT_EQ(scores.size(), 4U);
  // Frames S and S + s are given, so that frame S + h lies (h - s) / s steps after the second one.
  EXPECT_NEAR(scores[0].error.position_rmse_m, 9.0, 1e-9);
  EXPECT_NEAR(scores[1].error.position_rmse_m, 14.0, 1e-9);
  EXPECT_NEAR(scores[2].error.position_rmse_m, 4.0, 1e-9);
  EXPECT_NEAR(scores[3].error.position_rmse_m, 6.5, 1e-5);
}

TEST(Protocol, KeepsForecastersApartAndReportsProgress) {
  BallisticForecaster ballistic;
  DriftingForecaster drifting;
  ProtocolOptions options;
  options.starts = {0};
  options.steps = {10};
  options.horizons = {50};
  options.max_scenes = 3;
  long last_done = 0;
  long last_total = 0;
  const auto scores = evaluate(flying_set(5, 60), {&ballistic, &drifting}, options, [&](long done, long total) {
    EXPECT_GT(done, last_done);
    last_done = done;
    last_total = total;
  });
  EXPECT_EQ(last_total, 3 * 2 * 4);
  EXPECT_EQ(last_done, last_total);
  ASSERT_EQ(scores.size(), 2U);
  EXPECT_EQ(scores[0].model, "ballistic");
  EXPECT_EQ(scores[1].model, "drifting");
  EXPECT_EQ(scores[1].set, "flying");
  EXPECT_EQ(scores[1].num_scenes, 3);
  EXPECT_LT(scores[0].error.position_rmse_m, 1e-9);
  EXPECT_NEAR(scores[1].error.position_rmse_m, 4.0, 1e-9);
}

TEST(Protocol, HandsOutEveryRolloutWithItsErrors) {
  BallisticForecaster ballistic;
  DriftingForecaster drifting;
  ProtocolOptions options;
  options.starts = {20};
  options.steps = {10};
  options.horizons = {50, 75};
  options.curve_end = 240;
  const SceneArchive archive = flying_set(2, 130);
  std::vector<SceneResult> results;
  const auto scores = evaluate(archive, {&ballistic, &drifting}, options, {},
                               [&](const SceneResult& result) { results.push_back(result); });
  ASSERT_EQ(results.size(), 4U);
  const SceneResult& result = results[3];
  EXPECT_EQ(result.model, "drifting");
  EXPECT_EQ(result.set, "flying");
  EXPECT_EQ(result.start, 20);
  EXPECT_EQ(result.step, 10);
  EXPECT_EQ(result.scene, &archive.scenes[1]);
  ASSERT_EQ(result.at_horizon.size(), 2U);
  EXPECT_NEAR(result.at_horizon[0].position_rmse_m, 4.0, 1e-9);
  ASSERT_EQ(result.object_at_horizon[0].size(), 2U);
  EXPECT_NEAR(result.object_at_horizon[0][1].position_rmse_m, 4.0, 1e-9);
  // The recording ends at frame 129: whole steps reach frame 120, nine of them after the second given frame.
  ASSERT_EQ(result.curve.size(), 10U);
  EXPECT_NEAR(result.curve.at(10).position_rmse_m, 0.0, 1e-9);
  EXPECT_NEAR(result.curve.at(100).position_rmse_m, 9.0, 1e-9);
  EXPECT_EQ(result.predicted.size(), 2U);
  // Rolling out farther for the curve does not change the scores.
  options.curve_end = 0;
  const auto short_scores = evaluate(archive, {&ballistic, &drifting}, options);
  EXPECT_EQ(short_scores[2].error.position_rmse_m, scores[2].error.position_rmse_m);
  options.curve_end = -1;
  EXPECT_THROW(options.validate(), std::invalid_argument);
}

TEST(Protocol, DriftCountsOnlyWhatLiesStill) {
  // Object 0 of the second scene lies still from frame 10 on; the first scene has nothing at rest.
  SceneArchive archive = flying_set(2, 130);
  auto& poses = archive.scenes[1].objects[0].T_world_object;
  for (std::size_t frame = 10; frame < poses.size(); ++frame) {
    poses[frame] = {Eigen::Quaterniond::Identity(), {0, 0, 0.5}};
  }
  class StillDrifting : public Forecaster {
   public:
    std::string name() const override { return "still_drifting"; }
    std::vector<std::vector<RigidTransform>> forecast(const std::vector<ObjectState>& objects,
                                                      const RolloutOptions& rollout,
                                                      const std::vector<GivenTrack>&) override {
      std::vector<std::vector<RigidTransform>> forecast;
      for (const ObjectState& object : objects) {
        forecast.emplace_back(static_cast<std::size_t>(rollout.num_steps) + 1, object.T_world_current);
        for (std::size_t k = 0; k < forecast.back().size(); ++k) {
          forecast.back()[k].translation.x() += 0.01 * static_cast<double>(k);
        }
      }
      return forecast;
    }
  } drifting;
  ProtocolOptions options;
  options.starts = {20};
  options.steps = {10};
  options.horizons = {50, 100};
  options.resting_only = true;
  const auto scores = evaluate(archive, {&drifting}, options);
  ASSERT_EQ(scores.size(), 2U);
  EXPECT_EQ(scores[1].num_scenes, 1);
  EXPECT_NEAR(scores[0].error.position_rmse_m, 0.04, 1e-9);
  EXPECT_NEAR(scores[1].error.position_rmse_m, 0.09, 1e-9);
  options.starts = {0};
  EXPECT_THROW(evaluate(archive, {&drifting}, options), std::invalid_argument);  // the objects still fly at frame 0
}

TEST(Protocol, P45_EveryScoreIsAMeanOverTheScenesThatReachItsHorizons) {
  BallisticForecaster ballistic;
  ProtocolOptions options;
  options.starts = {0, 30};
  options.steps = {10};
  options.horizons = {50, 100};
  SceneArchive archive = flying_set(1, 140);
  archive.scenes.push_back(flying_cubes(1, 110));
  archive.scenes.push_back(flying_cubes(0, 140));
  archive.scenes.push_back(flying_cubes(1, 60));
  const auto scores = evaluate(archive, {&ballistic}, options);
  ASSERT_EQ(scores.size(), 4U);
  EXPECT_EQ(scores[0].num_scenes, 2);
  EXPECT_EQ(scores[1].num_scenes, 2);
  EXPECT_EQ(scores[2].num_scenes, 1);
  const std::vector<std::string> sentences = scenes_left_out(archive, options);
  ASSERT_EQ(sentences.size(), 3U);  // one without objects, one too short for start 0, two for start 30
  EXPECT_NE(sentences[0].find("no object in them can move"), std::string::npos) << sentences[0];
  EXPECT_NE(sentences[2].find("2 scenes left out"), std::string::npos) << sentences[2];
  options.starts = {60};
  EXPECT_THROW(evaluate(archive, {&ballistic}, options), std::invalid_argument);
}

TEST(Protocol, P42_AnotherFrameRateIsAnotherTimeStep) {
  class TimeStep : public BallisticForecaster {
   public:
    std::vector<std::vector<RigidTransform>> forecast(const std::vector<ObjectState>& objects,
                                                      const RolloutOptions& rollout,
                                                      const std::vector<GivenTrack>&) override {
      time_step_s = rollout.time_step_s;
      return BallisticForecaster::forecast(objects, rollout);
    }
    double time_step_s = 0.0;
  } forecaster;
  ProtocolOptions options;
  options.starts = {0};
  options.steps = {5};
  SceneArchive archive = flying_set(1, 140);
  archive.scenes[0].frame_rate_hz = 60.0;
  evaluate(archive, {&forecaster}, options);
  EXPECT_NEAR(forecaster.time_step_s, 5.0 / 60.0, 1e-12);
}

TEST(Protocol, P41_StaticObjectsAreSeenButNotScored) {
  DriftingForecaster drifting;
  ProtocolOptions options;
  options.starts = {0};
  options.steps = {10};
  options.horizons = {50};
  SceneArchive archive = flying_set(1, 60);
  archive.scenes[0].objects[1].is_static = true;
  std::vector<SceneResult> results;
  const auto scores = evaluate(archive, {&drifting}, options, {}, [&](const SceneResult& r) { results.push_back(r); });
  EXPECT_EQ(results.at(0).predicted.size(), 2U);
  EXPECT_NEAR(scores.at(0).error.position_rmse_m, 4.0, 1e-9);
}

TEST(Protocol, ForecastersGetTheTracksOfDrivenObjectsWhichAreNotScored) {
  DriftingForecaster drifting;
  BallisticForecaster ballistic;
  ProtocolOptions options;
  options.starts = {0};
  options.steps = {10};
  options.horizons = {50};
  options.curve_end = 50;
  SceneArchive archive = flying_set(1, 60);
  RecordedObject& driven = archive.scenes[0].objects[1];
  driven.is_driven = true;
  for (int frame = 0; frame < 60; ++frame) {
    driven.T_world_object[static_cast<std::size_t>(frame)].translation = {0.001 * frame * frame, 9.0, 0.5};
  }
  std::vector<SceneResult> results;
  const auto scores =
      evaluate(archive, {&drifting, &ballistic}, options, {}, [&](const SceneResult& r) { results.push_back(r); });
  EXPECT_NEAR(scores.at(0).error.position_rmse_m, 4.0, 1e-9) << "the mean over the free object alone";
  EXPECT_NEAR(results.at(0).curve.at(50).position_rmse_m, 4.0, 1e-9);
  ASSERT_EQ(results.at(1).predicted.at(1).size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    const RigidTransform& truth = driven.T_world_object[10 * (k + 1)];
    EXPECT_LT((results[1].predicted[1][k].translation - truth.translation).norm(), 1e-9);
  }
}

TEST(Protocol, RefusesScenesThatAreTooShortAndBadOptions) {
  BallisticForecaster ballistic;
  ProtocolOptions options;
  options.starts = {0};
  EXPECT_THROW(evaluate(flying_set(1, 100), {&ballistic}, options), std::invalid_argument);
  EXPECT_NO_THROW(evaluate(flying_set(1, 101), {&ballistic}, options));
  EXPECT_THROW(evaluate(flying_set(0, 101), {&ballistic}, options), std::invalid_argument);
  options.horizons = {5};
  EXPECT_THROW(options.validate(), std::invalid_argument);  // a horizon shorter than step size 10
  options = {};
  options.steps = {0};
  EXPECT_THROW(options.validate(), std::invalid_argument);
  options = {};
  options.starts.clear();
  EXPECT_THROW(options.validate(), std::invalid_argument);
}

}  // namespace
}  // namespace rigidformer
