// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rigidformer/scene/object.hpp"
#include "rigidformer/scene/recording.hpp"
#include "rigidformer/scene/shape.hpp"
#include "rigidformer/scene/surface_sampling.hpp"

namespace rigidformer {

/// The part of the truth that a forecaster gets to see.
struct ObservationOptions {
  int num_points = 256;          ///< Surface samples per object; 0 = the vertices of the shape instead
  bool known_properties = true;  ///< false: mass, friction and restitution are left empty, those of the ground too
  std::optional<double> friction, restitution;  ///< Told of every object instead of what is recorded
  double noise_m = 0.0;                         ///< Standard deviation of each coordinate of the points [m]
  double masked_fraction = 0.0;                 ///< Share of the points that is dropped at random, in [0, 1)
  double boxed_fraction = 0.0;  ///< Share that is dropped inside a random box of every object, in [0, 1)
  bool one_view = false;        ///< Keep only points whose outward normal faces the camera at the later given frame
  Eigen::Vector3d camera_world{7.5, -6.5, 5.3};  ///< Position of that camera [m]; chosen by eye

  /// Throws std::invalid_argument naming field and value.
  void validate() const;
};

/// What is known of the ground of a scene.
GroundProperties observed_ground(const SceneRecording& scene, const ObservationOptions& options);

/// Turns recorded scenes into what a perception pipeline would give. The reference frame of every object is its body
/// frame, whichever part of its points is seen, so that predicted poses compare with the recorded ones.
class Observer {
 public:
  /// Points are drawn once per shape. Throws std::invalid_argument for invalid options or a shape without area.
  Observer(const std::vector<Shape>& shapes, const ObservationOptions& options);

  /// Gives the objects at `frame` and at `step` frames before it. The same scene and frame give the same
  /// points, and at least four points are kept per object. Throws std::invalid_argument for an unknown shape or
  /// a frame outside the recording.
  std::vector<ObjectState> observe(const SceneRecording& scene, int frame, int step) const;

  const ObservationOptions& options() const { return options_; }

 private:
  Points observed_points(const RecordedObject& object, int frame, std::uint64_t seed) const;

  ObservationOptions options_;
  std::map<std::string, SurfaceSamples> samples_;  ///< Samples of every shape at size 1
};

}  // namespace rigidformer
