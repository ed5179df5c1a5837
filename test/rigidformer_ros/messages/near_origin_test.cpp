// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/messages/near_origin.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "rigidformer_ros/test_scene.hpp"

namespace rigidformer_ros {
namespace {

TEST(NearOrigin, P56_FarPlacesAreRefusedWithPlaceAndRemedy) {
  Points points = testing::blob(30);
  points.rowwise() += Eigen::RowVector3f(5e5F, 5e6F, 30.0F);
  try {
    require_near_origin(points, "map");
    FAIL() << "UTM coordinates do not fit into single precision";
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    for (const char* part : {"5000000", "'map'", "10000 m", "fixed_frame"}) {
      EXPECT_NE(text.find(part), std::string::npos) << text << " lacks " << part;
    }
  }
}

TEST(NearOrigin, P56_OneStrayPointRefusesNothing) {
  Points points = testing::blob(30);
  points.row(3).setConstant(1e6F);
  EXPECT_NO_THROW(require_near_origin(points, "world"));
  points.rowwise() += Eigen::RowVector3f(9000.0F, 0.0F, 0.0F);
  EXPECT_NO_THROW(require_near_origin(points, "world"));
  EXPECT_NO_THROW(require_near_origin(Points::Constant(3, 3, std::numeric_limits<float>::quiet_NaN()), "world"));
}

}  // namespace
}  // namespace rigidformer_ros
