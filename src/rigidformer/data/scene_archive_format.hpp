// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace rigidformer::scene_archive_format {

constexpr char kFormat[] = "rigidformer_scenes";
/// Version of the layout; readers refuse others. Files say 2 where a reader of version 1 would misread them: scenes of
/// different lengths, objects that never move. They say 3 where the ground differs from that of the MOVi scenes, and
/// 4 where there are driven objects.
constexpr int kPlainVersion = 1, kMixedVersion = 2, kGroundVersion = 3, kVersion = 4;
constexpr std::size_t kPoseSize = 7;  ///< numbers of a pose: x y z qx qy qz qw

[[noreturn]] inline void fail(const std::filesystem::path& path, const std::string& defect) {
  throw std::runtime_error("scene archive '" + path.string() + "': " + defect);
}

inline std::int64_t signed_size(std::size_t size) { return static_cast<std::int64_t>(size); }

}  // namespace rigidformer::scene_archive_format
