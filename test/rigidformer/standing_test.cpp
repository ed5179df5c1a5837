// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/standing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "rigidformer/box_scene.hpp"
#include "rigidformer/candidate_batch.hpp"
#include "rigidformer/engine/cubes.hpp"
#include "rigidformer/predictor.hpp"

#ifdef RIGIDFORMER_HAS_SIMULATION
namespace rigidformer {
namespace {

constexpr int kHalfSecond = 12;         // steps
constexpr double kLong_s = 2.0;         // was seen to stand for so long
constexpr double kStill_m = 0.005;      // the bounds of what stands still after half a second
constexpr double kStill_rad = 0.03490;  // 2 degrees

/// What a camera sees of a carton of width 0.6 m and height 1 m that stands on z = 0: its front face, a thin sheet.
Points front_face() {
  Points points(77, 3);
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 11; ++j) {
      points.row(i * 11 + j) << 0.0F, 0.1F * static_cast<float>(i - 3), 0.1F * static_cast<float>(j - 5);
    }
  }
  return points;
}

/// Its lowest 3 cm are hidden.
ObjectState carton(const std::string& id, double x, double floor_m, double stood_s) {
  ObjectState object = box(id, {x, 0.0, floor_m + 0.53});
  object.points_reference = front_face();
  object.properties = {};
  object.stood_s = stood_s;
  return object;
}

ObjectState shelf(double x, double height_m, MotionMode mode = MotionMode::kStatic) {
  ObjectState object = box("shelf", {x, 0.0, height_m - 0.5});
  object.mode = mode;
  return object;
}

double moved_m(const ObjectTrajectory& object, std::size_t step = kHalfSecond) {
  return (object.poses.at(step).translation - object.poses[0].translation).norm();
}

double turned_rad(const ObjectTrajectory& object, std::size_t step = kHalfSecond) {
  return rotation_angle(object.poses.at(step).rotation, object.poses[0].rotation);
}

void expect_still(const ObjectTrajectory& object) {
  for (std::size_t i = 0; i < object.poses.size(); ++i) {
    EXPECT_LT(moved_m(object, i), kStill_m) << object.id << " in step " << i;
    EXPECT_LT(turned_rad(object, i), kStill_rad) << object.id << " in step " << i;
  }
}

RolloutOptions steps(int num_steps) {
  RolloutOptions rollout;
  rollout.num_steps = num_steps;
  rollout.time_step_s = kTimeStep_s;
  return rollout;
}

/// Of a network whose answer is that of its engine, so that scenes go as their hulls say.
class StandingTest : public ::testing::Test {
 protected:
  static RigidFormer make_model() {
    ModelOptions options = engine_options();
    options.centre_of_mass_head = false;  // which would guess wrongly without training
    RigidFormer model = random_model(options, torch::kFloat32);
    model->fixed_engine_share = 1.0;
    return model;
  }

  Forecast roll_out(const std::vector<ObjectState>& objects, int num_steps = kHalfSecond, double ground_m = 0.0) {
    return outcome_of({}, objects, num_steps, ground_m).forecast;
  }

  CandidateOutcome outcome_of(const Candidate& candidate, const std::vector<ObjectState>& objects,
                              int num_steps = kHalfSecond, double ground_m = 0.0) {
    BatchOptions options;
    options.rollout = steps(num_steps);
    options.rollout.ground_height_m = ground_m;
    const Perceive see = [&](const std::vector<ObjectState>& some) {
      c10::InferenceMode inference;
      return perceive(maker_.model, torch::kCPU, 256, some, options.rollout);
    };
    CandidateBatch batch(maker_, see, see(objects), objects, {}, {candidate}, options, 100);
    batch.advance(1e9);
    EXPECT_EQ(batch.outcomes()[0].message, "");
    return batch.outcomes()[0];
  }

  StepMaker maker_{make_model(), {}};
};

TEST_F(StandingTest, P59_WhatWasSeenToStandStandsThoughItsHullWouldFall) {
  for (const double ground_m : {0.0, -3.0}) {
    const ObjectState stood = carton("carton", 0.0, ground_m, kLong_s);
    ObjectState unknown = carton("carton", 0.0, ground_m, 0.0);
    unknown.T_world_previous.translation.x() += 0.001;
    expect_still(roll_out({stood}, 48, ground_m).objects[0]);
    EXPECT_GT(moved_m(roll_out({unknown}, kHalfSecond, ground_m).objects[0]), 0.01) << "without history it comes down";
  }
}

TEST_F(StandingTest, OnAShelfAndOnAStack) {
  const Forecast on_shelf = roll_out({shelf(0.0, 2.0), carton("carton", 0.0, 2.0, kLong_s)});
  expect_still(on_shelf.objects[1]);
  ObjectState low = box("low", {0, 0, 0.501}), middle = box("middle", {0, 0, 1.503});
  low.stood_s = middle.stood_s = kLong_s;
  const Forecast stack = roll_out({low, middle, carton("carton", 0.1, 2.004, kLong_s)});
  for (const ObjectTrajectory& object : stack.objects) expect_still(object);
}

