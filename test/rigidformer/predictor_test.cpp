// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/predictor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/model/checkpoint.hpp"
#include "rigidformer/model/random_scene.hpp"

namespace rigidformer {
namespace {

constexpr double kTimeStep_s = 5.0 / 240.0;  // [s] five frames of the training data

TrainingFacts facts_for_steps(double min_frames, double max_frames) {
  TrainingFacts facts;
  facts.min_step_frames = min_frames;
  facts.max_step_frames = max_frames;
  facts.min_diameter_m = 0.5;
  facts.max_diameter_m = 2.5;
  facts.max_speed_mps = 9.0;
  return facts;
}

/// Two clouds that touch above the ground, so that every part of the network has work to do.
std::vector<ObjectState> touching_objects() {
  std::vector<ObjectState> objects(2);
  std::srand(5);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    objects[i].id = i == 0 ? "left" : "right";
    objects[i].points_reference = 0.5F * Points::Random(24, 3);
    objects[i].T_world_current.translation = {0.6 * static_cast<double>(i), 0.0, 0.5};
    objects[i].T_world_previous = objects[i].T_world_current;
    objects[i].T_world_previous.translation.x() -= i == 0 ? 0.03 : -0.01;
  }
  return objects;
}

RolloutOptions short_rollout(int num_steps = 4) {
  RolloutOptions rollout;
  rollout.num_steps = num_steps;
  rollout.time_step_s = kTimeStep_s;
  return rollout;
}

double pose_difference(const ObjectTrajectory& a, const ObjectTrajectory& b) {
  double difference = a.poses.size() == b.poses.size() ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < std::min(a.poses.size(), b.poses.size()); ++k) {
    difference = std::max({difference, (a.poses[k].translation - b.poses[k].translation).norm(),
                           a.poses[k].rotation.angularDistance(b.poses[k].rotation)});
  }
  return difference;
}

class PredictorTest : public ::testing::Test {
 protected:
  PredictorTest() {
    const RigidFormer model = random_model(contact_aware(model_preset("tiny")), torch::kFloat32);
    save_checkpoint(options_.file, model, facts_for_steps(1.0, 10.0));
  }

  const TemporaryFolder folder_;
  PredictorOptions options_{(folder_.path() / "model.safetensors").string(), "cpu", "float32", 1, 256, 1};
};

TEST_F(PredictorTest, ForecastHasTheObservationAndEveryStep) {
  Predictor predictor(options_);
  predictor.warm_up();
  const auto objects = touching_objects();
  const Forecast forecast = predictor.predict(objects, short_rollout());
  ASSERT_EQ(forecast.times_s.size(), 5u);
  EXPECT_NEAR(forecast.times_s[4], 4.0 * kTimeStep_s, 1e-12);
  ASSERT_EQ(forecast.objects.size(), 2u);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    EXPECT_EQ(forecast.objects[i].id, objects[i].id);
    EXPECT_EQ(forecast.objects[i].status, ObjectTrajectory::Status::kOk);
    ASSERT_EQ(forecast.objects[i].poses.size(), 5u);
    EXPECT_EQ(forecast.objects[i].poses[0].translation, objects[i].T_world_current.translation);
  }
  EXPECT_GT(forecast.compute_time_s, 0.0);
}

TEST_F(PredictorTest, SameInputGivesTheSameForecastToTheBit) {
  Predictor first(options_), second(options_);
  const Forecast a = first.predict(touching_objects(), short_rollout());
  first.predict({touching_objects()[0]}, short_rollout(1));  // what came in between leaves no trace
  const Forecast b = first.predict(touching_objects(), short_rollout());
  const Forecast c = second.predict(touching_objects(), short_rollout());
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    EXPECT_EQ(pose_difference(a.objects[i], b.objects[i]), 0.0);
    EXPECT_EQ(pose_difference(a.objects[i], c.objects[i]), 0.0);
  }
}

ModelOptions carrying_velocities() {
  ModelOptions options = contact_aware(model_preset("tiny"));
  options.end_velocity_output = true;
  return options;
}

TEST_F(PredictorTest, ARolloutInPiecesIsTheWholeToTheBit) {
  save_checkpoint(options_.file, random_model(carrying_velocities(), torch::kFloat32), facts_for_steps(1.0, 10.0));
  Predictor predictor(options_);
  const auto objects = touching_objects();
  const Forecast whole = predictor.predict(objects, short_rollout(5));
  const std::unique_ptr<Rollout> rollout = predictor.start(objects, short_rollout(5));
  EXPECT_EQ(rollout->advance(2).times_s.size(), 3u);
  predictor.predict(objects, short_rollout(1));  // other calls may come in between
  const Forecast pieces = rollout->advance(3);
  EXPECT_EQ(pieces.times_s, whole.times_s);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    EXPECT_EQ(pose_difference(pieces.objects[i], whole.objects[i]), 0.0);
  }

  // Two poses do not hold the velocity at the end of a step: a rollout that starts anew from them gives something else.
  auto later = objects;
  for (std::size_t i = 0; i < later.size(); ++i) {
    later[i].T_world_previous = whole.objects[i].poses[1];
    later[i].T_world_current = whole.objects[i].poses[2];
  }
  const Forecast anew = predictor.predict(later, short_rollout(3));
  EXPECT_GT((anew.objects[0].poses[3].translation - whole.objects[0].poses[5].translation).norm(), 1e-5);
}

