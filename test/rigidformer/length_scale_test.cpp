// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/length_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/evaluation/ballistic.hpp"
#include "rigidformer/evaluation/flying_cubes.hpp"
#include "rigidformer/evaluation/length_scaled_forecaster.hpp"
#include "rigidformer/evaluation/observation.hpp"

namespace rigidformer {
namespace {

SceneArchive cubes() {
  SceneArchive archive;
  archive.set = "cubes";
  archive.shapes = {unit_cube()};
  archive.scenes = {flying_cubes(3, 60)};
  return archive;
}

TEST(LengthScale, IsANumberOrAuto) {
  EXPECT_EQ(length_scale_from("0.131"), 0.131);
  EXPECT_FALSE(length_scale_from("auto"));
  for (const char* text : {"", "0", "-1", "1m", "nan", "inf", "Auto"}) {
    EXPECT_THROW(length_scale_from(text), std::invalid_argument) << text;
  }
}

TEST(LengthScale, FreeFlightAtTheModelsScaleIsFreeFlight) {
  const double scale = 0.04;
  const SceneArchive archive = to_model_scale(cubes(), scale);
  const SceneRecording& scene = archive.scenes[0];
  EXPECT_NEAR(scene.frame_rate_hz, 240.0 * 0.2, 1e-9);
  EXPECT_NEAR(scene.objects[1].size, 2.0 / scale, 1e-9);
  const auto& poses = scene.objects[1].T_world_object;
  for (std::size_t frame = 2; frame < poses.size(); ++frame) {
    const double bend =
        poses[frame].translation.z() - 2.0 * poses[frame - 1].translation.z() + poses[frame - 2].translation.z();
    EXPECT_NEAR(bend * scene.frame_rate_hz * scene.frame_rate_hz, -10.0, 1e-6);
  }
}

TEST(LengthScale, AutoBringsTheMedianDiameterToTheMiddleOfTheTrainedOnes) {
  const double cube_diameter = std::sqrt(3.0);  // of size 1; the sizes are 1, 2 and 3
  EXPECT_NEAR(automatic_length_scale(cubes(), 0.5, 8.0), 2.0 * cube_diameter / 2.0, 1e-6);
  EXPECT_EQ(automatic_length_scale(cubes(), 0.0, 8.0), 1.0);
  EXPECT_EQ(automatic_length_scale(SceneArchive(), 0.5, 8.0), 1.0);
}

TEST(LengthScaledForecaster, AnswersInRealLengthsAndTimes) {
  class Seeing : public BallisticForecaster {
   public:
    std::vector<std::vector<RigidTransform>> forecast(const std::vector<ObjectState>& objects,
                                                      const RolloutOptions& rollout,
                                                      const std::vector<GivenTrack>& = {}) override {
      seen = objects.at(1);
      time_step_s = rollout.time_step_s;
      return BallisticForecaster::forecast(objects, rollout);
    }
    ObjectState seen;
    double time_step_s = 0.0;
  } ballistic;
  const SceneArchive archive = cubes();
  const auto objects = Observer(archive.shapes, {}).observe(archive.scenes[0], 10, 10);
  RolloutOptions rollout;
  rollout.num_steps = 4;
  const auto plain = ballistic.forecast(objects, rollout);
  const auto scaled = LengthScaledForecaster(ballistic, 0.25).forecast(objects, rollout);
  EXPECT_NEAR(ballistic.time_step_s, 2.0 * rollout.time_step_s, 1e-12);
  EXPECT_NEAR(ballistic.seen.points_reference.norm(), 4.0F * objects[1].points_reference.norm(), 1e-3);
  for (std::size_t k = 0; k <= 4; ++k) {
    EXPECT_LT((scaled[1][k].translation - plain[1][k].translation).norm(), 1e-9);
    EXPECT_LT(rotation_angle(scaled[1][k].rotation, plain[1][k].rotation), 1e-9);
  }
}

}  // namespace
}  // namespace rigidformer
