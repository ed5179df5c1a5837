// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rigidformer/box_scene.hpp"
#include "rigidformer/engine/cubes.hpp"
#include "rigidformer/model/given_motion.hpp"
#include "rigidformer/rollout_world.hpp"

#ifdef RIGIDFORMER_HAS_SIMULATION
namespace rigidformer {
namespace {

using Rows = std::vector<std::int64_t>;

RolloutOptions steps_of(int num_steps) {
  RolloutOptions rollout;
  rollout.num_steps = num_steps;
  rollout.time_step_s = kTimeStep_s;
  return rollout;
}

RigidFormer model_of(bool engine) {
  ModelOptions options = engine_options();
  options.engine_motion = engine;
  options.contact_tokens = !engine;
  options.centre_of_mass_head = false;  // which would guess wrongly without training
  return random_model(options, torch::kFloat32);
}

/// A forecast with the objects that the network saw in every step.
struct Seen {
  Forecast forecast;
  std::vector<Rows> seen;

  double coordinate(std::size_t k, std::size_t step, int axis) const {
    return forecast.objects[k].poses[step].translation[axis];
  }
  bool moved(std::size_t k, std::size_t from, std::size_t to) const {
    const RigidTransform &a = forecast.objects[k].poses[from], &b = forecast.objects[k].poses[to];
    return a.translation != b.translation || a.rotation.coeffs() != b.rotation.coeffs();
  }
  /// Impulse between two objects in a step; NaN where they do not touch.
  double impulse(int a, int b, int step) const {
    for (const StepContact& contact : forecast.contacts) {
      if (contact.step == step && contact.object_a == a && contact.object_b == b) return contact.normal_impulse_Ns;
    }
    return std::nan("");
  }
};

/// A network whose answer is that of its engine, so that scenes go as they should.
Seen roll_out(const std::vector<ObjectState>& objects, const Candidate& candidate, int num_steps,
              double rest_speed_mps = 0.1) {
  c10::InferenceMode inference;
  RigidFormer model = model_of(true);
  model->fixed_engine_share = 1.0;
  const RolloutOptions rollout = steps_of(num_steps);
  Seen run;
  StepMaker maker{model, {}};
  maker.rest.speed_mps = rest_speed_mps;
  RolloutWorld world(maker, perceive(model, torch::kCPU, 256, objects, rollout),
                     candidate_objects(candidate, objects, kTimeStep_s), rollout, run.forecast);
  for (int i = 0; i < num_steps; ++i) {
    world.step();
    run.seen.push_back(world.seen());
  }
  return run;
}

/// Two boxes on each other, one that is far away, and one that is thrown so that it comes down on the two after 3 s.
Seen thrown_on_a_stack(int num_steps) {
  const std::vector<ObjectState> objects{box("low", {0, 0, 0.501}), box("high", {0, 0, 1.503}),
                                         box("far", {0, 9, 0.501}), box("thrown", {-15, 0, 2.5})};
  Candidate candidate;
  candidate.changes = {{"thrown", {}, Twist{{5.0, 0.0, 15.0}, {0.0, 0.0, 0.0}}, {}}};
  return roll_out(objects, candidate, num_steps);
}

TEST(NetworkSleep, EverybodyTogetherIsTheNetworkOnTheWholeScene) {
  c10::InferenceMode inference;
  for (const bool engine : {true, false}) {
    RigidFormer model = model_of(engine);
    const std::vector<ObjectState> objects{box("a", {0, 0, 0.5}), box("b", {1.1, 0, 0.5}), box("c", {0, 1, 1.4})};
    const PerceivedObjects perceived = perceive(model, torch::kCPU, 256, objects, steps_of(1));
    const SceneState state = make_scene_state(objects, perceived.origin_world);
    const StepPrediction whole =
        model->forward(perceived.batch, state, perceived.centre, nearest_search(perceived),
                       engine ? make_engine_step(perceived.batch, perceived.solids, 1, Sleep::kNever) : EngineStep(),
                       make_contact_search(model->options, perceived.batch, perceived.solids));
    SceneState here = state;
    here.coming = coming_pose(state);
    const StepPrediction steps = NetworkSteps(model, perceived).predict(here, everybody(3));
    EXPECT_TRUE(torch::equal(steps.pose.rotation, whole.pose.rotation));
    EXPECT_TRUE(torch::equal(steps.pose.translation, whole.pose.translation));
    EXPECT_TRUE(torch::equal(steps.departure.translation, whole.departure.translation));
  }
}

TEST(NetworkSleep, APartIsTheNetworkOnASceneOfThatPart) {
  c10::InferenceMode inference;
  for (const bool engine : {true, false}) {
    RigidFormer model = model_of(engine);
    const std::vector<ObjectState> objects{box("a", {0, 0, 0.5}), box("b", {0.1, 0.1, 1.503}), box("c", {1, 1, 3})};
    const PerceivedObjects scene = perceive(model, torch::kCPU, 256, objects, steps_of(1));
    SceneState state = make_scene_state(objects, scene.origin_world);
    state.coming = state.current;
    NetworkSteps steps(model, scene);
    const StepPrediction part = steps.predict(state, {{false, true, true}, {1, 2}});
    PerceivedObjects two = gather({&scene, &scene}, {1, 2}, scene);
    for (std::size_t i = 0; i < 2; ++i) two.solids[i].object = static_cast<std::int64_t>(i);
    const SceneState of_two = make_scene_state({objects[1], objects[2]}, scene.origin_world);
    const StepPrediction alone = NetworkSteps(model, two).predict(of_two, everybody(2));
    EXPECT_TRUE(torch::equal(part.pose.translation.slice(1, 1), alone.pose.translation));
    EXPECT_TRUE(torch::equal(part.departure.rotation.slice(1, 1), alone.departure.rotation));
    EXPECT_TRUE(torch::equal(part.pose.rotation.select(1, 0), state.current.rotation.select(1, 0)));
    for (const PressedPair& pair : steps.pressed()) EXPECT_GT(pair.object, 0);
  }
}

TEST(NetworkSleep, WhereNobodyRestsNothingChanges) {
  const std::vector<ObjectState> objects{box("a", {0, 0, 6}), box("b", {0.2, 0, 8}), box("c", {4, 0, 7})};
  const Seen held = roll_out(objects, {}, 20), never_held = roll_out(objects, {}, 20, 0.0);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(held.seen[i], (Rows{0, 1, 2})) << i;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i <= 20; ++i) {
      EXPECT_EQ(held.forecast.objects[k].poses[i].translation, never_held.forecast.objects[k].poses[i].translation);
      EXPECT_EQ(held.forecast.objects[k].poses[i].rotation.coeffs(),
                never_held.forecast.objects[k].poses[i].rotation.coeffs());
    }
  }
}

