// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/process_place.hpp"

#include <gtest/gtest.h>

#include <map>

#include "rigidformer/data/example_archive.hpp"

namespace rigidformer {
namespace {

ProcessPlace place_in(const std::map<std::string, std::string>& variables) {
  return read_process_place([&](const char* name) -> const char* {
    const auto entry = variables.find(name);
    return entry == variables.end() ? nullptr : entry->second.c_str();
  });
}

TEST(ProcessPlace, WithoutALauncherThereIsOneProcess) {
  const ProcessPlace place = place_in({});
  EXPECT_EQ(place.rank, 0);
  EXPECT_EQ(place.size, 1);
  EXPECT_EQ(place.local_rank, 0);
}

TEST(ProcessPlace, ReadsWhatTorchrunSets) {
  const ProcessPlace place = place_in({{"RANK", "11"},
                                       {"WORLD_SIZE", "16"},
                                       {"LOCAL_RANK", "3"},
                                       {"MASTER_ADDR", "node0"},
                                       {"MASTER_PORT", "1234"},
                                       {"TORCHELASTIC_USE_AGENT_STORE", "True"}});
  EXPECT_EQ(place.rank, 11);
  EXPECT_EQ(place.size, 16);
  EXPECT_EQ(place.local_rank, 3);
  EXPECT_EQ(place.address, "node0");
  EXPECT_EQ(place.port, 1234);
  EXPECT_TRUE(place.store_is_running);
}

TEST(ProcessPlace, ReadsWhatMpirunSets) {
  const ProcessPlace place = place_in({{"OMPI_COMM_WORLD_RANK", "1"},
                                       {"OMPI_COMM_WORLD_SIZE", "2"},
                                       {"OMPI_COMM_WORLD_LOCAL_RANK", "0"},
                                       {"MASTER_ADDR", "node0"}});
  EXPECT_EQ(place.rank, 1);
  EXPECT_EQ(place.size, 2);
  EXPECT_EQ(place.local_rank, 0);
  EXPECT_FALSE(place.store_is_running);
}

TEST(ProcessPlace, ImpossibleValuesAreRefusedByName) {
  const std::map<std::string, std::map<std::string, std::string>> cases = {
      {"WORLD_SIZE", {{"WORLD_SIZE", "two"}}},
      {"WORLD_SIZE", {{"WORLD_SIZE", "0"}}},
      {"RANK", {{"WORLD_SIZE", "2"}, {"RANK", "2"}}},
      {"LOCAL_RANK", {{"WORLD_SIZE", "2"}, {"RANK", "1"}, {"LOCAL_RANK", "1x"}}},
      {"MASTER_PORT", {{"WORLD_SIZE", "2"}, {"RANK", "1"}, {"MASTER_PORT", "70000"}}}};
  for (const auto& [variable, environment] : cases) {
    const std::string message = error_of([&] { place_in(environment); });
    EXPECT_NE(message.find(variable), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace rigidformer
