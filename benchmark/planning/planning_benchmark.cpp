// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Candidates of one scene against single calls: time, memory and the ratio of both.
//   planning_bench MODEL_FILE [THREADS]
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "rigidformer/predictor.hpp"

namespace {

using namespace rigidformer;

constexpr int kObjects = 10;  // the scene of the targets
constexpr int kSteps = 24;    // 1 s
constexpr int kPoints = 256;  // per object, all that the shipped model looks at
constexpr int kSingles = 64;  // single calls that a batch of as many is compared with

/// Boxes of 1 m beside each other on the ground, 0.3 m apart, each of known material.
std::vector<ObjectState> table_scene() {
  std::srand(7);
  std::vector<ObjectState> objects(kObjects);
  for (int i = 0; i < kObjects; ++i) {
    ObjectState& object = objects[static_cast<std::size_t>(i)];
    object.id = "box_" + std::to_string(i);
    object.points_reference = 0.5F * Points::Random(kPoints, 3);
    for (int row = 0; row < kPoints; ++row) object.points_reference(row, row % 3) = row % 2 == 0 ? 0.5F : -0.5F;
    object.T_world_current.translation = {1.3 * (i % 5), 1.3 * (i / 5), 0.501};
    object.T_world_previous = object.T_world_current;
    object.properties = {1.0, 0.5, 0.3};
  }
  return objects;
}

/// Pushes of one box in as many directions, and a slow finger in every fourth candidate.
std::vector<Candidate> candidates(int count) {
  std::vector<Candidate> pushes;
  for (int i = 0; i < count; ++i) {
    Candidate candidate;
    const double angle = 2.0 * M_PI * i / count;
    const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0.0);
    candidate.pushes = {{"box_0", 0.0, 4.0 * direction, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}};
    if (i % 4 == 0) {
      const RigidTransform from{Eigen::Quaterniond::Identity(), {-0.9, 0.0, 0.4}};
      const RigidTransform to{Eigen::Quaterniond::Identity(), {-0.4, 0.0, 0.4}};
      candidate.pushes.clear();
      candidate.tracks = {{"finger", 0.3F * table_scene()[0].points_reference, {}, {0.0, 1.0}, {from, to}}};
    }
    pushes.push_back(candidate);
  }
  return pushes;
}

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double peak_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

double batch_s(Predictor& predictor, Fidelity fidelity, int count, int num_threads) {
  BatchOptions options;
  options.rollout.num_steps = kSteps;
  options.fidelity = fidelity;
  options.num_threads = num_threads;
  return seconds([&] {
    const auto rollout = predictor.start_batch(table_scene(), candidates(count), options);
    while (rollout->advance()) {
    }
    for (const CandidateOutcome& outcome : rollout->outcomes()) {
      if (outcome.stop != CandidateOutcome::Stop::kHorizon) std::printf("refused: %s\n", outcome.message.c_str());
    }
  });
}

/// Calls of a batch of one each: what a planner has without batches.
double singles_s(Predictor& predictor, Fidelity fidelity) {
  BatchOptions options;
  options.rollout.num_steps = kSteps;
  options.fidelity = fidelity;
  return seconds([&] {
    for (const Candidate& candidate : candidates(kSingles)) {
      const auto rollout = predictor.start_batch(table_scene(), {candidate}, options);
      while (rollout->advance()) {
      }
    }
  });
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::fprintf(stderr, "usage: %s MODEL_FILE [THREADS]\n", argv[0]);
    return 2;
  }
  PredictorOptions options;
  options.file = argv[1];
  options.device = "cpu";
  const int num_threads = argc > 2 ? std::atoi(argv[2]) : 1;
  Predictor predictor(options);
  predictor.warm_up();
  std::printf("%d objects of %d points, %d steps, %d threads\n", kObjects, kPoints, kSteps, num_threads);
  std::printf("steps per second and thread at warm-up: model %.0f, engine %.0f\n", predictor.info().model_steps_per_s,
              predictor.info().engine_steps_per_s);
  for (const Fidelity fidelity : {Fidelity::kEngine, Fidelity::kModel}) {
    const char* name = fidelity == Fidelity::kEngine ? "ENGINE" : "MODEL";
    const double few_s = batch_s(predictor, fidelity, kSingles, num_threads);
    std::printf("%-6s  %3d candidates  %7.2f s\n", name, kSingles, few_s);
    std::printf("%-6s  %3d candidates  %7.2f s  peak %.0f MiB\n", name, 256,
                batch_s(predictor, fidelity, 256, num_threads), peak_mib());
    const double single_s = singles_s(predictor, fidelity);
    std::printf("%-6s  %3d single calls %7.2f s  ratio %.2f\n", name, kSingles, single_s, single_s / few_s);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
