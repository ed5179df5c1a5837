// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/forecast/forecast_messages.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "rigidformer/length_scale.hpp"
#include "rigidformer_ros/messages/cloud_conversion.hpp"
#include "rigidformer_ros/messages/conversions.hpp"

namespace rigidformer_ros {

namespace {

constexpr double kRangeMargin = 1.05;  // sampled clouds miss or exceed the nominal size a little
// Spread of a cloud across a face over that along it, below which only that face is seen. The noise of a depth camera,
// 1 to 3 mm, is a hundredth of the size of what stands on a table. Chosen by eye.
constexpr double kSheet = 0.03;

bool is_selected(const ForecastSelection& selection, const std::string& id) {
  return selection.object_ids.empty() || std::count(selection.object_ids.begin(), selection.object_ids.end(), id) > 0;
}

geometry_msgs::Twist observed_twist(const ObservedObject& object, double time_step_s) {
  return twist_between(object.state.T_world_previous, object.state.T_world_current, time_step_s);
}

bool is_out_of_range(const ObservedObject& object, double time_step_s, const rigidformer::ModelInfo& model) {
  const geometry_msgs::Twist twist = observed_twist(object, time_step_s);
  const double size = rigidformer::object_diameter(object.state.points_reference);
  const double speed = std::hypot(twist.linear.x, twist.linear.y, twist.linear.z) +
                       std::hypot(twist.angular.x, twist.angular.y, twist.angular.z) * size / 2.0;
  return (model.max_size_m > 0.0 &&
          (size > model.max_size_m * kRangeMargin || size * kRangeMargin < model.min_size_m)) ||
         (model.max_speed_mps > 0.0 && speed > model.max_speed_mps * kRangeMargin);
}

// Whether only one face of it is seen.
bool is_sheet(const rigidformer::Points& points) {
  const Eigen::MatrixX3d centred = points.cast<double>().rowwise() - points.cast<double>().colwise().mean();
  const Eigen::Matrix3d covariance = centred.transpose() * centred;
  const Eigen::Vector3d variance = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues();
  return variance[0] < kSheet * kSheet * variance[2];
}

// Where it stands, its hull reaches down to what carries it, if that is seen.
bool is_incomplete(const SceneRollout& rollout, std::size_t index) {
  const rigidformer::ObjectState& state = rollout.scene.objects[index].state;
  const rigidformer::Forecast& forecast = rollout.outcome.forecast;
  const bool contacts_are_known = !forecast.contacts.empty() || rollout.model.engine_steps_per_s > 0.0;
  const bool stands_on_nothing = state.stood_s > 0.0 && contacts_are_known &&
                                 rigidformer::first_contact_step(forecast, static_cast<int>(index)) != 0;
  return stands_on_nothing || is_sheet(state.points_reference);
}

ObjectForecast to_object_forecast(const SceneRollout& rollout, std::size_t index, int record_every) {
  const ObservedObject& object = rollout.scene.objects[index];
  const rigidformer::ObjectTrajectory& forecast = rollout.outcome.forecast.objects[index];
  const double dt_s = rollout.scene.time_step_s;
  ObjectForecast message;
  message.id = object.state.id;
  message.mode = to_message_mode(object.state.mode);
  message.registration_rmse = static_cast<float>(object.quality.rmse_m);
  message.registration_inlier_ratio = static_cast<float>(object.quality.inlier_ratio);
  for (std::size_t k = 0; k < forecast.poses.size(); k += static_cast<std::size_t>(record_every)) {
    message.poses.push_back(to_pose(forecast.poses[k]));
    message.twists.push_back(k == 0 ? observed_twist(object, dt_s)
                                    : twist_between(forecast.poses[k - 1], forecast.poses[k], dt_s));
  }
  message.position_stddev = recorded_values(forecast.position_stddev_m, record_every);
  message.rotation_stddev = recorded_values(forecast.rotation_stddev_rad, record_every);
  message.status = status_of(rollout, index);
  const auto num_recorded = static_cast<int>(message.poses.size());
  const auto recorded = [&](int step) {
    const int k = step < 0 ? -1 : (step + record_every - 1) / record_every;
    return k < num_recorded ? k : -1;
  };
  message.first_contact_step =
      recorded(rigidformer::first_contact_step(rollout.outcome.forecast, static_cast<int>(index)));
  message.settled_step = recorded(rollout.outcome.settled_steps[index]);
  return message;
}

std_msgs::Header header_at(const SceneRollout& rollout, std::size_t step, const std::string& fixed_frame) {
  std_msgs::Header header;
  header.frame_id = fixed_frame;
  header.stamp = to_ros_time(rollout.scene.stamp) + ros::Duration(rollout.outcome.forecast.times_s.at(step));
  return header;
}

}  // namespace

std::vector<float> recorded_values(const std::vector<double>& values, int record_every) {
  std::vector<float> recorded;
  for (std::size_t k = 0; k < values.size(); k += static_cast<std::size_t>(record_every)) {
    recorded.push_back(static_cast<float>(values[k]));
  }
  return recorded;
}

std::uint8_t status_of(const SceneRollout& rollout, std::size_t index) {
  const ObservedObject& object = rollout.scene.objects.at(index);
  if (rollout.outcome.forecast.objects.at(index).status == rigidformer::ObjectTrajectory::Status::kDiverged) {
    return ObjectForecast::DIVERGED;
  }
  if (object.low_quality) {
    return ObjectForecast::LOW_QUALITY;
  }
  if (object.assumed_static) {
    return ObjectForecast::ASSUMED_STATIC;
  }
  const bool moves_freely = object.state.mode == rigidformer::MotionMode::kDynamic;
  if (!moves_freely) {
    return ObjectForecast::OK;
  }
  if (is_incomplete(rollout, index)) {
    return ObjectForecast::INCOMPLETE;
  }
  return is_out_of_range(object, rollout.scene.time_step_s, rollout.model) ? ObjectForecast::OUT_OF_RANGE
                                                                           : ObjectForecast::OK;
}

std::string model_label(const rigidformer::ModelInfo& model) {
  return model.sha256.empty() ? model.id : model.id + " " + model.sha256.substr(0, 8);
}

SceneForecast to_forecast(const SceneRollout& rollout, const ForecastSelection& selection,
                          const std::string& fixed_frame) {
  SceneForecast message;
  message.header = header_at(rollout, 0, fixed_frame);
  message.time_step = rollout.scene.time_step_s;
  message.compute_time = rollout.outcome.forecast.compute_time_s;
  message.trusted_horizon = rollout.trusted_horizon_s;
  message.model_id = model_label(rollout.model);
  const auto& times_s = rollout.outcome.forecast.times_s;
  for (std::size_t k = 0; k < times_s.size(); k += static_cast<std::size_t>(selection.record_every)) {
    message.times.push_back(times_s[k]);
  }
  for (std::size_t i = 0; i < rollout.scene.objects.size(); ++i) {
    if (is_selected(selection, rollout.scene.objects[i].state.id)) {
      message.objects.push_back(to_object_forecast(rollout, i, selection.record_every));
    }
  }
  message.contacts = contact_events(rollout.outcome.forecast, selection);
  for (ContactEvent& contact : message.contacts) {
    const auto every = static_cast<std::uint32_t>(selection.record_every);
    contact.first_step = (contact.first_step + every - 1) / every;
    contact.last_step = std::max(contact.first_step, contact.last_step / every);
  }
  const auto is_recorded = [&](const ContactEvent& contact) { return contact.first_step < message.times.size(); };
  message.contacts.erase(std::partition(message.contacts.begin(), message.contacts.end(), is_recorded),
                         message.contacts.end());
  for (const rigidformer::SkippedObject& skipped : rollout.scene.skipped) {
    message.skipped_ids.push_back(skipped.id);
    message.skip_reasons.push_back(skipped.reason);
  }
  return message;
}

std::vector<ContactEvent> contact_events(const rigidformer::Forecast& forecast, const ForecastSelection& selection) {
  const auto id_of = [&](int object) {
    return object < 0 ? std::string() : forecast.objects[static_cast<std::size_t>(object)].id;
  };
  std::vector<ContactEvent> events;
  for (const rigidformer::ContactSpan& span : rigidformer::contact_spans(forecast)) {
    ContactEvent event;
    event.id_a = id_of(span.object_a);
    event.id_b = id_of(span.object_b);
    if (!is_selected(selection, event.id_a) && !is_selected(selection, event.id_b)) {
      continue;
    }
    event.first_step = static_cast<std::uint32_t>(span.first_step);
    event.last_step = static_cast<std::uint32_t>(span.last_step);
    event.max_normal_impulse = span.max_normal_impulse_Ns;
    event.max_penetration = span.max_penetration_m;
    events.push_back(event);
  }
  return events;
}

std::uint64_t count_points(const ObservedScene& scene, const ForecastSelection& selection, int num_steps) {
  std::uint64_t points = 0;
  for (const ObservedObject& object : scene.objects) {
    if (is_selected(selection, object.state.id)) {
      points += static_cast<std::uint64_t>(object.state.points_reference.rows());
    }
  }
  return points * static_cast<std::uint64_t>(num_steps / selection.record_every + 1);
}

sensor_msgs::PointCloud2 to_points_cloud(const SceneRollout& rollout, const ForecastSelection& selection,
                                         const std::string& fixed_frame, int first_step) {
  const rigidformer::Forecast& forecast = rollout.outcome.forecast;
  std::vector<LabelledPoints> batches;
  std::uint32_t label = 0;
  for (std::size_t i = 0; i < rollout.scene.objects.size(); ++i) {
    const rigidformer::ObjectState& state = rollout.scene.objects[i].state;
    if (!is_selected(selection, state.id)) {
      continue;
    }
    std::uint32_t recorded = 0;
    for (std::size_t k = 0; k < forecast.times_s.size(); k += static_cast<std::size_t>(selection.record_every)) {
      if (static_cast<int>(k) >= first_step) {
        batches.push_back({forecast.objects[i].poses[k].apply(state.points_reference), label, recorded,
                           static_cast<float>(forecast.times_s[k])});
      }
      ++recorded;
    }
    ++label;
  }
  sensor_msgs::PointCloud2 cloud = to_labelled_cloud(batches);
  cloud.header = header_at(rollout, 0, fixed_frame);
  return cloud;
}

sensor_msgs::PointCloud2 object_points_at(const SceneRollout& rollout, std::size_t object, std::size_t step,
                                          const std::string& fixed_frame) {
  sensor_msgs::PointCloud2 cloud = to_cloud(rollout.outcome.forecast.objects.at(object).poses.at(step).apply(
      rollout.scene.objects.at(object).state.points_reference));
  cloud.header = header_at(rollout, step, fixed_frame);
  return cloud;
}

nav_msgs::Path path_of(const SceneRollout& rollout, std::size_t object, const std::string& fixed_frame) {
  const rigidformer::ObjectTrajectory& forecast = rollout.outcome.forecast.objects.at(object);
  nav_msgs::Path path;
  path.header = header_at(rollout, 0, fixed_frame);
  for (std::size_t k = 0; k < forecast.poses.size(); ++k) {
    geometry_msgs::PoseStamped stamped;
    stamped.header = header_at(rollout, k, fixed_frame);
    stamped.pose = to_pose(forecast.poses[k]);
    path.poses.push_back(stamped);
  }
  return path;
}

geometry_msgs::PoseArray poses_at(const SceneRollout& rollout, std::size_t step, const std::string& fixed_frame) {
  geometry_msgs::PoseArray poses;
  poses.header = header_at(rollout, step, fixed_frame);
  for (const rigidformer::ObjectTrajectory& object : rollout.outcome.forecast.objects) {
    poses.poses.push_back(to_pose(object.poses.at(step)));
  }
  return poses;
}

}  // namespace rigidformer_ros
