// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/forecast/scene_forecaster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <thread>
#include <utility>

#include "rigidformer/scene/defects.hpp"
#include "rigidformer_ros/ballistic_predictor.hpp"
#include "rigidformer_ros/forecast/forecast_messages.hpp"
#include "rigidformer_ros/test_scene.hpp"

namespace rigidformer_ros {
namespace {

using rigidformer::ObjectTrajectory;
using rigidformer::SkipCause;
using rigidformer::SkippedObject;

constexpr int kNumSteps = 3;

void wait_until_loaded(const SceneForecaster& forecaster) {
  while (forecaster.state() == InferenceWorker::State::kLoading) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

ObservedObject object_at(const std::string& id, double x, unsigned seed) {
  ObservedObject object;
  object.state.id = id;
  object.state.points_reference = testing::blob(30, seed);
  object.state.T_world_current.translation = {x, 0.0, 0.6};
  object.state.T_world_previous.translation = {x - 0.01, 0.0, 0.62};
  return object;
}

ObservedScene random_scene(int count, std::mt19937& random) {
  ObservedScene scene;
  scene.stamp = rigidformer::stamp_at(100.0);
  scene.time_step_s = 10.0 / 240.0;
  for (int i = 0; i < count; ++i) {
    scene.objects.push_back(object_at("object_" + std::to_string(i), 0.8 * i, random()));
  }
  return scene;
}

// Returns the id of the object that was added.
std::string add_defective(ObservedScene& scene, const rigidformer::testing::Defect& defect, std::mt19937& random) {
  ObservedObject object = object_at(defect.name + std::string("_") + std::to_string(scene.objects.size()), 0.5, 7);
  defect.apply(object.state);
  const auto place = static_cast<std::ptrdiff_t>(random() % (scene.objects.size() + 1));
  scene.objects.insert(scene.objects.begin() + place, object);
  return object.state.id;
}

SceneRollout roll_out(SceneForecaster& forecaster, const ObservedScene& scene) {
  RolloutSettings settings = forecaster.default_settings();
  settings.options.num_steps = kNumSteps;
  settings.options.time_step_s = scene.time_step_s;
  return forecaster.roll_out(scene, settings);
}

// Of everything but the time it took.
void expect_same_bytes(const SceneRollout& a, const SceneRollout& b) {
  const auto &first = a.outcome.forecast.objects, &second = b.outcome.forecast.objects;
  ASSERT_EQ(first.size(), second.size());
  EXPECT_EQ(a.outcome.forecast.times_s, b.outcome.forecast.times_s);
  EXPECT_EQ(a.outcome.settled_steps, b.outcome.settled_steps);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].id, second[i].id);
    EXPECT_EQ(a.scene.objects[i].state.id, first[i].id);
    EXPECT_EQ(first[i].status, second[i].status);
    ASSERT_EQ(first[i].poses.size(), second[i].poses.size());
    for (std::size_t k = 0; k < first[i].poses.size(); ++k) {
      EXPECT_EQ(first[i].poses[k].translation, second[i].poses[k].translation) << first[i].id << " step " << k;
      EXPECT_EQ(first[i].poses[k].rotation.coeffs(), second[i].poses[k].rotation.coeffs());
    }
  }
}

// Of all skipped objects one reason each, in the rollout and in its message.
void expect_reasons(const SceneRollout& rollout, std::vector<std::string> ids) {
  SceneForecast message = to_forecast(rollout, {}, "world");
  EXPECT_EQ(message.objects.size(), rollout.scene.objects.size());
  ASSERT_EQ(message.skip_reasons.size(), message.skipped_ids.size());
  EXPECT_EQ(std::count(message.skip_reasons.begin(), message.skip_reasons.end(), ""), 0);
  std::sort(ids.begin(), ids.end());
  std::sort(message.skipped_ids.begin(), message.skipped_ids.end());
  EXPECT_EQ(message.skipped_ids, ids);
  for (const SkippedObject& skipped : rollout.scene.skipped) {
    EXPECT_EQ(skipped.cause, SkipCause::kUnusable) << skipped.id;
  }
}

void play_random_scenes(SceneForecaster& forecaster, int rounds) {
  std::mt19937 random(17);
  const auto defects = rigidformer::testing::defects();
  for (int round = 0; round < rounds; ++round) {
    const ObservedScene usable = random_scene(1 + round % 3, random);
    ObservedScene scene = usable;
    std::vector<std::string> ids;
    const auto num_defects = 1 + random() % 3;
    for (std::size_t i = 0; i < num_defects; ++i) {
      ids.push_back(add_defective(scene, defects[random() % defects.size()], random));
    }
    const SceneRollout rollout = roll_out(forecaster, scene);
    expect_same_bytes(rollout, roll_out(forecaster, usable));
    expect_reasons(rollout, ids);
  }
}

