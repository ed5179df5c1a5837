// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/options.hpp"

#include <gtest/gtest.h>

#include "rigidformer/data/example_archive.hpp"

namespace rigidformer {
namespace {

const std::filesystem::path kConfigFolder = std::filesystem::path(RIGIDFORMER_SOURCE_DIR) / "config" / "train";

class TrainingOptionsTest : public ::testing::Test {
 protected:
  TrainingOptions load(const std::string& text) {
    write_text(path_, text);
    return load_training_options(path_);
  }

  /// Message of the std::invalid_argument; it names the file.
  std::string refusal(const std::string& text) {
    EXPECT_THROW(load(text), std::invalid_argument) << text;
    const std::string message = error_of([&] { load(text); });
    EXPECT_NE(message.find(path_.string()), std::string::npos) << message;
    return message;
  }

  void expect_refusal(const std::string& text, const std::string& word) {
    const std::string message = refusal(text);
    EXPECT_NE(message.find(word), std::string::npos) << text << "\n  " << message;
  }

  const TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_.path() / "train.yaml";
};

TEST_F(TrainingOptionsTest, EveryShippedFileLoads) {
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kConfigFolder)) {
    if (entry.path().extension() != ".yaml") continue;
    SCOPED_TRACE(entry.path());
    for (const TrainingOptions& stage : load_training_stages(entry.path())) EXPECT_GT(stage.iterations, 0);
    ++files;
  }
  EXPECT_GE(files, 17);
}

TEST_F(TrainingOptionsTest, PaperFileHasTheNumbersOfTheText) {
  const TrainingOptions options = load_training_options(kConfigFolder / "paper.yaml");
  EXPECT_EQ(options.model.preset, "paper");
  EXPECT_EQ(options.windows.step_sizes, (std::vector<int>{1, 5, 10}));
  EXPECT_EQ(options.loss.position_weight, 10.0);
  EXPECT_EQ(options.loss.acceleration_weight, 1.0);
  EXPECT_EQ(options.loss.residual_unit, "frames2");
  EXPECT_EQ(options.optimizer.learning_rate, 1e-4);
  EXPECT_EQ(options.optimizer.final_learning_rate, 1e-6);
  EXPECT_EQ(options.optimizer.weight_decay, 0.01);
  EXPECT_EQ(options.optimizer.clip_norm, 1.0);
  EXPECT_EQ(options.augmentation.yaw_step_deg, 5.0);
  EXPECT_EQ(options.augmentation.yaw_probability, 0.5);
  ASSERT_EQ(options.unroll.size(), 1u);
  EXPECT_EQ(options.unroll[0].steps, 6);  // windows of eight frames
}

TEST_F(TrainingOptionsTest, AnEmptyFileIsAllDefaults) {
  const TrainingOptions options = load("");
  EXPECT_EQ(options.batch_size, TrainingOptions().batch_size);
  EXPECT_EQ(to_json(options.model), to_json(ModelOptions()));
}

TEST_F(TrainingOptionsTest, EveryKeyReachesItsField) {
  const TrainingOptions o = load(R"(
model: {preset: small, position_encoding: pca, num_anchors: 8, contact_gate: false, dropout: 0.2}
windows: {step_sizes: [2, 4], any_step_probability: 0.1, mid_air_probability: 0.2, floor_probability: 0.3}
augmentation: {min_points: 5, max_points: 50, view_probability: 0.4, noise_m: 0.01, shift_m: 2, yaw_per_batch: false}
point_sets: {sets_per_shape: 7, points_per_set: 70, seed: 3}
loss: {position_weight: 2, acceleration_weight: 3, residual_unit: dt, beta: 0.5, centre_of_mass_weight: 4}
optimizer: {learning_rate: 0.01, warmup: 0.1, beta1: 0.8, beta2: 0.9, clip_norm: 2, ema_decay: 0.5}
unroll: [{from: 0, steps: 2}, {from: 0.5, steps: 3}]
iterations: 11
batch_size: 12
seed: 18446744073709551615
precision: bfloat16
log_every: 13
)");
  EXPECT_EQ(o.model.preset, "small");
  EXPECT_EQ(o.model.position_encoding, PositionEncoding::kPca);
  EXPECT_EQ(o.model.num_anchors, 8);
  EXPECT_FALSE(o.model.contact_gate);
  EXPECT_EQ(o.model.dropout, 0.2);
  EXPECT_EQ(o.windows.step_sizes, (std::vector<int>{2, 4}));
  EXPECT_EQ(o.windows.floor_probability, 0.3);
  EXPECT_EQ(o.augmentation.max_points, 50);
  EXPECT_EQ(o.augmentation.shift_m, 2.0);
  EXPECT_FALSE(o.augmentation.yaw_per_batch);
  EXPECT_EQ(o.point_sets.points_per_set, 70);
  EXPECT_EQ(o.loss.residual_unit, "dt");
  EXPECT_EQ(o.loss.centre_of_mass_weight, 4.0);
  EXPECT_EQ(o.optimizer.beta2, 0.9);
  EXPECT_EQ(o.optimizer.ema_decay, 0.5);
  ASSERT_EQ(o.unroll.size(), 2u);
  EXPECT_EQ(o.unroll[1].from, 0.5);
  EXPECT_EQ(o.iterations, 11);
  EXPECT_EQ(o.seed, 18446744073709551615u);
  EXPECT_EQ(o.precision, "bfloat16");
  EXPECT_EQ(o.log_every, 13);
}

