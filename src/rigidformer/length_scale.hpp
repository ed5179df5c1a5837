// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rigidformer/candidates.hpp"
#include "rigidformer/data/scene_archive.hpp"
#include "rigidformer/predictor.hpp"

namespace rigidformer {

// Rigid contact under gravity looks the same when lengths shrink by a factor and times by its square root. That is how
// a model trained on objects of a metre predicts objects on a table: a real length is `scale` times the length that the
// model sees, a real time is sqrt(`scale`) times the time that the model sees, and gravity is the same for both.

/// The number that `text` holds, or none for `auto`. Throws std::invalid_argument for anything but these, and for
/// numbers that are not above 0.
std::optional<double> length_scale_from(const std::string& text);

/// Turns real positions and points of objects into those that the model sees.
std::vector<ObjectState> to_model_scale(std::vector<ObjectState> objects, double scale);

/// Turns the real time step and ground height of a rollout into those that the model sees.
RolloutOptions to_model_scale(RolloutOptions options, double scale);

/// Turns recordings of real objects into what they would be at the model's scale: sizes, positions and frame rates.
SceneArchive to_model_scale(SceneArchive archive, double scale);

/// Turns the changes of a candidate into those that the model sees. Masses stay, so that impulses change as speeds do.
Candidate to_model_scale(Candidate candidate, double scale);

/// Turns what holds for all candidates into what the model sees.
BatchOptions to_model_scale(BatchOptions options, double scale);

/// Turns the times, positions and contacts that the model predicted into real ones.
Forecast to_real_scale(Forecast forecast, double scale);
CandidateOutcome to_real_scale(CandidateOutcome outcome, double scale);

/// Turns the ranges that the model was trained on into real lengths, times and speeds.
ModelInfo to_real_scale(ModelInfo info, double scale);

/// Diameter [m] of the smallest sphere about the centroid of the points that holds all of them.
double object_diameter(const Points& points);

/// The scale at which the object of median size has the middle size (geometric mean of smallest and largest) that the
/// model was trained on. It is 1 for an empty scene and for a model that does not state its sizes.
double automatic_length_scale(const std::vector<ObjectState>& objects, const ModelInfo& info);

/// Likewise for all objects of all scenes, from the smallest and the largest trained diameter.
double automatic_length_scale(const SceneArchive& archive, double min_size_m, double max_size_m);

}  // namespace rigidformer
