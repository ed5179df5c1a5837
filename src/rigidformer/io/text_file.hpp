// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace rigidformer {

/// Reads the bytes of a regular file. Throws std::runtime_error naming the defect (not the path) when the file cannot
/// be read or is larger than `max_bytes`; nothing is allocated before the size is known.
std::string read_text_file(const std::filesystem::path& path, std::uintmax_t max_bytes);

/// Writes to a temporary file and renames it, so that neither a crash nor a full disk leaves half a file; what is there
/// and no regular file (a pipe, a terminal) is written to as it is. Throws std::runtime_error naming the defect (not
/// the path).
void write_text_file(const std::filesystem::path& path, const std::string& text);

/// The same, with an error that names the path as well.
void save_text_file(const std::filesystem::path& path, const std::string& text);

/// Whether lists and objects of a JSON text lie deeper than 64 levels in each other. What copies and writes JSON calls
/// itself once per level, so that such a text could exhaust the stack.
bool nests_too_deeply(const std::string& json);

}  // namespace rigidformer
