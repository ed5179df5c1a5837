// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/rigid_projection.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "gradient_check.hpp"
#include "random_scene.hpp"

namespace rigidformer {
namespace {

constexpr double kFiniteDifferenceTolerance = 1e-6;  // relative, of central differences in float64

Tensor random_rotation() { return special_procrustes(torch::randn({3, 3}, torch::kFloat64)); }

/// U diag(s) V^T with random rotations U and V.
Tensor matrix_with_singular_values(double s1, double s2, double s3) {
  const Tensor s = torch::tensor({s1, s2, s3}, torch::kFloat64);
  return torch::matmul(random_rotation() * s, random_rotation());
}

Eigen::Matrix3Xd columns(const Tensor& points) {
  const Tensor dense = points.contiguous();
  return Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>>(dense.data_ptr<double>(), 3, dense.size(0));
}

Eigen::Matrix3d matrix(const Tensor& R) {
  const Tensor dense = R.contiguous();
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(dense.data_ptr<double>());
}

class RigidProjectionTest : public ::testing::Test {
 protected:
  void SetUp() override { torch::manual_seed(21); }

  void expect_gradient(const Tensor& H) {
    const Tensor leaf = H.detach().clone().set_requires_grad(true);
    EXPECT_LT(gradient_error([&] { return special_procrustes(leaf); }, {leaf}), kFiniteDifferenceTolerance) << H;
  }
};

TEST_F(RigidProjectionTest, MatchesUmeyama) {
  const Tensor source = torch::randn({4, 5, 6, 3}, torch::kFloat64);
  const Tensor target = source + 0.5 * torch::randn_like(source) + 3.0;
  const Pose pose = align_rigidly(source, target);
  for (std::int64_t b = 0; b < 4; ++b) {
    for (std::int64_t k = 0; k < 5; ++k) {
      const Eigen::Matrix4d expected = Eigen::umeyama(columns(source[b][k]), columns(target[b][k]), false);
      EXPECT_TRUE(matrix(pose.rotation[b][k]).isApprox(expected.topLeftCorner<3, 3>(), 1e-9));
      EXPECT_TRUE(columns(pose.translation[b][k].unsqueeze(0)).isApprox(expected.topRightCorner<3, 1>(), 1e-9));
    }
  }
}

TEST_F(RigidProjectionTest, RecoversAnExactMotionAlsoOfPlanarAnchors) {
  for (const bool planar : {false, true}) {
    Tensor source = torch::randn({1, 1, 4, 3}, torch::kFloat64);
    if (planar) source.select(-1, 2).zero_();
    const Tensor R = random_rotation(), t = torch::randn({3}, torch::kFloat64);
    const Pose pose = align_rigidly(source, torch::matmul(source, R.t()) + t);
    EXPECT_LT(largest_difference(pose.rotation[0][0], R), 1e-12);
    EXPECT_LT(largest_difference(pose.translation[0][0], t), 1e-12);
  }
}

TEST_F(RigidProjectionTest, MirroredTargetsStillGiveProperRotations) {
  const Tensor source = torch::randn({1, 8, 4, 3}, torch::kFloat64);
  const Tensor mirrored = source * torch::tensor({1.0, 1.0, -1.0}, torch::kFloat64);
  const Pose pose = align_rigidly(source, mirrored);
  EXPECT_LT(largest_difference(torch::det(pose.rotation), torch::ones({1, 8}, torch::kFloat64)), 1e-12);
  for (std::int64_t k = 0; k < 8; ++k) {
    const Eigen::Matrix4d expected = Eigen::umeyama(columns(source[0][k]), columns(mirrored[0][k]), false);
    EXPECT_TRUE(matrix(pose.rotation[0][k]).isApprox(expected.topLeftCorner<3, 3>(), 1e-9));
  }
}

TEST_F(RigidProjectionTest, DegenerateInputStaysFiniteAndRigid) {
  Tensor H = torch::zeros({3, 3, 3}, torch::kFloat64);
  H[1][0][0] = 2.0;  // the anchors lie on a line
  H[2] = 1e-30 * torch::randn({3, 3}, torch::kFloat64);
  H.set_requires_grad(true);
  const Tensor R = special_procrustes(H);
  EXPECT_LT(largest_difference(torch::matmul(R.transpose(-1, -2), R), torch::eye(3, torch::kFloat64).expand({3, 3, 3})),
            1e-9);
  R.select(-1, 0).sum().backward();
  EXPECT_TRUE(torch::isfinite(H.grad()).all().item<bool>());
}

TEST_F(RigidProjectionTest, FloatAndDoubleAgree) {
  const Tensor H = torch::randn({50, 3, 3}, torch::kFloat64);
  const Tensor R = special_procrustes(H.to(torch::kFloat32));
  EXPECT_LT(largest_difference(torch::matmul(R.transpose(-1, -2), R), torch::eye(3).expand({50, 3, 3})), 1e-5);
  EXPECT_LT(largest_difference(R, special_procrustes(H)), 1e-3);
}

TEST_F(RigidProjectionTest, GradientOfGeneralMatrices) {
  for (int i = 0; i < 5; ++i) expect_gradient(matrix_with_singular_values(3.0, 2.0, 1.0));
}

TEST_F(RigidProjectionTest, GradientWithEqualSingularValues) {
  expect_gradient(matrix_with_singular_values(2.0, 2.0, 2.0));
  expect_gradient(matrix_with_singular_values(3.0, 1.0, 1.0));
  expect_gradient(matrix_with_singular_values(2.0, 2.0, 1.0));
  expect_gradient(torch::eye(3, torch::kFloat64));
}

TEST_F(RigidProjectionTest, GradientOfPlanarAnchors) {
  expect_gradient(matrix_with_singular_values(2.0, 1.0, 0.0));
  expect_gradient(matrix_with_singular_values(1.0, 1.0, 0.0));
}

TEST_F(RigidProjectionTest, GradientOfReflections) {
  expect_gradient(matrix_with_singular_values(3.0, 2.0, -1.0));
  expect_gradient(matrix_with_singular_values(2.0, 2.0, -0.5));
}

TEST_F(RigidProjectionTest, GradientOfAlignment) {
  const Tensor source = random_leaf({1, 2, 4, 3}), target = random_leaf({1, 2, 4, 3});
  const auto f = [&] {
    const Pose pose = align_rigidly(source, target);
    return torch::cat({pose.rotation.flatten(), pose.translation.flatten()});
  };
  EXPECT_LT(gradient_error(f, {source, target}), kFiniteDifferenceTolerance);
}

TEST_F(RigidProjectionTest, AlignmentCanBeAConstant) {
  const Tensor source = torch::randn({1, 2, 4, 3}, torch::kFloat64), target = random_leaf({1, 2, 4, 3});
  const Pose constant = align_rigidly(source, target, false), learned = align_rigidly(source, target);
  EXPECT_FALSE(constant.rotation.requires_grad() || constant.translation.requires_grad());
  EXPECT_TRUE(learned.rotation.requires_grad() && learned.translation.requires_grad());
  EXPECT_TRUE(torch::equal(constant.rotation, learned.rotation));
}

}  // namespace
}  // namespace rigidformer
