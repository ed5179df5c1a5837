// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/trainer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/model/checkpoint.hpp"
#include "rigidformer/model/nearest.hpp"
#include "rigidformer/training/command_line.hpp"
#include "rigidformer/training/losses.hpp"
#include "rigidformer/training/options.hpp"
#include "rigidformer/training/quiet_terminal.hpp"
#include "rigidformer/training/simulated_scenes.hpp"
#include "rigidformer/training/stages.hpp"
#include "rigidformer/training/training_data.hpp"
#include "rigidformer/windows/window_scenes.hpp"

namespace rigidformer {
namespace {

constexpr std::int64_t kIterations = 30;  // iterations of a run, enough to be cut in two; chosen by eye
const std::string kConfigFile = std::string(RIGIDFORMER_SOURCE_DIR) + "/config/train/tiny.yaml";

bool same_weights(const std::filesystem::path& a, const std::filesystem::path& b) {
  const std::vector<Tensor> first = load_checkpoint(a).model->parameters();
  const std::vector<Tensor> second = load_checkpoint(b).model->parameters();
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const Tensor& x, const Tensor& y) { return torch::equal(x, y); });
}

class TrainerTest : public ::testing::Test {
 protected:
  void SetUp() override {
#ifdef RIGIDFORMER_HAS_SIMULATION
    write_scene_archive(data_, simulated_scenes());
    options_ = load_training_options(kConfigFile);
    options_.iterations = kIterations;
#else
    GTEST_SKIP() << "scenes need the simulation, which was built without Bullet";
#endif
  }

  TrainingPaths paths(const std::string& output) const { return {{data_}, {}, {}, folder_.path() / output, {}}; }

  /// Trains into folder `output` and returns the number of iterations done so far.
  std::int64_t run(const std::string& output, double max_seconds = 0.0, bool resume = false) const {
    TrainingMachine machine;
    machine.device = "cpu";
    machine.max_minutes = max_seconds / 60.0;
    machine.resume = resume;
    train(options_, paths(output), machine);
    return load_checkpoint(model_file(output)).facts.iterations;
  }

  std::filesystem::path model_file(const std::string& output) const {
    return folder_.path() / output / "model.safetensors";
  }

  const TemporaryFolder folder_;
  const std::filesystem::path data_ = folder_.path() / "scenes.safetensors";
  TrainingOptions options_;
  const QuietTerminal quiet_;
};

TEST_F(TrainerTest, ARunThatIsAskedToStopSavesAndGoesOn) {
  int asked = 0;
  TrainingMachine machine;
  machine.device = "cpu";
  machine.should_stop = [&asked] { return ++asked > 5; };
  train(options_, paths("cut"), machine);
  EXPECT_EQ(load_checkpoint(model_file("cut")).facts.iterations, 5);
  EXPECT_EQ(run("cut", 0.0, true), kIterations);
  EXPECT_EQ(run("whole"), kIterations);
  EXPECT_TRUE(same_weights(model_file("cut"), model_file("whole")));
}

TEST_F(TrainerTest, StagesFollowEachOtherAndAreResumed) {
  TrainingOptions second = options_;
  options_.iterations = 4;
  second.iterations = 6;
  second.seed = 2;
  second.model.own_token_in_query = true;
  const auto run_all = [&](const std::string& output, double max_minutes, bool resume) {
    TrainingMachine machine;
    machine.device = "cpu";
    machine.max_minutes = max_minutes;
    machine.resume = resume;
    train_in_stages({options_, second}, paths(output), machine);
  };
  run_all("whole", 0.0, false);
  EXPECT_EQ(load_checkpoint(model_file("whole/stage_1")).facts.iterations, 4);
  EXPECT_EQ(load_checkpoint(model_file("whole")).facts.iterations, 6);
  EXPECT_TRUE(load_checkpoint(model_file("whole")).model->options.own_token_in_query);

  run_all("parts", 1e-9, false);  // the first stage is begun only
  EXPECT_FALSE(std::filesystem::exists(model_file("parts")));
  run_all("parts", 0.0, true);
  const auto first_written = std::filesystem::last_write_time(model_file("parts/stage_1"));
  run_all("parts", 0.0, true);
  EXPECT_EQ(std::filesystem::last_write_time(model_file("parts/stage_1")), first_written) << "a finished stage is kept";
  EXPECT_TRUE(same_weights(model_file("parts"), model_file("whole")));
}

