// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "rigidformer/tracking/stamp.hpp"

namespace rigidformer {

/// The newest cloud of one object that moves.
struct Sighting {
  std::string id;
  Stamp stamp;    ///< By the clock of its sensor
  Stamp arrival;  ///< By the clock of the receiver
};

/// How an object takes part in a scene.
enum class Presence {
  kShared,    ///< At the instant that the objects share
  kOwnClock,  ///< At its own newest instant: it comes with the others, but its sensor's clock differs from theirs
  kUnseen     ///< Not at all: it has not come for too long
};

/// The instant of a scene and how each object takes part in it, in the order of the sightings.
struct SceneInstant {
  Stamp stamp;
  std::vector<Presence> presence;
  std::string clock_remark;  ///< Which objects have a clock of their own; empty = none
};

/// Objects arrive one after another: the scene is taken where the slowest of them is, so that none is extrapolated. An
/// object that neither came within `sync_window_s` of the newest nor is stamped within it is unseen. At least one
/// sighting.
SceneInstant choose_instant(const std::vector<Sighting>& sightings, double sync_window_s);

}  // namespace rigidformer
