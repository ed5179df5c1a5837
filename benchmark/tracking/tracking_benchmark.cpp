// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/tracking_benchmark.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rigidformer/simulation/builtin_shapes.hpp"
#include "rigidformer/tracking/shape_camera.hpp"
#include "rigidformer/tracking/track_store.hpp"

namespace rigidformer {

std::uint64_t tracking_seed = 101;

namespace {

using testing::ShapeCamera;
using testing::Tumble;
using testing::View;

// The series of docs/tracking.md, "How well it works"; its numbers were chosen by eye.
constexpr int kFrames = 60;                  // clouds in one series of 2 s
constexpr int kPoints = 1000;                // points of one cloud
constexpr double kFramePeriod = 1.0 / 30.0;  // [s] between two clouds
constexpr double kWellVisible = 0.4;         // share of the surface, from which on a frame counts
const Eigen::Vector3d kEye(0.0, -3.0, 1.0);  // position of the camera [m]

std::vector<Tumble> tumbles() {
  Tumble first, second, slow;
  second.velocity = {-0.3, 0.3, 0.8};
  second.angular_velocity = {-2.0, 1.0, 2.2};
  slow.angular_velocity = {0.5, 0.3, -0.4};
  return {first, second, slow};
}

/// The outcome of one series of clouds.
struct Tracking {
  double worst_position_m = 0.0;    ///< Over the frames in which the object is well visible
  double worst_rotation_rad = 0.0;  ///< Over the frames in which the object is well visible
  double add_s = 0.0, worst_add_s = 0.0;
  int frames = 0, well_visible = 0, within_target = 0, low_quality = 0, new_tracks = 0;
  /// LOW_QUALITY among the well visible frames, by whether they are within the target.
  int flagged_within = 0, flagged_outside = 0;
};

/// Adds the cloud of one frame and compares; `T_object_track` leads from the frame of the track to the true one.
class Series {
 public:
  Series(std::string shape, const Tumble& tumble, std::uint64_t seed, Tracking& result)
      : shape_(std::move(shape)), tumble_(tumble), camera_(shape_, 1.0, seed), result_(result) {
    TrackingOptions options;
    options.correspondence.method = Correspondence::kRegistration;
    store_ = std::make_unique<TrackStore>(options);
  }

  void add(int frame) {
    const double t = frame * kFramePeriod;
    const RigidTransform T_true = tumble_.pose(t);
    const View view = camera_.look(T_true, kEye, kPoints);
    ObjectObservation observation;
    observation.id = shape_;
    observation.stamp = stamp_at(100.0 + t);
    observation.points_world = view.points_world;
    const AddResult added = timed_add(observation);
    const RigidTransform T_track = store_->snapshot(kFramePeriod).objects.at(0).state.T_world_current;
    if (added == AddResult::kNewTrack) {
      T_track_object_ = T_track.inverse() * T_true;
      result_.new_tracks += frame == 0 ? 0 : 1;
    }
    result_.low_quality += added == AddResult::kLowQuality ? 1 : 0;
    if (view.visible_share >= kWellVisible) {
      compare(T_track * T_track_object_, T_true, added == AddResult::kLowQuality);
    }
  }

 private:
  AddResult timed_add(const ObjectObservation& observation) {
    const auto start = std::chrono::steady_clock::now();
    const AddResult added = store_->add(observation);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    result_.add_s += seconds;
    result_.worst_add_s = std::max(result_.worst_add_s, seconds);
    ++result_.frames;
    return added;
  }

  void compare(const RigidTransform& T_estimated, const RigidTransform& T_true, bool is_flagged) {
    const double position_m = (T_estimated.translation - T_true.translation).norm();
    const double angle = visible_angle(shape_, T_estimated.rotation, T_true.rotation);
    result_.worst_position_m = std::max(result_.worst_position_m, position_m);
    result_.worst_rotation_rad = std::max(result_.worst_rotation_rad, angle);
    ++result_.well_visible;
    const bool is_within = position_m < 0.01 && angle < 3.0 * M_PI / 180.0;
    result_.within_target += is_within ? 1 : 0;
    result_.flagged_within += is_flagged && is_within ? 1 : 0;
    result_.flagged_outside += is_flagged && !is_within ? 1 : 0;
  }

  std::string shape_;
  Tumble tumble_;
  ShapeCamera camera_;
  Tracking& result_;
  std::unique_ptr<TrackStore> store_;
  RigidTransform T_track_object_;
};

/// Follows one shape through several series before one camera.
void track(benchmark::State& state, const std::string& shape) {
  Tracking result;
  for (auto _ : state) {
    std::uint64_t seed = tracking_seed;
    for (const Tumble& tumble : tumbles()) {
      Series series(shape, tumble, seed++, result);
      for (int frame = 0; frame < kFrames; ++frame) {
        series.add(frame);
      }
    }
  }
  state.counters["worst_mm"] = 1e3 * result.worst_position_m;
  state.counters["worst_deg"] = 180.0 / M_PI * result.worst_rotation_rad;
  state.counters["well_visible"] = result.well_visible;
  state.counters["in_target_%"] = 100.0 * result.within_target / std::max(result.well_visible, 1);
  state.counters["low_quality"] = result.low_quality;
  state.counters["flagged_within"] = result.flagged_within;
  state.counters["flagged_outside"] = result.flagged_outside;
  state.counters["new_tracks"] = result.new_tracks;
  state.counters["mean_ms"] = 1e3 * result.add_s / result.frames;
  state.counters["max_ms"] = 1e3 * result.worst_add_s;
}

const bool kRegistered = [] {
  for (const char* shape :
       {"bone", "cone", "cube", "cylinder", "gear", "pear", "pebble", "sphere", "sponge", "torus", "torus_knot"}) {
    benchmark::RegisterBenchmark((std::string("track/") + shape).c_str(), track, shape)->Iterations(1);
  }
  return true;
}();

}  // namespace
}  // namespace rigidformer
