// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/scene_instant.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace rigidformer {
namespace {

Stamp newest_arrival(const std::vector<Sighting>& sightings) {
  Stamp newest = sightings.front().arrival;
  for (const Sighting& sighting : sightings) newest = std::max(newest, sighting.arrival);
  return newest;
}

/// The newest stamp of those that came lately: one from a clock that is ahead must not outlive its object.
Stamp leading_stamp(const std::vector<Sighting>& sightings, Stamp newest, double sync_window_s) {
  Stamp lead;
  for (const Sighting& sighting : sightings) {
    if (seconds_between(sighting.arrival, newest) <= sync_window_s) lead = std::max(lead, sighting.stamp);
  }
  return lead;
}

std::string describe_clock(const Sighting& sighting, Stamp lead, double sync_window_s) {
  const double behind_s = seconds_between(sighting.stamp, lead);
  std::ostringstream text;
  text << "clouds of '" << sighting.id << "' come with those of the others but are stamped " << std::abs(behind_s)
       << " s " << (behind_s > 0.0 ? "before" : "after") << " them, input/sync_window is " << sync_window_s
       << " s: the object is taken where it was then, with status LOW_QUALITY";
  return text.str();
}

}  // namespace

SceneInstant choose_instant(const std::vector<Sighting>& sightings, double sync_window_s) {
  const Stamp newest = newest_arrival(sightings);
  const Stamp lead = leading_stamp(sightings, newest, sync_window_s);
  SceneInstant instant{lead, {}, {}};
  for (const Sighting& sighting : sightings) {
    if (std::abs(seconds_between(sighting.stamp, lead)) <= sync_window_s) {
      instant.stamp = std::min(instant.stamp, sighting.stamp);
      instant.presence.push_back(Presence::kShared);
    } else if (seconds_between(sighting.arrival, newest) <= sync_window_s) {
      instant.presence.push_back(Presence::kOwnClock);
      instant.clock_remark = describe_clock(sighting, lead, sync_window_s);
    } else {
      instant.presence.push_back(Presence::kUnseen);
    }
  }
  return instant;
}

}  // namespace rigidformer
