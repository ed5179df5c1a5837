// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "walker_scene.hpp"

#include <cmath>

#include "rigidformer/geometry/random.hpp"
#include "walker_world.hpp"

namespace rigidformer {
namespace {

constexpr int kStepsPerFrame = 16;     // of the solver, 480 per second: motors hold without ringing; chosen by eye
constexpr int kStandingUpFrames = 45;  // in which the walker settles and reaches its speed; chosen by eye
constexpr int kCommandGrid = 10;       // frames; as long as the steps of App. I.2
constexpr int kFewestGridSteps = 6, kMostGridSteps = 12;  // between two commands; chosen by eye
constexpr double kMinSpeed_mps = 0.2, kMaxSpeed_mps = 0.6;
constexpr double kMaxChange_rad = 0.5 * M_PI;

WalkerCommand draw_command(const WalkerDesign& design, double direction_rad, Random& random) {
  WalkerCommand command;
  command.speed_mps = random.uniform(kMinSpeed_mps, kMaxSpeed_mps);
  command.direction_rad = direction_rad;
  if (design.neck) command.facing_rad = direction_rad + random.uniform(-kMaxChange_rad, kMaxChange_rad);
  return command;
}

SceneRecording empty_recording(const WalkerDesign& design, const std::vector<WalkerCommand>& commands) {
  SceneRecording scene;
  scene.frame_rate_hz = kWalkerFrameRate_hz;
  scene.num_frames = static_cast<int>(commands.size());
  scene.control_directions = design.neck ? 2 : 1;
  for (const WalkerCommand& command : commands) scene.control.push_back(command.numbers());
  for (const WalkerPart& part : design.parts) {
    RecordedObject object;
    object.shape = part.shape;
    object.properties = {part.mass_kg, kWalkerFriction, kWalkerRestitution};
    scene.objects.push_back(object);
  }
  return scene;
}

}  // namespace

std::vector<WalkerCommand> draw_walker_commands(const WalkerDesign& design, std::uint64_t seed, std::uint64_t index,
                                                int num_frames) {
  Random random(seed, index);
  std::vector<WalkerCommand> commands;
  double direction_rad = random.uniform(-M_PI, M_PI);
  while (static_cast<int>(commands.size()) < num_frames) {
    const WalkerCommand command = draw_command(design, direction_rad, random);
    const int frames = kCommandGrid * random.uniform_int(kFewestGridSteps, kMostGridSteps);
    commands.insert(commands.end(), static_cast<std::size_t>(frames), command);
    direction_rad += random.uniform(-kMaxChange_rad, kMaxChange_rad);
  }
  commands.resize(static_cast<std::size_t>(num_frames));
  return commands;
}

SceneRecording simulate_walker(const WalkerDesign& design, const std::vector<WalkerCommand>& commands,
                               std::uint64_t seed, std::uint64_t index, int first_frame) {
  Random random(seed, index);
  SceneRecording scene = empty_recording(design, commands);
  scene.name = std::to_string(index);
  scene.seed = seed;
  WalkerGait gait(design, random.uniform(0.0, 1.0));
  WalkerWorld world(design, commands.front().direction_rad);
  const double time_step_s = 1.0 / (kWalkerFrameRate_hz * kStepsPerFrame);
  const auto walk_frame = [&](const WalkerCommand& command) {
    for (int i = 0; i < kStepsPerFrame; ++i) {
      world.step(gait.advance(command, world.yaw_rad(), time_step_s), time_step_s);
    }
  };
  for (int frame = 0; frame < kStandingUpFrames + first_frame; ++frame) walk_frame(commands.front());
  for (std::size_t frame = 0; frame < commands.size(); ++frame) {
    for (std::size_t part = 0; part < scene.objects.size(); ++part) {
      scene.objects[part].T_world_object.push_back(world.T_world_part(part));
    }
    walk_frame(commands[frame]);
  }
  return scene;
}

}  // namespace rigidformer
