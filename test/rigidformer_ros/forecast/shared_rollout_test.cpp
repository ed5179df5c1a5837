// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/forecast/shared_rollout.hpp"

#include <gtest/gtest.h>

#include <future>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "rigidformer_ros/ballistic_predictor.hpp"
#include "rigidformer_ros/forecast/rollout.hpp"
#include "rigidformer_ros/test_scene.hpp"

namespace rigidformer_ros {
namespace {

using rigidformer::BallisticPredictor;
using rigidformer::Forecast;
using rigidformer::ObjectState;
using Clock = SharedRollout::Clock;
using Status = rigidformer::ObjectTrajectory::Status;

// [s]. A round number within the range that BallisticPredictor states (1/240 to 1/24 s).
constexpr double kTimeStep = 0.04;
// A time limit that never passes: an hour is longer than any test runs.
const Clock::time_point kLongTime = Clock::now() + std::chrono::hours(1);

// A predictor that notes every job as its first object's id and its number of steps, such as "a 8". The object "bad"
// is lost at the sixth step after the observation. The second job of the object "throws" throws.
class NotingPredictor : public BallisticPredictor {
 public:
  explicit NotingPredictor(std::vector<std::string>& jobs) : jobs_(jobs) {}
  Forecast predict(const std::vector<ObjectState>& objects, const rigidformer::RolloutOptions& rollout) override {
    const std::string& id = objects.at(0).id;
    jobs_.push_back(id + " " + std::to_string(rollout.num_steps));
    if (id == "throws" && jobs_.size() == 2) {
      throw std::runtime_error("tensor trouble");
    }
    Forecast forecast = BallisticPredictor::predict(objects, rollout);
    for (int k = 1; k <= rollout.num_steps && id == "bad"; ++k) {
      if (++steps_ >= 6) {
        forecast.objects[0].poses[static_cast<std::size_t>(k)].translation.x() =
            std::numeric_limits<double>::quiet_NaN();
      }
    }
    return forecast;
  }