TEST_F(StandingTest, WhatIsTakenToBeAtRestCanStandThoughOnlyItsFrontIsSeen) {
  const Forecast forecast = roll_out({carton("carton", 0.0, 0.0, 0.0)});
  EXPECT_LT(turned_rad(forecast.objects[0]), kStill_rad);
  ObjectState edge = carton("carton", 0.7, 2.0, 0.0);
  EXPECT_GT(moved_m(roll_out({shelf(0.0, 2.0), edge}, 24).objects[1], 24), 0.1) << "nothing is below its foot";
}

TEST_F(StandingTest, NoiseOfThePosesIsNoVelocity) {
  ObjectState noisy = carton("carton", 0.0, 0.0, kLong_s);
  noisy.T_world_previous.translation.x() -= 0.01;
  expect_still(roll_out({noisy}).objects[0]);
}

TEST_F(StandingTest, AFragmentOfWhichNobodySeesWhatCarriesItStands) {
  ObjectState fragment = carton("fragment", 0.0, 4.0, kLong_s);
  expect_still(roll_out({fragment}).objects[0]);
  fragment.stood_s = 0.0;
  EXPECT_GT(moved_m(roll_out({fragment}).objects[0]), 1.0) << "nobody has seen it stand";
}

TEST_F(StandingTest, TooShortARestIsNone) {
  EXPECT_GT(moved_m(roll_out({carton("carton", 0.0, 4.0, 0.6)}).objects[0]), 1.0) << "what is thrown up comes back";
  expect_still(roll_out({carton("carton", 0.0, 0.0, 0.4)}).objects[0]);
}

TEST_F(StandingTest, ABallThatHitsItMovesIt) {
  ObjectState ball = box("ball", {-2.5, 0.0, 0.8}, 0.4);
  ball.T_world_previous.translation.x() -= 6.0 * kTimeStep_s;
  const Forecast forecast = roll_out({carton("carton", 0.0, 0.0, kLong_s), ball}, 24);
  const ObjectTrajectory& hit = forecast.objects[0];
  EXPECT_LT(moved_m(hit, 4), 1e-6) << "the ball is not there yet";
  EXPECT_GT(moved_m(hit, 16), 0.1);
}

TEST_F(StandingTest, APassingBallDoesNotMoveIt) {
  ObjectState ball = box("ball", {0.5, -3.0, 0.8}, 0.4);
  ball.T_world_previous.translation.y() -= 8.0 * kTimeStep_s;
  expect_still(roll_out({carton("carton", 0.0, 0.0, kLong_s), ball}).objects[0]);
}

TEST_F(StandingTest, AStackIsKnockedOver) {
  ObjectState low = box("low", {0, 0, 0.501}), ball = box("ball", {-3.0, 0.0, 0.5}, 0.6);
  low.stood_s = kLong_s;
  ball.properties.mass_kg = 20.0;
  ball.T_world_previous.translation.x() -= 8.0 * kTimeStep_s;
  const Forecast forecast = roll_out({low, carton("carton", 0.0, 1.002, kLong_s), ball}, 36);
  EXPECT_GT(moved_m(forecast.objects[0], 24), 0.3) << "it is hit";
  EXPECT_GT(moved_m(forecast.objects[1], 36), 0.2) << "what carries it is";
}

TEST_F(StandingTest, ABoxOverAnEdgeFallsWhenNobodySawItStand) {
  maker_.rest.speed_mps = 0.0;  // what begins to tip over is slow enough to be held at rest, known or not
  ObjectState edge = box("box", {0.7, 0.0, 2.502});
  EXPECT_GT(turned_rad(roll_out({shelf(0.0, 2.0), edge}, 24).objects[1], 24), 0.2);
  edge.stood_s = kLong_s;
  expect_still(roll_out({shelf(0.0, 2.0), edge}, 24).objects[1]);
}

TEST_F(StandingTest, ATiltedBoxInMotionTopples) {
  ObjectState tilted = box("box", {0.0, 0.0, 0.6985});
  tilted.T_world_current.rotation = Eigen::AngleAxisd(0.95, Eigen::Vector3d::UnitY());
  tilted.T_world_previous = tilted.T_world_current;
  tilted.T_world_previous.rotation = Eigen::AngleAxisd(0.91, Eigen::Vector3d::UnitY());
  const Forecast forecast = roll_out({tilted, carton("carton", 4.0, 0.0, kLong_s)}, 24);
  EXPECT_GT(turned_rad(forecast.objects[0], 24), 0.3);
  expect_still(forecast.objects[1]);
}

