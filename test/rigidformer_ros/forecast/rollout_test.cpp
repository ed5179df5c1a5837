// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/forecast/rollout.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <stdexcept>
#include <thread>

#include "rigidformer/length_scale.hpp"
#include "rigidformer_ros/ballistic_predictor.hpp"
#include "rigidformer_ros/test_scene.hpp"

namespace rigidformer_ros {
namespace {

using rigidformer::BallisticPredictor;
using rigidformer::ObjectState;
using testing::blob;
using testing::Flight;

// [s]. A round number within the range that BallisticPredictor states (1/240 to 1/24 s).
constexpr double kTimeStep = 0.04;

std::unique_ptr<InferenceWorker> ready_worker(PredictorFactory make) {
  auto worker = std::make_unique<InferenceWorker>(std::move(make));
  while (worker->state() == InferenceWorker::State::kLoading) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return worker;
}

ObjectState flying(const std::string& id, const Flight& flight, double dt = kTimeStep) {
  ObjectState state;
  state.id = id;
  state.points_reference = blob();
  state.T_world_previous = flight.pose(-dt);
  state.T_world_current = flight.pose(0.0);
  return state;
}

RolloutSettings settings(int steps) {
  RolloutSettings s;
  s.options.num_steps = steps;
  s.options.time_step_s = kTimeStep;
  s.settle = {0.02, 0.1, 0.25};
  return s;
}

// Makes a rollout that has one user.
RolloutOutcome roll_out(InferenceWorker& worker, const std::vector<ObjectState>& objects, const RolloutSettings& s,
                        double length_scale = 1.0) {
  SharedRollout rollout(worker, objects, s.options, length_scale, {s.options.num_steps}, JobLane::kForecast);
  return rigidformer_ros::roll_out(rollout, s);
}

rigidformer::Forecast predict_nothing(rigidformer::Predictor& predictor) { return predictor.predict({}, {}); }

// A predictor that gives the object "bad" a pose that is not finite from the third step of every call on.
class FaultyPredictor : public BallisticPredictor {
 public:
  rigidformer::Forecast predict(const std::vector<ObjectState>& objects,
                                const rigidformer::RolloutOptions& rollout) override {
    rigidformer::Forecast forecast = BallisticPredictor::predict(objects, rollout);
    for (auto& object : forecast.objects) {
      for (std::size_t k = 3; k < object.poses.size() && object.id == "bad"; ++k) {
        object.poses[k].translation.x() = std::numeric_limits<double>::quiet_NaN();
      }
    }
    return forecast;
  }
};

// A predictor that stops its own worker in the third call, as a shutdown in the middle of a rollout would.
class StoppingPredictor : public BallisticPredictor {
 public:
  explicit StoppingPredictor(const std::unique_ptr<InferenceWorker>& worker) : worker_(worker) {}
  rigidformer::Forecast predict(const std::vector<ObjectState>& objects,
                                const rigidformer::RolloutOptions& rollout) override {
    if (++calls_ == 3) {
      worker_->stop();
    }
    EXPECT_LE(calls_, 3);
    return BallisticPredictor::predict(objects, rollout);
  }

