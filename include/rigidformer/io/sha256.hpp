// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace rigidformer {

/// SHA-256 of `size` bytes as 64 lower-case hex digits.
std::string sha256_hex(const std::uint8_t* data, std::size_t size);

}  // namespace rigidformer