TEST_F(StandingTest, WhatIsPulledAwayLetsItFall) {
  Candidate pull;
  pull.tracks = {{"shelf", {}, {}, {0.0, 0.25}, {at(0.0, 0.0, 1.5), at(5.0, 0.0, 1.5)}}};
  const std::vector<ObjectState> scene{shelf(0.0, 2.0), carton("carton", 0.0, 2.0, kLong_s)};
  EXPECT_LT(outcome_of(pull, scene, 24).forecast.objects[1].poses.back().translation.z(), 1.8);
  Candidate take;
  take.removed_ids = {"shelf"};
  EXPECT_LT(outcome_of(take, scene).forecast.objects[0].poses.back().translation.z(), 1.6);
  Candidate lower;
  lower.changes = {{"shelf", at(0.0, 0.0, 0.5), {}, {}}};
  EXPECT_LT(outcome_of(lower, scene).forecast.objects[1].poses.back().translation.z(), 1.8);
}

TEST_F(StandingTest, WhatIsPulledAwayFromUnderAStackLetsAllOfItFall) {
  ObjectState low = box("low", {0, 0, 2.501});
  low.stood_s = kLong_s;
  Candidate take;
  take.removed_ids = {"shelf"};
  const Forecast forecast = outcome_of(take, {shelf(0.0, 2.0), low, carton("carton", 0.0, 3.002, kLong_s)}).forecast;
  EXPECT_LT(forecast.objects[0].poses.back().translation.z(), 1.8);
  EXPECT_LT(forecast.objects[1].poses.back().translation.z(), 3.0);
}

TEST_F(StandingTest, WhatIsPushedOrPlacedOrThrownMoves) {
  ObjectState object = box("box", {0.0, 0.0, 0.501});
  object.stood_s = kLong_s;
  Candidate push;
  push.pushes = {{"box", 0.1, {4.0, 0.0, 0.0}, {0, 0, 0}, {0.0, 0.0, 0.0}}};
  EXPECT_GT(moved_m(outcome_of(push, {object}).forecast.objects[0]), 0.2);
  Candidate lift;
  lift.changes = {{"box", at(0.0, 0.0, 3.0), {}, {}}};
  EXPECT_GT(moved_m(outcome_of(lift, {object}).forecast.objects[0]), 1.0);
  Candidate shove;
  shove.changes = {{"box", {}, Twist{{3.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, {}}};
  EXPECT_GT(moved_m(outcome_of(shove, {object}).forecast.objects[0]), 0.2);
}

TEST_F(StandingTest, AFingerPushesIt) {
  ObjectState object = box("box", {0.0, 0.0, 0.501});
  object.stood_s = kLong_s;
  Candidate finger;
  finger.tracks = {{"finger", box_cloud(0.3), {}, {0.0, 1.0}, {at(-0.7, 0, 0.5), at(0.3, 0, 0.5)}}};
  EXPECT_GT(moved_m(outcome_of(finger, {object}, 24).forecast.objects[0], 24), 0.3);
}

TEST_F(StandingTest, ALightTouchTopplesNothing) {
  ObjectState ball = box("ball", {-0.45, 0.0, 0.25}, 0.4);
  ball.properties.mass_kg = 0.01;
  ball.T_world_previous.translation.x() -= 0.5 * kTimeStep_s;
  ObjectState object = carton("carton", 0.0, 0.0, kLong_s);
  object.properties.mass_kg = 1.0;
  EXPECT_LT(turned_rad(roll_out({object, ball}, 24).objects[0], 24), 0.1);
}

TEST_F(StandingTest, IsMoreThanBeingSlow) {
  maker_.rest.speed_mps = 0.0;  // nothing is held for that
  expect_still(roll_out({carton("carton", 0.0, 0.0, kLong_s), box("restless", {3.0, 0.0, 0.501})}).objects[0]);
}

/// The models that come with the package, on what their training never showed them.
TEST(ShippedModels, LeaveAOneSidedCartonStanding) {
  for (const char* name : {"small", "varied"}) {
    PredictorOptions options;
    options.file = std::string(RIGIDFORMER_SOURCE_DIR "/models/") + name + ".safetensors";
    options.device = "cpu";
    if (!std::filesystem::exists(options.file)) GTEST_SKIP() << options.file << " is not there";
    Predictor predictor(options);
    expect_still(predictor.predict({carton("carton", 0.0, 0.0, kLong_s)}, steps(kHalfSecond)).objects[0]);
    const Forecast shelved =
        predictor.predict({shelf(0.0, 2.0), carton("carton", 0.0, 2.0, kLong_s)}, steps(kHalfSecond));
    expect_still(shelved.objects[1]);
    ObjectState ball = box("ball", {-2.5, 0.0, 0.8}, 0.6);
    ball.T_world_previous.translation.x() -= 6.0 * kTimeStep_s;
    const Forecast hit = predictor.predict({carton("carton", 0.0, 0.0, kLong_s), ball}, steps(24));
    EXPECT_LT(moved_m(hit.objects[0], 2), 1e-6) << name;
    EXPECT_GT(moved_m(hit.objects[0], 24), 0.05) << name;
  }
}

}  // namespace
}  // namespace rigidformer
#endif
