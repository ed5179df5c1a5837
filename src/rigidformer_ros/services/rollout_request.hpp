// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/PredictRollout.h>

#include <functional>
#include <string>
#include <vector>

#include "rigidformer_ros/forecast/forecast_messages.hpp"
#include "rigidformer_ros/forecast/scene_forecaster.hpp"
#include "rigidformer_ros/services/scene_request.hpp"

namespace rigidformer_ros {

/// Where the scene of a request comes from.
enum class SceneSource {
  kLive,            ///< The node's newest state
  kGiven,           ///< The request; its objects start at rest
  kGivenAndBefore,  ///< The request, with an earlier scene that tells the velocities
};

/// What one request asks for.
struct RolloutTask {
  SceneSource source = SceneSource::kLive;
  RolloutSettings settings;
  ForecastSelection selection;
};

/// Where a request's data comes from.
struct RequestSources {
  std::function<ObservedScene(double time_step_s)> live_scene;
  std::function<rigidformer::ModelInfo(const ObservedScene&)> model_for;
  FrameLookup T_fixed_from;
};

// Checks and gathers what a request asks for. All throw RequestError with the code and the field at fault.

/// All but the time step, which read_scene() tells.
RolloutTask read_task(const PredictRollout::Request& request, const NodeParameters& parameters,
                      const RolloutSettings& defaults);

/// Equal for requests whose steps come from one and the same rollout, if that begins while they wait.
std::string rollout_key(const PredictRollout::Request& request);

/// The scene of that source, with the time step to predict it with.
ObservedScene read_scene(const PredictRollout::Request& request, SceneSource source, const NodeParameters& parameters,
                         double default_time_step_s, const RequestSources& sources);

/// Whether all objects that are asked for take part in the scene.
void check_object_ids(const std::vector<std::string>& ids, const ObservedScene& scene);

/// Whether this scene can answer this request.
void check_scene(const PredictRollout::Request& request, const RolloutTask& task, const ObservedScene& scene,
                 const NodeParameters& parameters, const ros::Time& now);

}  // namespace rigidformer_ros
