// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/usable_rollout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/engine/engine_step.hpp"
#include "rigidformer/model/checkpoint.hpp"
#include "rigidformer/model/random_scene.hpp"
#include "rigidformer/predictor.hpp"
#include "rigidformer/scene/defects.hpp"
#include "rigidformer/tracking/flying_blob.hpp"

namespace rigidformer {
namespace {

using Status = ObjectTrajectory::Status;

constexpr int kNumSteps = 3;

RolloutOptions few_steps() {
  RolloutOptions rollout;
  rollout.num_steps = kNumSteps;
  return rollout;
}

/// Objects that fall near each other.
std::vector<ObjectState> random_scene_of(int count, std::mt19937& random) {
  std::uniform_real_distribution<double> step(-0.03, 0.03);
  std::vector<ObjectState> objects(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    ObjectState& object = objects[static_cast<size_t>(i)];
    object.id = "object_" + std::to_string(i);
    object.points_reference = testing::blob(20 + 5 * i, random());
    object.T_world_current.translation = {0.9 * i, 0.0, 0.5 + 0.1 * i};
    object.T_world_previous = object.T_world_current;
    object.T_world_previous.translation += Eigen::Vector3d(step(random), step(random), step(random));
    if (i % 2 == 0) object.properties = {1.0 + 0.2 * i, 0.5, 0.3};
  }
  return objects;
}

/// The object as it would be seen amid the others, with this defect.
ObjectState defective(const testing::Defect& defect) {
  ObjectState object;
  object.id = defect.name;
  object.points_reference = testing::blob();
  object.T_world_current.translation = object.T_world_previous.translation = {0.5, 0.5, 0.5};
  defect.apply(object);
  return object;
}

void expect_same_bytes(const ObjectTrajectory& a, const ObjectTrajectory& b, const std::string& where) {
  EXPECT_EQ(a.status, b.status) << where;
  ASSERT_EQ(a.poses.size(), b.poses.size()) << where;
  for (size_t k = 0; k < a.poses.size(); ++k) {
    EXPECT_EQ(a.poses[k].translation, b.poses[k].translation) << where << " step " << k;
    EXPECT_EQ(a.poses[k].rotation.coeffs(), b.poses[k].rotation.coeffs()) << where << " step " << k;
  }
}

const ObjectTrajectory& of(const Forecast& forecast, const std::string& id) {
  return *std::find_if(forecast.objects.begin(), forecast.objects.end(), [&](const auto& o) { return o.id == id; });
}

/// With the physics engine where there is one.
class UsableRollout : public ::testing::Test {
 protected:
  UsableRollout() {
    ModelOptions model = contact_aware(model_preset("tiny"));
#ifdef RIGIDFORMER_HAS_SIMULATION
    model.engine_motion = true;
#endif
    TrainingFacts facts;
    facts.min_step_frames = 1.0;
    facts.max_step_frames = 10.0;
    save_checkpoint(options_.file, random_model(model, torch::kFloat32), facts);
  }

