// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which push brings an object nearest to a place? Random pushes of the object that the node sees are rolled out by the
// engine. It needs a running node, and the object's mass [kg].
//   rosrun rigidformer_ros push_planner cup 1.0 0.0 0.3
#include <ros/init.h>

#include <cstdio>
#include <cstdlib>
#include <random>

#include "rigidformer_ros/services/planner_client.hpp"

int main(int argc, char** argv) try {
  ros::init(argc, argv, "push_planner", ros::init_options::AnonymousName);
  const ros::NodeHandle keeps_ros_alive;
  if (argc != 5) {
    std::fprintf(stderr, "usage: push_planner ID X Y MASS\n");
    return 2;
  }
  const std::string id = argv[1];
  const Eigen::RowVector2d goal(std::atof(argv[2]), std::atof(argv[3]));

  rigidformer_ros::BatchRequest request;
  request.fidelity = rigidformer_ros::BatchRequest::ENGINE;
  request.num_steps = 48;
  request.record = rigidformer_ros::BatchRequest::POSES;  // rviz draws them
  rigidformer_ros::StateOverride assumed;
  assumed.id = id;
  assumed.fields = rigidformer_ros::StateOverride::PROPERTIES;
  assumed.properties.known = rigidformer_ros::PhysicalProperties::MASS;
  assumed.properties.mass = std::atof(argv[4]);
  request.base.overrides = {assumed};
  request.candidates.resize(64);
  std::mt19937 random(1);
  std::normal_distribution<double> impulse_Ns(0.0, 2.0);
  for (rigidformer_ros::RolloutCandidate& candidate : request.candidates) {
    candidate.impulses.resize(1);
    candidate.impulses[0].id = id;
    candidate.impulses[0].linear.x = impulse_Ns(random);
    candidate.impulses[0].linear.y = impulse_Ns(random);
  }
  const auto outcomes = rigidformer_ros::outcomes_of(rigidformer_ros::PlannerClient().predict(request), id);
  Eigen::VectorXd cost = (outcomes.end_positions.leftCols<2>().rowwise() - goal).rowwise().norm();
  cost = outcomes.ok.select(cost, 1e9);
  Eigen::Index best = 0;
  const double distance = cost.minCoeff(&best);
  const auto& push = request.candidates[static_cast<std::size_t>(best)].impulses[0].linear;
  std::printf("push by %.2f %.2f N s: %.3f m from the goal\n", push.x, push.y, distance);
  return outcomes.ok.any() ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "push_planner: %s\n", error.what());
  return 1;
}
