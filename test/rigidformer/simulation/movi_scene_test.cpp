// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/movi_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "rigidformer/simulation/builtin_shapes.hpp"

namespace rigidformer {
namespace {

const Shape& shape_of(const RecordedObject& object, const std::vector<Shape>& shapes) {
  return *std::find_if(shapes.begin(), shapes.end(), [&](const Shape& s) { return s.name == object.shape; });
}

Points vertices_world(const RecordedObject& object, const std::vector<Shape>& shapes, std::size_t frame) {
  const Points scaled = static_cast<float>(object.size) * shape_of(object, shapes).vertices();
  return object.T_world_object[frame].apply(scaled);
}

/// True when a vertex of `points_world` lies deeper than 1 mm in a part of `object` at frame 0.
bool penetrates(const Points& points_world, const RecordedObject& object, const std::vector<Shape>& shapes) {
  const Points local = object.T_world_object[0].inverse().apply(points_world) / static_cast<float>(object.size);
  for (const ConvexPart& part : shape_of(object, shapes).parts) {
    Eigen::VectorXf depth = Eigen::VectorXf::Constant(local.rows(), 1e9F);
    for (Eigen::Index f = 0; f < part.triangles.rows(); ++f) {
      const Eigen::Vector3f a = part.vertices.row(part.triangles(f, 0));
      const Eigen::Vector3f b = part.vertices.row(part.triangles(f, 1));
      const Eigen::Vector3f c = part.vertices.row(part.triangles(f, 2));
      const Eigen::Vector3f normal = (b - a).cross(c - a).normalized();
      depth = depth.cwiseMin(Eigen::VectorXf(normal.dot(a) - (local * normal).array()));
    }
    if (depth.maxCoeff() > 1e-3F) return true;
  }
  return false;
}

class MoviScene : public ::testing::TestWithParam<MoviSet> {
 protected:
  const std::vector<Shape> shapes_ = movi_shapes(GetParam(), builtin_shapes());
};

TEST_P(MoviScene, ObjectsStartApartInsideTheRegionWithSpecifiedProperties) {
  const MoviOptions options;
  for (std::uint64_t index = 0; index < 10; ++index) {
    const SceneRecording scene = sample_movi_scene(GetParam(), shapes_, 11, index);
    ASSERT_GE(scene.objects.size(), 3u);
    ASSERT_LE(scene.objects.size(), 10u);
    for (const RecordedObject& object : scene.objects) {
      const Points vertices = vertices_world(object, shapes_, 0);
      EXPECT_TRUE(
          (vertices.colwise().minCoeff().transpose().cast<double>().array() >= options.region_min.array() - 1e-4)
              .all());
      EXPECT_TRUE(
          (vertices.colwise().maxCoeff().transpose().cast<double>().array() <= options.region_max.array() + 1e-4)
              .all());
      for (const RecordedObject& other : scene.objects) {
        if (&other == &object) continue;
        EXPECT_FALSE(penetrates(vertices, other, shapes_)) << object.shape << other.shape;
      }
      EXPECT_TRUE(object.size >= 0.7 && object.size <= 1.4);
      EXPECT_TRUE(GetParam() == MoviSet::kB || object.size == 0.7 || object.size == 1.4);
      const bool metal = object.properties.friction == 0.4 && object.properties.restitution == 0.3;
      const bool rubber = object.properties.friction == 0.8 && object.properties.restitution == 0.7;
      ASSERT_TRUE(metal || rubber);
      const double mass = shape_of(object, shapes_).mass_kg * (metal ? 2.7 : 1.1) * std::pow(object.size, 3);
      EXPECT_NEAR(*object.properties.mass_kg, mass, 1e-9);
      const Eigen::Vector3d thrown = object.velocities[0] + object.T_world_object[0].translation;
      EXPECT_LE(thrown.head<2>().cwiseAbs().maxCoeff(), 4.0);
      EXPECT_EQ(object.velocities[0].z(), 0.0);
      EXPECT_EQ(object.angular_velocities[0].norm(), 0.0);
    }
  }
}

TEST_P(MoviScene, SameSeedSameSceneAndOthersDiffer) {
  MoviOptions options;
  options.num_frames = 40;
  const SceneRecording a = generate_movi_scene(GetParam(), shapes_, 1, 2, options);
  const SceneRecording b = generate_movi_scene(GetParam(), shapes_, 1, 2, options);
  ASSERT_EQ(a.objects.size(), b.objects.size());
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    ASSERT_EQ(a.objects[i].T_world_object.size(), 40u);
    EXPECT_EQ(a.objects[i].shape, b.objects[i].shape);
    EXPECT_EQ(a.objects[i].T_world_object[39].translation, b.objects[i].T_world_object[39].translation);
    EXPECT_EQ(a.objects[i].T_world_object[39].rotation.coeffs(), b.objects[i].T_world_object[39].rotation.coeffs());
  }
  const auto first_position = [&](std::uint64_t seed, std::uint64_t index) {
    return sample_movi_scene(GetParam(), shapes_, seed, index).objects[0].T_world_object[0].translation;
  };
  EXPECT_NE(first_position(1, 2), first_position(2, 2));
  EXPECT_NE(first_position(1, 2), first_position(1, 3));
}

TEST_P(MoviScene, ALaterFirstFrameShowsTheSameMotionLater) {
  MoviOptions whole, later;
  whole.num_frames = 60;
  later.num_frames = 20;
  later.first_frame = 40;
  const SceneRecording a = generate_movi_scene(GetParam(), shapes_, 3, 0, whole);
  const SceneRecording b = generate_movi_scene(GetParam(), shapes_, 3, 0, later);
  EXPECT_EQ(b.num_frames, 20);
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    ASSERT_EQ(b.objects[i].T_world_object.size(), 20u);
    EXPECT_EQ(a.objects[i].T_world_object[40].translation, b.objects[i].T_world_object[0].translation);
    EXPECT_EQ(a.objects[i].velocities[59], b.objects[i].velocities[19]);
  }
  later.first_frame = -1;
  EXPECT_THROW(generate_movi_scene(GetParam(), shapes_, 3, 0, later), std::invalid_argument);
}

