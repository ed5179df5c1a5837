// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/tracking/flying_blob.hpp"

namespace rigidformer_ros {

using rigidformer::Points;
using rigidformer::RigidTransform;

namespace testing {

using rigidformer::testing::blob;
using rigidformer::testing::Flight;
using rigidformer::testing::observe;

}  // namespace testing
}  // namespace rigidformer_ros
