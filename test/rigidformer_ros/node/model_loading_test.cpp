// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "rigidformer_ros/forecast/inference_worker.hpp"
#include "rigidformer_ros/node/prediction_node.hpp"

namespace rigidformer_ros {
namespace {

namespace fs = std::filesystem;

// The weights in the repository.
const char kShippedModel[] = RIGIDFORMER_SOURCE_DIR "/models/hybrid.safetensors";

class ModelLoadingTest : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(folder / name, std::ios::binary) << content;
    return (folder / name).string();
  }

  static std::string shipped_bytes() {
    std::ifstream file(kShippedModel, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  // Loads a model on an inference thread as the node does, and waits until that succeeded or failed.
  static std::unique_ptr<InferenceWorker> load(const rigidformer::PredictorOptions& options) {
    auto worker = std::make_unique<InferenceWorker>([options] { return load_model(options); });
    while (worker->state() == InferenceWorker::State::kLoading) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return worker;
  }

  static void expect_refused(const std::string& file, const std::string& part) {
    rigidformer::PredictorOptions options;
    options.file = file;
    options.device = "cpu";
    const auto worker = load(options);
    EXPECT_EQ(worker->state(), InferenceWorker::State::kFailed) << file;
    EXPECT_NE(worker->message().find(part), std::string::npos) << worker->message();
  }

  const fs::path folder = fs::temp_directory_path() / ("rigidformer_ros_model_loading_" + std::to_string(getpid()));
};

TEST_F(ModelLoadingTest, P20_unusable_weights_are_refused_by_name) {
  const std::string bytes = shipped_bytes();
  ASSERT_GT(bytes.size(), 1000U);
  expect_refused((folder / "missing.safetensors").string(), "missing.safetensors");
  expect_refused(write("empty.safetensors", ""), "empty.safetensors");
  expect_refused(write("random.safetensors", std::string(4096, '\xa5')), "random.safetensors");
  expect_refused(write("truncated.safetensors", bytes.substr(0, bytes.size() / 2)), "truncated.safetensors");
  std::string damaged = bytes;
  damaged[damaged.size() - 100] = static_cast<char>(~damaged[damaged.size() - 100]);
  expect_refused(write("damaged.safetensors", damaged), "damaged.safetensors");
  expect_refused(folder.string(), folder.filename().string());
  expect_refused("package://no_such_package/model.safetensors", "no_such_package");
  expect_refused("", "file");
}

TEST_F(ModelLoadingTest, P20_weights_of_another_network_are_refused_by_name) {
  const std::string header = R"({"weight":{"dtype":"F32","shape":[2],"data_offsets":[0,8]}})";
  std::string foreign(8, '\0');
  foreign[0] = static_cast<char>(header.size());
  expect_refused(write("foreign.safetensors", foreign + header + std::string(8, '\0')), "foreign.safetensors");
}

TEST_F(ModelLoadingTest, P21_an_absent_gpu_is_an_error_when_asked_for_and_else_the_cpu_serves) {
  rigidformer::PredictorOptions options;
  options.file = kShippedModel;
  const auto automatic = load(options);
  ASSERT_EQ(automatic->state(), InferenceWorker::State::kReady) << automatic->message();
  if (automatic->info().device != "cpu") {
    GTEST_SKIP() << "this machine has a GPU";
  }
  options.device = "cuda";
  const auto explicit_gpu = load(options);
  EXPECT_EQ(explicit_gpu->state(), InferenceWorker::State::kFailed);
  EXPECT_NE(explicit_gpu->message().find("cuda"), std::string::npos) << explicit_gpu->message();
}

}  // namespace
}  // namespace rigidformer_ros
