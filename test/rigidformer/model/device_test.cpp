// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/device.hpp"

#include <gtest/gtest.h>

#include "rigidformer/data/example_archive.hpp"

namespace rigidformer {
namespace {

TEST(Device, CpuAndAutoAlwaysWork) {
  EXPECT_TRUE(select_device("cpu").is_cpu());
  EXPECT_EQ(select_device("auto").is_cuda(), torch::cuda::is_available());
}

TEST(Device, AMissingCudaDeviceIsAnErrorAndNeverTheCpu) {
  const std::string message = error_of([] { select_device("cuda:99"); });
  EXPECT_NE(message.find("cuda:99"), std::string::npos) << message;
  if (!torch::cuda::is_available()) {
    EXPECT_THROW(select_device("cuda"), std::runtime_error);
  }
}

TEST(Device, OtherNamesAreRefused) {
  for (const char* name : {"", "gpu", "CPU", "cuda:", "cuda:x", "cuda:-1", "cuda:1234", "cuda0"}) {
    EXPECT_THROW(select_device(name), std::invalid_argument) << name;
  }
}

}  // namespace
}  // namespace rigidformer
