// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace rigidformer {

/// What stands in for unknown material, in the network as in every physics engine: the means of the MOVi scenes.
constexpr double kMeanMass = 1.2;     ///< [kg] where only the number of objects is known
constexpr double kMeanDensity = 1.0;  ///< [kg/m^3] where a volume is known; MOVi's bodies are as light as that
constexpr double kMeanFriction = 0.6;
constexpr double kMeanRestitution = 0.5;
constexpr double kGroundFriction = 0.3;  ///< Of the floor of the MOVi scenes, which stands in for an unknown ground
constexpr double kGroundRestitution = 0.5;

}  // namespace rigidformer
