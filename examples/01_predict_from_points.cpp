// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// This example predicts the future of a cloud of points from two poses: a cube of 1 m falls from a height of 3 m while
// it drifts at 1 m/s.
#include <cmath>
#include <cstdio>

#include "rigidformer/predictor.hpp"

int main() try {
  rigidformer::PredictorOptions options;
  options.file = RIGIDFORMER_SOURCE_DIR "/models/hybrid.safetensors";
  rigidformer::Predictor predictor(options);

  rigidformer::ObjectState cube;
  cube.id = "cube";
  cube.points_reference = 0.5F * rigidformer::Points::Random(240, 3);  // [m]; moved to the six faces below
  for (int i = 0; i < 240; ++i) cube.points_reference(i, i % 3) = i % 2 == 0 ? 0.5F : -0.5F;
  cube.T_world_previous.translation = {0.0, 0.0, 3.0};
  cube.T_world_current.translation = {1.0 / 24.0, 0.0, 3.0};  // This pose is one time step of 1/24 s later.

  rigidformer::RolloutOptions rollout;  // The defaults are a gravity of -10 m/s^2 and a ground at z = 0.
  rollout.time_step_s = 1.0 / 24.0;
  rollout.num_steps = 24;
  const rigidformer::Forecast forecast = predictor.predict({cube}, rollout);
  const auto position = [&](int k) { return forecast.objects[0].poses[static_cast<size_t>(k)].translation; };
  for (int k = 0; k <= 24; k += 4) {
    std::printf("after %.2f s: x %6.3f  y %6.3f  z %6.3f m\n", k / 24.0, position(k).x(), position(k).y(),
                position(k).z());
  }
  // [m] the free fall of 12 steps, in which the cube does not reach the floor.
  const double fallen = 0.5 * 10.0 * (12.0 * 13.0) / (24.0 * 24.0);
  const bool plausible = std::abs(position(0).z() - position(12).z() - fallen) < 0.05 && position(24).z() > 0.25;
  return plausible ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
