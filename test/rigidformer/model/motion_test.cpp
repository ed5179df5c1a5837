// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "random_scene.hpp"
#include "rigidformer/model/features.hpp"

namespace rigidformer {
namespace {

const auto kWide = torch::TensorOptions(torch::kFloat64);

Tensor vec3(double x, double y, double z) { return torch::tensor({x, y, z}, kWide); }

/// Turn about a unit axis [3, 3].
Tensor rotation_about(const Tensor& axis, double angle) {
  const Tensor a = axis / axis.norm();
  const double x = a[0].item<double>(), y = a[1].item<double>(), z = a[2].item<double>();
  const Tensor K = torch::tensor({0.0, -z, y, z, 0.0, -x, -y, x, 0.0}, kWide).view({3, 3});
  return torch::eye(3, kWide) + std::sin(angle) * K + (1.0 - std::cos(angle)) * torch::matmul(K, K);
}

/// A body that spins at a constant rate about its centre, which follows a parabola.
struct FreeFlight {
  Tensor centre_reference = vec3(0.1, -0.2, 0.3), start = vec3(1.0, 2.0, 3.0), velocity = vec3(2.0, -1.0, 4.0);
  Tensor axis = vec3(1.0, -2.0, 0.5), R0 = rotation_about(vec3(0.3, 1.0, 0.2), 0.7);
  double rate = 5.0, gravity = -10.0;

  Pose at(double t) const {
    const Tensor R = torch::matmul(rotation_about(axis, rate * t), R0);
    const Tensor centre = start + velocity * t + vec3(0.0, 0.0, 0.5 * gravity * t * t);
    return {R.view({1, 1, 3, 3}), (centre - torch::matmul(R, centre_reference)).view({1, 1, 3})};
  }
};

/// Centres of spheres that stand still or move in straight lines, for the contact gate.
struct Spheres {
  SceneBatch batch;
  BaseMotion base;
  Tensor radius;

  Spheres(const Tensor& centre, const Tensor& step, double ground = kNoGround, double sphere_radius = 0.5) {
    const std::int64_t K = centre.size(0);
    batch.points_reference = torch::zeros({1, K, 1, 3}, kWide);
    batch.object_mask = torch::ones({1, K}, torch::kBool);
    batch.ground_height = torch::full({1}, ground, kWide);
    base.centre = centre.unsqueeze(0);
    base.centre_step = step.unsqueeze(0);
    radius = torch::full({1, K}, sphere_radius, kWide);
  }

