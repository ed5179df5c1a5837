// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/depth_camera.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "rigidformer/geometry/random.hpp"
#include "rigidformer/simulation/builtin_shapes.hpp"

namespace rigidformer {
namespace {

const Shape& shape_named(const std::string& name) {
  return *std::find_if(builtin_shapes().begin(), builtin_shapes().end(),
                       [&](const Shape& shape) { return shape.name == name; });
}

CameraBody body_at(const std::string& name, const Eigen::Vector3d& position_camera, double size = 1.0,
                   const Eigen::Quaterniond& rotation = Eigen::Quaterniond::Identity()) {
  return {&shape_named(name), size, {rotation, position_camera}};
}

CameraIntrinsics small_camera() {
  CameraIntrinsics camera;
  camera.width = 80;
  camera.height = 60;
  return camera;
}

DepthCameraOptions perfect() {
  DepthCameraOptions options;
  options.depth_noise_m = options.pixel_noise_px = options.dropout = options.mislabelled = 0.0;
  return options;
}

DepthImage render(const std::vector<CameraBody>& bodies) { return render_depth(small_camera(), bodies, {}, {}); }

/// Depth of the first triangle that a ray from the camera meets (by Moeller and
/// Trumbore); infinity where it meets none.
double first_hit(const std::vector<CameraBody>& bodies, const Eigen::Vector3d& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const CameraBody& body : bodies) {
    for (const ConvexPart& part : body.shape->parts) {
      const Points vertices = body.T_camera_body.apply(part.vertices * static_cast<float>(body.size));
      for (Eigen::Index t = 0; t < part.triangles.rows(); ++t) {
        const Eigen::Vector3d a = vertices.row(part.triangles(t, 0)).transpose().cast<double>();
        const Eigen::Vector3d e1 = vertices.row(part.triangles(t, 1)).transpose().cast<double>() - a;
        const Eigen::Vector3d e2 = vertices.row(part.triangles(t, 2)).transpose().cast<double>() - a;
        const double det = e1.dot(ray.cross(e2));
        const double u = -a.dot(ray.cross(e2)) / det;
        const double v = ray.dot((-a).cross(e1)) / det;
        const double depth = e2.dot((-a).cross(e1)) / det;
        if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && depth > 1e-3) nearest = std::min(nearest, depth);
      }
    }
  }
  return nearest;
}

std::vector<CameraBody> clutter() {
  Random random(5);
  std::vector<CameraBody> bodies;
  for (const char* name : {"torus", "cube", "gear", "sphere", "bone", "torus_knot"}) {
    bodies.push_back(body_at(name, {random.uniform(-1.2, 1.2), random.uniform(-0.8, 0.8), random.uniform(3.0, 5.0)},
                             1.0, random.rotation()));
  }
  bodies.push_back(body_at("cube", {0.0, 0.2, 0.3}, 1.0));  // beside the camera and partly behind it
  return bodies;
}

TEST(DepthCamera, OccludedPointsNeverAppear) {
  std::vector<CameraBody> bodies = clutter();
  bodies.pop_back();
  const DepthImage image = render(bodies);
  const CameraFrame frame = measure(image, perfect(), 0);
  ASSERT_GT(frame.points_camera.rows(), 1000);
  for (Eigen::Index i = 0; i < frame.points_camera.rows(); ++i) {
    const Eigen::Vector3d point = frame.points_camera.row(i).transpose().cast<double>();
    EXPECT_NEAR(first_hit(bodies, point / point.z()), point.z(), 2e-4 * point.z());
  }
}

TEST(DepthCamera, EveryRayThatMeetsABodyGivesAPoint) {
  const std::vector<CameraBody> bodies{body_at("torus", {0.2, 0.0, 3.0}), body_at("cube", {-0.5, 0.1, 4.0})};
  const DepthImage image = render(bodies);
  const CameraIntrinsics camera = small_camera();
  int disagreements = 0;
  for (int pixel = 0; pixel < camera.width * camera.height; ++pixel) {
    const double depth = first_hit(bodies, camera.ray(pixel % camera.width + 0.5, pixel / camera.width + 0.5));
    const float seen = image.depth_m[static_cast<std::size_t>(pixel)];
    disagreements += std::isinf(depth) != std::isinf(seen) || (!std::isinf(depth) && std::abs(depth - seen) > 1e-3);
  }
  EXPECT_LE(disagreements, 2) << "rays along an edge may go either way";
}

