// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <torch/torch.h>

#include "paper_scene.hpp"
#include "ratio_reporter.hpp"
#include "rigidformer/geometry/nearest_points.hpp"
#include "rigidformer/model/rigid_projection.hpp"

namespace rigidformer {
namespace {

constexpr const char* kTrees = "nearest_points/trees";
constexpr const char* kTreesBuild = "nearest_points/trees_with_build";
constexpr const char* kMatrix = "nearest_points/distance_matrix";

std::vector<Points> clouds_of(const std::vector<ObjectState>& objects) {
  std::vector<Points> clouds;
  for (const ObjectState& object : objects) {
    clouds.push_back(object.points_reference);
  }
  return clouds;
}

/// Poses as in the steps of a rollout: trees are built once, and poses move by a few
/// centimetres and degrees between queries.
void trees(benchmark::State& state) {
  const auto objects = paper_scene();
  NearestPoints search(clouds_of(objects));
  std::vector<NearestNeighbors> nearest;
  int step = 0;
  for (auto _ : state) {
    search.query(moved_poses(objects, step++ % 20), nearest);
    benchmark::DoNotOptimize(nearest.data());
  }
}

void trees_with_build(benchmark::State& state) {
  const auto objects = paper_scene();
  const auto poses = moved_poses(objects, 0);
  std::vector<NearestNeighbors> nearest;
  for (auto _ : state) {
    NearestPoints(clouds_of(objects)).query(poses, nearest);
    benchmark::DoNotOptimize(nearest.data());
  }
}

/// The alternative: torch::cdist of all points against all, an object's own points masked out, then min.
void distance_matrix(benchmark::State& state) {
  torch::NoGradGuard no_grad;
  const auto objects = paper_scene();
  std::vector<Tensor> parts, owners;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    Points world = objects[i].T_world_current.apply(objects[i].points_reference);
    parts.push_back(torch::from_blob(world.data(), {world.rows(), 3}).clone());
    owners.push_back(torch::full({world.rows()}, static_cast<std::int64_t>(i)));
  }
  const Tensor points = torch::cat(parts);
  const Tensor owner = torch::cat(owners);
  const Tensor own = owner.unsqueeze(0).eq(owner.unsqueeze(1));
  for (auto _ : state) {
    const auto nearest = torch::cdist(points, points).masked_fill_(own, 1e6).min(1);
    benchmark::DoNotOptimize(std::get<1>(nearest).data_ptr());
  }
}

/// Times the rigid projection of the scene's anchors: 10 objects with 4 anchors each.
void kabsch(benchmark::State& state) {
  torch::NoGradGuard no_grad;
  const auto objects = paper_scene();
  const SceneBatch batch = as_batch(objects);
  const Tensor anchors = batch.anchors_reference();
  const Tensor target = as_state(objects).current.apply(anchors) + 0.01 * torch::randn_like(anchors);
  for (auto _ : state) {
    benchmark::DoNotOptimize(align_rigidly(anchors, target).translation.data_ptr());
  }
}

const bool kRegistered = [] {
  benchmark::RegisterBenchmark(kTrees, trees)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark(kTreesBuild, trees_with_build)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark(kMatrix, distance_matrix)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("kabsch", kabsch)->Unit(benchmark::kMillisecond);
  RatioReporter::compare(kTrees, kMatrix);
  RatioReporter::compare(kTreesBuild, kMatrix);
  return true;
}();

}  // namespace
}  // namespace rigidformer
