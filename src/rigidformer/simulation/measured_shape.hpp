// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// A real object's shape about its centre of mass, and where that is in the frame of its poses.
struct MeasuredShape {
  Shape shape;                                              ///< In metres, at size 1
  Eigen::Vector3d centre_object = Eigen::Vector3d::Zero();  ///< [m] centroid of the volume in the frame of the poses
  std::string remark;                                       ///< What was changed, for the user; may be empty
};

/// Makes the shape that `text` describes in metres: `box:LxWxH`, `sphere:D`, `cylinder:DxH` (axis z), all about the
/// origin of the poses, or the path of an OBJ file in the frame of the poses. Every `o` or `g` group of a file becomes
/// its convex hull. The density is taken to be uniform. Throws std::invalid_argument naming text and what is accepted,
/// std::runtime_error for files.
MeasuredShape measured_shape(const std::string& name, const std::string& text);

}  // namespace rigidformer