TEST(DepthCamera, BodiesPartlyBehindTheCameraDoNotSpoilTheImage) {
  const DepthImage image = render({body_at("cube", {0.0, 0.8, 0.3}), body_at("sphere", {0.0, -0.3, 3.0})});
  EXPECT_GT(std::count(image.body.begin(), image.body.end(), 0), 0);
  EXPECT_GT(std::count(image.body.begin(), image.body.end(), 1), 0);
  const DepthImage behind = render({body_at("cube", {0.0, 0.0, -3.0})});
  EXPECT_TRUE(std::all_of(behind.depth_m.begin(), behind.depth_m.end(), [](float depth) { return std::isinf(depth); }));
}

TEST(DepthCamera, TheNearerBodyHidesTheOther) {
  const SurfaceSamples surface = sample_surface(shape_named("cube"), 500, 1);
  const CameraBody cube = body_at("cube", {0.0, 0.0, 5.0});
  const double alone = visible_fraction(render({cube}), cube, 0, surface);
  EXPECT_NEAR(alone, 1.0 / 6.0, 0.04) << "one face of six";
  EXPECT_EQ(visible_fraction(render({cube, body_at("cube", {0.0, 0.0, 2.0}, 1.2)}), cube, 0, surface), 0.0);
  const double half = visible_fraction(render({cube, body_at("cube", {1.0, 0.0, 3.5}, 1.5)}), cube, 0, surface);
  EXPECT_GT(half, 0.2 * alone);
  EXPECT_LT(half, 0.9 * alone);
}

TEST(DepthCamera, ASphereShowsItsNearCap) {
  const Shape& sphere = shape_named("sphere");
  const CameraBody body = body_at("sphere", {0.3, 0.2, 3.0});
  const double radius = sphere.vertices().rowwise().norm().mean();
  const double cap = 0.5 * (1.0 - radius / body.T_camera_body.translation.norm());
  EXPECT_NEAR(visible_fraction(render({body}), body, 0, sample_surface(sphere, 2000, 1)), cap, 0.04);
}

TEST(DepthCamera, TheGroundIsBackgroundBehindTheBodies) {
  const RigidTransform T_world_camera = look_at({0.0, -3.0, 2.0}, {0.0, 0.0, 0.0});
  const RigidTransform T_camera_world = T_world_camera.inverse();
  const CameraBody cube{&shape_named("cube"), 1.0, T_camera_world};
  const DepthImage image = render_depth(small_camera(), {cube}, T_camera_world, 0.0);
  const CameraFrame frame = measure(image, perfect(), 0);
  const Points world = T_world_camera.apply(frame.points_camera);
  for (Eigen::Index i = 0; i < world.rows(); ++i) {
    if (frame.body[static_cast<std::size_t>(i)] == DepthImage::kBackground) {
      EXPECT_NEAR(world(i, 2), 0.0F, 1e-4F);
    } else {
      EXPECT_GT(world(i, 2), -1e-4F) << "what is below the ground is hidden by it";
    }
  }
  EXPECT_GT(world.rows(), small_camera().width * small_camera().height / 2);
}

TEST(DepthCamera, LookAtKeepsTheImageUpright) {
  const RigidTransform T_world_camera = look_at({4.0, -2.0, 3.0}, {0.0, 0.5, 1.0});
  const Eigen::Vector3d target = T_world_camera.inverse() * Eigen::Vector3d(0.0, 0.5, 1.0);
  EXPECT_NEAR(target.head<2>().norm(), 0.0, 1e-12);
  EXPECT_GT(target.z(), 0.0);
  EXPECT_LT((T_world_camera.rotation * Eigen::Vector3d::UnitY()).z(), 0.0) << "down in the image is down";
  EXPECT_NEAR((T_world_camera.rotation * Eigen::Vector3d::UnitX()).z(), 0.0, 1e-12);
}

/// Fills the whole image evenly.
DepthImage wall(double distance_m) {
  return render_depth(small_camera(), {body_at("cube", {0.0, 0.0, distance_m + 50.0}, 100.0)}, {}, {});
}

