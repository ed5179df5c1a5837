// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// This example plans a throw. It rolls out several throws of the same box past a ball, each with another speed, and
// picks the throw after which the box comes to rest nearest to a goal.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "rigidformer/predictor.hpp"

namespace {

using namespace rigidformer;

// [s]. The longest time step that the shipped model was trained on.
constexpr double kTimeStep = 10.0 / 240.0;
// Steps of a rollout: 3 s, chosen by eye so that the box comes to rest.
constexpr int kNumSteps = 72;
// [m/s]. A box that stays slower than this until the end is at rest; chosen by eye.
constexpr double kRestSpeed = 0.1;
// [m]. Where the box should come to rest; chosen by eye.
const Eigen::Vector3d kGoal(2.0, 0.0, 0.0);

/// Makes points on the six faces of a box with the given edges [m].
Points box_points(const Eigen::RowVector3f& edges) {
  Points points = Points::Random(240, 3);
  for (int i = 0; i < 240; ++i) points(i, i % 3) = i % 2 == 0 ? 1.0F : -1.0F;
  return 0.5F * (points.array().rowwise() * edges.array()).matrix();
}

Points ball_points(float radius_m) { return radius_m * Points::Random(240, 3).rowwise().normalized(); }

/// The pose that a body in free flight with velocity v [m/s] at `now` had one time step earlier: x - v dt + g dt^2 / 2.
RigidTransform one_step_before(const RigidTransform& now, const Eigen::Vector3d& v) {
  const Eigen::Vector3d g(0.0, 0.0, -10.0);
  return {now.rotation, now.translation - v * kTimeStep + 0.5 * g * kTimeStep * kTimeStep};
}

std::vector<ObjectState> thrown_scene(const Eigen::Vector3d& velocity) {
  ObjectState box, ball;
  box.id = "box";
  box.points_reference = box_points({1.0F, 0.8F, 0.6F});
  box.properties = {1.0, 0.6, 0.4};  // These are mass [kg], friction and restitution.
  box.T_world_current.translation = {-3.0, 0.0, 1.2};
  box.T_world_previous = one_step_before(box.T_world_current, velocity);
  ball.id = "ball";
  ball.points_reference = ball_points(0.4F);  // Its material is not known, so its properties stay empty.
  ball.T_world_current.translation = {0.0, 2.0, 0.4};
  ball.T_world_previous = ball.T_world_current;
  return {box, ball};
}

/// The first step from which the object stays slower than kRestSpeed, or the last step when there is none.
size_t rest_step(const std::vector<RigidTransform>& poses) {
  size_t k = poses.size() - 1;
  const auto speed = [&](size_t i) { return (poses[i].translation - poses[i - 1].translation).norm() / kTimeStep; };
  while (k > 0 && speed(k) < kRestSpeed) --k;
  return std::min(k + 1, poses.size() - 1);
}

}  // namespace

int main() try {
  PredictorOptions options;
  options.file = RIGIDFORMER_SOURCE_DIR "/models/hybrid.safetensors";
  Predictor predictor(options);
  RolloutOptions rollout;
  rollout.num_steps = kNumSteps;
  rollout.time_step_s = kTimeStep;

  std::printf("throw [m/s]   rests at x, y [m]   after [s]   distance to goal [m]\n");
  double best_speed = 0.0, best_distance = 1e9;
  std::vector<double> reached;
  for (const double speed : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
    const Forecast forecast = predictor.predict(thrown_scene({speed, 0.0, 1.0}), rollout);
    const std::vector<RigidTransform>& poses = forecast.objects[0].poses;
    const Eigen::Vector3d end = poses.back().translation;
    const double distance = (end - kGoal).head<2>().norm();
    std::printf("%11.1f   %8.2f, %7.2f   %9.2f   %20.2f\n", speed, end.x(), end.y(), forecast.times_s[rest_step(poses)],
                distance);
    if (distance < best_distance) {
      best_distance = distance;
      best_speed = speed;
    }
    reached.push_back(end.x());
    if (end.z() < 0.1 || end.z() > 1.2) return 1;  // The box sank into the floor, or is still in the air.
  }
  std::printf("chosen: %.1f m/s, %.2f m from the goal\n", best_speed, best_distance);
  return reached.back() > reached.front() + 1.0 ? 0 : 1;  // A faster throw must carry the box farther.
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
