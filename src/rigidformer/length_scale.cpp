// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/length_scale.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace rigidformer {
namespace {

/// The scale at which the median of the diameters is the middle of the trained sizes; 1 where either is not known.
double scale_of(std::vector<double> diameters, double min_size_m, double max_size_m) {
  const double trained = std::sqrt(min_size_m * max_size_m);
  if (diameters.empty() || !(trained > 0.0)) {
    return 1.0;
  }
  const auto middle = diameters.begin() + static_cast<std::ptrdiff_t>(diameters.size() / 2);
  std::nth_element(diameters.begin(), middle, diameters.end());
  return *middle > 0.0 ? *middle / trained : 1.0;
}

}  // namespace

std::optional<double> length_scale_from(const std::string& text) {
  if (text == "auto") {
    return std::nullopt;
  }
  double scale = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), scale);
  if (error != std::errc() || rest != text.data() + text.size() || !(scale > 0.0) || !std::isfinite(scale)) {
    throw std::invalid_argument("length scale: '" + text + "' is neither a number above 0 nor auto");
  }
  return scale;
}

std::vector<ObjectState> to_model_scale(std::vector<ObjectState> objects, double scale) {
  if (scale == 1.0) {
    return objects;
  }
  for (ObjectState& object : objects) {
    object.points_reference /= static_cast<float>(scale);
    object.T_world_previous.translation /= scale;
    object.T_world_current.translation /= scale;
    object.stood_s /= std::sqrt(scale);
  }
  return objects;
}

RolloutOptions to_model_scale(RolloutOptions options, double scale) {
  options.time_step_s /= std::sqrt(scale);
  if (options.ground_height_m) {
    *options.ground_height_m /= scale;
  }
  return options;
}

Candidate to_model_scale(Candidate candidate, double scale) {
  if (scale == 1.0) {
    return candidate;
  }
  const double time_scale = std::sqrt(scale);
  for (StateChange& change : candidate.changes) {
    if (change.T_world_reference) {
      change.T_world_reference->translation /= scale;
    }
    if (change.twist) {
      change.twist->linear_mps /= time_scale;
      change.twist->angular_rps *= time_scale;
    }
  }
  for (Push& push : candidate.pushes) {
    push.time_s /= time_scale;
    push.linear_Ns /= time_scale;
    push.angular_Nms /= scale * time_scale;
    push.point_reference /= scale;
  }
  for (GivenTrack& track : candidate.tracks) {
    track.points_reference /= static_cast<float>(scale);
    track.max_speed_mps /= time_scale;
    for (double& time : track.times_s) {
      time /= time_scale;
    }
    for (RigidTransform& pose : track.T_world_reference) {
      pose.translation /= scale;
    }
  }
  return candidate;
}

BatchOptions to_model_scale(BatchOptions options, double scale) {
  options.rollout = to_model_scale(options.rollout, scale);
  options.settle.linear_speed_mps /= std::sqrt(scale);
  options.settle.angular_speed_rps *= std::sqrt(scale);
  options.settle.duration_s /= std::sqrt(scale);
  for (StopRule& rule : options.stop) {
    rule.region.T_world_box.translation /= scale;
    rule.region.size_m /= scale;
  }
  return options;
}

Forecast to_real_scale(Forecast forecast, double scale) {
  for (double& time : forecast.times_s) {
    time *= std::sqrt(scale);
  }
  for (auto& object : forecast.objects) {
    for (auto& pose : object.poses) {
      pose.translation *= scale;
    }
    for (double& stddev_m : object.position_stddev_m) {
      stddev_m *= scale;
    }
  }
  for (StepContact& contact : forecast.contacts) {
    contact.penetration_m *= scale;
    contact.normal_impulse_Ns *= std::sqrt(scale);
  }
  return forecast;
}

CandidateOutcome to_real_scale(CandidateOutcome outcome, double scale) {
  outcome.forecast = to_real_scale(std::move(outcome.forecast), scale);
  for (auto& particles : outcome.particles) {
    for (ParticleOutcome& particle : particles) {
      particle.T_world_end.translation *= scale;
    }
  }
  return outcome;
}

ModelInfo to_real_scale(ModelInfo info, double scale) {
  info.min_time_step_s *= std::sqrt(scale);
  info.max_time_step_s *= std::sqrt(scale);
  info.min_size_m *= scale;
  info.max_size_m *= scale;
  info.max_speed_mps *= std::sqrt(scale);
  return info;
}

SceneArchive to_model_scale(SceneArchive archive, double scale) {
  for (SceneRecording& scene : archive.scenes) {
    scene.frame_rate_hz *= std::sqrt(scale);
    for (RecordedObject& object : scene.objects) {
      object.size /= scale;
      for (RigidTransform& pose : object.T_world_object) {
        pose.translation /= scale;
      }
      for (Eigen::Vector3d& velocity : object.velocities) {
        velocity /= std::sqrt(scale);
      }
      for (Eigen::Vector3d& spin : object.angular_velocities) {
        spin *= std::sqrt(scale);
      }
    }
  }
  return archive;
}

double object_diameter(const Points& points) {
  if (points.rows() == 0) {
    return 0.0;
  }
  const Eigen::RowVector3f centroid = points.colwise().mean();
  return 2.0 * (points.rowwise() - centroid).rowwise().norm().maxCoeff();
}

double automatic_length_scale(const std::vector<ObjectState>& objects, const ModelInfo& info) {
  std::vector<double> diameters;
  for (const ObjectState& object : objects) {
    diameters.push_back(object_diameter(object.points_reference));
  }
  return scale_of(std::move(diameters), info.min_size_m, info.max_size_m);
}

double automatic_length_scale(const SceneArchive& archive, double min_size_m, double max_size_m) {
  std::map<std::string, double> diameter_of;
  for (const Shape& shape : archive.shapes) {
    diameter_of[shape.name] = object_diameter(shape.vertices());
  }
  std::vector<double> diameters;
  for (const SceneRecording& scene : archive.scenes) {
    for (const RecordedObject& object : scene.objects) {
      if (object.is_given()) continue;
      diameters.push_back(object.size * diameter_of.at(object.shape));
    }
  }
  return scale_of(std::move(diameters), min_size_m, max_size_m);
}

}  // namespace rigidformer