/// Kinetic and potential energy [J], with the inertia of the bounding box, as the simulation uses it.
double energy(const RecordedObject& object, const std::vector<Shape>& shapes, std::size_t frame) {
  const Points vertices = shape_of(object, shapes).vertices();
  const Eigen::Vector3d extent =
      object.size * (vertices.colwise().maxCoeff() - vertices.colwise().minCoeff()).transpose().cast<double>() +
      Eigen::Vector3d::Constant(0.002);
  const Eigen::Vector3d squares = extent.cwiseAbs2();
  const double mass = *object.properties.mass_kg;
  const Eigen::Vector3d inertia = mass / 12.0 * (Eigen::Vector3d::Constant(squares.sum()) - squares);
  const RigidTransform& T = object.T_world_object[frame];
  const Eigen::Vector3d spin = T.rotation.conjugate() * object.angular_velocities[frame];
  return 0.5 * mass * object.velocities[frame].squaredNorm() + 0.5 * inertia.dot(spin.cwiseAbs2()) +
         mass * 10.0 * T.translation.z();
}

TEST_P(MoviScene, EnergyNeverGrowsAndNothingSinksIntoTheFloor) {
  for (std::uint64_t index = 0; index < 2; ++index) {
    const SceneRecording scene = generate_movi_scene(GetParam(), shapes_, 21, index);
    const auto total = [&](std::size_t frame) {
      double sum = 0.0;
      for (const RecordedObject& object : scene.objects) sum += energy(object, shapes_, frame);
      return sum;
    };
    const double start = total(0);
    double lowest_so_far = start;
    for (std::size_t frame = 10; frame < 480; frame += 10) {
      EXPECT_LT(total(frame), lowest_so_far + 0.01 * start) << "scene " << index << " frame " << frame;
      lowest_so_far = std::min(lowest_so_far, total(frame));
      for (const RecordedObject& object : scene.objects) {
        EXPECT_GT(vertices_world(object, shapes_, frame).col(2).minCoeff(), -0.02F) << object.shape;
      }
    }
    EXPECT_LT(lowest_so_far, 0.9 * start) << "nothing ever hit anything";
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, MoviScene, ::testing::Values(MoviSet::kSphere, MoviSet::kA, MoviSet::kB),
                         [](const auto& info) { return to_string(info.param); });

TEST(MoviSets, NamesAndShapes) {
  EXPECT_EQ(parse_movi_set("movi_b"), MoviSet::kB);
  EXPECT_THROW(parse_movi_set("movi_c"), std::invalid_argument);
  EXPECT_EQ(movi_shapes(MoviSet::kSphere, builtin_shapes()).size(), 1u);
  EXPECT_EQ(movi_shapes(MoviSet::kA, builtin_shapes()).size(), 3u);
  EXPECT_EQ(movi_shapes(MoviSet::kB, builtin_shapes()).size(), builtin_shapes().size());
  EXPECT_THROW(movi_shapes(MoviSet::kA, {}), std::invalid_argument);
}

TEST(MoviSets, ARegionTooSmallIsAnErrorNotALoop) {
  MoviOptions options;
  options.region_max = {-4.0, -4.0, 2.0};
  options.placement_tries = 2;
  options.min_objects = options.max_objects;
  const std::vector<Shape> shapes = movi_shapes(MoviSet::kSphere, builtin_shapes());
  EXPECT_THROW(sample_movi_scene(MoviSet::kSphere, shapes, 1, 1, options), std::runtime_error);
}

}  // namespace
}  // namespace rigidformer