#ifdef RIGIDFORMER_HAS_SIMULATION
TEST_F(PredictorTest, APhysicsEngineTakesPartInTheForecast) {
  ModelOptions with_engine = contact_aware(model_preset("tiny"));
  with_engine.engine_motion = true;
  save_checkpoint(options_.file, random_model(with_engine, torch::kFloat32), facts_for_steps(1.0, 10.0));
  options_.engine_share = 1.0;
  Predictor engine(options_);
  auto objects = touching_objects();
  objects.resize(1);
  const RolloutOptions rollout = short_rollout(60);
  const ObjectTrajectory alone = engine.predict(objects, rollout).objects[0];
  EXPECT_EQ(alone.status, ObjectTrajectory::Status::kOk);
  EXPECT_GT(alone.poses.back().translation.z(), 0.05);  // the object lies on the floor instead of falling through
  options_.engine_share = -1.0;
  const ObjectTrajectory learned = Predictor(options_).predict(objects, rollout).objects[0];
  EXPECT_GT(pose_difference(alone, learned), 1e-3);
  options_.engine_share = 1.5;
  EXPECT_NE(error_of([&] { Predictor{options_}; }).find("engine_share is 1.5"), std::string::npos);
}
#endif

TEST_F(PredictorTest, OrderOfTheObjectsDoesNotMatter) {
  Predictor predictor(options_);
  auto objects = touching_objects();
  const Forecast forecast = predictor.predict(objects, short_rollout());
  std::swap(objects[0], objects[1]);
  const Forecast swapped = predictor.predict(objects, short_rollout());
  EXPECT_LT(pose_difference(swapped.objects[0], forecast.objects[1]), 1e-4);
  EXPECT_LT(pose_difference(swapped.objects[1], forecast.objects[0]), 1e-4);
}

TEST_F(PredictorTest, AnObjectFarFromEverythingFollowsTheParabola) {
  Predictor predictor(options_);
  std::vector<ObjectState> objects(1);
  objects[0].points_reference = 0.5F * Points::Random(24, 3);
  objects[0].T_world_current.translation = {0.0, 0.0, 10.0};
  objects[0].T_world_previous.translation = {-0.02, 0.0, 10.0};
  const RolloutOptions rollout = short_rollout(20);
  const Forecast forecast = predictor.predict(objects, rollout);
  for (std::size_t k = 0; k < forecast.times_s.size(); ++k) {
    // The two observed positions give the velocity half a step ago.
    const double t = forecast.times_s[k], drop = 0.5 * rollout.gravity * t * (t + kTimeStep_s);
    const Eigen::Vector3d expected(0.02 * static_cast<double>(k), 0.0, 10.0 + drop);
    // float32 places a body at 10 m to 1e-6 m, and each step extrapolates that error.
    const double rounding = 1e-6 * (1.0 + 0.5 * static_cast<double>(k * (k + 1)));
    EXPECT_LT((forecast.objects[0].poses[k].translation - expected).norm(), rounding) << "step " << k;
  }
}

TEST_F(PredictorTest, StaticObjectsStayAndKinematicOnesKeepTheirTwist) {
  Predictor predictor(options_);
  auto objects = touching_objects();
  objects[0].mode = MotionMode::kStatic;
  objects[1].mode = MotionMode::kKinematic;
  const Forecast forecast = predictor.predict(objects, short_rollout());
  EXPECT_LT((forecast.objects[0].poses[4].translation - objects[0].T_world_current.translation).norm(), 1e-6);
  const double expected_x = objects[1].T_world_current.translation.x() - 4 * 0.01;
  EXPECT_NEAR(forecast.objects[1].poses[4].translation.x(), expected_x, 1e-5);
  EXPECT_NEAR(forecast.objects[1].poses[4].translation.z(), 0.5, 1e-5) << "no gravity on what is driven";
}

TEST_F(PredictorTest, AnEmptySceneGivesAnEmptyForecast) {
  const Forecast forecast = Predictor(options_).predict({}, short_rollout(3));
  EXPECT_TRUE(forecast.objects.empty());
  EXPECT_EQ(forecast.times_s.size(), 4u);
}

