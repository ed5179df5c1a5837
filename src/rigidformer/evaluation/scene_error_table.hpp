// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "rigidformer/evaluation/protocol.hpp"

namespace rigidformer {

/// The error of every scene at every horizon, as a CSV that other programs can choose and resample from.
class SceneErrorTable {
 public:
  explicit SceneErrorTable(const ProtocolOptions& options);

  void add(const SceneResult& result);

  /// Throws std::runtime_error naming the path when it cannot be written.
  void write(const std::filesystem::path& path) const;

 private:
  ProtocolOptions options_;
  std::string text_;
};

}  // namespace rigidformer