TEST_F(TrainingOptionsTest, OverridesGoBeforeTheFile) {
  write_text(path_, "model: {preset: small, contact_gate: true}\niterations: 5");
  const TrainingOptions o =
      load_training_options(path_, {"model.contact_gate=false", "iterations=7", "windows.step_sizes=[2, 3]",
                                    "unroll=[{from: 0, steps: 2}]", "optimizer.learning_rate=0.5"});
  EXPECT_EQ(o.model.preset, "small");
  EXPECT_FALSE(o.model.contact_gate);
  EXPECT_EQ(o.iterations, 7);
  EXPECT_EQ(o.windows.step_sizes, (std::vector<int>{2, 3}));
  EXPECT_EQ(o.unroll.at(0).steps, 2);
  EXPECT_EQ(o.optimizer.learning_rate, 0.5);
}

TEST_F(TrainingOptionsTest, WrongOverridesAreNamed) {
  write_text(path_, "iterations: 5");
  const std::pair<const char*, const char*> wrong[] = {{"iterations", "'iterations' must look like"},
                                                       {"model.contact_gates=false", "'model.contact_gates'"},
                                                       {"iterations=many", "'iterations'"},
                                                       {"iterations.most=3", path_.c_str()},
                                                       {"model.preset=[", path_.c_str()}};
  for (const auto& [assignment, word] : wrong) {
    const std::string message = error_of([&] { load_training_options(path_, {assignment}); });
    EXPECT_NE(message.find(word), std::string::npos) << assignment << "\n  " << message;
  }
}

TEST_F(TrainingOptionsTest, UnknownKeysAreRefusedWithTheKnownOnes) {
  expect_refusal("iteration: 5", "'iteration'");
  expect_refusal("iteration: 5", "iterations");
  expect_refusal("model: {presett: tiny}", "'model.presett'");
  expect_refusal("windows: {step_size: [1]}", "'windows.step_size'");
  expect_refusal("augmentation: {yaw: 1}", "'augmentation.yaw'");
  expect_refusal("point_sets: {count: 1}", "'point_sets.count'");
  expect_refusal("loss: {gamma: 1}", "'loss.gamma'");
  expect_refusal("optimizer: {lr: 1}", "'optimizer.lr'");
  expect_refusal("unroll: [{from: 0, step: 1}]", "'unroll[].step'");
}

TEST_F(TrainingOptionsTest, WrongTypesAreRefusedByKey) {
  expect_refusal("iterations: many", "'iterations'");
  expect_refusal("batch_size: 1.5", "'batch_size'");
  expect_refusal("seed: -1", "'seed'");
  expect_refusal("windows: {step_sizes: 5}", "'windows.step_sizes'");
  expect_refusal("windows: {step_sizes: [1, x]}", "'windows.step_sizes'");
  expect_refusal("model: {contact_gate: 3}", "'model.contact_gate'");
  expect_refusal("optimizer: {learning_rate: [1]}", "'optimizer.learning_rate'");
  expect_refusal("optimizer: fast", "'optimizer.'");
  expect_refusal("unroll: [1]", "'unroll[].'");
  refusal("unroll: 4");
  refusal("[1, 2]");
  refusal("model: {preset: [");
}

TEST_F(TrainingOptionsTest, ValuesOutOfRangeAreRefusedByKey) {
  const std::pair<const char*, const char*> wrong[] = {
      {"iterations: 0", "iterations"},
      {"batch_size: 0", "batch_size"},
      {"log_every: 0", "log_every"},
      {"precision: half", "precision"},
      {"loss: {residual_unit: s}", "loss.residual_unit"},
      {"loss: {beta: 0}", "loss.beta"},
      {"augmentation: {min_points: 3}", "augmentation.min_points"},
      {"augmentation: {min_points: 64, max_points: 32}", "augmentation.min_points"},
      {"augmentation: {view_probability: 1.5}", "augmentation.view_probability"},
      {"augmentation: {noise_m: -1}", "augmentation.noise_m"},
      {"point_sets: {sets_per_shape: 1}", "point_sets"},
      {"point_sets: {points_per_set: 100}", "point_sets"},
      {"optimizer: {learning_rate: -1}", "optimizer.learning_rate"},
      {"optimizer: {beta2: 1}", "optimizer.beta2"},
      {"optimizer: {clip_norm: 0}", "optimizer.clip_norm"},
      {"optimizer: {ema_decay: 1}", "optimizer.ema_decay"},
      {"unroll: []", "unroll"},
      {"unroll: [{from: 0.5, steps: 1}]", "unroll"},
      {"unroll: [{from: 0, steps: -1}]", "unroll[].steps"},
      {"model: {preset: huge}", "huge"},
      {"model: {position_encoding: rope}", "rope"},
      {"model: {num_anchors: 2}", "num_anchors"}};
  for (const auto& [text, word] : wrong) expect_refusal(text, word);
}

