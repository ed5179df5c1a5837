// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/scene/objection.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rigidformer {
namespace {

constexpr int kMinPoints = 4;
constexpr double kMinSpread_m = 1e-4;  // standard deviation across the second axis below which a cloud is a line
// Any coordinate of a map. Beyond it single precision does not even resolve metres, and from 10^15 m on, or at such
// speeds, numbers overflow on the way through the network and take the other objects with them.
constexpr double kLargestCoordinate_m = 1e7;

struct Range {
  double low, high;
};
constexpr Range kMass_kg{1e-6, 1e6}, kFriction{0.0, 1e3}, kRestitution{0.0, 1.0};

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.6g", value);
  return text;
}

std::optional<std::string> objection_to(const std::optional<double>& value, const char* name, const Range& range) {
  if (!value || (*value >= range.low && *value <= range.high)) return std::nullopt;
  return std::string(name) + " is " + number(*value) + ", must lie in [" + number(range.low) + ", " +
         number(range.high) + "]";
}

std::optional<std::string> objection_to(const BodyProperties& properties) {
  auto found = objection_to(properties.mass_kg, "mass_kg", kMass_kg);
  if (!found) found = objection_to(properties.friction, "friction", kFriction);
  return found ? found : objection_to(properties.restitution, "restitution", kRestitution);
}

std::optional<std::string> objection_to(const RigidTransform& pose, const char* name, double length_scale) {
  if (!is_valid(pose)) return std::string(name) + " is not a finite pose with a unit quaternion";
  if (pose.translation.cwiseAbs().maxCoeff() / length_scale > kLargestCoordinate_m) {
    return std::string(name) + " is farther than " + number(kLargestCoordinate_m * length_scale) + " m from the origin";
  }
  return std::nullopt;
}

/// Standard deviations [m] along the principal axes, ascending.
Eigen::Vector3d spread(const Points& points) {
  const Eigen::MatrixX3d centred = points.cast<double>().rowwise() - points.cast<double>().colwise().mean();
  const Eigen::Matrix3d covariance = centred.transpose() * centred / static_cast<double>(points.rows());
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues().cwiseMax(0.0).cwiseSqrt();
}

}  // namespace

std::optional<std::string> objection(const ObjectState& object, std::optional<double> length_scale) {
  const Points& points = object.points_reference;
  if (points.rows() < kMinPoints) {
    return "it has " + std::to_string(points.rows()) + " points, at least " + std::to_string(kMinPoints) +
           " are needed";
  }
  if (!points.allFinite()) return "its points hold values that are not finite";
  const Eigen::Vector3d deviation = spread(points);
  const double scale = length_scale.value_or(deviation[2]);
  // Three anchors that are not on a line are needed to fix a rotation.
  if (!(deviation[1] >= kMinSpread_m * scale && scale > 0.0)) {
    return "its points lie on a line or in one place: the rotation is undefined";
  }
  if (static_cast<double>(points.cwiseAbs().maxCoeff()) / scale > kLargestCoordinate_m) {
    return "its points lie farther than " + number(kLargestCoordinate_m * scale) + " m from its origin";
  }
  auto found = objection_to(object.T_world_previous, "T_world_previous", scale);
  if (!found) found = objection_to(object.T_world_current, "T_world_current", scale);
  return found ? found : objection_to(object.properties);
}

}  // namespace rigidformer
