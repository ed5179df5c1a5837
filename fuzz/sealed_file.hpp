// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "rigidformer/io/sha256.hpp"
#include "rigidformer/io/text_file.hpp"

/// Makes a tensor file of `bytes`, whose first zero byte ends the header, with the right SHA-256, so that the fuzzer
/// gets past the hash, which it could never guess. A header that is no JSON object is taken as it is.
inline std::string sealed_file(const std::string& bytes) {
  using Json = nlohmann::ordered_json;
  const std::size_t zero = std::min(bytes.find('\0'), bytes.size());
  std::string text = bytes.substr(0, zero);
  const std::string data = zero < bytes.size() ? bytes.substr(zero + 1) : "";
  Json header = rigidformer::nests_too_deeply(text) ? Json() : Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (header.is_object() && header["__metadata__"].is_object()) {
    header["__metadata__"]["sha256"] = "";
    const std::string content = header.dump(-1, ' ', false, Json::error_handler_t::replace) + data;
    rigidformer::Sha256 hash;
    hash.update(content.data(), content.size());
    header["__metadata__"]["sha256"] = hash.finish();
    text = header.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  const std::uint64_t size = text.size();
  std::string file(sizeof(size), '\0');
  std::memcpy(file.data(), &size, sizeof(size));
  return file + text + data;
}