 private:
  const std::unique_ptr<InferenceWorker>& worker_;
  int calls_ = 0;
};

TEST(Rollout, StoppingTheWorkerEndsARolloutAfterItsCurrentJob) {
  std::unique_ptr<InferenceWorker> worker;
  worker = ready_worker([&] { return std::make_unique<StoppingPredictor>(worker); });
  EXPECT_THROW(roll_out(*worker, {flying("a", Flight())}, settings(1000)), std::exception);
}

TEST(Rollout, FollowsTheParabolaAcrossJobs) {
  const auto worker = ready_worker([] { return std::make_unique<BallisticPredictor>(); });
  const Flight flight;
  const RolloutOutcome outcome = roll_out(*worker, {flying("a", flight)}, settings(20));
  EXPECT_EQ(outcome.steps_done, 20);
  EXPECT_EQ(outcome.stop_reason, StopReason::kHorizon);
  ASSERT_EQ(outcome.forecast.times_s.size(), 21U);
  for (int k = 0; k <= 20; ++k) {
    EXPECT_NEAR(outcome.forecast.times_s[k], k * kTimeStep, 1e-12);
    const RigidTransform& pose = outcome.forecast.objects[0].poses[k];
    EXPECT_LT((pose.translation - flight.pose(k * kTimeStep).translation).norm(), 1e-9);
    EXPECT_LT(rigidformer::rotation_angle(pose.rotation, flight.pose(k * kTimeStep).rotation), 1e-7);
  }
}

// A predictor that notes every start and the number of steps of every advance of its rollouts.
class CountingPredictor : public BallisticPredictor {
 public:
  explicit CountingPredictor(std::vector<std::string>& calls) : calls_(calls) {}
  std::unique_ptr<rigidformer::Rollout> start(const std::vector<ObjectState>& objects,
                                              const rigidformer::RolloutOptions& rollout) override {
    calls_.push_back("start");
    return BallisticPredictor::start(objects, rollout);
  }
  rigidformer::Forecast predict(const std::vector<ObjectState>& objects,
                                const rigidformer::RolloutOptions& rollout) override {
    calls_.push_back(std::to_string(rollout.num_steps));
    return BallisticPredictor::predict(objects, rollout);
  }

