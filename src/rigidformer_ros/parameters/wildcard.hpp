// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace rigidformer_ros {

/// True when `text` matches `pattern`, in which every '*' stands for any text, also none.
bool matches_wildcard(const std::string& pattern, const std::string& text);

/// True for a topic name in which exactly one whole segment is '*', such as /objects/*/points.
bool is_topic_pattern(const std::string& pattern);

/// The segment of `topic` that stands where `pattern` has its '*'; empty when the topic does not match.
std::optional<std::string> match_topic(const std::string& pattern, const std::string& topic);

}  // namespace rigidformer_ros
