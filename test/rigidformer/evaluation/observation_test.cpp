// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/observation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "rigidformer/evaluation/flying_cubes.hpp"

namespace rigidformer {
namespace {

std::vector<ObjectState> observe(const ObservationOptions& options, int frame = 20, int step = 10) {
  return Observer({unit_cube()}, options).observe(flying_cubes(2, 50), frame, step);
}

double largest_distance_from_cube_surface(const Points& points, double size) {
  const Eigen::VectorXf depth = points.cwiseAbs().rowwise().maxCoeff();
  return (depth.array() - 0.5F * static_cast<float>(size)).abs().maxCoeff();
}

TEST(Observer, GivesTwoPosesOneStepApartAndScaledSurfacePoints) {
  const SceneRecording scene = flying_cubes(2, 50);
  const auto objects = observe({});
  ASSERT_EQ(objects.size(), 2U);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(objects[i].T_world_previous.translation, scene.objects[i].T_world_object[10].translation);
    EXPECT_EQ(objects[i].T_world_current.translation, scene.objects[i].T_world_object[20].translation);
    EXPECT_EQ(objects[i].points_reference.rows(), 256);
    EXPECT_LT(largest_distance_from_cube_surface(objects[i].points_reference, scene.objects[i].size), 1e-5);
    EXPECT_EQ(objects[i].properties.mass_kg, 2.0);
  }
  EXPECT_NE(objects[0].id, objects[1].id);
}

TEST(Observer, CanGiveVerticesAndHideProperties) {
  ObservationOptions options;
  options.num_points = 0;
  options.known_properties = false;
  const auto objects = observe(options);
  EXPECT_EQ(objects[1].points_reference, Points(unit_cube().vertices() * 2.0F));
  EXPECT_FALSE(objects[1].properties.mass_kg || objects[1].properties.friction || objects[1].properties.restitution);
}

TEST(Observer, OneViewKeepsOnlyPointsThatFaceTheCamera) {
  ObservationOptions options;
  options.one_view = true;
  options.camera_world = {100.0, 0.0, 5.2};  // on the world's x axis, between the heights of the cube's bottom and top
  const auto objects = observe(options);
  const Points world = objects[0].T_world_current.apply(objects[0].points_reference);
  EXPECT_GT(world.rows(), 40);
  EXPECT_LT(world.rows(), 200);
  // At frame 20 the cube has turned by 0.167 rad: its +x and -y sides face the camera, the others do not.
  const Points& body = objects[0].points_reference;
  for (Eigen::Index row = 0; row < body.rows(); ++row) {
    EXPECT_TRUE(body(row, 0) > 0.499F || body(row, 1) < -0.499F) << body.row(row);
  }
}

TEST(Observer, OneViewOfVerticesKeepsAtLeastFour) {
  ObservationOptions options;
  options.num_points = 0;
  options.one_view = true;
  const auto objects = observe(options);
  EXPECT_GE(objects[0].points_reference.rows(), 4);
  EXPECT_LT(objects[0].points_reference.rows(), 8);
}

TEST(Observer, MaskDropsTheStatedShareButKeepsFour) {
  ObservationOptions options;
  options.masked_fraction = 0.25;
  EXPECT_EQ(observe(options)[0].points_reference.rows(), 192);
  options.masked_fraction = 0.999;
  EXPECT_EQ(observe(options)[0].points_reference.rows(), 4);
}

TEST(Observer, BoxDropsTheStatedShareInOnePlace) {
  ObservationOptions options;
  options.num_points = 2000;
  const Points whole = observe(options)[0].points_reference;
  options.boxed_fraction = 0.25;
  const Points kept = observe(options)[0].points_reference;
  EXPECT_EQ(kept.rows(), 1500);
  EXPECT_EQ(kept, observe(options)[0].points_reference) << "the same box every time";
  // The middle of the box is far from all that is left: points of a unit cube at random lie 5 cm apart.
  float farthest = 0.0F;
  for (Eigen::Index i = 0; i < whole.rows(); ++i) {
    farthest = std::max(farthest, (kept.rowwise() - whole.row(i)).rowwise().norm().minCoeff());
  }
  EXPECT_GT(farthest, 0.2F);
}

TEST(Observer, NoiseHasTheStatedSizeAndIsRepeatable) {
  ObservationOptions options;
  options.num_points = 2000;
  const Points clean = observe(options)[0].points_reference;
  options.noise_m = 0.01;
  const Points noisy = observe(options)[0].points_reference;
  const double deviation = std::sqrt((noisy - clean).squaredNorm() / static_cast<double>(clean.size()));
  EXPECT_NEAR(deviation, 0.01, 0.0005);
  EXPECT_EQ(noisy, observe(options)[0].points_reference);
}

TEST(Observer, RefusesWhatIsNotThere) {
  EXPECT_THROW(observe({}, 50, 10), std::invalid_argument);
  EXPECT_THROW(observe({}, 9, 10), std::invalid_argument);
  EXPECT_THROW(Observer({}, {}).observe(flying_cubes(1, 50), 20, 10), std::invalid_argument);
}

TEST(ObservationOptions, NamesFieldAndValue) {
  ObservationOptions options;
  options.masked_fraction = 1.0;
  EXPECT_THROW(options.validate(), std::invalid_argument);
  options = {};
  options.boxed_fraction = -0.1;
  EXPECT_THROW(options.validate(), std::invalid_argument);
  options = {};
  options.num_points = 3;
  EXPECT_THROW(options.validate(), std::invalid_argument);
  options = {};
  options.noise_m = -0.1;
  EXPECT_THROW(options.validate(), std::invalid_argument);
}

}  // namespace
}  // namespace rigidformer
