// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/baselines/physics_engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "rigidformer/baselines/engine_scenes.hpp"

namespace rigidformer {
namespace {

constexpr double kDegrees = 180.0 / M_PI;  // degrees in a radian

/// Properties that hold for every engine.
class PhysicsEngine : public testing::TestWithParam<std::string> {
 protected:
  std::vector<std::vector<RigidTransform>> forecast(const std::vector<ObjectState>& objects,
                                                    const RolloutOptions& rollout,
                                                    const std::vector<GivenTrack>& tracks = {}) {
    return engine_->forecast(objects, rollout, tracks);
  }

  void SetUp() override {
    try {
      engine_ = make_physics_engine(GetParam());
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
  }

  std::unique_ptr<Forecaster> engine_;
};

TEST_P(PhysicsEngine, HasItsName) { EXPECT_EQ(engine_->name(), GetParam()); }

TEST_P(PhysicsEngine, FliesAParabolaWithConstantSpinAtEveryStepSize) {
  const Flight flight{{1.0, -2.0, 8.0}, {0.5, 2.0, 3.0}, {1.0, -2.0, 0.5}};
  for (const int frames : {1, 5, 10}) {
    const RolloutOptions rollout = rollout_of(frames, 100 / frames);
    const auto poses = forecast({flying_object(box_cloud({0.8, 0.8, 0.8}), flight, rollout)}, rollout);
    ASSERT_EQ(poses.size(), 1U);
    ASSERT_EQ(poses[0].size(), static_cast<std::size_t>(rollout.num_steps) + 1);
    for (std::size_t k = 0; k < poses[0].size(); ++k) {
      const RigidTransform truth = flight.at(static_cast<double>(k) * rollout.time_step_s);
      EXPECT_LT((poses[0][k].translation - truth.translation).norm(), 1e-3) << frames << " frames, step " << k;
      EXPECT_LT(rotation_angle(poses[0][k].rotation, truth.rotation) * kDegrees, 0.1)
          << frames << " frames, step " << k;
    }
  }
}

TEST_P(PhysicsEngine, TurnsAboutTheCloudAndNotAboutTheReferenceOrigin) {
  // The origin lies 1 m beside the cube, whose turning must not move its centre off the parabola.
  const Eigen::Vector3d beside(1.0, 0.0, 0.0);
  const Flight centre{{0.0, 0.0, 6.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 3.0}};
  const RolloutOptions rollout = rollout_of(10, 10);
  ObjectState object = flying_object(box_cloud({0.5, 0.5, 0.5}, beside), centre, rollout);
  for (RigidTransform* pose : {&object.T_world_previous, &object.T_world_current}) {
    pose->translation -= pose->rotation * beside;
  }
  const auto poses = forecast({object}, rollout);
  const RigidTransform truth = centre.at(10 * rollout.time_step_s);
  EXPECT_LT((poses[0][10] * beside - truth.translation).norm(), 1e-3);
  EXPECT_LT(rotation_angle(poses[0][10].rotation, truth.rotation) * kDegrees, 0.1);
}

TEST_P(PhysicsEngine, ACubeAtRestStaysAtRestOnAnyGround) {
  // The ball starts half a millimetre up: Bullet's bodies float by their margin of a
  // millimetre, MuJoCo's sink in a little.
  for (const int frames : {1, 10}) {
    for (const double ground : {0.0, -0.7}) {
      RolloutOptions rollout = rollout_of(frames, 240 / frames);
      rollout.ground_height_m = ground;
      const auto poses = forecast(
          {resting_object(box_cloud({0.6, 0.6, 0.6}), {0.4, -0.2, ground + 0.3005}, {{1.0}, {0.5}, {0.5}})}, rollout);
      for (const RigidTransform& pose : poses[0]) {
        EXPECT_LT((pose.translation - poses[0][0].translation).norm(), 1e-3) << frames << " frames per step";
        EXPECT_LT(rotation_angle(pose.rotation, poses[0][0].rotation) * kDegrees, 0.5) << frames << " frames per step";
      }
    }
  }
}

/// Height of the rebound over the height of the drop, for a ball that falls for about half a second.
double rebound_ratio(Forecaster& engine, double drop, double object_restitution) {
  const double radius = 0.4;
  const RolloutOptions rollout = rollout_of(1, 270);
  const Flight fall{{0.0, 0.0, radius + drop}, Eigen::Vector3d::Zero()};
  const BodyProperties properties{{1.0}, {0.5}, {object_restitution}};
  const auto poses = engine.forecast({flying_object(sphere_cloud(radius), fall, rollout, properties)}, rollout);
  double highest = 0.0;
  for (std::size_t k = 130; k < poses[0].size(); ++k) {
    highest = std::max(highest, poses[0][k].translation.z() - radius);
  }
  return highest / drop;
}

TEST_P(PhysicsEngine, ReboundsToTheSquareOfTheRestitution) {
  for (const double restitution : {0.25, 0.4, 0.5}) {
    // The impact falls somewhere between two solver steps: drops are tried that differ by fractions of such a step.
    double mean = 0.0;
    for (const double drop : {1.25, 1.2555, 1.261, 1.2665}) {
      const double ratio = rebound_ratio(*engine_, drop, restitution / 0.5);  // the floor's restitution is 0.5
      EXPECT_NEAR(std::sqrt(ratio), restitution, 0.06) << "drop " << drop;
      mean += ratio / 4.0;
    }
    EXPECT_NEAR(std::sqrt(mean), restitution, 0.035);
  }
}

TEST_P(PhysicsEngine, SlidesOnTheGroundThatIsToldElseOnMovis) {
  RolloutOptions rollout = rollout_of(10, 12);
  const Flight push{{0.0, 0.0, 0.3005}, {2.0, 0.0, 0.0}, Eigen::Vector3d::Zero(), 0.0};
  const auto slid_m = [&](const GroundProperties& ground) {
    rollout.ground = ground;
    const ObjectState cube = flying_object(box_cloud({0.6, 0.6, 0.6}), push, rollout, {{1.0}, {0.5}, {0.0}});
    return forecast({cube}, rollout)[0].back().translation.x();
  };
  const double t = 12 * rollout.time_step_s;
  EXPECT_NEAR(slid_m({1.0, 0.5}), 2.0 * 2.0 / (2.0 * 0.5 * 10.0), 0.06);  // it stops
  EXPECT_NEAR(slid_m({0.2, 0.5}), 2.0 * t - 0.5 * 0.1 * 10.0 * t * t, 0.06);
  EXPECT_EQ(slid_m({}), slid_m({0.3, 0.5}));
}

TEST_P(PhysicsEngine, AMidAirCollisionConservesMomentum) {
  const RolloutOptions rollout = rollout_of(1, 120);
  const BodyProperties light{{1.0}, {0.4}, {0.6}};
  const BodyProperties heavy{{3.0}, {0.4}, {0.6}};
  const Points cube = box_cloud({0.7, 0.7, 0.7});
  const Flight left{{-1.0, 0.1, 5.0}, {4.0, 0.0, 2.0}, {0.3, 1.0, 0.2}};
  const Flight right{{1.0, -0.1, 5.1}, {-2.0, 0.0, 2.0}, {0.0, -1.0, 0.5}};
  const auto poses =
      forecast({flying_object(cube, left, rollout, light), flying_object(cube, right, rollout, heavy)}, rollout);
  const double t = 120 * rollout.time_step_s;
  EXPECT_GT((poses[0][120].translation - left.at(t).translation).norm(), 0.3) << "they did not meet";
  const auto velocity = [&](int i) {
    return Eigen::Vector3d((poses[i][120].translation - poses[i][119].translation) / rollout.time_step_s);
  };
  const Eigen::Vector3d gravity(0.0, 0.0, -10.0);
  const Eigen::Vector3d before = 1.0 * left.velocity + 3.0 * right.velocity;
  const Eigen::Vector3d after = 1.0 * velocity(0) + 3.0 * velocity(1) - 4.0 * gravity * (t - 0.5 * rollout.time_step_s);
  EXPECT_LT((after - before).norm(), 0.01 * before.norm());
}

TEST_P(PhysicsEngine, HullsThatOverlapAtTheStartAreNotShotApart) {
  const RolloutOptions rollout = rollout_of(10, 10);
  const Points cube = box_cloud({0.6, 0.6, 0.6});
  const auto poses = forecast({resting_object(cube, {0.0, 0.0, 0.3}), resting_object(cube, {0.45, 0.0, 0.3})}, rollout);
  for (int i = 0; i < 2; ++i) {
    EXPECT_LT((poses[i][10].translation - poses[i][0].translation).norm(), 0.2) << "object " << i;
  }
}

TEST_P(PhysicsEngine, OrderDoesNotMatterInFreeFlight) {
  const RolloutOptions rollout = rollout_of(5, 10);
  std::vector<ObjectState> objects;
  for (int i = 0; i < 4; ++i) {
    const Flight flight{{3.0 * i, 0.0, 6.0}, {0.1 * i, 1.0, 0.0}, {0.5, 0.3 * i, 1.0}};
    objects.push_back(flying_object(box_cloud({0.5, 0.6 + 0.1 * i, 0.7}), flight, rollout));
  }
  const auto forward = forecast(objects, rollout);
  std::reverse(objects.begin(), objects.end());
  auto backward = forecast(objects, rollout);
  std::reverse(backward.begin(), backward.end());
  for (std::size_t i = 0; i < forward.size(); ++i) {
    EXPECT_LT((forward[i][10].translation - backward[i][10].translation).norm(), 1e-9);
    EXPECT_LT(rotation_angle(forward[i][10].rotation, backward[i][10].rotation), 1e-6);
  }
}

TEST_P(PhysicsEngine, TakesFlatCloudsAndFourPoints) {
  const RolloutOptions rollout = rollout_of(10, 10);
  const Flight flight{{0.0, 0.0, 6.0}, {1.0, 0.0, 0.0}};
  Points line = Points::Zero(5, 3);
  line.col(0).setLinSpaced(-0.3F, 0.3F);
  Points tetrahedron(4, 3);
  tetrahedron << -0.1F, -0.1F, -0.1F, 0.3F, -0.1F, -0.1F, -0.1F, 0.3F, -0.1F, -0.1F, -0.1F, 0.3F;
  for (const Points& points : {box_cloud({0.5, 0.5, 0.0}), line, tetrahedron, Points(Points::Zero(4, 3))}) {
    const auto poses = forecast({flying_object(points, flight, rollout)}, rollout);
    EXPECT_LT((poses[0][10].translation - flight.at(10 * rollout.time_step_s).translation).norm(), 1e-3);
  }
}

TEST_P(PhysicsEngine, RefusesWhatItCannotSimulate) {
  const RolloutOptions rollout = rollout_of(10, 10);
  ObjectState object = resting_object(box_cloud({0.6, 0.6, 0.6}), {0.0, 0.0, 0.3});
  RolloutOptions bad = rollout;
  bad.num_steps = 0;
  EXPECT_THROW(forecast({object}, bad), std::invalid_argument);
  bad = rollout;
  bad.time_step_s = 0.0;
  EXPECT_THROW(forecast({object}, bad), std::invalid_argument);
  bad = rollout;
  bad.ground_height_m.reset();
  EXPECT_THROW(forecast({object}, bad), std::invalid_argument);
  object.points_reference = Points::Zero(3, 3);
  EXPECT_THROW(forecast({object}, rollout), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Engines, PhysicsEngine, testing::ValuesIn(physics_engine_names()),
                         [](const auto& engine) { return engine.param; });

TEST_P(PhysicsEngine, P41_StaticObjectsStayInTheAirAndCarryOthers) {
  const RolloutOptions rollout = rollout_of(10, 10);
  ObjectState table = resting_object(box_cloud({1.0, 1.0, 0.2}), {0.0, 0.0, 1.0});
  table.id = "table";
  table.mode = MotionMode::kStatic;
  const ObjectState cube = resting_object(box_cloud({0.4, 0.4, 0.4}), {0.0, 0.0, 1.3});
  const auto poses = forecast({table, cube}, rollout);
  EXPECT_EQ(poses[0].back().translation.z(), 1.0);
  EXPECT_NEAR(poses[1].back().translation.z(), 1.3, 0.03);
}

TEST_P(PhysicsEngine, KinematicObjectsFollowTheirTrackAndPush) {
  const RolloutOptions rollout = rollout_of(10, 12);
  ObjectState pusher = resting_object(box_cloud({0.2, 0.4, 0.4}), {-0.5, 0.0, 0.3});
  pusher.id = "pusher";
  pusher.mode = MotionMode::kKinematic;
  GivenTrack track;
  track.id = "pusher";
  track.times_s = {0.0, 0.1, 0.4};
  for (const double x : {-0.5, -0.5, 0.4}) {
    track.T_world_reference.push_back({Eigen::Quaterniond::Identity(), {x, 0.0, 0.3}});
  }
  const ObjectState cube = resting_object(box_cloud({0.4, 0.4, 0.4}), {0.0, 0.0, 0.2});
  const auto poses = forecast({pusher, cube}, rollout, {track});
  EXPECT_NEAR(poses[0][12].translation.x(), 0.4, 1e-9);
  EXPECT_NEAR(poses[0][6].translation.x(), -0.05, 1e-9);
  EXPECT_NEAR(poses[1][2].translation.x(), 0.0, 1e-3) << "not touched yet";
  EXPECT_GT(poses[1][12].translation.x(), 0.68) << "pushed to 0.7 m, with the pusher 0.2 m thick";
}

TEST_P(PhysicsEngine, KinematicObjectsWithoutATrackKeepTheirTwist) {
  const RolloutOptions rollout = rollout_of(10, 4);
  ObjectState palm = resting_object(box_cloud({1.0, 1.0, 0.2}), {0.0, 0.0, 1.0});
  palm.mode = MotionMode::kKinematic;
  palm.T_world_previous.translation.z() = 0.99;
  const auto poses = forecast({palm}, rollout);
  EXPECT_NEAR(poses[0][4].translation.z(), 1.04, 1e-9);
}

TEST(PhysicsEngineNames, UnknownOnesAreRefused) { EXPECT_THROW(make_physics_engine("newton"), std::invalid_argument); }

}  // namespace
}  // namespace rigidformer
