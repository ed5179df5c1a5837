// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <torch/torch.h>

#include <cstdio>
#include <string>

#include "peak_memory.hpp"
#include "ratio_reporter.hpp"
#include "rigidformer/model/threads.hpp"

int main(int argc, char** argv) {
  rigidformer::use_vector_units();
  at::set_num_threads(1);  // numbers must not depend on the neighbours of a shared machine
  if (argc == 3 && std::string(argv[1]) == "--peak-memory") {
    std::printf("%.1f\n", rigidformer::peak_memory_of(argv[2]));
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 1;
  }
  rigidformer::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  return 0;
}
