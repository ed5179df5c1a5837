// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/predictor.hpp"

namespace rigidformer_ros {

// Rigid contact under gravity looks the same when lengths shrink by a factor and times by its square root. That is how
// a model trained on objects of a metre predicts objects on a table: a real length is `scale` times the length that the
// model sees, a real time is sqrt(`scale`) times the time that the model sees, and gravity is the same for both.

/// Turns real positions and points of objects into those that the model sees.
std::vector<rigidformer::ObjectState> to_model_scale(std::vector<rigidformer::ObjectState> objects, double scale);

/// Turns the real time step and ground height of a rollout into those that the model sees.
rigidformer::RolloutOptions to_model_scale(rigidformer::RolloutOptions options, double scale);

/// Turns the times and positions that the model predicted into real ones.
rigidformer::Forecast to_real_scale(rigidformer::Forecast forecast, double scale);

/// Turns the ranges that the model was trained on into real lengths, times and speeds.
rigidformer::ModelInfo to_real_scale(rigidformer::ModelInfo info, double scale);

/// Diameter [m] of the smallest sphere about the centroid of the points that holds all of them.
double object_diameter(const rigidformer::Points& points);

/// The scale at which the object of median size has the middle size (geometric mean of smallest and largest) that the
/// model was trained on. It is 1 for an empty scene and for a model that does not state its sizes.
double automatic_length_scale(const std::vector<rigidformer::ObjectState>& objects, const rigidformer::ModelInfo& info);

}  // namespace rigidformer_ros
