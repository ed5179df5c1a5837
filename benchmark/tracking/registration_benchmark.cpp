// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ratio_reporter.hpp"
#include "rigidformer/tracking/cloud_registration.hpp"
#include "rigidformer/tracking/shape_camera.hpp"
#include "tracking/tracking_benchmark.hpp"

namespace rigidformer {
namespace {

using testing::ShapeCamera;
using PclCloud = pcl::PointCloud<pcl::PointNormal>;

constexpr int kPoints = 1000;                 // per cloud, about a metre large; chosen by eye
constexpr int kClouds = 20;                   // over which errors are averaged; chosen by eye
constexpr double kTurn = 8.0 * M_PI / 180.0;  // [rad] of an object between two frames; chosen by eye
constexpr double kMove = 0.06;                // [m] of an object between two frames; chosen by eye

PclCloud::Ptr to_pcl(const Points& points, const Points& normals) {
  auto cloud = std::make_shared<PclCloud>();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (!normals.row(i).isZero()) {  // every method gets the points that point-to-plane can use
      cloud->emplace_back(points(i, 0), points(i, 1), points(i, 2), normals(i, 0), normals(i, 1), normals(i, 2));
    }
  }
  return cloud;
}

/// Views of one object about a metre large, each moved by another small motion from the known reference cloud.
struct Views {
  CorrespondenceOptions parameters;
  ShapeCamera camera{"bone", 1.0, 5};
  ReferenceCloud reference{estimate_surface(camera.sample(RigidTransform(), 2000), parameters.noise), parameters};
  std::vector<RigidTransform> T_world_object;
  std::vector<Points> clouds_world;

  Views() {
    for (int i = 0; i < kClouds; ++i) {
      const Eigen::Vector3d axis = camera.random().rotation() * Eigen::Vector3d::UnitX();
      const Eigen::Vector3d move = kMove * (camera.random().rotation() * axis);
      T_world_object.push_back({Eigen::Quaterniond(Eigen::AngleAxisd(kTurn, axis)), move});
      const Eigen::Vector3d eye = camera.random().rotation() * Eigen::Vector3d(0.0, 0.0, 3.0);
      clouds_world.push_back(camera.look(T_world_object.back(), eye, kPoints).points_world);
    }
  }
};

const Views& views() {
  static const Views all;
  return all;
}

/// Times `find_pose(i)` over the clouds and reports the mean errors of its poses.
template <class FindPose>
void measure(benchmark::State& state, const FindPose& find_pose) {
  double position_m = 0.0;
  double rotation_rad = 0.0;
  int done = 0;
  for (auto _ : state) {
    const auto i = static_cast<std::size_t>(done++ % kClouds);
    const RigidTransform found = find_pose(i);
    const RigidTransform& truth = views().T_world_object[i];
    position_m += (found.translation - truth.translation).norm();
    rotation_rad += rotation_angle(found.rotation, truth.rotation);
  }
  state.counters["position_mm"] = 1e3 * position_m / done;
  state.counters["rotation_deg"] = 180.0 / M_PI * rotation_rad / done;
}

void by_register_cloud(benchmark::State& state) {
  measure(state, [](std::size_t i) {
    return register_cloud(views().reference, estimate_surface(views().clouds_world[i], views().parameters.noise),
                          RigidTransform(), RigidTransform(), views().parameters)
        .T_world_object;
  });
}

template <class Method>
void by_pcl(benchmark::State& state) {
  const Views& all = views();
  std::vector<PclCloud::Ptr> clouds;
  for (const Points& points : all.clouds_world) {
    // Point-to-plane asks for the target's normals only.
    clouds.push_back(to_pcl(points, Points::Constant(points.rows(), 3, 1.0F / std::sqrt(3.0F))));
  }
  Method method;
  method.setInputTarget(to_pcl(all.reference.points(), all.reference.normals()));
  method.setMaxCorrespondenceDistance(all.parameters.max_correspondence_distance * all.reference.size_m());
  method.setMaximumIterations(all.parameters.max_iterations);
  PclCloud aligned;
  measure(state, [&](std::size_t i) {
    method.setInputSource(clouds[i]);
    method.align(aligned);
    const Eigen::Matrix4d T_object_world = method.getFinalTransformation().template cast<double>();
    return RigidTransform{Eigen::Quaterniond(Eigen::Matrix3d(T_object_world.topLeftCorner<3, 3>())),
                          T_object_world.topRightCorner<3, 1>()}
        .inverse();
  });
}

using Icp = pcl::IterativeClosestPoint<pcl::PointNormal, pcl::PointNormal>;
using IcpWithNormals = pcl::IterativeClosestPointWithNormals<pcl::PointNormal, pcl::PointNormal>;
using Gicp = pcl::GeneralizedIterativeClosestPoint<pcl::PointNormal, pcl::PointNormal>;

BENCHMARK(by_register_cloud)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(by_pcl, Icp)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(by_pcl, IcpWithNormals)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(by_pcl, Gicp)->Unit(benchmark::kMillisecond);

/// Takes `--seed=N` out of the arguments. Throws std::invalid_argument where N is no number.
void take_seed(int& argc, char** argv) {
  const std::string option = "--seed=";
  char** const end = std::remove_if(argv + 1, argv + argc, [&](const std::string& argument) {
    const bool is_seed = argument.compare(0, option.size(), option) == 0;
    tracking_seed = is_seed ? std::stoull(argument.substr(option.size())) : tracking_seed;
    return is_seed;
  });
  argc = static_cast<int>(end - argv);
}

}  // namespace
}  // namespace rigidformer

int main(int argc, char** argv) {
  rigidformer::take_seed(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 1;
  }
  for (const std::string method : {"Icp", "IcpWithNormals", "Gicp"}) {
    rigidformer::RatioReporter::compare("by_register_cloud", "by_pcl<" + method + ">");
  }
  rigidformer::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  return 0;
}
