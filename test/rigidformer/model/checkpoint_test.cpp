// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/checkpoint.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "random_scene.hpp"
#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/model/summary.hpp"
#include "rigidformer/model/tensor_conversion.hpp"

namespace rigidformer {
namespace {

TrainingFacts example_facts() {
  TrainingFacts facts;
  facts.data = "movi_a 12, movi_b 3";
  facts.iterations = (std::int64_t{1} << 40) + 1;
  facts.windows = 77;
  facts.seed = std::numeric_limits<std::uint64_t>::max();
  facts.source_revision = "abc123";
  facts.min_step_frames = 2.0;
  facts.max_step_frames = 8.0;
  facts.min_diameter_m = 0.1;
  facts.max_diameter_m = 3.3;
  facts.max_speed_mps = 12.25;
  facts.min_points = 64;
  facts.max_points = 192;
  return facts;
}

class CheckpointTest : public ::testing::Test {
 protected:
  void SetUp() override { save_checkpoint(path_, model_, example_facts()); }

  /// Returns the message of the one std::runtime_error that loading must throw.
  std::string defect() {
    return file_error_of(path_, [&] { load_checkpoint(path_); });
  }

  void expect_defect(const std::string& word) {
    const std::string message = defect();
    EXPECT_NE(message.find(word), std::string::npos) << message;
  }

  /// Rewrites the file, with a fitting hash, after a change of its content.
  template <typename Change>
  void rewrite(const Change& change) {
    save_checkpoint(path_, model_, example_facts());
    TensorFile file = read_tensor_file(path_);
    change(file);
    write_tensor_file(path_, file);
  }

  void flip_byte(std::streamoff position) {
    save_checkpoint(path_, model_, example_facts());
    std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(position);
    const char value = static_cast<char>(file.get() ^ 1);
    file.seekp(position);
    file.put(value);
  }

  const TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_.path() / "model.safetensors";
  RigidFormer model_ = random_model(contact_aware(model_preset("tiny")), torch::kFloat32);
};

TEST_F(CheckpointTest, Float32RoundTripIsExact) {
  Checkpoint loaded = load_checkpoint(path_);
  const auto expected = model_->named_parameters();
  ASSERT_EQ(loaded.model->named_parameters().size(), expected.size());
  for (const auto& parameter : loaded.model->named_parameters()) {
    EXPECT_TRUE(torch::equal(parameter.value(), expected[parameter.key()])) << parameter.key();
  }
  EXPECT_EQ(to_json(loaded.model->options), to_json(model_->options));
  EXPECT_EQ(loaded.sha256.size(), 64u);
  loaded.model->eval();
  const RandomScene scene = random_scene(1, {{12, 9}}, 4, 0, torch::kFloat32);
  EXPECT_TRUE(torch::equal(predict(loaded.model, scene).anchors_raw, predict(model_, scene).anchors_raw));
}

TEST_F(CheckpointTest, TrainingFactsSurvive) {
  const TrainingFacts a = example_facts(), b = load_checkpoint(path_).facts;
  EXPECT_EQ(b.data, a.data);
  EXPECT_EQ(b.iterations, a.iterations);
  EXPECT_EQ(b.windows, a.windows);
  EXPECT_EQ(b.seed, a.seed);
  EXPECT_EQ(b.source_revision, a.source_revision);
  EXPECT_EQ(b.min_step_frames, a.min_step_frames);
  EXPECT_EQ(b.max_step_frames, a.max_step_frames);
  EXPECT_EQ(b.min_diameter_m, a.min_diameter_m);
  EXPECT_EQ(b.max_diameter_m, a.max_diameter_m);
  EXPECT_EQ(b.max_speed_mps, a.max_speed_mps);
  EXPECT_EQ(b.min_points, a.min_points);
  EXPECT_EQ(b.max_points, a.max_points);
}

TEST_F(CheckpointTest, BFloat16RoundTripIsWithinRoundingAndHalfTheSize) {
  const auto full_size = std::filesystem::file_size(path_);
  save_checkpoint(path_, model_, example_facts(), TensorType::kBFloat16);
  EXPECT_LT(std::filesystem::file_size(path_), 0.6 * static_cast<double>(full_size));
  const auto expected = model_->named_parameters();
  const Checkpoint loaded = load_checkpoint(path_);
  for (const auto& parameter : loaded.model->named_parameters()) {
    const Tensor exact = expected[parameter.key()];
    EXPECT_TRUE(((parameter.value() - exact).abs() <= exact.abs() / 256.0).all().item<bool>()) << parameter.key();
    EXPECT_EQ(parameter.value().scalar_type(), torch::kFloat32);
  }
}

TEST_F(CheckpointTest, MissingTruncatedAndForeignFilesAreRefused) {
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) - 5);
  defect();
  std::filesystem::resize_file(path_, 100);
  defect();
  write_text(path_, "PK\x03\x04 some zip archive of another program");
  defect();
  std::filesystem::remove(path_);
  defect();
  TensorFile foreign;
  foreign.tensors["weight"] = make_raw_tensor<float>(TensorType::kFloat32, {1}, {1.0F});
  write_tensor_file(path_, foreign);
  expect_defect("not a RigidFormer model");
  rewrite([](TensorFile& file) { file.metadata["format"] = "rigidformer-training-state"; });
  expect_defect("not a RigidFormer model");
}