TEST(DepthCamera, NoiseHasTheStatedSpread) {
  DepthCameraOptions options = perfect();
  options.depth_noise_m = 0.01;
  options.pixel_noise_px = 0.5;
  const DepthImage image = wall(2.0);
  double depth_mean = 0.0, depth_square = 0.0, pixel_square = 0.0;
  int count = 0;
  for (std::uint64_t number = 0; number < 4; ++number) {
    const CameraFrame frame = measure(image, options, number);
    for (Eigen::Index i = 0; i < frame.points_camera.rows(); ++i, ++count) {
      const int pixel = frame.pixel[static_cast<std::size_t>(i)];
      const Eigen::Vector3d p = frame.points_camera.row(i).transpose().cast<double>();
      const double error = p.z() - image.depth_m[static_cast<std::size_t>(pixel)];
      const double column = p.x() / p.z() * image.intrinsics.focal_length_px() + 0.5 * image.intrinsics.width;
      depth_mean += error;
      depth_square += error * error;
      pixel_square += std::pow(column - (pixel % image.intrinsics.width + 0.5), 2);
    }
  }
  EXPECT_EQ(count, 4 * 80 * 60);
  EXPECT_NEAR(depth_mean / count, 0.0, 4.0 * 0.01 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(depth_square / count), 0.01, 0.0003);
  EXPECT_NEAR(std::sqrt(pixel_square / count), 0.5, 0.015);
}

TEST(DepthCamera, DropoutLosesTheStatedShare) {
  DepthCameraOptions options = perfect();
  options.dropout = 0.3;
  EXPECT_NEAR(static_cast<double>(measure(wall(2.0), options, 0).points_camera.rows()) / (80 * 60), 0.7, 0.03);
}

TEST(DepthCamera, FarSurfacesGiveNoPoint) {
  DepthCameraOptions options = perfect();
  options.max_range_m = 1.5;
  EXPECT_EQ(measure(wall(2.0), options, 0).points_camera.rows(), 0);
}

TEST(DepthCamera, OnlyBorderPixelsAreMislabelledInTheStatedShare) {
  const DepthImage image = render(clutter());
  DepthCameraOptions options = perfect();
  options.mislabelled = 0.4;
  const CameraFrame frame = measure(image, options, 0);
  const int width = image.intrinsics.width;
  int border = 0, wrong = 0;
  for (std::size_t i = 0; i < frame.body.size(); ++i) {
    const int pixel = frame.pixel[i];
    const int own = image.body[static_cast<std::size_t>(pixel)];
    bool at_border = false, across = frame.body[i] == own;
    for (const auto& [column, row] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
      const int c = pixel % width + column, r = pixel / width + row;
      if (c < 0 || c >= width || r < 0 || r >= image.intrinsics.height) continue;
      const int other = image.body[static_cast<std::size_t>(r * width + c)];
      at_border = at_border || other != own;
      across = across || frame.body[i] == other;
    }
    EXPECT_TRUE(across) << "pixel " << pixel << " has a label that is not next to it";
    border += at_border;
    wrong += frame.body[i] != own;
  }
  ASSERT_GT(border, 200);
  EXPECT_NEAR(static_cast<double>(wrong) / border, 0.4, 0.1);
}

TEST(DepthCamera, SameSeedAndFrameSamePoints) {
  const DepthImage image = render(clutter());
  const DepthCameraOptions options;
  const CameraFrame first = measure(image, options, 3);
  EXPECT_EQ(measure(image, options, 3).points_camera, first.points_camera);
  EXPECT_EQ(measure(image, options, 3).body, first.body);
  EXPECT_NE(measure(image, options, 4).pixel, first.pixel);
  DepthCameraOptions other = options;
  other.seed = 2;
  EXPECT_NE(measure(image, other, 3).pixel, first.pixel);
}

TEST(DepthCamera, InvalidOptionsAreNamed) {
  const std::pair<const char*, std::function<void(DepthCameraOptions&)>> cases[] = {
      {"width", [](DepthCameraOptions& o) { o.intrinsics.width = 0; }},
      {"horizontal_fov_rad", [](DepthCameraOptions& o) { o.intrinsics.horizontal_fov_rad = 3.2; }},
      {"max_range_m", [](DepthCameraOptions& o) { o.max_range_m = 0.0; }},
      {"depth_noise_m", [](DepthCameraOptions& o) { o.depth_noise_m = -1.0; }},
      {"pixel_noise_px", [](DepthCameraOptions& o) { o.pixel_noise_px = std::nan(""); }},
      {"dropout", [](DepthCameraOptions& o) { o.dropout = 1.0; }},
      {"mislabelled", [](DepthCameraOptions& o) { o.mislabelled = 1.1; }}};
  for (const auto& [name, damage] : cases) {
    DepthCameraOptions options;
    damage(options);
    try {
      options.validate();
      ADD_FAILURE() << name << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace rigidformer
