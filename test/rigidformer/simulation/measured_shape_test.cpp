// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/measured_shape.hpp"

#include <gtest/gtest.h>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/io/text_file.hpp"
#include "rigidformer/simulation/mesh_volume.hpp"

namespace rigidformer {
namespace {

Eigen::Vector3d extents(const Shape& shape) {
  const Points points = shape.vertices();
  return (points.colwise().maxCoeff() - points.colwise().minCoeff()).cast<double>().transpose();
}

TEST(MeasuredShape, PrimitivesHaveTheSizesAskedFor) {
  const Shape box = measured_shape("carton", "box:0.1x0.2x0.3").shape;
  EXPECT_EQ(box.name, "carton");
  EXPECT_LT((extents(box) - Eigen::Vector3d(0.1, 0.2, 0.3)).norm(), 1e-6);
  EXPECT_NEAR(measure_volume(box.parts).volume_m3, 0.006, 1e-8);
  const Shape cylinder = measured_shape("can", "cylinder:0.08x0.12").shape;
  EXPECT_NEAR(extents(cylinder).z(), 0.12, 1e-6);
  EXPECT_NEAR(measure_volume(cylinder.parts).volume_m3, M_PI * 0.04 * 0.04 * 0.12, 0.01 * 6e-4);
  const Shape ball = measured_shape("ball", "sphere:0.2").shape;
  EXPECT_LT((extents(ball) - Eigen::Vector3d::Constant(0.2)).norm(), 1e-6);
}

TEST(MeasuredShape, AMeshIsMovedToItsCentreOfMass) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "tetrahedron.obj";
  write_text_file(file, "v 1 0 0\nv 5 0 0\nv 1 4 0\nv 1 0 4\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const MeasuredShape measured = measured_shape("thing", file);
  EXPECT_LT((measured.centre_object - Eigen::Vector3d(2, 1, 1)).norm(), 1e-5);
  EXPECT_LT(measure_volume(measured.shape.parts).centroid.norm(), 1e-5);
  EXPECT_EQ(measured.remark, "");
}

TEST(MeasuredShape, WhatIsNotConvexBecomesItsHullAndSaysSo) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "open.obj";
  write_text_file(file, "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 1 4 3\n");  // one face is missing
  EXPECT_NE(measured_shape("thing", file).remark.find("not convex or not closed"), std::string::npos);
}

TEST(MeasuredShape, RefusesOtherWordsAndLengths) {
  for (const std::string text : {"box:1x2", "box:1x2x-3", "box:1x2x3x", "sphere:", "sphere:big", "torus:1", "no.obj"}) {
    const std::string error = error_of([&] { measured_shape("thing", text); });
    EXPECT_NE(error.find("shape '" + text + "'"), std::string::npos) << error;
    EXPECT_NE(error.find("accepted are box:LxWxH"), std::string::npos) << error;
  }
}

}  // namespace
}  // namespace rigidformer