  const TemporaryFolder folder_;
  PredictorOptions options_{(folder_.path() / "model.safetensors").string(), "cpu", "float32", 1, 256, 1};
};

TEST_F(UsableRollout, P36_AnObjectThatCannotBePredictedCostsTheOthersNothing) {
  Predictor predictor(options_);
  std::mt19937 random(3);
  const std::vector<ObjectState> usable = random_scene_of(2, random);
  const Forecast alone = predictor.predict(usable, few_steps());
  size_t place = 0;
  for (const testing::Defect& defect : testing::defects()) {
    std::vector<ObjectState> scene = usable;
    const size_t k = place++ % 3;
    scene.insert(scene.begin() + static_cast<std::ptrdiff_t>(k), defective(defect));
    const Forecast forecast = predictor.predict(scene, few_steps());
    ASSERT_EQ(forecast.objects.size(), 3u) << defect.name;
    EXPECT_EQ(forecast.times_s, alone.times_s);
    for (const ObjectTrajectory& object : alone.objects) {
      EXPECT_EQ(object.status, Status::kOk);
      expect_same_bytes(of(forecast, object.id), object, defect.name);
    }
    EXPECT_EQ(forecast.objects[k].id, defect.name) << "the order of the scene is kept";
    EXPECT_EQ(forecast.objects[k].status, Status::kUnusable) << defect.name;
    EXPECT_NE(forecast.objects[k].reason.find(defect.part), std::string::npos) << forecast.objects[k].reason;
    ASSERT_EQ(forecast.objects[k].poses.size(), alone.times_s.size()) << defect.name;
    EXPECT_EQ(forecast.objects[k].poses.back().translation.z(), 0.5) << "it stays where it was observed";
  }
}

TEST_F(UsableRollout, P36_RandomScenesWithRandomDefectsAreThoseWithoutTheDefectiveObjects) {
  Predictor predictor(options_);
  std::mt19937 random(11);
  const std::vector<testing::Defect> defects = testing::defects();
  for (int round = 0; round < 12; ++round) {
    const std::vector<ObjectState> usable = random_scene_of(1 + round % 4, random);
    std::vector<ObjectState> scene = usable;
    const int num_defects = 1 + static_cast<int>(random() % 4);
    for (int i = 0; i < num_defects; ++i) {
      const auto at = static_cast<std::ptrdiff_t>(random() % (scene.size() + 1));
      scene.insert(scene.begin() + at, defective(defects[random() % defects.size()]));
    }
    const Forecast alone = predictor.predict(usable, few_steps());
    const std::unique_ptr<Rollout> rollout = predictor.start(scene, few_steps());
    rollout->advance(1);
    const Forecast forecast = rollout->advance(kNumSteps - 1);
    ASSERT_EQ(forecast.objects.size(), scene.size());
    for (const ObjectTrajectory& object : alone.objects) expect_same_bytes(of(forecast, object.id), object, object.id);
    const auto without_a_word = std::count_if(forecast.objects.begin(), forecast.objects.end(), [](const auto& object) {
      return (object.status == Status::kUnusable) == object.reason.empty();
    });
    EXPECT_EQ(without_a_word, 0);
  }
}

TEST_F(UsableRollout, P36_OnlyASceneWithoutAnyUsableObjectIsAnError) {
  Predictor predictor(options_);
  std::vector<ObjectState> scene;
  for (const testing::Defect& defect : testing::observable_defects()) scene.push_back(defective(defect));
  for (int i = 0; i < 3; ++i) scene.push_back(scene[0]);
  const std::string message = error_of([&] { predictor.predict(scene, few_steps()); });
  EXPECT_NE(message.find("'line': its points lie on a line"), std::string::npos) << message;
  EXPECT_NE(message.find("'light': mass_kg is 1e-09"), std::string::npos) << message;
  EXPECT_NE(message.find("and 3 more"), std::string::npos) << message;
  std::mt19937 random(5);
  EXPECT_EQ(predictor.predict(random_scene_of(2, random), few_steps()).objects.size(), 2u) << "the next call works";
}

/// Makes no body of the object "hollow".
class PickyRollout : public Rollout {
 public:
  explicit PickyRollout(const std::vector<ObjectState>& objects) {
    forecast_.times_s = {0.0, 1.0};
    for (size_t k = 0; k < objects.size(); ++k) {
      if (objects[k].id == "hollow") throw BodyError(static_cast<std::int64_t>(k), "no volume");
      forecast_.objects.push_back({objects[k].id, Status::kOk, {{}, {}}});
    }
  }
  const Forecast& advance(int /*num_steps*/) override { return forecast_; }

 private:
  Forecast forecast_;
};

TEST(UsableObjects, P36_WhatOnlyTheEngineFindsOutLeavesAnObjectOutToo) {
  std::mt19937 random(5);
  std::vector<ObjectState> scene = random_scene_of(4, random);
  scene[0].points_reference.setZero();
  scene[2].id = "hollow";
  const StartRollout start = [](const auto& usable) { return std::make_unique<PickyRollout>(usable); };
  const Forecast forecast = start_usable(scene, 8, start)->advance(1);
  const std::vector<Status> expected{Status::kUnusable, Status::kOk, Status::kUnusable, Status::kOk};
  for (size_t k = 0; k < expected.size(); ++k) EXPECT_EQ(forecast.objects[k].status, expected[k]) << k;
  EXPECT_EQ(forecast.objects[2].reason, "no volume");
  EXPECT_NE(error_of([&] { start_usable({scene[2]}, 8, start); }).find("'hollow': no volume"), std::string::npos);
}

TEST(UsableObjects, P36_RepeatedIdsAndSurplusObjectsAreLeftOut) {
  std::mt19937 random(5);
  std::vector<ObjectState> scene = random_scene_of(4, random);
  scene.insert(scene.begin() + 1, scene[0]);
  const StartRollout start = [](const auto& usable) { return std::make_unique<PickyRollout>(usable); };
  const Forecast forecast = start_usable(scene, 3, start)->advance(1);
  const std::vector<std::string> expected{"", "its id appears more than once", "", "",
                                          "the model takes at most 3 objects"};
  for (size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(forecast.objects[k].reason, expected[k]) << "a repeated id takes nobody's place: " << k;
    EXPECT_EQ(forecast.objects[k].status, expected[k].empty() ? Status::kOk : Status::kUnusable) << k;
  }
}

}  // namespace
}  // namespace rigidformer
