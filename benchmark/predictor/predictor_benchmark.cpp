// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "paper_scene.hpp"
#include "peak_memory.hpp"
#include "ratio_reporter.hpp"
#include "rigidformer/model/checkpoint.hpp"
#include "rigidformer/predictor.hpp"

namespace rigidformer {
namespace {

constexpr int kStepsPerRollout = 10;  // chosen by eye, as the numbers below
constexpr int kMemorySteps = 5000;    // steps over which memory is watched
constexpr int kWarmUpSteps = 500;     // steps before the first look at memory

/// A checkpoint with random weights, deleted at the end: time and memory do not depend on the weights.
class TemporaryCheckpoint {
 public:
  explicit TemporaryCheckpoint(const std::string& preset)
      : path_(std::filesystem::temp_directory_path() /
              ("rigidformer_bench_" + std::to_string(getpid()) + ".safetensors")) {
    TrainingFacts facts;
    facts.max_diameter_m = 2.0;
    facts.max_speed_mps = 20.0;
    facts.max_points = 1142;
    save_checkpoint(path_, RigidFormer(model_preset(preset)), facts);
  }
  ~TemporaryCheckpoint() { std::filesystem::remove(path_); }
  TemporaryCheckpoint(const TemporaryCheckpoint&) = delete;
  TemporaryCheckpoint& operator=(const TemporaryCheckpoint&) = delete;

  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

PredictorOptions on_cpu(const std::string& file, const std::string& precision) {
  PredictorOptions options;
  options.file = file;
  options.device = "cpu";
  options.precision = precision;
  return options;
}

RolloutOptions rollout_of(int num_steps) {
  RolloutOptions rollout;
  rollout.num_steps = num_steps;
  return rollout;
}

double resident_mib() {
  std::ifstream file("/proc/self/statm");
  double total_pages = 0.0, resident_pages = 0.0;
  file >> total_pages >> resident_pages;
  return resident_pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

/// Times one predicted step with everything included: the mean over the steps of a rollout.
void step(benchmark::State& state, const std::string& preset, const std::string& precision) {
  const TemporaryCheckpoint checkpoint(preset);
  Predictor predictor(on_cpu(checkpoint.path(), precision));
  predictor.warm_up();
  const auto objects = paper_scene();
  for (auto _ : state) {
    const Forecast forecast = predictor.predict(objects, rollout_of(kStepsPerRollout));
    state.SetIterationTime(forecast.compute_time_s / kStepsPerRollout);
  }
}

/// Watches resident memory over many steps of scenes whose point counts change from rollout to rollout.
void memory_growth(benchmark::State& state) {
  const TemporaryCheckpoint checkpoint("small");
  Predictor predictor(on_cpu(checkpoint.path(), "float32"));
  const auto scene = paper_scene();
  double after_warm_up = 0.0;
  for (auto _ : state) {
    for (int done = 0; done < kMemorySteps; done += kStepsPerRollout) {
      if (done == kWarmUpSteps) {
        after_warm_up = resident_mib();
      }
      auto objects = scene;
      for (std::size_t i = 0; i < objects.size(); ++i) {
        const auto rows = objects[i].points_reference.rows();
        const Eigen::Index kept = 16 + (37 * done + 101 * static_cast<Eigen::Index>(i)) % (rows - 16);
        objects[i].points_reference = objects[i].points_reference.topRows(kept).eval();
      }
      benchmark::DoNotOptimize(predictor.predict(objects, rollout_of(kStepsPerRollout)));
    }
  }
  state.counters["resident_MiB"] = resident_mib();
  state.counters["growth_MiB"] = resident_mib() - after_warm_up;
}

/// Measures peak memory in a process of its own, which only loads and predicts.
void peak_memory(benchmark::State& state, const std::string& preset) {
  const TemporaryCheckpoint checkpoint(preset);
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command = "\"" + program + "\" --peak-memory \"" + checkpoint.path() + "\"";
  double peak_mib = 0.0;
  for (auto _ : state) {
    FILE* child = popen(command.c_str(), "r");
    if (child == nullptr || std::fscanf(child, "%lf", &peak_mib) != 1) {
      state.SkipWithError("the measuring process failed");
    }
    if (child != nullptr) {
      pclose(child);
    }
  }
  state.counters["peak_MiB"] = peak_mib;
}

const bool kRegistered = [] {
  for (const std::string preset : {"paper", "small"}) {
    for (const std::string precision : {"float32", "bfloat16"}) {
      const std::string name = preset + "/" + precision + "/total";
      benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { step(state, preset, precision); })
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
      RatioReporter::compare(name, preset + "/float32/step_with_distance_matrix");
    }
    const std::string name = preset + "/float32/peak_memory";
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { peak_memory(state, preset); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::RegisterBenchmark("small/float32/memory_over_5000_steps", memory_growth)
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace

double peak_memory_of(const std::string& checkpoint) {
  Predictor predictor(on_cpu(checkpoint, "float32"));
  predictor.predict(paper_scene(), rollout_of(20));
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace rigidformer
