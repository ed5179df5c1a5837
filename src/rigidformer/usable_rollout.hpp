// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rigidformer/rollout.hpp"
#include "rigidformer/scene/object.hpp"

namespace rigidformer {

/// Reads a scene of usable objects, at least one; may throw BodyError for one of them.
using TakeUsable = std::function<void(const std::vector<ObjectState>& usable)>;

/// Hands those objects that can be predicted to `take`, again and without the one at fault when that throws BodyError.
/// One entry per object: why it is left out, empty for the usable ones. Throws std::invalid_argument with the reasons
/// when no object is left.
std::vector<std::optional<std::string>> take_usable(const std::vector<ObjectState>& objects, int max_objects,
                                                    const TakeUsable& take);

/// Begins a rollout of usable objects, at least one; may throw BodyError for one of them.
using StartRollout = std::function<std::unique_ptr<Rollout>(const std::vector<ObjectState>& usable)>;

/// Begins a rollout of those objects that can be predicted, as if there were no others; those stand beside it with
/// Status::kUnusable and the reason. What only the engine finds out about an object leaves it out, too. Throws
/// std::invalid_argument with the reasons when no object is left.
std::unique_ptr<Rollout> start_usable(const std::vector<ObjectState>& objects, int max_objects,
                                      const StartRollout& start);

}  // namespace rigidformer
