// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/engine/observed_solid.hpp"
#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/options.hpp"

namespace rigidformer {

/// Searches for contacts among the convex hulls of the clouds (see observed_hull.hpp) with the network's centres of
/// mass [B, K, 3]. Bullet's narrow phase measures distances; nothing is simulated. Empty for models without
/// contact_tokens. Throws BodyError for the first object without a hull, and std::runtime_error when the model needs
/// the search and Bullet was not there at build time.
ContactSearch make_contact_search(const ModelOptions& options, const SceneBatch& batch, const Tensor& centre_reference);

/// The same for a batch of one scene whose bodies are made already.
ContactSearch make_contact_search(const ModelOptions& options, const SceneBatch& batch,
                                  const std::vector<ObservedSolid>& solids);

}  // namespace rigidformer
