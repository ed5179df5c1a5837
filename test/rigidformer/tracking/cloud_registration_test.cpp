// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/cloud_registration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "rigidformer/geometry/point_rows.hpp"
#include "rigidformer/tracking/point_tree.hpp"
#include "rigidformer/tracking/shape_camera.hpp"

namespace rigidformer {
namespace {

using testing::Imperfections;
using testing::ShapeCamera;
using testing::View;

constexpr double kDegree = M_PI / 180.0;  // [rad]

RigidTransform turned(double angle_rad, const Eigen::Vector3d& axis, const Eigen::Vector3d& moved) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, axis.normalized())), moved};
}

SurfaceCloud surface_of(const Points& points) { return estimate_surface(points, CorrespondenceOptions().noise); }

// Registers with reference, object frame and world the same at the start, and the prediction that nothing moved.
CloudRegistration register_from_rest(const ReferenceCloud& reference, const Points& cloud) {
  CorrespondenceOptions parameters;
  parameters.max_registered_points = static_cast<int>(cloud.rows());
  return register_cloud(reference, surface_of(cloud), RigidTransform(), RigidTransform(), parameters);
}

double mean_distance(const PointTree& surface, const Points& points) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3f point = points.row(i).transpose();
    sum += (surface.points().row(surface.nearest(point)).transpose() - point).norm();
  }
  return sum / static_cast<double>(points.rows());
}

TEST(CloudRegistration, P12_any_points_in_any_number_and_order_give_the_same_pose) {
  for (const double size : {1.0, 0.1}) {
    ShapeCamera camera("bone", size, 5);
    const Imperfections imperfections{0.003 * size, 0.08};
    CorrespondenceOptions parameters;
    parameters.noise = imperfections.noise_m;
    const ReferenceCloud reference(
        estimate_surface(camera.sample(RigidTransform(), 2000, imperfections), parameters.noise), parameters);
    for (int i = 0; i < 12; ++i) {
      const Eigen::Vector3d axis = camera.random().rotation() * Eigen::Vector3d::UnitX();
      const RigidTransform truth = turned(8.0 * kDegree, axis, 0.06 * size * (camera.random().rotation() * axis));
      const Eigen::Vector3d eye = camera.random().rotation() * Eigen::Vector3d(0.0, 0.0, 3.0 * size);
      const int count = camera.random().uniform_int(300, 3000);
      const bool whole = i % 3 == 0;
      const Points cloud = whole ? camera.sample(truth, count, imperfections)
                                 : camera.look(truth, eye, count, imperfections).points_world;
      const CloudRegistration found = register_cloud(reference, estimate_surface(cloud, parameters.noise),
                                                     RigidTransform(), RigidTransform(), parameters);
      EXPECT_EQ(found.objection, "") << "case " << i;
      EXPECT_LT((found.T_world_object.translation - truth.translation).norm(), 0.01 * size) << "case " << i;
      EXPECT_LT(rotation_angle(found.T_world_object.rotation, truth.rotation), 2.0 * kDegree) << i;
    }
  }
}

TEST(CloudRegistration, P12_the_order_of_the_points_does_not_matter) {
  ShapeCamera camera("gear", 1.0, 6);
  const ReferenceCloud reference(surface_of(camera.sample(RigidTransform(), 1500)), CorrespondenceOptions());
  const Points cloud = camera.sample(turned(0.1, {1, 2, 3}, {0.03, 0.0, 0.02}), 700);
  const RigidTransform forth = register_from_rest(reference, cloud).T_world_object;
  const RigidTransform back = register_from_rest(reference, cloud.colwise().reverse()).T_world_object;
  EXPECT_LT((forth.translation - back.translation).norm(), 1e-6);
  EXPECT_LT(rotation_angle(forth.rotation, back.rotation), 1e-6);
}

TEST(CloudRegistration, P13_symmetric_shapes_do_not_flip_or_spin) {
  for (const std::string shape : {"cube", "cylinder", "sphere"}) {
    ShapeCamera camera(shape, 1.0, 7);
    const ReferenceCloud reference(surface_of(camera.sample(RigidTransform(), 2000)), CorrespondenceOptions());
    const RigidTransform truth = turned(4.0 * kDegree, {0.3, -1.0, 0.2}, {0.03, 0.02, -0.03});
    // Poses a quarter or half turn away explain the cloud as well: the one near the prediction must be taken.
    for (const double symmetry : {0.0, M_PI / 2.0, M_PI}) {
      const RigidTransform alias = turned(symmetry, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero());
      const CloudRegistration found =
          register_cloud(reference, surface_of(camera.sample(truth, 800)), alias, alias, CorrespondenceOptions());
      EXPECT_EQ(found.objection, "") << shape;
      EXPECT_LT((found.T_world_object.translation - truth.translation).norm(), 0.01) << shape;
      EXPECT_LT(rotation_angle(found.T_world_object.rotation, alias.rotation), 8.0 * kDegree) << shape;
    }
  }
}

TEST(CloudRegistration, AFaceDoesNotSlideAlongItselfWhileBothOfItsEndsAreSeen) {
  ShapeCamera camera("cube", 1.0, 14);
  const ReferenceCloud reference(surface_of(camera.look(RigidTransform(), {0.0, -3.0, 3.0}, 2000).points_world),
                                 CorrespondenceOptions());
  for (const double slide : {-0.03, -0.01, 0.0, 0.02}) {
    const RigidTransform truth{Eigen::Quaterniond::Identity(), {slide, 0.0, 0.0}};
    const View view = camera.look(truth, {0.0, -3.0, 3.0}, 1000);
    const CloudRegistration found =
        register_cloud(reference, surface_of(view.points_world), RigidTransform(), RigidTransform(), {});
    EXPECT_EQ(found.objection, "") << slide;
    EXPECT_NEAR(found.T_world_object.translation.x(), slide, 0.008);
  }
}

