// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/window_commands.hpp"

#include "window_batch_fixture.hpp"

namespace rigidformer {
namespace {

SceneArchive commanded_archive() {
  SceneArchive archive = flying_cubes_archive({1, 2, 3}, 60);
  for (SceneRecording& scene : archive.scenes) {
    for (int frame = 0; frame < 60; ++frame) scene.control.push_back({0.1 * frame, 1.0, 0.0});
    scene.control_directions = 1;
  }
  return archive;
}

TEST_F(WindowBatchTest, EveryStepHasTheCommandOfTheFrameItBeginsAt) {
  const SceneTensors tensors = make_scene_tensors({commanded_archive()}, {4, 64, 1});
  const WindowBatch batch = make_window_batch(tensors, kWindows, 2, 4, no_augmentation(64));
  ASSERT_EQ(batch.controls.size(), 2u);
  for (std::int64_t b = 0; b < 3; ++b) {
    const Window& window = kWindows[static_cast<size_t>(b)];
    for (int step = 0; step < 2; ++step) {
      const int frame = window.frame + window.step_size * (1 + step);
      EXPECT_NEAR(batch.controls[static_cast<size_t>(step)][b][0].item<float>(), 0.1 * frame, 1e-5);
    }
  }
}

TEST_F(WindowBatchTest, DirectionsInCommandsTurnWithTheScene) {
  const SceneTensors tensors = make_scene_tensors({commanded_archive()}, {4, 64, 1});
  const SceneTensors plain = make_scene_tensors({flying_cubes_archive({1, 2, 3}, 60)}, {4, 64, 1});
  const Tensor zero = torch::zeros({}), one = torch::ones({});
  const Tensor yaw = torch::stack({zero, -one, zero, one, zero, zero, zero, zero, one}).reshape({1, 3, 3});
  const auto commands = window_commands(tensors, torch::tensor({{0, 5, 10}}, torch::kInt64), yaw);
  ASSERT_EQ(commands.size(), 1u);
  EXPECT_TRUE(torch::allclose(commands[0], torch::tensor({{0.5, 0.0, 1.0}}, torch::kFloat32)));
  EXPECT_TRUE(window_commands(plain, torch::tensor({{0, 5, 10}}, torch::kInt64), yaw).empty());
}

TEST(SceneTensorsTest, OtherWidthsOfCommandsAreRefused) {
  SceneArchive archive = commanded_archive();
  archive.scenes[1].control.clear();
  EXPECT_THROW(make_scene_tensors({archive}, {4, 64, 1}), std::invalid_argument);
}

TEST(SceneTensorsTest, StepsOfSlowerRecordingsLastLonger) {
  SceneArchive archive = flying_cubes_archive({1}, 60);
  archive.scenes[0].frame_rate_hz = 30.0;
  const SceneTensors tensors = make_scene_tensors({archive}, {4, 64, 1});
  const WindowBatch batch = make_window_batch(tensors, {{0, 0, 10}}, 1, 4, no_augmentation(64));
  EXPECT_NEAR(batch.scene.time_step()[0].item<double>(), 1.0 / 3.0, 1e-6);
}

}  // namespace
}  // namespace rigidformer
