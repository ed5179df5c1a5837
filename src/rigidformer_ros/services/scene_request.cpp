// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/services/scene_request.hpp"

#include <rigidformer_ros/PredictRollout.h>

#include <algorithm>
#include <set>
#include <utility>

#include "rigidformer/geometry/point_rows.hpp"
#include "rigidformer_ros/inputs/frame_transformer.hpp"
#include "rigidformer_ros/messages/near_origin.hpp"
#include "rigidformer_ros/messages/object_clouds.hpp"
#include "rigidformer_ros/services/request_error.hpp"

namespace rigidformer_ros {

namespace {

using rigidformer::AddResult;
using rigidformer::HistoryOptions;
using Response = PredictRollout::Response;

[[noreturn]] void reject(const std::string& message) { throw RequestError(Response::INVALID_REQUEST, message); }

void check_arrays(const ObjectClouds& clouds, const std::string& field) {
  try {
    check_lengths(clouds, field);
  } catch (const std::invalid_argument& error) {
    reject(error.what());
  }
}

void check_ids(const ObjectClouds& clouds, const std::string& field) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < clouds.ids.size(); ++i) {
    const std::string name = field + ".ids[" + std::to_string(i) + "]";
    if (clouds.ids[i].empty()) {
      reject(name + ": is empty");
    }
    if (!seen.insert(clouds.ids[i]).second) {
      reject(name + ": '" + clouds.ids[i] + "' occurs twice");
    }
  }
}

RigidTransform look_up(const ObjectClouds& clouds, const std::string& field, const NodeParameters& parameters,
                       const FrameLookup& T_fixed_from) {
  const std::string& frame = clouds.header.frame_id;
  try {
    return T_fixed_from(frame.empty() ? parameters.fixed_frame : frame, clouds.header.stamp);
  } catch (const TransformError& error) {
    throw RequestError(Response::FRAME_TRANSFORM_FAILURE, field + ".header.frame_id: " + error.what());
  }
}

void check_same_objects(const ObjectClouds& scene, const ObjectClouds& previous) {
  for (const std::string& id : scene.ids) {
    if (std::count(previous.ids.begin(), previous.ids.end(), id) == 0) {
      reject("previous_scene.ids: lacks '" + id + "' of scene.ids");
    }
  }
  for (const std::string& id : previous.ids) {
    if (std::count(scene.ids.begin(), scene.ids.end(), id) == 0) {
      reject("previous_scene.ids: '" + id + "' is not in scene.ids");
    }
  }
}

void check_interval(const ObjectClouds& scene, const ObjectClouds& previous, const HistoryOptions& history) {
  const double dt = (scene.header.stamp - previous.header.stamp).toSec();
  if (dt < history.min_dt || dt > history.max_dt) {
    reject("previous_scene.header.stamp: lies " + std::to_string(dt) + " s before scene.header.stamp, must be in [" +
           std::to_string(history.min_dt) + ", " + std::to_string(history.max_dt) + "] s");
  }
}

std::string too_few_points(const ObjectObservation& object, int min_points) {
  return "has " + std::to_string(rigidformer::finite_rows(object.points_world).size()) +
         " finite points, needs at least " + std::to_string(min_points);
}

// What a track is asked to take in must have points enough, belong to it, and come with a pose where poses are asked
// for.
void take(TrackStore& tracks, const ObjectObservation& object, const std::string& field, int min_points,
          bool must_extend) {
  const AddResult result = tracks.add(object);
  if (result == AddResult::kNoPose) {
    reject(field + ".poses: lacks the pose of '" + object.id + "', correspondence/method is pose");
  }
  if (result == AddResult::kTooFewPoints) {
    reject(field + " object '" + object.id + "': " + too_few_points(object, min_points));
  }
  if (must_extend && result != AddResult::kExtended && result != AddResult::kLowQuality) {
    reject("previous_scene object '" + object.id +
           "': other points than in scene, or a motion faster than history/max_speed or max_angular_speed");
  }
}

}  // namespace

std::vector<ObjectObservation> read_scene(const ObjectClouds& clouds, const std::string& field,
                                          const NodeParameters& parameters, const FrameLookup& T_fixed_from) {
  check_arrays(clouds, field);
  check_ids(clouds, field);
  const RigidTransform T_fixed_cloud = look_up(clouds, field, parameters, T_fixed_from);
  std::vector<ObjectObservation> objects;
  for (std::size_t i = 0; i < clouds.ids.size(); ++i) {
    try {
      objects.push_back(read_object(clouds, i, max_points_per_object(parameters.input), T_fixed_cloud));
      require_near_origin(objects.back().points_world, parameters.fixed_frame);
      resolve_properties(parameters.properties, objects.back());
    } catch (const std::invalid_argument& error) {
      reject(field + " object " + std::to_string(i) + " '" + clouds.ids[i] + "': " + error.what());
    }
  }
  return objects;
}

TrackStore track_scenes(const ObjectClouds& scene, const ObjectClouds* previous, const NodeParameters& parameters,
                        const FrameLookup& T_fixed_from) {
  TrackStore tracks(tracking_options(parameters));
  const int min_points = parameters.input.min_points;
  if (previous != nullptr) {
    for (const ObjectObservation& object : read_scene(*previous, "previous_scene", parameters, T_fixed_from)) {
      take(tracks, object, "previous_scene", min_points, false);
    }
    check_same_objects(scene, *previous);
    check_interval(scene, *previous, parameters.history);
  }
  for (const ObjectObservation& object : read_scene(scene, "scene", parameters, T_fixed_from)) {
    take(tracks, object, "scene", min_points, previous != nullptr);
  }
  return tracks;
}

}  // namespace rigidformer_ros