TEST_F(CheckpointTest, TamperedHeaderAndDataAreRefused) {
  std::ifstream in(path_, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  for (const char* word : {"embedding_dim", "max_speed_mps", "data_offsets", "iterations"}) {
    ASSERT_NE(text.find(word), std::string::npos);
    flip_byte(static_cast<std::streamoff>(text.find_first_of("0123456789", text.find(word))));
    defect();
  }
  flip_byte(static_cast<std::streamoff>(text.size()) - 1);
  expect_defect("SHA-256");
  flip_byte(static_cast<std::streamoff>(text.size()) - 4001);
  expect_defect("SHA-256");
}

TEST_F(CheckpointTest, WrongVersionsAndBrokenTextsAreRefused) {
  rewrite([](TensorFile& file) { file.metadata["format_version"] = "2"; });
  expect_defect("version 2");
  for (const char* key : {"format", "format_version", "model", "training"}) {
    rewrite([&](TensorFile& file) { file.metadata.erase(key); });
    expect_defect(key);
  }
  rewrite([](TensorFile& file) { file.metadata["model"] = "{\"embedding_dim\": 64}"; });
  expect_defect("model options");
  rewrite([](TensorFile& file) { file.metadata["model"] = "not json"; });
  expect_defect("model options");
  rewrite([](TensorFile& file) { file.metadata["training"] = "{}"; });
  expect_defect("data");
  rewrite([](TensorFile& file) { file.metadata["training"] = "[1"; });
  defect();
}

// JSON text can hold any number. Converting one that does not fit would cut it or be undefined.
TEST_F(CheckpointTest, TrainingFactsThatAreNoIntegersOfTheirRangeAreRefusedByName) {
  const std::pair<const char*, const char*> wrong[] = {
      {"iterations", "1.5"},        {"iterations", "1e300"}, {"iterations", "18446744073709551615"},
      {"min_points", "4294967360"}, {"max_points", "true"},  {"seed", "-1"},
      {"windows", "\"77\""}};
  for (const auto& [name, number] : wrong) {
    rewrite([&, name = name, number = number](TensorFile& file) {
      std::string& facts = file.metadata.at("training");
      const std::size_t begin = facts.find(':', facts.find('"' + std::string(name) + '"')) + 1;
      facts.replace(begin, facts.find_first_of(",}", begin) - begin, number);
    });
    expect_defect("training fact '" + std::string(name) + "'");
  }
}

TEST_F(CheckpointTest, WrongTensorsAreRefusedByName) {
  const std::string name = "decoder.registers";
  rewrite([&](TensorFile& file) { file.tensors.erase(name); });
  expect_defect("'" + name + "' is missing");
  rewrite([&](TensorFile& file) { file.tensors["decoder.extra"] = file.tensors.at(name); });
  expect_defect("surplus tensor 'decoder.extra'");
  rewrite([&](TensorFile& file) { std::swap(file.tensors[name].shape[0], file.tensors[name].shape[1]); });
  expect_defect(name);
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    rewrite([&](TensorFile& file) {
      Tensor tensor = from_raw(file.tensors.at(name));
      tensor[1][2] = value;
      file.tensors[name] = to_raw(tensor, TensorType::kFloat32);
    });
    expect_defect(name);
  }
}

TEST_F(CheckpointTest, SummaryNamesPartsAndFacts) {
  const std::string text = summarize_checkpoint(path_);
  for (const std::string& word : {std::string("movi_a 12"), std::string("decoder"), std::string("predictor"),
                                  load_checkpoint(path_).sha256, std::to_string(count_parameters(*model_))}) {
    EXPECT_NE(text.find(word), std::string::npos) << word << '\n' << text;
  }
  EXPECT_NE(summarize_preset("tiny").find("encoder"), std::string::npos);
}

TEST(TensorConversion, KeepsEveryTypeAndIgnoresStrides) {
  const Tensor values = torch::tensor({{1.0, -2.0, 3.0}, {4.0, 5.0, 6.0}}, torch::kFloat64).t();
  const std::pair<TensorType, torch::ScalarType> types[] = {
      {TensorType::kFloat32, torch::kFloat32}, {TensorType::kBFloat16, torch::kBFloat16},
      {TensorType::kFloat64, torch::kFloat64}, {TensorType::kInt64, torch::kInt64},
      {TensorType::kInt32, torch::kInt32},     {TensorType::kInt16, torch::kInt16}};
  for (const auto& [stored, type] : types) {
    const Tensor back = from_raw(to_raw(values, stored));
    EXPECT_EQ(back.scalar_type(), type);
    EXPECT_TRUE(torch::equal(back, values.to(type)));
  }
  EXPECT_THROW(from_raw({TensorType::kFloat32, {2}, {1, 2, 3}}), std::invalid_argument);
}

}  // namespace
}  // namespace rigidformer