NodeParameters shipped_model() {
  NodeParameters parameters;
  parameters.model.file = RIGIDFORMER_SOURCE_DIR "/models/hybrid.safetensors";
  parameters.model.device = "cpu";
  parameters.model.warmup_runs = 0;
  return parameters;
}

TEST(SceneForecaster, P36_RandomScenesWithRandomDefectsAreThoseWithoutTheDefectiveObjects) {
  NodeParameters parameters = shipped_model();
  for (const std::optional<double> length_scale : {std::optional<double>(1.0), std::optional<double>()}) {
    parameters.predict.length_scale = length_scale;
    SceneForecaster forecaster(parameters,
                               [&parameters] { return std::make_unique<rigidformer::Predictor>(parameters.model); });
    wait_until_loaded(forecaster);
    if (!forecaster.ready()) {
      GTEST_SKIP() << forecaster.message();
    }
    play_random_scenes(forecaster, 6);
  }
}

TEST(SceneForecaster, P36_UnusableObjectsNeitherSetTheScaleNorTakeAPlace) {
  NodeParameters parameters;
  parameters.predict.length_scale.reset();
  SceneForecaster forecaster(parameters, [] { return std::make_unique<rigidformer::BallisticPredictor>(); });
  wait_until_loaded(forecaster);
  std::mt19937 random(3);
  const ObservedScene usable = random_scene(8, random);  // as many as the predictor takes
  ObservedScene scene = usable;
  ObservedObject giant = object_at("giant", 0.0, 7);
  giant.state.points_reference *= 1e30F;
  rigidformer::testing::stretch(giant.state.points_reference, 1.0F, 0.0F, 0.0F);
  for (int i = 0; i < 20; ++i) {
    scene.objects.insert(scene.objects.begin(), giant);
  }
  EXPECT_EQ(forecaster.model_for(scene).max_size_m, forecaster.model_for(usable).max_size_m);
  const ObservedScene taken = forecaster.usable_part(scene);
  EXPECT_EQ(taken.objects.size(), 8U);
  EXPECT_EQ(taken.skipped.size(), 20U);
  expect_same_bytes(roll_out(forecaster, scene), roll_out(forecaster, usable));
}

TEST(SceneForecaster, P38_ObjectsBeyondTheLimitOfTheModelAreSkippedWithTheReason) {
  SceneForecaster forecaster(NodeParameters(), [] { return std::make_unique<rigidformer::BallisticPredictor>(); });
  wait_until_loaded(forecaster);
  std::mt19937 random(3);
  const ObservedScene taken = forecaster.usable_part(random_scene(9, random));
  ASSERT_EQ(taken.skipped.size(), 1U);
  EXPECT_EQ(taken.skipped[0].cause, SkipCause::kSurplus);
  EXPECT_EQ(taken.skipped[0].reason, "the model takes at most 8 objects");
}

// Finds out about the object "hollow" what nobody else does.
class PickyPredictor : public rigidformer::BallisticPredictor {
 public:
  rigidformer::Forecast predict(const std::vector<rigidformer::ObjectState>& objects,
                                const rigidformer::RolloutOptions& rollout) override {
    rigidformer::Forecast forecast = BallisticPredictor::predict(objects, rollout);
    for (ObjectTrajectory& object : forecast.objects) {
      if (object.id == "hollow") {
        object.status = ObjectTrajectory::Status::kUnusable;
        object.reason = "no volume";
      }
    }
    return forecast;
  }
};

TEST(SceneForecaster, P36_WhatOnlyThePredictorFindsOutSkipsAnObjectToo) {
  SceneForecaster forecaster(NodeParameters(), [] { return std::make_unique<PickyPredictor>(); });
  wait_until_loaded(forecaster);
  std::mt19937 random(3);
  const ObservedScene usable = random_scene(3, random);
  ObservedScene scene = usable;
  scene.objects.insert(scene.objects.begin() + 1, object_at("hollow", 0.4, 7));
  const SceneRollout rollout = roll_out(forecaster, scene);
  expect_same_bytes(rollout, roll_out(forecaster, usable));
  expect_reasons(rollout, {"hollow"});
  EXPECT_EQ(rollout.scene.skipped.at(0).reason, "no volume");
}

}  // namespace
}  // namespace rigidformer_ros
