// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/builtin_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "rigidformer/data/kubasic.hpp"
#include "rigidformer/scene/surface_sampling.hpp"

namespace rigidformer {
namespace {

TEST(BuiltinShapes, AreElevenDifferentOnesWithSensibleSizeAndMass) {
  std::set<std::string> names;
  for (const Shape& shape : builtin_shapes()) {
    names.insert(shape.name);
    const Points vertices = shape.vertices();
    const float extent = (vertices.colwise().maxCoeff() - vertices.colwise().minCoeff()).maxCoeff();
    EXPECT_GT(extent, 0.9F) << shape.name;
    EXPECT_LT(extent, 1.6F) << shape.name;
    EXPECT_GT(shape.mass_kg, 0.05) << shape.name;
    EXPECT_LT(shape.mass_kg, 1.0) << shape.name;
    if (movi_shape_mass(shape.name) > 0.0) {
      EXPECT_EQ(shape.mass_kg, movi_shape_mass(shape.name));
    }
  }
  EXPECT_EQ(names.size(), 11u);
  for (const char* name : {"cube", "cylinder", "sphere", "cone", "torus", "gear", "torus_knot", "sponge"}) {
    EXPECT_EQ(names.count(name), 1u) << name;
  }
}

TEST(BuiltinShapes, EveryPartIsConvexAndClosed) {
  for (const Shape& shape : builtin_shapes()) {
    for (const ConvexPart& part : shape.parts) {
      Eigen::Vector3f area = Eigen::Vector3f::Zero();
      for (Eigen::Index f = 0; f < part.triangles.rows(); ++f) {
        const Eigen::Vector3f a = part.vertices.row(part.triangles(f, 0));
        const Eigen::Vector3f b = part.vertices.row(part.triangles(f, 1));
        const Eigen::Vector3f c = part.vertices.row(part.triangles(f, 2));
        const Eigen::Vector3f cross = (b - a).cross(c - a);
        area += 0.5F * cross;
        if (cross.norm() < 1e-4F) continue;  // slivers have no reliable plane
        const float outside = ((part.vertices.rowwise() - a.transpose()) * cross.normalized()).maxCoeff();
        EXPECT_LT(outside, 2e-4F) << shape.name;
      }
      EXPECT_LT(area.norm(), 1e-4F) << shape.name;  // the area vectors of a closed surface sum to zero
    }
  }
}

/// Centre of the union of the parts by Monte Carlo over its bounding box.
Eigen::Vector3f centre_of_union(const Shape& shape) {
  const Points vertices = shape.vertices();
  const Eigen::Array3f low = vertices.colwise().minCoeff().transpose();
  const Eigen::Array3f high = vertices.colwise().maxCoeff().transpose();
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  int hits = 0;
  const int steps = 24;
  for (int i = 0; i < steps * steps * steps; ++i) {
    const Eigen::Array3f cell(i % steps + 0.5F, i / steps % steps + 0.5F, i / steps / steps + 0.5F);
    const Eigen::Vector3f p = low + (high - low) * cell / steps;
    bool inside = false;
    for (const ConvexPart& part : shape.parts) {
      bool in_part = true;
      for (Eigen::Index f = 0; in_part && f < part.triangles.rows(); ++f) {
        const Eigen::Vector3f a = part.vertices.row(part.triangles(f, 0));
        const Eigen::Vector3f b = part.vertices.row(part.triangles(f, 1));
        const Eigen::Vector3f c = part.vertices.row(part.triangles(f, 2));
        in_part = (b - a).cross(c - a).dot(p - a) <= 0.0F;
      }
      inside = inside || in_part;
    }
    if (inside) {
      sum += p;
      ++hits;
    }
  }
  return sum / static_cast<float>(hits);
}

TEST(BuiltinShapes, OriginIsTheCentreOfMass) {
  for (const Shape& shape : builtin_shapes()) {
    EXPECT_LT(centre_of_union(shape).norm(), 0.03F) << shape.name << ' ' << centre_of_union(shape).transpose();
  }
}

/// Largest distance of a vertex of the shape, turned by `angle` about z, from the nearest one of the unturned shape.
float change_by_turning(const Shape& shape, double angle) {
  const Points vertices = shape.vertices();
  const Points turned = RigidTransform{rotation_about({0.0, 0.0, angle}), Eigen::Vector3d::Zero()}.apply(vertices);
  float largest = 0.0F;
  for (Eigen::Index i = 0; i < turned.rows(); ++i) {
    largest = std::max(largest, (vertices.rowwise() - turned.row(i)).rowwise().norm().minCoeff());
  }
  return largest;
}

TEST(BuiltinShapes, ABodyOfRevolutionLooksTheSameWhenTurned) {
  for (const Shape& shape : builtin_shapes()) {
    if (symmetry_of(shape.name) != Symmetry::kAxis) continue;
    const int sides = shape.name == "cone" ? 63 : shape.name == "cylinder" ? 32 : 16;
    EXPECT_LT(change_by_turning(shape, 2.0 * M_PI / sides), 1e-3F) << shape.name;
  }
}

TEST(BuiltinShapes, TheTeethOfAGearShowHowItIsTurned) {
  const auto gear = std::find_if(builtin_shapes().begin(), builtin_shapes().end(),
                                 [](const Shape& shape) { return shape.name == "gear"; });
  EXPECT_GT(change_by_turning(*gear, 2.0 * M_PI / 16), 0.05F) << "a tooth is where a gap was";
  EXPECT_EQ(symmetry_of("gear"), Symmetry::kNone);
  const Eigen::Quaterniond still = Eigen::Quaterniond::Identity();
  EXPECT_NEAR(visible_angle("gear", still, rotation_about({0.0, 0.0, 0.2})), 0.2, 1e-9);
}

TEST(BuiltinShapes, OnlyRotationsThatCanBeSeenCount) {
  const Eigen::Quaterniond still = Eigen::Quaterniond::Identity();
  const Eigen::Quaterniond spun = rotation_about({0.0, 0.0, 0.3}), tilted = rotation_about({0.2, 0.0, 0.0});
  EXPECT_EQ(visible_angle("sphere", still, tilted), 0.0);
  for (const char* shape : {"cone", "cylinder", "pear", "torus"}) {
    EXPECT_EQ(symmetry_of(shape), Symmetry::kAxis);
    EXPECT_NEAR(visible_angle(shape, still, spun), 0.0, 1e-9) << shape;
    EXPECT_NEAR(visible_angle(shape, still, tilted * spun), 0.2, 1e-9) << shape;
  }
  for (const char* shape : {"bone", "cube", "pebble", "sponge", "torus_knot", "something else"}) {
    EXPECT_NEAR(visible_angle(shape, still, spun), 0.3, 1e-9) << shape;
  }
}

TEST(BuiltinShapes, SurfacesCanBeSampled) {
  for (const Shape& shape : builtin_shapes()) EXPECT_EQ(sample_surface(shape, 64, 1).points.rows(), 64);
}

}  // namespace
}  // namespace rigidformer
