// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace rigidformer {

/// Everything a checkpoint says about itself as text: options, parameters part by part, training facts, hash.
/// Throws what load_checkpoint throws.
std::string summarize_checkpoint(const std::filesystem::path& file);

/// Lists the number of parameters of a preset, part by part.
std::string summarize_preset(const std::string& preset);

}  // namespace rigidformer