TEST_F(TrainingOptionsTest, AFileExtendsAnotherKeyByKey) {
  std::filesystem::create_directories(folder_.path() / "deep");
  write_text(folder_.path() / "first.yaml",
             "model: {preset: small, contact_gate: false}\nunroll: [{from: 0, steps: 2}, {from: 0.5, steps: 3}]\n"
             "iterations: 5\nbatch_size: 6\nloss: {beta: 0.5}");
  write_text(folder_.path() / "deep" / "second.yaml",
             "extends: ../first.yaml\nunroll: [{from: 0, steps: 4}]\niterations: 7");
  const TrainingOptions o = load("extends: deep/second.yaml\nmodel: {dropout: 0.5}\noptimizer: {beta1: 0.5}");
  EXPECT_EQ(o.model.preset, "small");
  EXPECT_FALSE(o.model.contact_gate);
  EXPECT_EQ(o.model.dropout, 0.5);
  ASSERT_EQ(o.unroll.size(), 1U) << "a list is replaced as a whole";
  EXPECT_EQ(o.unroll[0].steps, 4);
  EXPECT_EQ(o.iterations, 7);
  EXPECT_EQ(o.batch_size, 6);
  EXPECT_EQ(o.loss.beta, 0.5);
  EXPECT_EQ(o.optimizer.beta1, 0.5);
  EXPECT_EQ(load_training_options(path_, {"iterations=9"}).iterations, 9);
  EXPECT_EQ(load("extends: deep/second.yaml").iterations, 7);
}

TEST_F(TrainingOptionsTest, ExtendedFilesThatCannotBeReadAreNamed) {
  const std::string other = (folder_.path() / "other.yaml").string();
  write_text(other, "extends: train.yaml");
  const std::string message = refusal("extends: other.yaml");
  EXPECT_NE(message.find(path_.string() + " -> " + other + " -> " + path_.string()), std::string::npos) << message;
  expect_refusal("extends: train.yaml", "leads back");
  expect_refusal("extends: nowhere.yaml", (folder_.path() / "nowhere.yaml").string());
  expect_refusal("extends: [other.yaml]", "'extends'");
  write_text(other, "iteration: 5");
  expect_refusal("extends: other.yaml", "unknown key 'iteration'");
  write_text(other, "");
  expect_refusal("extends: other.yaml", "no mapping");
  write_text(other, "iterations: [");
  expect_refusal("extends: other.yaml", other);
}

TEST_F(TrainingOptionsTest, AStageChangesTheOneBefore) {
  write_text(path_,
             "model: {preset: small}\niterations: 5\nbatch_size: 6\nloss: {beta: 0.5}\n"
             "stages:\n  - {}\n  - {model: {contact_tokens: true}, iterations: 7, loss: {beta: 0.25}}\n"
             "  - {loss: {position_weight: 2}, unroll: [{from: 0, steps: 3}]}\n");
  const auto stages = load_training_stages(path_, {"batch_size=8"});
  ASSERT_EQ(stages.size(), 3U);
  EXPECT_EQ(stages[0].iterations, 5);
  EXPECT_FALSE(stages[0].model.contact_tokens);
  EXPECT_EQ(stages[1].iterations, 7);
  EXPECT_TRUE(stages[2].model.contact_tokens);
  EXPECT_EQ(stages[2].loss.beta, 0.25);
  EXPECT_EQ(stages[2].loss.position_weight, 2.0);
  EXPECT_EQ(stages[2].unroll.front().steps, 3);
  EXPECT_EQ(stages[1].unroll.front().steps, 1);
  for (const TrainingOptions& stage : stages) EXPECT_EQ(stage.batch_size, 8);
  EXPECT_NE(error_of([&] { load_training_options(path_); }).find("3 stages"), std::string::npos);
  EXPECT_EQ(load_training_stages(kConfigFolder / "tiny.yaml").size(), 1U);
}

TEST_F(TrainingOptionsTest, StagesThatAreNoneAreRefused) {
  expect_refusal("stages: 3", "'stages' must be a list of mappings");
  expect_refusal("stages: []", "'stages' must be a list of mappings");
  expect_refusal("stages: [5]", "'stages' must be a list of mappings");
  expect_refusal("stages: [{iteration: 5}]", "unknown key 'iteration'");
  expect_refusal("stages: [{stages: [{}]}]", "unknown key 'stages'");
}

TEST_F(TrainingOptionsTest, AMissingFileIsNamed) {
  const std::string message = error_of([] { load_training_options("/nowhere/train.yaml"); });
  EXPECT_NE(message.find("/nowhere/train.yaml"), std::string::npos) << message;
}

}  // namespace
}  // namespace rigidformer
