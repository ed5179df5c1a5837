// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rigidformer_ros/PredictRollouts.h>

#include <string>
#include <vector>

#include "rigidformer/box_scene.hpp"
#include "rigidformer_ros/node/node_client.hpp"
#include "rigidformer_ros/services/planner_client.hpp"

namespace rigidformer_ros::testing {
namespace {

using Codes = PredictRollout::Response;

constexpr int kSteps = 8;

PhysicalProperties known_material() {
  PhysicalProperties properties;
  properties.known = PhysicalProperties::MASS | PhysicalProperties::FRICTION | PhysicalProperties::RESTITUTION;
  properties.mass = 1.0;
  properties.friction = 0.5;
  properties.restitution = 0.2;
  return properties;
}

/// Two boxes of 1 m that lie beside each other on the ground.
ObjectClouds two_boxes() {
  ObjectClouds scene;
  scene.header.stamp = ros::Time(100.0);
  scene.ids = {"left", "right"};
  for (const double x : {0.0, 1.3}) {
    scene.clouds.push_back(to_cloud(rigidformer::at(x, 0.0, 0.501).apply(rigidformer::box_cloud(1.0))));
    scene.properties.push_back(known_material());
  }
  return scene;
}

RolloutCandidate named(const std::string& name) {
  RolloutCandidate candidate;
  candidate.name = name;
  return candidate;
}

RolloutCandidate pushed(double impulse_Ns) {
  RolloutCandidate candidate = named("pushed by " + std::to_string(impulse_Ns));
  candidate.impulses.resize(1);
  candidate.impulses[0].id = "left";
  candidate.impulses[0].linear.x = impulse_Ns;
  return candidate;
}

RolloutCandidate without(const std::string& id) {
  RolloutCandidate candidate = named("without " + id);
  candidate.removed_ids = {id};
  return candidate;
}

/// A cube of 0.3 m that nobody observes drives from the left against the left box.
RolloutCandidate finger() {
  RolloutCandidate candidate = named("finger");
  candidate.kinematic.resize(1);
  KinematicTrack& track = candidate.kinematic[0];
  track.id = "finger";
  track.cloud = to_cloud(rigidformer::box_cloud(0.3));
  track.times = {0.0, 1.0};
  track.poses = {to_pose(rigidformer::at(-0.7, 0.0, 0.5)), to_pose(rigidformer::at(0.3, 0.0, 0.5))};
  return candidate;
}

BatchRequest request_of(const std::vector<RolloutCandidate>& candidates, std::uint8_t fidelity) {
  BatchRequest request;
  request.num_steps = kSteps;
  request.scene = two_boxes();
  request.candidates = candidates;
  request.fidelity = fidelity;
  request.record = BatchRequest::POSES;
  return request;
}

BatchResult ask(const BatchRequest& request) {
  PredictRollouts service;
  service.request.request = request;
  ros::ServiceClient connection =
      ros::NodeHandle().serviceClient<PredictRollouts>("predict_rollouts", /*persistent=*/true);
  EXPECT_TRUE(connection.call(service)) << "the handler must always return true";
  return service.response.result;
}

template <typename Message>
std::string bytes_of(const Message& message) {
  std::string bytes(ros::serialization::serializationLength(message), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

const ObjectOutcome& object_of(const CandidateResult& result, const std::string& id) {
  for (const ObjectOutcome& object : result.objects) {
    if (object.id == id) {
      return object;
    }
  }
  static const ObjectOutcome none;
  ADD_FAILURE() << "'" << result.name << "' lacks '" << id << "': " << result.message;
  return none;
}

class PlanningNodeTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { NodeClient().start_afresh(); }
};

TEST_F(PlanningNodeTest, P25_ServiceAndActionInAnyOrderAgree) {
  for (const std::uint8_t fidelity : {BatchRequest::MODEL, BatchRequest::ENGINE}) {
    const std::vector<RolloutCandidate> candidates = {named("as it is"), pushed(3.0), without("right"), finger()};
    const BatchResult forwards = ask(request_of(candidates, fidelity));
    ASSERT_TRUE(forwards.success) << forwards.message;
    ASSERT_EQ(forwards.results.size(), candidates.size());
    PlannerClient client("predict_rollouts", 10.0, 120.0);
    const BatchResult backwards = client.predict(request_of({candidates.rbegin(), candidates.rend()}, fidelity));
    ASSERT_EQ(backwards.results.size(), candidates.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      EXPECT_EQ(forwards.results[i].name, candidates[i].name);
      EXPECT_EQ(forwards.results[i].error_code, Codes::SUCCESS) << forwards.results[i].message;
      EXPECT_EQ(bytes_of(forwards.results[i]), bytes_of(backwards.results[candidates.size() - 1 - i])) << i;
    }
  }
}

TEST_F(PlanningNodeTest, P25_OneCandidateIsTheSingleRequest) {
  for (const RolloutCandidate& candidate : {named("as it is"), pushed(3.0), finger()}) {
    const BatchResult batch = ask(request_of({pushed(1.0), candidate}, BatchRequest::MODEL));
    ASSERT_TRUE(batch.success) << batch.message;
    PredictRollout::Request request;
    request.num_steps = kSteps;
    request.scene = two_boxes();
    request.candidate = candidate;
    const PredictRollout::Response single = NodeClient::call(request);
    ASSERT_TRUE(single.success) << single.message;
    ASSERT_EQ(single.forecast.objects.size(), batch.results[1].objects.size());
    EXPECT_EQ(single.forecast.contacts.size(), batch.results[1].contacts.size());
    for (const ObjectForecast& forecast : single.forecast.objects) {
      const ObjectOutcome& outcome = object_of(batch.results[1], forecast.id);
      ASSERT_EQ(forecast.poses.size(), outcome.poses.size());
      for (std::size_t k = 0; k < forecast.poses.size(); ++k) {
        EXPECT_EQ(bytes_of(forecast.poses[k]), bytes_of(outcome.poses[k])) << candidate.name << " step " << k;
      }
      EXPECT_EQ(forecast.first_contact_step, outcome.first_contact_step);
      EXPECT_EQ(forecast.settled_step, outcome.settled_step);
    }
  }
}

TEST_F(PlanningNodeTest, OutcomesTellWhatHappened) {
  const BatchResult result =
      ask(request_of({named("as it is"), pushed(3.0), without("right"), finger()}, BatchRequest::ENGINE));
  ASSERT_EQ(result.results.size(), 4u) << result.message;
  EXPECT_EQ(object_of(result.results[0], "left").first_contact_step, 0) << "it lies on the ground";
  EXPECT_LT(object_of(result.results[0], "left").path_length, 0.01);
  EXPECT_EQ(object_of(result.results[0], "left").poses.size(), kSteps + 1u);
  EXPECT_TRUE(std::isnan(object_of(result.results[0], "left").p_settled));
  EXPECT_GT(object_of(result.results[1], "left").end_pose.position.x, 0.05);
  EXPECT_EQ(result.results[2].objects.size(), 1u);
  EXPECT_NEAR(object_of(result.results[3], "finger").end_twist.linear.x, 1.0, 1e-3);
  EXPECT_GT(object_of(result.results[3], "left").end_pose.position.x, 0.02);
  bool has_pressed = false;
  for (const ContactEvent& contact : result.results[3].contacts) {
    const bool is_pair = (contact.id_a == "finger" && contact.id_b == "left") || contact.id_b == "finger";
    has_pressed = has_pressed || (is_pair && contact.max_normal_impulse > 0.0);
  }
  EXPECT_TRUE(has_pressed) << "the finger pressed on the box";
  const OutcomeArrays arrays = outcomes_of(result, "left");
  EXPECT_TRUE(arrays.ok.all());
  EXPECT_EQ(arrays.end_positions(1, 0), object_of(result.results[1], "left").end_pose.position.x);
  EXPECT_FALSE(outcomes_of(result, "right").ok[2]);
}

TEST_F(PlanningNodeTest, P25_ABadCandidateIsToldAndCostsTheOthersNothing) {
  RolloutCandidate late = finger(), malformed = finger(), deep = named("deep");
  late.kinematic[0].times[1] = 0.0;
  malformed.kinematic[0].cloud.data.resize(5);
  deep.overrides.resize(1);
  deep.overrides[0].id = "left";
  deep.overrides[0].fields = StateOverride::POSE;
  deep.overrides[0].pose = to_pose(rigidformer::at(1.0, 0.0, 0.6));
  const BatchResult alone = ask(request_of({pushed(3.0)}, BatchRequest::ENGINE));
  const BatchResult mixed =
      ask(request_of({late, malformed, without("nobody"), deep, pushed(3.0)}, BatchRequest::ENGINE));
  ASSERT_TRUE(mixed.success) << mixed.message;
  ASSERT_EQ(mixed.results.size(), 5u);
  EXPECT_EQ(bytes_of(mixed.results[4]), bytes_of(alone.results[0]));
  const auto expect_error = [&](std::size_t i, std::int32_t code, const std::string& word) {
    EXPECT_EQ(mixed.results[i].error_code, code) << mixed.results[i].message;
    EXPECT_EQ(mixed.results[i].stop_reason, CandidateResult::STOP_ERROR);
    EXPECT_NE(mixed.results[i].message.find(word), std::string::npos) << mixed.results[i].message;
  };
  expect_error(0, Codes::INVALID_REQUEST, "times[1]");
  expect_error(1, Codes::INVALID_REQUEST, "cloud");
  expect_error(2, Codes::UNKNOWN_OBJECT, "nobody");
  expect_error(3, Codes::INVALID_REQUEST, "deep");
}

TEST_F(PlanningNodeTest, RequestsBeyondTheLimitsAreRefusedByName) {
  const auto expect_refused = [](const BatchRequest& request, std::int32_t code, const std::string& word) {
    const BatchResult result = ask(request);
    EXPECT_FALSE(result.success);
    EXPECT_EQ(result.error_code, code) << result.message;
    EXPECT_NE(result.message.find(word), std::string::npos) << result.message;
    EXPECT_TRUE(result.results.empty());
  };
  expect_refused(request_of({}, 0), Codes::INVALID_REQUEST, "candidates");
  expect_refused(request_of(std::vector<RolloutCandidate>(41), 0), Codes::LIMIT_EXCEEDED, "service/max_candidates");
  expect_refused(request_of({named("a")}, 7), Codes::INVALID_REQUEST, "fidelity");
  BatchRequest request = request_of({named("a")}, 0);
  request.num_particles = 33;
  expect_refused(request, Codes::LIMIT_EXCEEDED, "service/max_particles");
  request = request_of({named("a")}, 0);
  request.tilt_limit = -1.0;
  expect_refused(request, Codes::INVALID_REQUEST, "tilt_limit");
  request = request_of({named("a")}, 0);
  request.object_ids = {"nobody"};
  expect_refused(request, Codes::UNKNOWN_OBJECT, "nobody");
  request = request_of({named("a")}, 0);
  request.stop.resize(1);
  request.stop[0].kind = StopCondition::LEAVE;
  request.stop[0].region = "nowhere";
  expect_refused(request, Codes::INVALID_REQUEST, "nowhere");
}

TEST_F(PlanningNodeTest, ConditionsEndCandidates) {
  BatchRequest request = request_of({named("as it is"), pushed(6.0)}, BatchRequest::ENGINE);
  request.num_steps = 48;
  request.regions.resize(1);
  request.regions[0].name = "spot";
  request.regions[0].pose = to_pose(rigidformer::at(0.0, 0.0, 0.5));
  request.regions[0].size.x = request.regions[0].size.y = 0.2;
  request.regions[0].size.z = 4.0;
  request.stop.resize(1);
  request.stop[0].kind = StopCondition::LEAVE;
  request.stop[0].ids = {"left"};
  request.stop[0].region = "spot";
  const BatchResult result = ask(request);
  ASSERT_EQ(result.results.size(), 2u) << result.message;
  EXPECT_EQ(result.results[0].stop_reason, CandidateResult::STOP_HORIZON);
  EXPECT_EQ(result.results[1].stop_reason, CandidateResult::STOP_CONDITION);
  EXPECT_EQ(result.results[1].stop_condition, 0);
  EXPECT_LT(result.results[1].steps_done, 48u);
}

TEST_F(PlanningNodeTest, ACancelledGoalKeepsWhatIsDone) {
  BatchRequest request = request_of(std::vector<RolloutCandidate>(40, pushed(3.0)), BatchRequest::MODEL);
  request.num_steps = 400;
  request.candidates[3] = without("nobody");
  actionlib::SimpleActionClient<PredictRolloutsAction> client("predict_rollouts", true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(10.0)));
  std::atomic<int> heard{0};
  PredictRolloutsGoal goal;
  goal.request = request;
  client.sendGoal(
      goal, [](const auto&, const auto&) {}, [] {}, [&](const PredictRolloutsFeedbackConstPtr&) { ++heard; });
  EXPECT_TRUE(NodeClient::wait_until([&] { return heard > 1; }, 60.0)) << "it tells how far it is";
  client.cancelGoal();
  ASSERT_TRUE(client.waitForResult(ros::Duration(60.0)));
  EXPECT_EQ(client.getState(), actionlib::SimpleClientGoalState::PREEMPTED);
  const BatchResult result = client.getResult()->result;
  ASSERT_EQ(result.results.size(), 40u);
  EXPECT_EQ(result.error_code, Codes::PREEMPTED);
  EXPECT_EQ(result.results[3].error_code, Codes::UNKNOWN_OBJECT);
  EXPECT_EQ(result.results[0].error_code, Codes::PREEMPTED);
  EXPECT_EQ(result.results[0].stop_reason, CandidateResult::STOP_PREEMPTED);
  EXPECT_LT(result.results[0].steps_done, 400u);
  EXPECT_LE(result.results[0].steps_done, result.results[39].steps_done + 1);
}

TEST_F(PlanningNodeTest, TheNodeSaysHowFastItIs) {
  GetModelInfo info;
  ASSERT_TRUE(ros::service::call("get_model_info", info));
  EXPECT_GT(info.response.model_steps_per_second, 0.0);
  EXPECT_GT(info.response.engine_steps_per_second, info.response.model_steps_per_second);
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "planning_node_test");
  const ros::NodeHandle keeps_ros_alive;
  return RUN_ALL_TESTS();
}
