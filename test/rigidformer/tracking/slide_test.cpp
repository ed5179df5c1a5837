// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/slide.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "rigidformer/geometry/point_rows.hpp"
#include "rigidformer/tracking/shape_camera.hpp"

namespace rigidformer {
namespace {

using testing::ShapeCamera;

SurfaceCloud surface_of(const Points& points) { return estimate_surface(points, CorrespondenceOptions().noise); }

TEST(MeasureSlide, ComparesBothEndsAndIsCertainWhereTheyAgree) {
  ShapeCamera camera("cube", 1.0, 15);
  const Eigen::Vector3d eye(0.0, -3.0, 3.0);
  const double noise_m = CorrespondenceOptions().noise;
  const ReferenceCloud reference(surface_of(camera.look(RigidTransform(), eye, 2000).points_world),
                                 CorrespondenceOptions());
  const RigidTransform slid{Eigen::Quaterniond::Identity(), {0.015, 0.0, 0.0}};
  const Points whole = camera.look(slid, eye, 1000).points_world;
  const std::optional<Slide> slide = measure_slide(reference, surface_of(whole), Eigen::Vector3d::UnitX(), noise_m);
  ASSERT_TRUE(slide.has_value());
  EXPECT_TRUE(slide->is_certain);
  EXPECT_NEAR(slide->distance_m, 0.015, 0.007);
  EXPECT_GT(slide->standard_deviation_m, 0.001);
  EXPECT_LT(slide->standard_deviation_m, 0.005);
  std::vector<int> rows;
  for (int i = 0; i < whole.rows(); ++i) {
    if (whole(i, 0) < 0.35F) {
      rows.push_back(i);
    }
  }
  const Points cut = select_rows(whole, rows);
  const std::optional<Slide> hidden = measure_slide(reference, surface_of(cut), Eigen::Vector3d::UnitX(), noise_m);
  ASSERT_TRUE(hidden.has_value());
  EXPECT_FALSE(hidden->is_certain);
  EXPECT_FALSE(measure_slide(reference, surface_of(whole.topRows(50)), Eigen::Vector3d::UnitX(), noise_m).has_value());
}

TEST(MeasureSlide, DoesNotAnswerWhereAnEndIsBlunt) {
  ShapeCamera camera("cone", 1.0, 16);
  const Eigen::Vector3d eye(0.0, -3.0, 1.0);
  const ReferenceCloud reference(surface_of(camera.look(RigidTransform(), eye, 2000).points_world),
                                 CorrespondenceOptions());
  const SurfaceCloud cloud = surface_of(camera.look(RigidTransform(), eye, 1000).points_world);
  EXPECT_FALSE(measure_slide(reference, cloud, Eigen::Vector3d::UnitZ(), CorrespondenceOptions().noise).has_value());
}

}  // namespace
}  // namespace rigidformer
