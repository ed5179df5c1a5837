// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "rigidformer/scene/object.hpp"

namespace rigidformer {

/// Why this object cannot be predicted, whatever stands around it: fewer than 4 points, points on a line (one side of
/// something flat is enough), material out of range, anything not finite or farther than 10^7 m. Empty = it can be.
/// Lengths are judged as the model sees them, divided by `length_scale`; empty = the object's own size counts as 1 m.
std::optional<std::string> objection(const ObjectState& object, std::optional<double> length_scale = 1.0);

}  // namespace rigidformer