TEST(CloudRegistration, P14_a_wrong_start_is_not_believed) {
  ShapeCamera camera("bone", 1.0, 8);
  const ReferenceCloud reference(surface_of(camera.sample(RigidTransform(), 2000)), CorrespondenceOptions());
  const Points cloud = camera.sample(RigidTransform(), 800);
  const Imperfections none{0.0, 0.0};
  const PointTree surface(camera.sample(RigidTransform(), 8000, none));
  const Points probes = camera.sample(RigidTransform(), 500, none);
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, 0, 0)}) {
    for (const double angle : {5.0, 10.0, 60.0, 90.0, 120.0}) {
      const RigidTransform start = turned(angle * kDegree, axis, Eigen::Vector3d::Zero());
      const CloudRegistration found =
          register_cloud(reference, surface_of(cloud), start, start, CorrespondenceOptions());
      // A symmetry of the shape is as good as the truth: what counts is that the moved shape lies on the true one.
      if (found.objection.empty()) {
        EXPECT_LT(mean_distance(surface, found.T_world_object.apply(probes)), 0.02) << "turned " << angle;
      }
      EXPECT_TRUE(found.objection.empty() || angle > 10.0) << "turned " << angle << ": " << found.objection;
    }
  }
}

TEST(CloudRegistration, P14_an_occluded_half_is_registered_to_the_whole) {
  ShapeCamera camera("bone", 1.0, 13);
  const ReferenceCloud reference(surface_of(camera.sample(RigidTransform(), 2000)), CorrespondenceOptions());
  const RigidTransform truth = turned(6.0 * kDegree, {1.0, -0.5, 2.0}, {0.04, -0.02, 0.03});
  const Points whole = camera.sample(truth, 1200);
  for (const Eigen::Vector3f& side : {Eigen::Vector3f(1, 0, 0), Eigen::Vector3f(0, 1, 0), Eigen::Vector3f(0, 0, 1)}) {
    const Eigen::VectorXf depth = truth.inverse().apply(whole) * side;
    for (const float sign : {-1.0F, 1.0F}) {
      std::vector<int> rows;
      for (Eigen::Index i = 0; i < depth.size(); ++i) {
        if (sign * depth[i] > 0.0F) {
          rows.push_back(static_cast<int>(i));
        }
      }
      const CloudRegistration found = register_from_rest(reference, select_rows(whole, rows));
      EXPECT_EQ(found.objection, "") << sign * side.transpose();
      EXPECT_LT((found.T_world_object.translation - truth.translation).norm(), 0.01) << sign * side.transpose();
      EXPECT_LT(rotation_angle(found.T_world_object.rotation, truth.rotation), 3.0 * kDegree)
          << sign * side.transpose();
    }
  }
}

TEST(CloudRegistration, P14_another_shape_is_not_believed) {
  ShapeCamera bone("bone", 1.0, 9);
  const ReferenceCloud reference(surface_of(bone.sample(RigidTransform(), 2000)), CorrespondenceOptions());
  for (const std::string shape : {"cube", "torus", "gear", "cone"}) {
    ShapeCamera other(shape, 1.0, 10);
    EXPECT_NE(register_from_rest(reference, other.sample(RigidTransform(), 800)).objection, "") << shape;
  }
}

TEST(CloudRegistration, P02_small_and_degenerate_clouds_are_harmless) {
  ShapeCamera camera("bone", 1.0, 11);
  const Points whole = camera.sample(RigidTransform(), 500);
  Points line = Points::Zero(50, 3);
  line.col(0).setLinSpaced(-0.5F, 0.5F);
  Points plane = camera.sample(RigidTransform(), 50);
  plane.col(2).setZero();
  const Points clouds[] = {
      whole.topRows(1), whole.topRows(2), whole.topRows(3), whole.topRows(9), whole, line, Points::Ones(30, 3), plane};
  for (const Points& first : clouds) {
    const ReferenceCloud reference(surface_of(first), CorrespondenceOptions());
    for (const Points& second : clouds) {
      const CloudRegistration found = register_from_rest(reference, second);
      EXPECT_TRUE(is_valid(found.T_world_object)) << first.rows() << " and " << second.rows();
      EXPECT_TRUE(second.rows() >= kMinRegisteredPoints || !found.objection.empty());
    }
  }
}

TEST(ReferenceCloud, GrowsByNewSidesButNotByStrayPointsAndStaysBounded) {
  ShapeCamera camera("cube", 1.0, 12);
  CorrespondenceOptions parameters;
  parameters.max_reference_points = 600;
  ReferenceCloud reference(surface_of(camera.look(RigidTransform(), {0.0, 0.0, 3.0}, 1000).points_world), parameters);
  EXPECT_GT(reference.points().col(2).minCoeff(), 0.2F) << "only the top was seen";
  // The camera goes around the cube twice.
  for (int i = 0; i < 80; ++i) {
    const double angle = 2.0 * M_PI * i / 40.0;
    reference.grow(surface_of(
        camera.look(RigidTransform(), {0.0, 3.0 * std::sin(angle), 3.0 * std::cos(angle)}, 1000).points_world));
    EXPECT_LE(reference.points().rows(), 600);
  }
  EXPECT_GT((reference.points().col(2).array() < -0.45F).cast<float>().mean(), 0.1F) << "the bottom has been seen";
  const Eigen::ArrayXf depth = 0.5F - reference.points().cwiseAbs().rowwise().maxCoeff().array();
  EXPECT_LT((depth.abs() > 0.05F).cast<float>().mean(), 0.1F) << "points away from the surface";
}

}  // namespace
}  // namespace rigidformer
