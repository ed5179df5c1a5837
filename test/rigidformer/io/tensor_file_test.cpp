// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/io/tensor_file.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <limits>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/io/full_disk.hpp"
#include "rigidformer/io/sha256.hpp"

namespace rigidformer {
namespace {

using Bytes = std::vector<std::uint8_t>;

TensorFile example_file() {
  TensorFile file;
  file.tensors["a.float32"] = make_raw_tensor<float>(TensorType::kFloat32, {2, 3}, {1, -2, 3, 4.5F, 0, 1e-30F});
  file.tensors["b.float64"] = make_raw_tensor<double>(TensorType::kFloat64, {2}, {1.0 / 3.0, -1e300});
  file.tensors["c.bfloat16"] = make_raw_tensor<std::uint16_t>(TensorType::kBFloat16, {2}, {0x3F80, 0xC000});
  file.tensors["d.int64"] = make_raw_tensor<std::int64_t>(TensorType::kInt64, {1, 1}, {1LL << 60});
  file.tensors["e.int32"] = make_raw_tensor<std::int32_t>(TensorType::kInt32, {2}, {-7, 7});
  file.tensors["f.int16"] = make_raw_tensor<std::int16_t>(TensorType::kInt16, {3}, {-1, 0, 32767});
  file.tensors["g.uint8"] = make_raw_tensor<std::uint8_t>(TensorType::kUInt8, {3}, {0, 128, 255});
  file.tensors["h.scalar"] = make_raw_tensor<float>(TensorType::kFloat32, {}, {2.5F});
  file.tensors["i.empty"] = make_raw_tensor<float>(TensorType::kFloat32, {0, 3}, {});
  file.metadata = {{"purpose", "test \"quoted\" \u00e9"}, {"empty", ""}};
  return file;
}

Bytes read_bytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_bytes(const std::filesystem::path& path, const Bytes& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// Writes a file in the right layout with any header text, without adding a hash.
Bytes assemble(const std::string& header, const Bytes& data) {
  const std::uint64_t size = header.size();
  std::string text(reinterpret_cast<const char*>(&size), sizeof(size));
  text += header;
  Bytes bytes(text.begin(), text.end());
  bytes.insert(bytes.end(), data.begin(), data.end());
  return bytes;
}

class TensorFileTest : public ::testing::Test {
 protected:
  /// Returns the message of the std::runtime_error that reading `bytes` throws, which must name the path.
  std::string defect_of(const Bytes& bytes) {
    write_bytes(path_, bytes);
    return file_error_of(path_, [&] { read_tensor_file(path_); });
  }

  void expect_defect(const Bytes& bytes, const std::string& word) {
    const std::string message = defect_of(bytes);
    EXPECT_NE(message.find(word), std::string::npos) << message;
  }

  const TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_.path() / "x.safetensors";
};

TEST_F(TensorFileTest, RoundTripKeepsEveryTypeByteByByte) {
  const TensorFile written = example_file();
  write_tensor_file(path_, written);
  const TensorFile read = read_tensor_file(path_);
  ASSERT_EQ(read.tensors.size(), written.tensors.size());
  for (const auto& [name, tensor] : written.tensors) {
    ASSERT_EQ(read.tensors.count(name), 1u) << name;
    EXPECT_EQ(read.tensors.at(name).type, tensor.type) << name;
    EXPECT_EQ(read.tensors.at(name).shape, tensor.shape) << name;
    EXPECT_EQ(read.tensors.at(name).bytes, tensor.bytes) << name;
  }
  EXPECT_EQ(read.metadata.at("purpose"), written.metadata.at("purpose"));
  EXPECT_EQ(read.metadata.at("empty"), "");
  EXPECT_EQ(stored_sha256(read).size(), 64u);
  EXPECT_EQ(stored_sha256(written), "");
}

TEST_F(TensorFileTest, SameContentGivesSameBytesAndOtherContentAnotherHash) {
  TensorFile file = example_file();
  write_tensor_file(path_, file);
  const Bytes first = read_bytes(path_);
  const std::string first_hash = stored_sha256(read_tensor_file(path_));
  write_tensor_file(path_, read_tensor_file(path_));  // the old hash in the metadata is ignored
  EXPECT_EQ(read_bytes(path_), first);
  file.metadata["purpose"] = "other";
  write_tensor_file(path_, file);
  EXPECT_NE(stored_sha256(read_tensor_file(path_)), first_hash);
}

TEST_F(TensorFileTest, DataIsAlignedToEightBytes) {
  write_tensor_file(path_, example_file());
  const Bytes bytes = read_bytes(path_);
  std::uint64_t header_size = 0;
  std::memcpy(&header_size, bytes.data(), 8);
  EXPECT_EQ(header_size % 8, 0u);
}

TEST_F(TensorFileTest, WritingLeavesNoTemporaryFileAndReplacesWhole) {
  write_text(path_, "old content");
  write_tensor_file(path_, example_file());
  EXPECT_EQ(read_tensor_file(path_).tensors.size(), example_file().tensors.size());
  EXPECT_EQ(count_files(folder_.path()), 1);
}

TEST_F(TensorFileTest, FailedWritingKeepsTheOldFile) {
  write_tensor_file(path_, example_file());
  const Bytes before = read_bytes(path_);
  TensorFile broken = example_file();
  broken.tensors["a.float32"].bytes.pop_back();
  const std::string message = error_of([&] { write_tensor_file(path_, broken); });
  EXPECT_NE(message.find("a.float32"), std::string::npos) << message;
  EXPECT_EQ(read_bytes(path_), before);
  EXPECT_THROW(write_tensor_file(folder_.path() / "missing" / "x", example_file()), std::runtime_error);
}

TEST_F(TensorFileTest, MissingEmptyAndForeignFilesAreRefused) {
  const std::string missing = error_of([&] { read_tensor_file(folder_.path() / "nothing.safetensors"); });
  EXPECT_NE(missing.find("nothing.safetensors"), std::string::npos) << missing;
  EXPECT_NE(error_of([&] { read_tensor_file(folder_.path()); }), "");
  expect_defect({}, "too short");
  expect_defect({1, 2, 3}, "too short");
  expect_defect(Bytes(64, 'P'), "header length");
  expect_defect(assemble("not json", {}), "header");
  expect_defect(assemble("[1, 2]", {}), "object");
  expect_defect(assemble("{}", {}), "SHA-256");
  expect_defect(assemble(R"({"__metadata__": {"format": "pt"}})", {}), "SHA-256");
  expect_defect(assemble(R"({"__metadata__": {"sha256": 5}})", {}), "header");
}

TEST_F(TensorFileTest, EveryTruncationIsRefused) {
  write_tensor_file(path_, example_file());
  const Bytes whole = read_bytes(path_);
  for (std::size_t size = 0; size < whole.size(); size += size < 16 ? 1 : 37) {
    defect_of(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
  }
  defect_of(Bytes(whole.begin(), whole.end() - 1));
}

TEST_F(TensorFileTest, EveryFlippedBitIsNoticed) {
  write_tensor_file(path_, example_file());
  const Bytes whole = read_bytes(path_);
  std::uint64_t header_size = 0;
  std::memcpy(&header_size, whole.data(), 8);
  const std::string header(whole.begin() + 8, whole.begin() + 8 + static_cast<std::ptrdiff_t>(header_size));
  const std::size_t padding = 8 + header.find_last_not_of(' ') + 1;  // the blanks after it carry no meaning
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (i >= padding && i < 8 + header_size) continue;
    Bytes flipped = whole;
    flipped[i] ^= 1;
    defect_of(flipped);
  }
}

TEST_F(TensorFileTest, OversizedHeaderIsRefusedWithoutReadingIt) {
  for (const std::uint64_t size : {std::numeric_limits<std::uint64_t>::max(), std::uint64_t{1} << 40,
                                   std::uint64_t{17} << 20, std::uint64_t{57}}) {
    Bytes bytes(64, ' ');
    std::memcpy(bytes.data(), &size, 8);
    expect_defect(bytes, "header length");
  }
}

TEST_F(TensorFileTest, EndlessNestingIsRefusedBeforeItExhaustsTheStack) {
  std::string nested = R"({"__metadata__": {"sha256": ""}, "weight": )";
  nested.append(1u << 20, '[');
  nested.append(1u << 20, ']');
  expect_defect(assemble(nested + "}", {}), "nested too deeply");
}

TEST_F(TensorFileTest, AFileOfImpossibleSizeIsRefusedWithoutReadingIt) {
  write_tensor_file(path_, example_file());
  std::filesystem::resize_file(path_, std::uintmax_t{5} << 30);  // a sparse file takes no room on the disk
  EXPECT_NE(file_error_of(path_, [&] { read_tensor_file(path_); }).find("accepted are at most"), std::string::npos);
}

TEST_F(TensorFileTest, AFullDiskIsAClearErrorAndKeepsTheOldFile) {
  write_tensor_file(path_, example_file());
  const Bytes before = read_bytes(path_);
  TensorFile large = example_file();
  large.tensors["z.large"] = make_raw_tensor<float>(TensorType::kFloat32, {4096}, std::vector<float>(4096));
  const std::string message = on_a_full_disk([&] { write_tensor_file(path_, large); });
  EXPECT_NE(message.find("cannot write"), std::string::npos) << message;
  EXPECT_EQ(read_bytes(path_), before);
  EXPECT_EQ(count_files(folder_.path()), 1);
}

TEST_F(TensorFileTest, MalformedEntriesAreRefusedByName) {
  const auto with_entry = [](const std::string& entry) {
    return assemble(R"({"__metadata__": {"sha256": ""}, "weight": )" + entry + "}", Bytes(16));
  };
  expect_defect(with_entry(R"({"dtype": "F32", "shape": [4], "data_offsets": [0, 17]})"), "weight");
  expect_defect(with_entry(R"({"dtype": "F32", "shape": [4], "data_offsets": [8, 4]})"), "weight");
  expect_defect(with_entry(R"({"dtype": "F32", "shape": [4], "data_offsets": [16]})"), "weight");
  expect_defect(with_entry(R"({"dtype": "F32", "shape": [5], "data_offsets": [0, 16]})"), "weight");
  expect_defect(with_entry(R"({"dtype": "F32", "shape": [-4], "data_offsets": [0, 16]})"), "weight");
  expect_defect(with_entry(R"({"dtype": "F32", "shape": [4294967296, 4294967296], "data_offsets": [0, 0]})"), "weight");
  expect_defect(with_entry(R"({"dtype": "Q4", "shape": [4], "data_offsets": [0, 16]})"), "Q4");
  expect_defect(with_entry(R"({"dtype": "F32", "shape": "4", "data_offsets": [0, 16]})"), "header");
  expect_defect(with_entry(R"({"dtype": "F32", "data_offsets": [0, 16]})"), "header");
  expect_defect(with_entry(R"({"dtype": "F32", "shape": [1e300], "data_offsets": [0, 16]})"), "integers");
  expect_defect(with_entry(R"({"dtype": "F32", "shape": [4], "data_offsets": [0.5, 16]})"), "integers");
  expect_defect(with_entry(R"({"dtype": "F32", "shape": [4], "data_offsets": [-16, 0]})"), "weight");
  expect_defect(with_entry("7"), "header");
  expect_defect(with_entry(R"({"dtype": "F32", "shape": [3], "data_offsets": [4, 16]})"), "gap");
  expect_defect(with_entry(R"({"dtype": "F32", "shape": [3], "data_offsets": [0, 12]})"), "no tensor");
  expect_defect(with_entry(R"({"dtype": "F32", "shape": [3], "data_offsets": [0, 12]}, "bias":
                              {"dtype": "F32", "shape": [2], "data_offsets": [8, 16]})"),
                "overlaps");
}

TEST(Sha256, MatchesPublishedVectors) {
  EXPECT_EQ(sha256_hex(nullptr, 0), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  const Bytes abc = {'a', 'b', 'c'};
  EXPECT_EQ(sha256_hex(abc.data(), 3), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  Sha256 hash;
  hash.update("a", 1);
  hash.update("bc", 2);
  EXPECT_EQ(hash.finish(), sha256_hex(abc.data(), 3));
}

TEST(RawTensor, CountsElementsAndBytes) {
  EXPECT_EQ((RawTensor{TensorType::kFloat32, {2, 3, 4}, {}}.num_elements()), 24);
  EXPECT_EQ((RawTensor{TensorType::kFloat32, {}, {}}.num_elements()), 1);
  EXPECT_EQ(size_in_bytes(TensorType::kBFloat16), 2u);
  EXPECT_EQ(size_in_bytes(TensorType::kFloat64), 8u);
  EXPECT_EQ(size_in_bytes(TensorType::kInt16), 2u);
}

}  // namespace
}  // namespace rigidformer
