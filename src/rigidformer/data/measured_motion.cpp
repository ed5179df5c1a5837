// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "measured_motion.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace rigidformer {
namespace {

constexpr double kEvenness = 0.1;  // [frames] stamps may be off by this; a tenth of a step's motion; chosen by eye
constexpr double kRateTolerance = 0.01;  // a rate asked for is the measured one if it differs by less; chosen by eye
constexpr double kSameTime_s = 1e-6;     // [s] resolution of the stamps in tables
constexpr std::size_t kMinFrames = 3;    // two are given, one can be scored

[[noreturn]] void fail(const MeasuredRecording& recording, const std::string& defect) {
  throw std::invalid_argument("recording '" + recording.name + "': " + defect);
}

/// The median rate of the object that was measured most slowly: frames at a higher one would be invented.
double measured_rate(const MeasuredRecording& recording) {
  double rate_hz = 0.0;
  for (const MeasuredTrack& track : recording.tracks) {
    if (track.times_s.size() < 2) fail(recording, "object '" + track.id + "' has one pose only");
    std::vector<double> steps;
    for (std::size_t i = 1; i < track.times_s.size(); ++i) steps.push_back(track.times_s[i] - track.times_s[i - 1]);
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    rate_hz = rate_hz == 0.0 ? 1.0 / *middle : std::min(rate_hz, 1.0 / *middle);
  }
  return rate_hz;
}

/// The rate at which all objects were measured together in equal steps, if they were.
std::optional<double> even_rate(const MeasuredRecording& recording) {
  const std::vector<double>& first = recording.tracks.front().times_s;
  const double rate_hz = static_cast<double>(first.size() - 1) / (first.back() - first.front());
  for (const MeasuredTrack& track : recording.tracks) {
    if (track.times_s.size() != first.size()) return std::nullopt;
    for (std::size_t i = 0; i < first.size(); ++i) {
      const double off_s = track.times_s[i] - first.front() - static_cast<double>(i) / rate_hz;
      if (!(std::abs(off_s) * rate_hz < kEvenness)) return std::nullopt;
    }
  }
  return rate_hz;
}

MeasuredFrames without_frames(const MeasuredRecording& recording, double rate_hz, bool is_resampled) {
  MeasuredFrames frames{recording.name, rate_hz, is_resampled, {}, {}};
  for (const MeasuredTrack& track : recording.tracks) frames.ids.push_back(track.id);
  frames.T_world_object.resize(frames.ids.size());
  return frames;
}

/// The pose at a time within the track, or none where the poses around it are too far apart.
std::optional<RigidTransform> pose_at(const MeasuredTrack& track, double time_s, double max_gap_s) {
  const auto after = std::upper_bound(track.times_s.begin(), track.times_s.end(), time_s);
  if (after == track.times_s.begin()) return std::nullopt;
  const auto i = static_cast<std::size_t>(after - track.times_s.begin()) - 1;
  if (i + 1 == track.times_s.size()) return track.T_world_object.back();
  if (time_s - track.times_s[i] < kSameTime_s) return track.T_world_object[i];
  if (track.times_s[i + 1] - time_s < kSameTime_s) return track.T_world_object[i + 1];
  const double step_s = track.times_s[i + 1] - track.times_s[i];
  if (step_s > max_gap_s) return std::nullopt;
  return interpolate(track.T_world_object[i], track.T_world_object[i + 1], (time_s - track.times_s[i]) / step_s);
}

std::vector<MeasuredFrames> resample(const MeasuredRecording& recording, double rate_hz, double max_gap_s) {
  double begin_s = recording.tracks.front().times_s.front(), end_s = recording.tracks.front().times_s.back();
  for (const MeasuredTrack& track : recording.tracks) {
    begin_s = std::max(begin_s, track.times_s.front());
    end_s = std::min(end_s, track.times_s.back());
  }
  std::vector<MeasuredFrames> parts(1, without_frames(recording, rate_hz, true));
  const auto num_frames = static_cast<long>(std::floor((end_s - begin_s) * rate_hz + kRateTolerance)) + 1;
  for (long frame = 0; frame < num_frames; ++frame) {
    const double time_s = std::min(end_s, begin_s + static_cast<double>(frame) / rate_hz);
    std::vector<RigidTransform> poses;
    for (const MeasuredTrack& track : recording.tracks) {
      if (const auto pose = pose_at(track, time_s, max_gap_s)) poses.push_back(*pose);
    }
    if (poses.size() < recording.tracks.size()) {  // a gap: what follows is another part
      if (!parts.back().T_world_object.front().empty()) parts.push_back(without_frames(recording, rate_hz, true));
      continue;
    }
    for (std::size_t k = 0; k < poses.size(); ++k) parts.back().T_world_object[k].push_back(poses[k]);
  }
  return parts;
}

}  // namespace

std::vector<MeasuredFrames> to_frames(const MeasuredRecording& recording, const FrameOptions& options) {
  const double median_hz = measured_rate(recording);
  const std::optional<double> even_hz = even_rate(recording);
  const double measured_hz = even_hz.value_or(median_hz);
  const double wanted_hz = options.frame_rate_hz > 0.0 ? options.frame_rate_hz : measured_hz;
  if (wanted_hz > measured_hz * (1.0 + kRateTolerance)) {
    fail(recording, "frames of " + std::to_string(wanted_hz) + " Hz are asked for, measured were " +
                        std::to_string(measured_hz) + " Hz: more would be invented, and less is no need");
  }
  if (even_hz && std::abs(wanted_hz / *even_hz - 1.0) < kRateTolerance) {
    MeasuredFrames frames = without_frames(recording, *even_hz, false);
    for (std::size_t k = 0; k < frames.ids.size(); ++k) frames.T_world_object[k] = recording.tracks[k].T_world_object;
    if (frames.T_world_object.front().size() < kMinFrames) fail(recording, "has fewer than three frames");
    return {frames};
  }
  std::vector<MeasuredFrames> parts = resample(recording, wanted_hz, options.max_gap_frames / measured_hz);
  const auto is_short = [](const MeasuredFrames& part) { return part.T_world_object.front().size() < kMinFrames; };
  parts.erase(std::remove_if(parts.begin(), parts.end(), is_short), parts.end());
  if (parts.empty()) fail(recording, "there are no three frames in a row in which all objects are seen");
  for (std::size_t i = 1; i < parts.size(); ++i) parts[i].name += "_" + std::to_string(i + 1);
  return parts;
}

}  // namespace rigidformer
