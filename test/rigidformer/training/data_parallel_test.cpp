// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <future>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/model/checkpoint.hpp"
#include "rigidformer/training/simulated_scenes.hpp"

namespace rigidformer {
namespace {

/// Finds a port that nobody listens on now.
int free_port() {
  const int handle = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  EXPECT_EQ(bind(handle, reinterpret_cast<sockaddr*>(&address), size), 0);
  EXPECT_EQ(getsockname(handle, reinterpret_cast<sockaddr*>(&address), &size), 0);
  close(handle);
  return ntohs(address.sin_port);
}

class DataParallelTest : public ::testing::Test {
 protected:
  void SetUp() override {
#if !defined(RIGIDFORMER_HAS_SIMULATION) || !defined(RIGIDFORMER_HAS_GLOO)
    GTEST_SKIP() << "built without Bullet or without c10d";
#else
    write_scene_archive(data_, simulated_scenes());
    std::ifstream tiny(RIGIDFORMER_SOURCE_DIR "/config/train/tiny.yaml");
    std::ofstream(config_) << tiny.rdbuf() << "micro_batches: 2\n";
#endif
  }

  /// Runs the trainer with extra environment variables and arguments; returns its exit status.
  int train(const std::string& environment, const std::string& output, const std::string& arguments = "") const {
    const std::string log = (folder_.path() / "train.log").string();
    const std::string command = environment + " " RIGIDFORMER_TRAIN_PROGRAM " --device cpu --config " +
                                config_.string() + " --data " + data_.string() + " --out " +
                                (folder_.path() / output).string() + " " + arguments + " >>" + log + " 2>&1";
    const int status = std::system(command.c_str());
    if (status != 0) {
      std::ifstream in(log);
      ADD_FAILURE() << "'" << command << "' failed:\n" << in.rdbuf();
    }
    return status;
  }

  void train_with_two_processes(const std::string& output, const std::string& arguments) const {
    const std::string common = "WORLD_SIZE=2 MASTER_ADDR=127.0.0.1 MASTER_PORT=" + std::to_string(free_port());
    auto second =
        std::async(std::launch::async, [&] { return train(common + " RANK=1 LOCAL_RANK=0", output, arguments); });
    train(common + " RANK=0", output, arguments);
    second.wait();
  }

  /// Largest difference of any weight of two models.
  double difference(const std::string& a, const std::string& b) const {
    const Checkpoint first = load_checkpoint(folder_.path() / a / "model.safetensors");
    const Checkpoint second = load_checkpoint(folder_.path() / b / "model.safetensors");
    const auto others = second.model->named_parameters();
    double largest = 0.0;
    for (const auto& parameter : first.model->named_parameters()) {
      const torch::Tensor gap = (parameter.value() - others[parameter.key()]).abs().max();
      largest = std::max(largest, gap.item<double>());
    }
    return largest;
  }

  const TemporaryFolder folder_;
  const std::filesystem::path data_ = folder_.path() / "scenes.safetensors", config_ = folder_.path() / "train.yaml";
};

TEST_F(DataParallelTest, TwoProcessesLearnWhatOneLearns) {
  train("", "one", "--iterations 8");
  train_with_two_processes("two", "--iterations 8");
  EXPECT_LT(difference("one", "two"), 1e-6);
  EXPECT_EQ(load_checkpoint(folder_.path() / "two" / "model.safetensors").facts.windows, 8 * 2 * 8);
  train("", "three", "--iterations 7");
  EXPECT_GT(difference("one", "three"), 1e-5) << "an iteration moves the weights by more than rounding";
}

TEST_F(DataParallelTest, ARunOfTwoProcessesGoesOnFromThatOfOne) {
  train("", "straight", "--iterations 8");
  train("", "parts", "--iterations 8 --max-minutes 0.0001");
  train_with_two_processes("parts", "--iterations 8 --resume");
  EXPECT_LT(difference("straight", "parts"), 1e-6);
}

}  // namespace
}  // namespace rigidformer
