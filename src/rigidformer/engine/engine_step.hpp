// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/options.hpp"

namespace rigidformer {

/// An object of which the engine can make no body.
class BodyError : public std::invalid_argument {
 public:
  BodyError(std::int64_t object, const std::string& reason) : std::invalid_argument(reason), object_(object) {}
  std::int64_t object() const { return object_; }  ///< Index k in the batch

 private:
  std::int64_t object_;
};

/// A physics engine on what the network sees: Bullet on the convex hulls of the clouds (see observed_hull.hpp) with the
/// network's centres of mass [B, K, 3], to be called with the states of one rollout. Unknown material: the means of the
/// MOVi scenes. Empty for models without engine_motion. Throws BodyError for the first object without a body, and
/// std::runtime_error when the model needs an engine and none was there at build time.
EngineStep make_engine_step(const ModelOptions& options, const SceneBatch& batch, const Tensor& centre_reference);

}  // namespace rigidformer