TEST_F(TrainerTest, LengthScaleIsThatOfTheScenes) {
  TrainingPaths small = paths("any");
  small.length_scale = 0.25;
  const TrainingData plain = load_training_data(paths("any"), options_, torch::kCPU);
  const TrainingData scaled = load_training_data(small, options_, torch::kCPU);
  EXPECT_NEAR(scaled.facts.max_diameter_m, 4.0 * plain.facts.max_diameter_m, 1e-3);
  EXPECT_NEAR(scaled.facts.max_speed_mps, 2.0 * plain.facts.max_speed_mps, 1e-2);
  EXPECT_NEAR(scaled.training.frame_rates()[0], 120.0, 1e-9);
  EXPECT_EQ(scaled.facts.max_step_frames, plain.facts.max_step_frames);
  small.length_scale.reset();
  EXPECT_THROW(load_training_data(small, options_, torch::kCPU), std::invalid_argument);  // auto goes by --init
  ASSERT_EQ(run("model"), kIterations);
  small.initial_model = model_file("model");
  EXPECT_NEAR(load_training_data(small, options_, torch::kCPU).training.frame_rates()[0], 240.0, 120.0);
}

// The windows show mostly free flight, in which gravity is soon learned.
TEST_F(TrainerTest, AHundredIterationsLowerTheLoss) {
  options_.windows.mid_air_probability = options_.windows.floor_probability = 0.0;
  options_.iterations = 100;
  options_.optimizer.learning_rate = 5e-3;
  options_.optimizer.ema_decay = 0.0;
  ASSERT_EQ(run("start", 1e-9), 0);
  ASSERT_EQ(run("end"), 100);
  const TrainingData data = load_training_data(paths("any"), options_, torch::kCPU);
  torch::manual_seed(1);
  const std::vector<Window> windows = data.sampler->draw_batch(64, 1, 99, 0);
  const WindowBatch batch = make_window_batch(data.training, windows, 1, 4, options_.augmentation);
  const auto loss_of = [&](const std::string& output) {
    torch::NoGradGuard no_grad;
    RigidFormer model = load_checkpoint(model_file(output)).model;
    model->eval();
    return window_loss(options_.loss, model, batch, nearest_by_distance_matrix).item<double>();
  };
  EXPECT_LT(loss_of("end"), 0.95 * loss_of("start"));
}

TEST_F(TrainerTest, ResumedRunEqualsTheUninterruptedOneBitByBit) {
  options_.unroll = {{0.0, 1}, {0.5, 2}};
  run("whole");
  double seconds = 0.2;
  std::int64_t done = 0;
  for (int attempt = 0; attempt < 12 && (done == 0 || done == kIterations); ++attempt) {
    done = run("parts", seconds);
    seconds *= done == 0 ? 3.0 : 0.3;
  }
  ASSERT_GT(done, 0);
  ASSERT_LT(done, kIterations);
  ASSERT_EQ(run("parts", 0.0, true), kIterations);
  const TensorFile whole = read_tensor_file(model_file("whole")), parts = read_tensor_file(model_file("parts"));
  ASSERT_EQ(parts.tensors.size(), whole.tensors.size());
  for (const auto& [name, tensor] : whole.tensors) EXPECT_EQ(parts.tensors.at(name).bytes, tensor.bytes) << name;
  EXPECT_EQ(parts.metadata, whole.metadata);  // the facts and the hash are the same too
}

