// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/io/text_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace rigidformer {

std::string read_text_file(const std::filesystem::path& path, std::uintmax_t max_bytes) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw std::runtime_error("cannot read: " + error.message());
  if (size > max_bytes) {
    throw std::runtime_error("has " + std::to_string(size) + " bytes, accepted are at most " +
                             std::to_string(max_bytes));
  }
  std::string text(size, '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in.read(text.data(), static_cast<std::streamsize>(size))) throw std::runtime_error("cannot read");
  return text;
}

void write_text_file(const std::filesystem::path& path, const std::string& text) {
  const bool in_place = std::filesystem::exists(path) && !std::filesystem::is_regular_file(path);
  const std::filesystem::path temporary =
      in_place ? path : std::filesystem::path(path.string() + ".tmp" + std::to_string(::getpid()));
  std::ofstream out(temporary, std::ios::binary);
  out << text;
  out.close();
  if (!out) {
    const std::string reason = std::strerror(errno);
    std::error_code ignored;
    if (!in_place) std::filesystem::remove(temporary, ignored);
    throw std::runtime_error("cannot write: " + reason);
  }
  if (!in_place) std::filesystem::rename(temporary, path);
}

void save_text_file(const std::filesystem::path& path, const std::string& text) {
  try {
    write_text_file(path, text);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("'" + path.string() + "': " + error.what());
  }
}

bool nests_too_deeply(const std::string& json) {
  constexpr int kMaxDepth = 64;  // levels, which no stack is too small for; chosen by eye
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (quoted) {
      if (c == '\\') ++i;  // the next character is part of the string, even a quotation mark
      if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kMaxDepth) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

}  // namespace rigidformer
