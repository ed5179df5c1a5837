// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/resource.h>

#include <csignal>
#include <filesystem>

#include "rigidformer/data/example_archive.hpp"

namespace rigidformer {

/// Returns the message of the exception that `call` throws while no file may grow beyond 256 bytes: writing then fails
/// in its middle, as on a full disk.
template <typename Call>
std::string on_a_full_disk(const Call& call) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit full{256, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &full);
  const std::string message = error_of(call);
  setrlimit(RLIMIT_FSIZE, &before);
  return message;
}

inline int count_files(const std::filesystem::path& folder) {
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) files += entry.is_regular_file();
  return files;
}

}  // namespace rigidformer
