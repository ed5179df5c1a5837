// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace rigidformer {

/// The place of this process among those that train one model together.
struct ProcessPlace {
  int rank = 0;        ///< Number of this process, in [0, size)
  int size = 1;        ///< Number of all processes
  int local_rank = 0;  ///< Number of this process among those of its machine: which GPU to take
  std::string address = "127.0.0.1";
  std::uint16_t port = 29500;
  bool store_is_running = false;  ///< The launcher already serves address:port
};

/// Value of an environment variable; nullptr when it is not set.
using Environment = std::function<const char*(const char*)>;

/// Reads what torchrun (RANK, WORLD_SIZE, LOCAL_RANK, MASTER_ADDR, MASTER_PORT) or mpirun (OMPI_COMM_WORLD_RANK,
/// ... with MASTER_ADDR given by the user) sets. Without either there is one process. Throws
/// std::invalid_argument naming the variable.
ProcessPlace read_process_place(const Environment& environment);

}  // namespace rigidformer