 private:
  std::vector<std::string>& jobs_;
  int steps_ = 0;
};

class SharedRolloutTest : public ::testing::Test {
 protected:
  void SetUp() override {
    while (worker->state() == InferenceWorker::State::kLoading) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  std::unique_ptr<SharedRollout> start(const std::string& id, std::set<int> ends, JobLane lane = JobLane::kRequest) {
    ObjectState state;
    state.id = id;
    state.points_reference = testing::blob();
    state.T_world_previous = testing::Flight().pose(-kTimeStep);
    state.T_world_current = testing::Flight().pose(0.0);
    rigidformer::RolloutOptions options;
    options.time_step_s = kTimeStep;
    return std::make_unique<SharedRollout>(*worker, std::vector<ObjectState>{state}, options, 1.0, std::move(ends),
                                           lane);
  }

  // Keeps the predictor busy until the test sets the promise of `until`.
  std::future<Forecast> occupy(std::shared_future<void> until) {
    return worker->run(
        [until](rigidformer::Predictor&) {
          until.wait();
          return Forecast();
        },
        JobLane::kForecast);
  }

  static Clock::time_point soon() { return Clock::now() + std::chrono::milliseconds(5); }

  static RolloutSettings settings(int num_steps) {
    RolloutSettings s;
    s.options.num_steps = num_steps;
    s.options.time_step_s = kTimeStep;
    s.settle = {0.02, 0.1, 0.25};
    return s;
  }

  std::vector<std::string> jobs;  // The worker's thread writes it: a test may read it only while no job is running.
  std::unique_ptr<InferenceWorker> worker =
      std::make_unique<InferenceWorker>([this] { return std::make_unique<NotingPredictor>(jobs); });
};

using Jobs = std::vector<std::string>;

TEST_F(SharedRolloutTest, AShorterRequestTakesTheFirstStepsOfTheLongerOne) {
  const auto rollout = start("a", {2, 20, 24});
  const RolloutOutcome longest = roll_out(*rollout, settings(24));
  const RolloutOutcome middle = roll_out(*rollout, settings(20));
  const RolloutOutcome shortest = roll_out(*rollout, settings(2));
  EXPECT_EQ(jobs, Jobs({"a 2", "a 6", "a 8", "a 4", "a 4"})) << "no step is made twice";
  EXPECT_EQ(longest.steps_done, 24);
  EXPECT_EQ(middle.steps_done, 20);
  EXPECT_EQ(shortest.steps_done, 2);
  for (const RolloutOutcome& outcome : {longest, middle, shortest}) {
    EXPECT_EQ(outcome.stop_reason, StopReason::kHorizon);
    const auto num_poses = static_cast<std::size_t>(outcome.steps_done) + 1;
    ASSERT_EQ(outcome.forecast.objects[0].poses.size(), num_poses);
    ASSERT_EQ(outcome.forecast.times_s.size(), num_poses);
    for (std::size_t k = 0; k < num_poses; ++k) {
      EXPECT_EQ(outcome.forecast.objects[0].poses[k].translation, longest.forecast.objects[0].poses[k].translation);
    }
  }
}

TEST_F(SharedRolloutTest, GoesOnOnlyForThoseWhoWantMore) {
  const auto rollout = start("a", {2, 500});
  roll_out(*rollout, settings(2));
  EXPECT_EQ(jobs, Jobs({"a 2"}));
}

TEST_F(SharedRolloutTest, WhoEndsBeforeAnObjectIsLostIsNotToldOfIt) {
  const auto rollout = start("bad", {4, 16});
  const RolloutOutcome longer = roll_out(*rollout, settings(16));
  EXPECT_EQ(longer.forecast.objects[0].status, Status::kDiverged);
  EXPECT_EQ(longer.stop_reason, StopReason::kDiverged);
  const RolloutOutcome shorter = roll_out(*rollout, settings(4));
  EXPECT_EQ(shorter.forecast.objects[0].status, Status::kOk);
  EXPECT_EQ(shorter.stop_reason, StopReason::kHorizon);
}

// Each of the three rollouts hands in one job and waits. After its turn a rollout goes to the end of the queue.
TEST_F(SharedRolloutTest, RequestsTakeTurns) {
  std::promise<void> go;
  const auto busy = occupy(go.get_future().share());
  const auto lasting = start("lasting", {400}), brief = start("brief", {2}), third = start("third", {24});
  EXPECT_FALSE(lasting->advance_to(8, soon()));
  EXPECT_FALSE(lasting->advance_to(8, soon())) << "still waits for its turn, and has no second job";
  EXPECT_FALSE(brief->advance_to(2, soon()));
  EXPECT_FALSE(third->advance_to(8, soon()));
  go.set_value();
  busy.wait();
  EXPECT_TRUE(third->advance_to(8, kLongTime)) << "the last of the three";
  EXPECT_EQ(jobs, Jobs({"lasting 8", "brief 2", "third 8"}));
  EXPECT_TRUE(brief->advance_to(2, Clock::now())) << "answered long before the end of the other";
  EXPECT_TRUE(lasting->advance_to(16, kLongTime));
  EXPECT_TRUE(third->advance_to(16, kLongTime));
  EXPECT_EQ(jobs, Jobs({"lasting 8", "brief 2", "third 8", "lasting 8", "third 8"}));
}

TEST_F(SharedRolloutTest, EveryOtherTurnIsTheForecasts) {
  std::promise<void> go;
  const auto busy = occupy(go.get_future().share());
  std::vector<std::unique_ptr<SharedRollout>> requests;
  for (const char* id : {"a", "b", "c"}) {
    requests.push_back(start(id, {8}));
    EXPECT_FALSE(requests.back()->advance_to(8, soon()));
  }
  const auto forecast = start("forecast", {8}, JobLane::kForecast);
  const auto newer = start("newer", {8}, JobLane::kForecast);
  EXPECT_FALSE(forecast->advance_to(8, soon()));
  EXPECT_FALSE(newer->advance_to(8, soon()));
  go.set_value();
  EXPECT_TRUE(requests.back()->advance_to(8, kLongTime));
  EXPECT_EQ(jobs, Jobs({"a 8", "forecast 8", "b 8", "newer 8", "c 8"}));
}

TEST_F(SharedRolloutTest, WhoGivesUpLeavesTheStepsToTheOthers) {
  std::promise<void> go;
  const auto busy = occupy(go.get_future().share());
  const auto rollout = start("a", {16});
  RolloutSettings impatient = settings(16);
  impatient.max_wall_time_s = 0.005;
  const RolloutOutcome nothing = roll_out(*rollout, impatient);
  EXPECT_EQ(nothing.stop_reason, StopReason::kWallTime);
  EXPECT_EQ(nothing.steps_done, 0);
  EXPECT_EQ(nothing.forecast.objects[0].poses.size(), 1U);
  go.set_value();
  EXPECT_EQ(roll_out(*rollout, settings(16)).steps_done, 16);
  EXPECT_EQ(jobs, Jobs({"a 8", "a 8"}));
}

TEST_F(SharedRolloutTest, ManyThreadsPullAlongAndNoStepIsMadeTwice) {
  const auto rollout = start("a", {40, 80, 120, 160});
  std::vector<std::future<RolloutOutcome>> outcomes;
  for (int i = 0; i < 8; ++i) {
    outcomes.push_back(
        std::async(std::launch::async, [&rollout, i] { return roll_out(*rollout, settings(40 * (i % 4 + 1))); }));
  }
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(outcomes[static_cast<std::size_t>(i)].get().steps_done, 40 * (i % 4 + 1));
  }
  EXPECT_EQ(jobs, Jobs(20, "a 8"));
}

TEST_F(SharedRolloutTest, AFailureIsToldToAllWhoWantMore) {
  const auto rollout = start("throws", {8, 16});
  EXPECT_THROW(roll_out(*rollout, settings(16)), std::runtime_error);
  EXPECT_THROW(roll_out(*rollout, settings(16)), std::runtime_error);
  EXPECT_EQ(roll_out(*rollout, settings(8)).steps_done, 8);
  EXPECT_EQ(jobs.size(), 2U);
}

TEST_F(SharedRolloutTest, WhenTheWorkerStopsNobodyWaitsOn) {
  std::promise<void> go;
  const auto busy = occupy(go.get_future().share());
  const auto rollout = start("a", {16});
  EXPECT_FALSE(rollout->advance_to(8, Clock::now() + std::chrono::milliseconds(5)));
  worker->stop();
  try {
    rollout->advance_to(8, kLongTime);
    ADD_FAILURE() << "there can be no more steps";
  } catch (const std::exception& error) {
    EXPECT_STREQ(error.what(), "the rollout was ended: the node shuts down");
  }
  go.set_value();
}

}  // namespace
}  // namespace rigidformer_ros