TEST(NetworkSleep, AStackWakesInTheStepInWhichItIsHit) {
  const Seen run = thrown_on_a_stack(96);
  int hit = 0;
  while (hit <= 96 && std::isnan(run.impulse(3, 1, hit)) && std::isnan(run.impulse(3, 0, hit))) ++hit;
  ASSERT_GT(hit, 60);
  ASSERT_LE(hit, 90);
  const auto step = static_cast<std::size_t>(hit);
  EXPECT_FALSE(run.moved(0, 1, step - 1));
  EXPECT_FALSE(run.moved(1, 1, step - 1));
  EXPECT_TRUE(run.moved(1, step - 1, step)) << "in the step of the first contact";
  EXPECT_GT((run.forecast.objects[1].poses[step + 6].translation - at(0, 0, 1.503).translation).norm(), 0.05);
  EXPECT_FALSE(run.moved(2, 1, 96)) << "nothing comes to what is far away";
}

TEST(NetworkSleep, TheNetworkSeesWhatMovesAndWhatIsNear) {
  const Seen run = thrown_on_a_stack(96);
  EXPECT_EQ(run.seen[0].size(), 4U) << "nobody sleeps yet";
  for (std::size_t i = 2; i < 60; ++i) EXPECT_EQ(run.seen[i], Rows{3}) << i;
  const auto sees_stack = [](const Rows& rows) { return rows == Rows{0, 1, 3}; };
  EXPECT_TRUE(std::any_of(run.seen.begin(), run.seen.end(), sees_stack));
}

TEST(NetworkSleep, SleepersStillTouchAndPress) {
  const Seen run = thrown_on_a_stack(50);
  EXPECT_NEAR(run.impulse(0, -1, 45), 2.0 * 10.0 * kTimeStep_s, 0.2) << "two boxes of 1 kg on the ground";
  EXPECT_EQ(run.impulse(0, -1, 45), run.impulse(0, -1, 2));
  EXPECT_EQ(run.impulse(1, 0, 45), run.impulse(1, 0, 2));
}

TEST(NetworkSleep, ABoxIsPushedIntoSleepersAsIfTheyWereAwake) {
  const std::vector<ObjectState> objects{box("a", {0, 0, 0.501}), box("b", {1.3, 0, 0.501}), box("c", {2.7, 0, 0.501}),
                                         box("d", {0, 6, 0.501})};
  Candidate candidate;
  candidate.pushes = {{"a", 0.5, {5.0, 0.0, 0.0}, {0, 0, 0}, {0.0, 0.0, 0.0}}};
  const Seen run = roll_out(objects, candidate, 48), awake = roll_out(objects, candidate, 48, 0.0);
  EXPECT_EQ(run.seen[6], Rows{}) << "all sleep";
  EXPECT_EQ(run.seen[12], (Rows{0, 1})) << "the third one is farther away";
  EXPECT_GT(run.coordinate(2, 48, 0), 3.0);
  EXPECT_FALSE(run.moved(3, 1, 48));
  // Half a second after the push; later, what is held stops a little earlier.
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(run.coordinate(k, 24, 0), awake.coordinate(k, 24, 0), 0.05) << k;
}

TEST(NetworkSleep, WhatFallsOntoASleepingTableDoesNotSinkIn) {
  std::vector<ObjectState> objects{box("table", {0, 0, 0.5}), box("cup", {0, 0, 4}, 0.5), box("other", {7, 0, 0.501})};
  objects[0].mode = MotionMode::kStatic;
  const Seen run = roll_out(objects, {}, 30);
  EXPECT_EQ(run.seen[3], Rows{1});
  EXPECT_FALSE(std::isnan(run.impulse(1, 0, 18))) << "it falls by 2.75 m";
  EXPECT_EQ(run.seen[18], (Rows{0, 1}));
  for (std::size_t i = 0; i <= 30; ++i) EXPECT_GT(run.coordinate(1, i, 2), 1.2) << i;
  EXPECT_FALSE(run.moved(0, 1, 30));
}

}  // namespace
}  // namespace rigidformer
#endif
