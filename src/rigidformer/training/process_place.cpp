// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/process_place.hpp"

#include <charconv>
#include <cstring>
#include <stdexcept>

namespace rigidformer {
namespace {

int read_number(const Environment& environment, const std::string& name, int low, int high, int otherwise) {
  const char* text = environment(name.c_str());
  if (text == nullptr) return otherwise;
  int value = 0;
  const char* end = text + std::strlen(text);
  const auto [rest, error] = std::from_chars(text, end, value);
  if (error != std::errc() || rest != end || value < low || value > high) {
    throw std::invalid_argument("environment variable " + name + " is '" + text + "', must be a whole number from " +
                                std::to_string(low) + " to " + std::to_string(high));
  }
  return value;
}

}  // namespace

ProcessPlace read_process_place(const Environment& environment) {
  constexpr int kMaxProcesses = 1 << 20;  // a larger number is surely a mistake; chosen by eye
  const bool is_mpi = environment("RANK") == nullptr && environment("OMPI_COMM_WORLD_RANK") != nullptr;
  const std::string prefix = is_mpi ? "OMPI_COMM_WORLD_" : "";
  ProcessPlace place;
  place.size = read_number(environment, is_mpi ? prefix + "SIZE" : "WORLD_SIZE", 1, kMaxProcesses, 1);
  place.rank = read_number(environment, prefix + "RANK", 0, place.size - 1, 0);
  place.local_rank = read_number(environment, prefix + "LOCAL_RANK", 0, place.size - 1, place.rank);
  place.port = static_cast<std::uint16_t>(read_number(environment, "MASTER_PORT", 1, 65535, place.port));
  if (const char* address = environment("MASTER_ADDR")) place.address = address;
  const char* agent_store = environment("TORCHELASTIC_USE_AGENT_STORE");
  place.store_is_running = agent_store != nullptr && std::strcmp(agent_store, "True") == 0;
  return place;
}

}  // namespace rigidformer