TEST_F(TrainerTest, LeavesModelStateLogAndValidation) {
  options_.iterations = 10;
  options_.validation_scenes = 2;
  TrainingPaths with_validation = paths("out");
  with_validation.validation = {data_};
  train(options_, with_validation, {"cpu", 1, 0.0, false});
  const std::filesystem::path out = folder_.path() / "out";
  for (const char* name : {"model.safetensors", "model_bfloat16.safetensors", "state.safetensors"}) {
    EXPECT_NO_THROW(read_tensor_file(out / name)) << name;
  }
  const auto text_of = [&](const char* name) {
    std::ifstream in(out / name);
    return std::string{std::istreambuf_iterator<char>(in), {}};
  };
  const std::string log = text_of("log.csv");
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 2) << log;  // the header and iteration 10
  EXPECT_NE(text_of("validation.log").find("start 240"), std::string::npos);
  const TrainingFacts facts = load_checkpoint(out / "model.safetensors").facts;
  EXPECT_EQ(facts.data, "movi_a 3");
  EXPECT_EQ(facts.windows, 10 * options_.batch_size);
  EXPECT_GT(facts.max_speed_mps, 1.0);
  EXPECT_GT(facts.max_diameter_m, facts.min_diameter_m);
}

TEST_F(TrainerTest, P45_ValidationScenesThatAreTooShortAreNamed) {
  options_.iterations = 2;
  TrainingPaths with_validation = paths("out");
  with_validation.validation = {folder_.path() / "short.safetensors"};
  write_scene_archive(with_validation.validation[0], flying_cubes_archive({1, 2}, 90));
  const auto train_it = [&] { train(options_, with_validation, {"cpu", 1, 0.0, false}); };
  const std::string error = error_of(train_it);
  EXPECT_NE(
      error.find("short.safetensors': rollouts from frame 0 need scenes of 101 frames at 240 Hz, the longest has 90"),
      std::string::npos)
      << error;
  // One that is long enough for the first start; what lies behind it must not be read.
  SceneArchive mixed = flying_cubes_archive({1, 2}, 90);
  mixed.scenes.push_back(flying_cubes(1, 130));
  write_scene_archive(with_validation.validation[0], mixed);
  ASSERT_EQ(error_of(train_it), "");
  std::ifstream in(folder_.path() / "out" / "validation.log");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("start 0"), std::string::npos) << text;
  EXPECT_EQ(text.find("start 120"), std::string::npos) << text;
}

TEST_F(TrainerTest, P45_ScenesWithoutObjectsAndShortOnesDoNotStopTheRun) {
  options_.iterations = 2;
  SceneArchive mixed = flying_cubes_archive({1, 2}, 90);
  mixed.scenes.push_back(flying_cubes(0, 90));
  mixed.scenes.push_back(flying_cubes(1, 5));
  mixed.scenes.push_back(flying_cubes(1, 40));
  write_scene_archive(data_, mixed);
  run("out");
  EXPECT_EQ(load_checkpoint(model_file("out")).facts.data, "flying_cubes 3");
}

TEST_F(TrainerTest, ResumingAnotherModelIsRefused) {
  run("out", 1e-9);
  options_.model.num_layers = 5;
  EXPECT_NE(error_of([&] { run("out", 1e-9, true); }).find("other model options"), std::string::npos);
  EXPECT_NE(error_of([&] { run("nothing", 1e-9, true); }).find("state.safetensors"), std::string::npos);
}

TEST_F(TrainerTest, CommandLineReportsErrorsInOneLine) {
  std::ostringstream log;
  TrainCommand command;
  command.config = "/nowhere/train.yaml";
  EXPECT_EQ(run_train(command, log), 1);
  EXPECT_EQ(log.str().rfind("train: ", 0), 0u) << log.str();
  command.config = kConfigFile;
  command.paths = paths("out");
  command.machine.device = "cpu";
  command.machine.max_minutes = 1e-9;
  command.iterations = 7;
  EXPECT_EQ(run_train(command, log), 0) << log.str();
  command.paths.data = {folder_.path() / "missing"};
  EXPECT_EQ(run_train(command, log), 1);
  EXPECT_NE(log.str().find("missing"), std::string::npos) << log.str();
}

}  // namespace
}  // namespace rigidformer
