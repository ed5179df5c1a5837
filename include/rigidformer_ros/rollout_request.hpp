// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/PredictRollout.h>

#include <functional>

#include "rigidformer_ros/forecast_messages.hpp"
#include "rigidformer_ros/forecaster.hpp"
#include "rigidformer_ros/scene_request.hpp"

namespace rigidformer_ros {

/// A checked request: everything needed to answer it.
struct RolloutTask {
  ObservedScene scene;
  RolloutSettings settings;
  ForecastSelection selection;
};

/// Where a request's data comes from.
struct RequestSources {
  std::function<ObservedScene(double time_step_s)> live_scene;
  std::function<rigidformer::ModelInfo(const ObservedScene&)> model_for;
  FrameLookup T_fixed_from;
  ros::Time now;
};

/// Checks a request and gathers what it asks for. Throws RequestError with the code and the field at fault.
RolloutTask read_request(const PredictRollout::Request& request, const NodeParameters& parameters,
                         const RolloutSettings& defaults, const RequestSources& sources);

}  // namespace rigidformer_ros
