// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "rigidformer/tracking/reference_cloud.hpp"
#include "rigidformer/tracking/surface_cloud.hpp"

namespace rigidformer {

/// How far a cloud has slid along its faces in one direction (docs/tracking.md, "Slides along faces").
struct Slide {
  double distance_m;
  double standard_deviation_m;
  bool is_certain;  ///< Both ends of the faces agree; if not, one is hidden now or was when it was learned
};

/// Measures how far a cloud in the object frame, which lies on the reference, has slid along the unit vector
/// `direction`: the cloud's faces parallel to it end that far from where the same faces of the reference end. Both ends
/// of the faces count. The answer is empty where the ends are blunt or few points show them.
std::optional<Slide> measure_slide(const ReferenceCloud& reference, const SurfaceCloud& cloud_object,
                                   const Eigen::Vector3d& direction, double noise_m);

}  // namespace rigidformer
