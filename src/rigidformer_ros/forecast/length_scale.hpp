// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/predictor.hpp"

namespace rigidformer_ros {

// Rigid contact under gravity looks the same when lengths shrink by a factor and times by its square root. A model
// trained on metre-sized objects thus predicts a tabletop: real length = scale x model length,
// real time = sqrt(scale) x model time, same gravity.

std::vector<rigidformer::ObjectState> to_model_scale(std::vector<rigidformer::ObjectState> objects, double scale);
rigidformer::RolloutOptions to_model_scale(rigidformer::RolloutOptions options, double scale);
rigidformer::Forecast to_real_scale(rigidformer::Forecast forecast, double scale);

/// The model's trained ranges in real lengths and times.
rigidformer::ModelInfo to_real_scale(rigidformer::ModelInfo info, double scale);

/// Diameter [m] of the bounding sphere about the centroid.
double object_diameter(const rigidformer::Points& points);

/// Scale that brings the median object to the middle (geometric mean) of the sizes the model was trained on.
/// 1 for an empty scene or a model without stated sizes.
double automatic_length_scale(const std::vector<rigidformer::ObjectState>& objects, const rigidformer::ModelInfo& info);

}  // namespace rigidformer_ros