  std::vector<bool> gate(double margin) const {
    const Tensor open = contact_gate(batch, base, radius, margin)[0];
    std::vector<bool> values;
    for (std::int64_t k = 0; k < open.size(0); ++k) values.push_back(open[k].item<bool>());
    return values;
  }
};

TEST(BaseMotion, PaperFormContinuesEveryPointOnItsLine) {
  const RandomScene scene = random_scene(1, {{9, 7}, {8}});
  const ModelOptions options = model_preset("tiny");
  const BaseMotion base = make_base_motion(options, scene.batch, scene.state, torch::zeros({2, 2, 3}, kWide));
  const Tensor& points = scene.batch.points_reference;
  const Tensor expected = 2.0 * scene.state.current.apply(points) - scene.state.previous.apply(points);
  const Tensor there = scene.batch.dynamic_mask.unsqueeze(-1).unsqueeze(-1);
  EXPECT_TRUE(torch::equal(base.apply(points) * there, expected * there));
}

TEST(BaseMotion, InertialFormIsSpinAndParabola) {
  const FreeFlight flight;
  RandomScene scene = random_scene(2, {{9}});
  ModelOptions options = model_preset("tiny");
  options.inertial_base_motion = true;
  for (const double s : {1.0, 4.0, 10.0}) {
    const double dt = s / kFrameRateHz;
    scene.batch.step_size.fill_(s);
    scene.state = {flight.at(0.0), flight.at(0.3 - dt), flight.at(0.3)};
    const BaseMotion base =
        make_base_motion(options, scene.batch, scene.state, flight.centre_reference.view({1, 1, 3}));
    const Pose expected = flight.at(0.3 + dt);
    EXPECT_LT(largest_difference(base.pose.rotation, expected.rotation), 1e-12);
    EXPECT_LT(largest_difference(base.pose.translation, expected.translation), 1e-12);
    EXPECT_LT(
        largest_difference(base.apply(scene.batch.points_reference), expected.apply(scene.batch.points_reference)),
        1e-12);
  }
}

TEST(BaseMotion, GravityPullsOnlyDynamicObjects) {
  RandomScene scene = random_scene(3, {{9, 9}});
  scene.state.previous = scene.state.current;  // the bodies rest
  scene.batch.dynamic_mask[0][1] = false;
  ModelOptions options = model_preset("tiny");
  options.inertial_base_motion = true;
  const BaseMotion base = make_base_motion(options, scene.batch, scene.state, torch::zeros({1, 2, 3}, kWide));
  const double dt = scene.batch.time_step().item<double>();
  const Tensor step = base.pose.translation - scene.state.current.translation;
  EXPECT_LT(largest_difference(step[0][0], vec3(0.0, 0.0, -10.0 * dt * dt)), 1e-12);
  EXPECT_LT(largest_difference(step[0][1], vec3(0.0, 0.0, 0.0)), 1e-12);
}

TEST(ContactGate, OpensExactlyAtTheReachOfSweptSpheres) {
  // The closest approach of the two lines is 2 m, half-way through the step; the radii sum to 1 m.
  const Spheres pair(torch::stack({vec3(-3, 0, 9), vec3(3, 2, 9)}), torch::stack({vec3(6, 0, 0), vec3(-6, 0, 0)}));
  EXPECT_EQ(pair.gate(0.999), (std::vector<bool>{false, false}));
  EXPECT_EQ(pair.gate(1.001), (std::vector<bool>{true, true}));
  // When the spheres part, the closest approach is now.
  const Spheres parting(torch::stack({vec3(0, 0, 9), vec3(1.5, 0, 9)}), torch::stack({vec3(-9, 0, 0), vec3(9, 0, 0)}));
  EXPECT_EQ(parting.gate(0.499), (std::vector<bool>{false, false}));
  EXPECT_EQ(parting.gate(0.501), (std::vector<bool>{true, true}));
}

TEST(ContactGate, GroundCountsForTheLowestPointOfTheStep) {
  const Spheres falling(vec3(0, 0, 2).unsqueeze(0), vec3(0, 0, -0.5).unsqueeze(0), 0.0);
  EXPECT_FALSE(falling.gate(0.999)[0]);  // the bottom ends at 2 - 0.5 - 0.5 = 1 m
  EXPECT_TRUE(falling.gate(1.001)[0]);
  const Spheres rising(vec3(0, 0, 2).unsqueeze(0), vec3(0, 0, 5).unsqueeze(0), 0.0);
  EXPECT_FALSE(rising.gate(1.499)[0]);  // the bottom starts at 1.5 m
  EXPECT_TRUE(rising.gate(1.501)[0]);
}

TEST(ContactGate, IsSymmetricAndIgnoresPadding) {
  torch::manual_seed(8);
  int open = 0;
  for (int i = 0; i < 200; ++i) {
    Spheres pair(torch::randn({2, 3}, kWide), torch::randn({2, 3}, kWide));
    const std::vector<bool> gate = pair.gate(0.1);
    EXPECT_EQ(gate[0], gate[1]);
    open += gate[0];
    pair.batch.object_mask[0][1] = false;
    EXPECT_EQ(pair.gate(0.1), (std::vector<bool>{false, false}));
  }
  EXPECT_GT(open, 10);
  EXPECT_LT(open, 190);
}

TEST(ContactGate, FreeFlightIsExactlyTheBaseMotion) {
  RandomScene scene = random_scene(4, {{12, 12}});
  const Tensor apart = torch::stack({vec3(-20, 0, 30), vec3(20, 0, 30)}).unsqueeze(0);
  const Tensor shift = apart - scene.state.current.translation;
  for (Pose* pose : {&scene.state.previous, &scene.state.current}) pose->translation = pose->translation + shift;
  const ModelOptions options = contact_aware(model_preset("tiny"));
  RigidFormer model = random_model(options);
  const Tensor centre = model->centre_of_mass(scene.batch, scene.state.current);
  const BaseMotion base = make_base_motion(options, scene.batch, scene.state, centre);
  const StepPrediction gated = predict(model, scene);
  EXPECT_TRUE(torch::equal(gated.anchors_raw, base.apply(scene.batch.anchors_reference())));
  EXPECT_LT(largest_difference(gated.pose.rotation, base.pose.rotation), 1e-9);
  EXPECT_LT(largest_difference(gated.pose.translation, base.pose.translation), 1e-9);
  EXPECT_LT(largest_difference(gated.departure.rotation, scene.state.current.rotation), 1e-9);
  EXPECT_LT(largest_difference(gated.departure.translation, scene.state.current.translation), 1e-9);
  model->options.contact_gate = false;
  EXPECT_GT(largest_difference(predict(model, scene).anchors_raw, gated.anchors_raw), 1e-4);
}

TEST(Advance, PredictedPosesMoveDynamicObjectsAndTwistsMoveTheOthers) {
  const FreeFlight flight;
  RandomScene scene = random_scene(5, {{8, 8, 8}});
  scene.batch.dynamic_mask[0][1] = scene.batch.dynamic_mask[0][2] = false;
  SceneState& state = scene.state;
  state.previous.rotation.select(1, 2).copy_(state.current.rotation.select(1, 2));  // the last object rests
  state.previous.translation.select(1, 2).copy_(state.current.translation.select(1, 2));
  const Pose next = flight.at(0.2);
  const Pose predicted{next.rotation.expand({1, 3, 3, 3}), next.translation.expand({1, 3, 3})};
  const Pose departure = flight.at(0.1);
  const Pose departures{departure.rotation.expand({1, 3, 3, 3}), departure.translation.expand({1, 3, 3})};
  const SceneState after = advance(scene.batch, state, {Tensor(), predicted, departures});
  EXPECT_TRUE(torch::equal(after.previous.rotation[0][0], departure.rotation[0][0]));
  EXPECT_TRUE(torch::equal(after.previous.translation[0][0], departure.translation[0][0]));
  EXPECT_TRUE(torch::equal(after.previous.rotation[0][1], state.current.rotation[0][1]));
  EXPECT_TRUE(torch::equal(after.first.translation, state.first.translation));
  EXPECT_TRUE(torch::equal(after.current.translation[0][0], next.translation[0][0]));
  EXPECT_TRUE(torch::equal(after.current.rotation[0][0], next.rotation[0][0]));
  EXPECT_LT(largest_difference(after.current.rotation[0][2], state.current.rotation[0][2]), 1e-12);
  EXPECT_LT(largest_difference(after.current.translation[0][2], state.current.translation[0][2]), 1e-12);
  const auto homogeneous = [&](const Pose& pose) {
    Tensor T = torch::eye(4, kWide);
    T.slice(0, 0, 3).slice(1, 0, 3).copy_(pose.rotation[0][1]);
    T.slice(0, 0, 3).select(1, 3).copy_(pose.translation[0][1]);
    return T;
  };
  const Tensor motion = torch::matmul(homogeneous(state.current), torch::inverse(homogeneous(state.previous)));
  EXPECT_LT(largest_difference(homogeneous(after.current).slice(0, 0, 3).slice(1, 0, 3),
                               torch::matmul(motion, homogeneous(state.current)).slice(0, 0, 3).slice(1, 0, 3)),
            1e-12);
}

TEST(Advance, GivenMotionsStayRigidOverLongRollouts) {
  RandomScene scene = random_scene(5, {{8, 8}}, 4, 0, torch::kFloat32);
  scene.batch.dynamic_mask.fill_(false);
  scene.state.previous.rotation.select(1, 1).copy_(scene.state.current.rotation.select(1, 1));
  SceneState state = scene.state;
  for (int step = 0; step < 200; ++step) state = advance(scene.batch, state, {Tensor(), state.current, state.current});
  const Tensor R = state.current.rotation;
  EXPECT_LT(largest_difference(torch::matmul(R.transpose(-1, -2), R), torch::eye(3).expand_as(R)), 1e-5);
  EXPECT_LT(largest_difference(R[0][1], scene.state.current.rotation[0][1]), 1e-3);  // the object did not turn
}

TEST(NearestByDistanceMatrix, MatchesBruteForce) {
  const RandomScene scene = random_scene(6, {{20, 9, 16}, {12, 17}, {6}}, 4, 0, torch::kFloat32);
  const Tensor x = scene.state.current.apply(scene.batch.points_reference);
  const Nearest nearest = nearest_by_distance_matrix(scene.batch, scene.state.current, x);
  const Tensor flat = x.flatten(1, 2), mask = scene.batch.point_mask.flatten(1, 2);
  const std::int64_t K = 3, N = scene.batch.max_points();
  for (std::int64_t b = 0; b < 3; ++b) {
    for (std::int64_t i = 0; i < K * N; ++i) {
      const Tensor distance = (flat[b] - flat[b][i]).norm(2, -1);
      const Tensor allowed = mask[b].logical_and(torch::arange(K * N, torch::kInt64).floor_divide(N) != i / N);
      const bool expected = mask[b][i].item<bool>() && allowed.any().item<bool>();
      ASSERT_EQ(nearest.found.flatten(1, 2)[b][i].item<bool>(), expected);
      if (!expected) continue;
      const std::int64_t index = nearest.index.flatten(1, 2)[b][i].item<std::int64_t>();
      ASSERT_TRUE(allowed[index].item<bool>());
      EXPECT_NEAR(distance[index].item<double>(), distance.masked_select(allowed).min().item<double>(), 1e-5);
    }
  }
}

TEST(VertexFeatures, PaperFormHasTwelveChannels) {
  const ModelOptions options = model_preset("tiny");
  EXPECT_EQ(num_vertex_features(options), 12);
  RandomScene scene = random_scene(7, {{8, 8}});
  const Tensor x = scene.state.current.apply(scene.batch.points_reference);
  const Nearest nearest = nearest_by_distance_matrix(scene.batch, scene.state.current, x);
  const BaseMotion base = make_base_motion(options, scene.batch, scene.state, torch::zeros({1, 2, 3}, kWide));
  const Tensor h = vertex_features(options, scene.batch, scene.state, base, x, nearest);
  const Tensor& points = scene.batch.points_reference;
  EXPECT_LT(largest_difference(h.slice(-1, 3, 6), x - scene.state.previous.apply(points)), 1e-12);
  EXPECT_LT(largest_difference(h.slice(-1, 6, 9), x - scene.state.first.apply(points)), 1e-12);
  EXPECT_LT(largest_difference(h.slice(-1, 9), scene.batch.properties.unsqueeze(2).expand({1, 2, 8, 3})), 1e-12);
  const Tensor distance = torch::cdist(x[0][0], x[0][1], 2, 2);
  for (std::int64_t i = 0; i < 8; ++i) {
    const double to_object = distance[i].min().item<double>(), height = x[0][0][i][2].item<double>();
    const Tensor d = h[0][0][i].slice(0, 0, 3);
    EXPECT_NEAR(d.norm().item<double>(), std::min(to_object, std::abs(height)), 1e-9);
    if (std::abs(height) < to_object) {
      EXPECT_LT(largest_difference(d, vec3(0.0, 0.0, -height)), 1e-12);
    }
  }
}

TEST(CentreOfMass, CentroidAndRadiusIgnorePadding) {
  Tensor points = torch::tensor({1.0, 0.0, 0.0, 3.0, 0.0, 0.0, 9.0, 9.0, 9.0}, kWide).view({1, 1, 3, 3});
  const Tensor mask = torch::tensor({1, 1, 0}, torch::kInt64).to(torch::kBool).view({1, 1, 3});
  EXPECT_LT(largest_difference(centroid(points, mask)[0][0], vec3(2, 0, 0)), 1e-12);
  EXPECT_NEAR(bounding_radius(points, mask, vec3(0, 0, 0).view({1, 1, 3})).item<double>(), 3.0, 1e-12);
}

}  // namespace
}  // namespace rigidformer
