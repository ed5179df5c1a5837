// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "rigidformer/evaluation/protocol.hpp"

namespace rigidformer {

/// The last horizon in frames of that scene; with horizons in milliseconds it need not be whole.
double last_horizon_frames(const ProtocolOptions& options, const SceneRecording& scene);

/// Number of steps of a rollout to the last horizon. Throws std::invalid_argument when a horizon is shorter than a
/// step.
int steps_to_last_horizon(const ProtocolOptions& options, const SceneRecording& scene, int step);

/// Indices of the objects whose errors count.
std::vector<std::size_t> objects_to_score(const SceneRecording& scene, const ProtocolOptions& options, int start);

/// What the driven objects do, of which `objects` are the observations at frame `now`: a planner knows it.
std::vector<GivenTrack> recorded_tracks(const SceneRecording& scene, const std::vector<ObjectState>& objects, int now);

/// Largest extent of every shape at size 1 [m], by name.
std::map<std::string, double> largest_extents(const std::vector<Shape>& shapes);

/// Rolls out the scenes of one set by one forecaster, from one start with one step size.
class RolloutRound {
 public:
  /// `extents` as of largest_extents(); both must outlive the round.
  RolloutRound(const ProtocolOptions& options, const std::map<std::string, double>& extents, int start, int step)
      : options_(options), extents_(extents), start_(start), step_(step), errors_(options.horizons.size()) {}

  SceneResult add_scene(const std::string& set, const SceneRecording& scene, const std::vector<ObjectState>& objects,
                        const std::vector<std::size_t>& scored, Forecaster& forecaster);

  /// Throws std::invalid_argument when no scene was added.
  void append_scores(const std::string& model, const std::string& set, std::vector<Score>& scores) const;

 private:
  using Poses = std::vector<RigidTransform>;

  int steps_of_rollout(const SceneRecording& scene) const;
  Poses predicted_at(const SceneResult& result, double frames) const;
  Poses recorded_at(const SceneRecording& scene, double frames) const;
  std::vector<double> sizes(const SceneRecording& scene) const;
  void add_curve(SceneResult& result) const;
  void add_settled(const std::vector<std::size_t>& scored, SceneResult& result) const;

  const ProtocolOptions& options_;
  const std::map<std::string, double>& extents_;
  int start_, step_;
  std::vector<std::vector<PoseError>> errors_;  ///< [horizon][scene] errors
  SettledCount settled_;
  double compute_s_ = 0.0, predicted_s_ = 0.0;
};

}  // namespace rigidformer