TEST_F(PredictorTest, BFloat16StaysNearFloat32) {
  const Forecast full = Predictor(options_).predict(touching_objects(), short_rollout(1));
  options_.precision = "bfloat16";
  const Forecast half = Predictor(options_).predict(touching_objects(), short_rollout(1));
  for (std::size_t i = 0; i < full.objects.size(); ++i) {
    const double moved = pose_difference(full.objects[i], half.objects[i]);
    EXPECT_GT(moved, 0.0) << "it does compute in bfloat16";
    EXPECT_LT(moved, 0.05);
  }
}

TEST_F(PredictorTest, InfoTellsWhatWasTrained) {
  save_checkpoint(options_.file, random_model(model_preset("tiny"), torch::kFloat32), facts_for_steps(2.0, 8.0));
  const Predictor predictor(options_);
  const ModelInfo& info = predictor.info();
  EXPECT_EQ(info.id, "rigidformer-tiny");
  EXPECT_EQ(info.sha256, load_checkpoint(options_.file).sha256);
  EXPECT_EQ(info.device, "cpu");
  EXPECT_NEAR(info.min_time_step_s, 2.0 / 240.0, 1e-12);
  EXPECT_NEAR(info.max_time_step_s, 8.0 / 240.0, 1e-12);
  EXPECT_EQ(info.max_size_m, 2.5);
  EXPECT_EQ(info.max_speed_mps, 9.0);
}

TEST_F(PredictorTest, TheModelSaysHowItIsUsedUnlessTheCallerDoes) {
  auto objects = touching_objects();
  for (ObjectState& object : objects) object.T_world_previous = object.T_world_current;
  PredictorOptions open;
  open.file = options_.file;
  open.device = "cpu";
  const auto moved = [&](double rest_speed) {
    open.rest_speed = rest_speed;
    const ObjectTrajectory forecast = Predictor(open).predict(objects, short_rollout()).objects[0];
    return (forecast.poses.back().translation - forecast.poses.front().translation).norm() > 1e-7;
  };
  for (const double rest_speed : {0.0, 0.1}) {
    ModelOptions model_options = model_preset("tiny");
    model_options.max_points = 1200;
    model_options.rest_speed_mps = rest_speed;
    RigidFormer model = random_model(model_options, torch::kFloat32);
    torch::NoGradGuard no_grad;
    for (Tensor parameter : model->predictor->head->second->parameters()) parameter.mul_(1e-3);  // slow, but not still
    save_checkpoint(open.file, model, facts_for_steps(1.0, 10.0));
    EXPECT_EQ(Predictor(open).info().max_points, 1200);
    EXPECT_EQ(Predictor(options_).info().max_points, 256);
    EXPECT_EQ(moved(-1.0), rest_speed == 0.0) << "the model says " << rest_speed;
    EXPECT_TRUE(moved(0.0));
    EXPECT_FALSE(moved(0.1));
  }
}

TEST_F(PredictorTest, BadRolloutOptionsAreRefusedByNameAndTheNextCallWorks) {
  Predictor predictor(options_);
  const auto expect_refused = [&](const auto& change, const std::string& word) {
    RolloutOptions rollout = short_rollout();
    change(rollout);
    const std::string message = error_of([&] { predictor.predict(touching_objects(), rollout); });
    EXPECT_NE(message.find(word), std::string::npos) << "'" << message << "' lacks " << word;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused([](auto& rollout) { rollout.num_steps = 0; }, "num_steps");
  expect_refused([](auto& rollout) { rollout.time_step_s = 1.0; }, "time_step_s");
  expect_refused([&](auto& rollout) { rollout.time_step_s = nan; }, "time_step_s");
  expect_refused([&](auto& rollout) { rollout.gravity = nan; }, "gravity");
  expect_refused([&](auto& rollout) { rollout.ground_height_m = nan; }, "ground_height");
  EXPECT_EQ(predictor.predict(touching_objects(), short_rollout()).objects.size(), 2u);
}

TEST_F(PredictorTest, BadOptionsAndFilesAreRefusedByName) {
  const auto refused = [&](const auto& change) {
    PredictorOptions options = options_;
    change(options);
    return error_of([&] { Predictor predictor(options); });
  };
  const auto expect_word = [](const std::string& message, const std::string& word) {
    EXPECT_NE(message.find(word), std::string::npos) << "'" << message << "' lacks " << word;
  };
  expect_word(refused([](auto& o) { o.precision = "int4"; }), "int4");
  expect_word(refused([](auto& o) { o.num_threads = 0; }), "num_threads");
  expect_word(refused([](auto& o) { o.max_points = 3; }), "max_points");
  expect_word(refused([](auto& o) { o.rest_spin = std::nan(""); }), "rest_spin");
  expect_word(refused([](auto& o) { o.device = "tpu"; }), "tpu");
  expect_word(refused([](auto& o) { o.file = "/nowhere/none.safetensors"; }), "/nowhere/none.safetensors");
}

}  // namespace
}  // namespace rigidformer