 private:
  std::vector<std::string>& calls_;
};

// All jobs must belong to one rollout: what a predictor carries from step to step would be lost if each began anew.
TEST(Rollout, IsOneRolloutOfThePredictorInShortJobs) {
  std::vector<std::string> calls;
  const auto worker = ready_worker([&] { return std::make_unique<CountingPredictor>(calls); });
  roll_out(*worker, {flying("a", Flight())}, settings(20));
  EXPECT_EQ(calls, std::vector<std::string>({"start", "8", "8", "4"}));
}

TEST(Rollout, LengthScaleLeavesFreeFallUnchanged) {
  const auto worker = ready_worker([] { return std::make_unique<BallisticPredictor>(); });
  const Flight flight;
  const RolloutOutcome outcome = roll_out(*worker, {flying("a", flight)}, settings(12), /*length_scale=*/0.04);
  EXPECT_LT((outcome.forecast.objects[0].poses.back().translation - flight.pose(12 * kTimeStep).translation).norm(),
            1e-9);
  EXPECT_NEAR(outcome.forecast.times_s.back(), 12 * kTimeStep, 1e-12);
}

TEST(Rollout, AutomaticScaleBringsTheMedianObjectToTheTrainedSize) {
  const rigidformer::ModelInfo info = BallisticPredictor().info();
  ObjectState object = flying("a", Flight());
  const double scale = automatic_length_scale({object, object, object}, info);
  object.points_reference /= static_cast<float>(scale);
  EXPECT_NEAR(rigidformer::object_diameter(object.points_reference), std::sqrt(0.1 * 3.0), 1e-5);
  EXPECT_EQ(automatic_length_scale({}, info), 1.0);
}

TEST(Rollout, P16_an_object_that_is_not_finite_stands_still_and_harms_no_other) {
  const auto worker = ready_worker([] { return std::make_unique<FaultyPredictor>(); });
  const Flight flight;
  const RolloutOutcome outcome = roll_out(*worker, {flying("bad", flight), flying("good", flight)}, settings(20));
  const auto& bad = outcome.forecast.objects[0];
  EXPECT_EQ(bad.status, rigidformer::ObjectTrajectory::Status::kDiverged);
  EXPECT_EQ(bad.poses.size(), 21U);
  EXPECT_EQ(bad.poses.back().translation, bad.poses[2].translation);
  EXPECT_EQ(outcome.forecast.objects[1].status, rigidformer::ObjectTrajectory::Status::kOk);
  EXPECT_LT((outcome.forecast.objects[1].poses.back().translation - flight.pose(20 * kTimeStep).translation).norm(),
            1e-9);
  EXPECT_EQ(outcome.stop_reason, StopReason::kHorizon);
}

TEST(Rollout, StopsWhenEverythingHasDiverged) {
  const auto worker = ready_worker([] { return std::make_unique<FaultyPredictor>(); });
  const RolloutOutcome outcome = roll_out(*worker, {flying("bad", Flight())}, settings(100));
  EXPECT_EQ(outcome.stop_reason, StopReason::kDiverged);
  EXPECT_LT(outcome.steps_done, 100);
}

TEST(Rollout, StopsWhenSettledOrOutOfTime) {
  const auto worker = ready_worker([] { return std::make_unique<BallisticPredictor>(); });
  ObjectState still = flying("a", Flight());
  still.mode = rigidformer::MotionMode::kStatic;
  RolloutSettings s = settings(200);
  s.stop_when_settled = true;
  const RolloutOutcome settled = roll_out(*worker, {still}, s);
  EXPECT_EQ(settled.stop_reason, StopReason::kSettled);
  EXPECT_EQ(settled.settled_steps, std::vector<int>({0}));
  EXPECT_LT(settled.steps_done, 200);
  s = settings(100000);
  s.max_wall_time_s = 1e-9;
  EXPECT_EQ(roll_out(*worker, {flying("a", Flight())}, s).stop_reason, StopReason::kWallTime);
}

TEST(Rollout, SettledStepIsTheStartOfTheFinalRest) {
  std::vector<RigidTransform> poses(12);
  for (int k = 0; k < 4; ++k) {
    poses[k].translation.x() = 0.1 * (4 - k);
  }
  EXPECT_EQ(settled_step(poses, 0.1, {0.02, 0.1, 0.25}), 4);
  EXPECT_EQ(settled_step(poses, 0.1, {0.02, 0.1, 0.9}), -1);
  poses.back().translation.x() = 0.1;
  EXPECT_EQ(settled_step(poses, 0.1, {0.02, 0.1, 0.25}), -1);
}

TEST(InferenceWorker, P15_says_why_the_model_is_missing_and_passes_errors_on) {
  const auto failed = ready_worker(
      []() -> std::unique_ptr<rigidformer::Predictor> { throw std::runtime_error("no such file: x.safetensors"); });
  EXPECT_EQ(failed->state(), InferenceWorker::State::kFailed);
  EXPECT_NE(failed->message().find("x.safetensors"), std::string::npos);
  EXPECT_THROW(failed->run(predict_nothing, JobLane::kForecast), std::logic_error);

  class Throwing : public BallisticPredictor {
    rigidformer::Forecast predict(const std::vector<ObjectState>&, const rigidformer::RolloutOptions&) override {
      throw std::runtime_error("tensor trouble");
    }
  };
  const auto worker = ready_worker([] { return std::make_unique<Throwing>(); });
  EXPECT_THROW(worker->run(predict_nothing, JobLane::kForecast).get(), std::runtime_error);
  EXPECT_THROW(worker->run(predict_nothing, JobLane::kForecast).get(), std::runtime_error);
}

// A predictor whose warm-up lasts until the test allows it to end.
class WarmingPredictor : public BallisticPredictor {
 public:
  explicit WarmingPredictor(std::shared_future<void> warm) : warm_(std::move(warm)) {}
  void warm_up() override { warm_.wait(); }

 private:
  std::shared_future<void> warm_;
};

TEST(InferenceWorker, P17_is_ready_only_after_the_warm_up) {
  std::promise<void> warm;
  const std::shared_future<void> is_warm = warm.get_future().share();
  InferenceWorker worker([is_warm] { return std::make_unique<WarmingPredictor>(is_warm); });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(worker.state(), InferenceWorker::State::kLoading);
  EXPECT_NE(worker.message().find("warmed up"), std::string::npos);
  EXPECT_THROW(worker.run(predict_nothing, JobLane::kForecast), std::logic_error);
  warm.set_value();
  while (worker.state() == InferenceWorker::State::kLoading) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(worker.state(), InferenceWorker::State::kReady);
}

}  // namespace
}  // namespace rigidformer_ros
