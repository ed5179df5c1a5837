// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/parameters/wildcard.hpp"

#include <algorithm>
#include <cctype>

namespace rigidformer_ros {

bool matches_wildcard(const std::string& pattern, const std::string& text) {
  // After a '*' that failed to match, retry with it taking one more character.
  std::size_t p = 0;
  std::size_t t = 0;
  std::size_t star = std::string::npos;
  std::size_t star_end = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      star_end = t;
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++p;
      ++t;
    } else if (star != std::string::npos) {
      p = star + 1;
      t = ++star_end;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string::npos;
}

bool is_topic_pattern(const std::string& pattern) {
  const std::size_t star = pattern.find('*');
  if (star == std::string::npos || star != pattern.rfind('*')) {
    return false;
  }
  const bool starts_segment = star == 0 || pattern[star - 1] == '/';
  const bool ends_segment = star + 1 == pattern.size() || pattern[star + 1] == '/';
  const bool valid_characters = std::all_of(pattern.begin(), pattern.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '/' || c == '*';
  });
  return starts_segment && ends_segment && valid_characters;
}

std::optional<std::string> match_topic(const std::string& pattern, const std::string& topic) {
  const std::size_t star = pattern.find('*');
  if (star == std::string::npos) {
    return std::nullopt;
  }
  const std::string before = pattern.substr(0, star);
  const std::string after = pattern.substr(star + 1);
  if (topic.size() <= before.size() + after.size() || topic.compare(0, before.size(), before) != 0 ||
      topic.compare(topic.size() - after.size(), after.size(), after) != 0) {
    return std::nullopt;
  }
  const std::string id = topic.substr(before.size(), topic.size() - before.size() - after.size());
  return id.find('/') == std::string::npos ? std::optional<std::string>(id) : std::nullopt;
}

}  // namespace rigidformer_ros
