// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <filesystem>

namespace rigidformer {

/// The scene that comes with the tests, in the published layout: `20/metadata.json` and `shapes/`
/// (test/data/README.md).
inline std::filesystem::path shipped_movi_a() { return RIGIDFORMER_SOURCE_DIR "/test/data/movi_a"; }

/// Published scenes and meshes, which may not be distributed: tests skip where they are not.
inline std::filesystem::path published_data() {
  const char* folder = std::getenv("RIGIDFORMER_TEST_DATA");
  return folder != nullptr ? folder : RIGIDFORMER_SOURCE_DIR "/../shared/data";
}

}  // namespace rigidformer
