// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <stdexcept>

#include "random_scene.hpp"
#include "rigidformer/model/features.hpp"

namespace rigidformer {
namespace {

const auto kDouble = torch::TensorOptions(torch::kFloat64);

/// Where the planes stand among the features: before the material, which is last.
struct PlaneFeatures {
  Tensor gap_to_other, gap_to_own, next_gap_to_other, next_gap_to_own, own_normal, other_normal, approach;
};

class LocalPlanesTest : public ::testing::Test {
 protected:
  LocalPlanesTest() { options_.local_planes = options_.inertial_base_motion = options_.contact_features = true; }

  PlaneFeatures features_of(const RandomScene& scene) const {
    const Tensor x = scene.state.current.apply(scene.batch.points_reference);
    const Nearest nearest = nearest_by_distance_matrix(scene.batch, scene.state.current, x);
    const Tensor centre = torch::zeros_like(scene.state.current.translation);
    const BaseMotion base = make_base_motion(options_, scene.batch, scene.state, centre);
    const Tensor h = vertex_features(options_, scene.batch, scene.state, base, x, nearest);
    EXPECT_EQ(h.size(-1), num_vertex_features(options_));
    const auto part = h.slice(-1, -18, -3).split_with_sizes({2, 2, 2, 2, 3, 3, 1}, -1);
    return {part[0], part[1], part[2], part[3], part[4], part[5], part[6]};
  }

  ModelOptions options_ = model_preset("tiny");
};

/// Two square plates of four vertices each, face to face with a given gap; the upper one is turned by 45 degrees, so
/// that no vertex lies above another, and approaches at a given speed without gravity.
RandomScene facing_plates(double gap_m, double speed_mps) {
  RandomScene scene = random_scene(1, {{4, 4}});
  SceneBatch& batch = scene.batch;
  const double r = std::sqrt(2.0);
  batch.points_reference = torch::tensor({1.0, 1.0, 0.0, 1.0, -1.0, 0.0, -1.0, 1.0, 0.0, -1.0, -1.0, 0.0,  //
                                          r,   0.0, 0.0, -r,  0.0,  0.0, 0.0,  r,   0.0, 0.0,  -r,   0.0},
                                         kDouble)
                               .view({1, 2, 4, 3});
  batch.normals_reference = torch::zeros({1, 2, 4, 3}, kDouble);
  batch.normals_reference[0][0].select(-1, 2) = 1.0;
  batch.normals_reference[0][1].select(-1, 2) = -1.0;
  batch.gravity.zero_();
  batch.step_size.fill_(10.0);
  const Pose still{torch::eye(3, kDouble).expand({1, 2, 3, 3}).clone(), torch::zeros({1, 2, 3}, kDouble)};
  scene.state = {still, still, {still.rotation.clone(), still.translation.clone()}};
  scene.state.current.translation[0][1][2] = gap_m;
  scene.state.previous.translation[0][1][2] = gap_m + speed_mps * 10.0 / kFrameRateHz;
  return scene;
}

/// d / (|d| + l) for both lengths.
Tensor squashed(double d) { return torch::tensor({d / (std::abs(d) + 0.05), d / (std::abs(d) + 0.5)}, kDouble); }

TEST_F(LocalPlanesTest, FacingPlatesAreAsFarApartAsTheirPlanes) {
  const PlaneFeatures planes = features_of(facing_plates(0.2, 2.4));
  EXPECT_LT(largest_difference(planes.gap_to_other, squashed(0.2)), 1e-12);
  EXPECT_LT(largest_difference(planes.gap_to_own, squashed(0.2)), 1e-12);
  EXPECT_LT(largest_difference(planes.next_gap_to_other, squashed(0.1)), 1e-12);
  EXPECT_LT(largest_difference(planes.next_gap_to_own, squashed(0.1)), 1e-12);
  EXPECT_LT(largest_difference(planes.approach, torch::full({1}, 2.4 / 5.0, kDouble)), 1e-12);
}

TEST_F(LocalPlanesTest, GapsAreContinuousThroughContact) {
  const PlaneFeatures before = features_of(facing_plates(1e-6, 0.0)), after = features_of(facing_plates(-1e-6, 0.0));
  EXPECT_LT(largest_difference(before.gap_to_other, after.gap_to_other), 1e-4);
  EXPECT_GT(before.gap_to_other.min().item<double>(), 0.0);
  EXPECT_LT(after.gap_to_other.max().item<double>(), 0.0);
}

TEST_F(LocalPlanesTest, NormalsAreThoseOfBothSidesInTheWorld) {
  const PlaneFeatures planes = features_of(facing_plates(0.2, 0.0));
  const Tensor up = torch::tensor({0.0, 0.0, 1.0}, kDouble);
  EXPECT_LT(largest_difference(planes.own_normal[0][0], up.expand({4, 3})), 1e-12);
  EXPECT_LT(largest_difference(planes.other_normal[0][0], -up.expand({4, 3})), 1e-12);
  EXPECT_LT(largest_difference(planes.own_normal[0][1], -up.expand({4, 3})), 1e-12);
}

TEST_F(LocalPlanesTest, ACommonRigidMotionTurnsNormalsAndNothingElse) {
  RandomScene scene = random_scene(4, {{12, 9, 10}});
  scene.batch.gravity.zero_();
  const PlaneFeatures before = features_of(scene);
  const Tensor R = special_procrustes(torch::randn({3, 3}, kDouble)), t = torch::tensor({3.0, -2.0, 1.0}, kDouble);
  for (Pose* pose : {&scene.state.first, &scene.state.previous, &scene.state.current}) {
    *pose = {torch::matmul(R, pose->rotation), torch::matmul(pose->translation, R.t()) + t};
  }
  const PlaneFeatures after = features_of(scene);
  EXPECT_LT(largest_difference(after.gap_to_other, before.gap_to_other), 1e-9);
  EXPECT_LT(largest_difference(after.gap_to_own, before.gap_to_own), 1e-9);
  EXPECT_LT(largest_difference(after.next_gap_to_other, before.next_gap_to_other), 1e-9);
  EXPECT_LT(largest_difference(after.next_gap_to_own, before.next_gap_to_own), 1e-9);
  EXPECT_LT(largest_difference(after.approach, before.approach), 1e-9);
  EXPECT_LT(largest_difference(after.own_normal, torch::matmul(before.own_normal, R.t())), 1e-9);
  EXPECT_LT(largest_difference(after.other_normal, torch::matmul(before.other_normal, R.t())), 1e-9);
}

TEST_F(LocalPlanesTest, WithoutAnotherObjectThereIsNothing) {
  const PlaneFeatures alone = features_of(random_scene(5, {{12}}));
  for (const Tensor& part : {alone.gap_to_other, alone.gap_to_own, alone.next_gap_to_other, alone.next_gap_to_own,
                             alone.own_normal, alone.other_normal, alone.approach}) {
    EXPECT_EQ(part.abs().max().item<double>(), 0.0);
  }
}

TEST_F(LocalPlanesTest, NormalsAreNeededAndSaidSo) {
  RandomScene scene = random_scene(6, {{12, 9}});
  scene.batch.normals_reference = Tensor();
  EXPECT_THROW(features_of(scene), std::invalid_argument);
  options_.local_planes = false;
  EXPECT_NO_THROW(features_of(scene));
}

}  // namespace
}  // namespace rigidformer
