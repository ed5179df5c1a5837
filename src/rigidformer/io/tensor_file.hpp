// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigidformer {

/// Element types a tensor file can hold.
enum class TensorType { kFloat32, kBFloat16, kFloat64, kInt64, kInt32, kInt16, kUInt8 };

std::size_t size_in_bytes(TensorType type);

/// One named, dense, row-major tensor as raw little-endian bytes.
struct RawTensor {
  TensorType type = TensorType::kFloat32;
  std::vector<std::int64_t> shape;
  std::vector<std::uint8_t> bytes;

  std::int64_t num_elements() const;
};

/// A file of named tensors and text metadata in the safetensors layout: an 8-byte header length, a JSON
/// header, raw data. Reading it never executes anything. The metadata carry a SHA-256 of header and
/// data, which is checked on reading.
struct TensorFile {
  std::map<std::string, RawTensor> tensors;
  std::map<std::string, std::string> metadata;
};

/// Writes to a temporary file and renames it, so that a crash never leaves half a file. Throws std::runtime_error.
void write_tensor_file(const std::filesystem::path& path, const TensorFile& file);

struct NamedTensor {
  std::string name;
  RawTensor tensor;
};

/// Reads tensor by tensor, so that a large file need not be in memory as a whole. All errors are std::runtime_error
/// naming path and defect: missing, truncated, foreign, oversized header, and at the end of the data a wrong hash.
class TensorFileReader {
 public:
  explicit TensorFileReader(const std::filesystem::path& path);
  ~TensorFileReader();

  const std::map<std::string, std::string>& metadata() const;

  /// Reads the next tensor in the order of the file. It is empty after the last one, if the hash was right; nothing
  /// that was read may be trusted before that.
  std::optional<NamedTensor> next();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Reads the whole file at once; throws as the reader does.
TensorFile read_tensor_file(const std::filesystem::path& path);

/// The SHA-256 in lower-case hex that the metadata of `file` hold; empty unless the file was read from disk.
std::string stored_sha256(const TensorFile& file);

/// Makes a raw tensor from a contiguous array.
template <typename T>
RawTensor make_raw_tensor(TensorType type, std::vector<std::int64_t> shape, const std::vector<T>& values) {
  const auto* begin = reinterpret_cast<const std::uint8_t*>(values.data());
  return {type, std::move(shape), std::vector<std::uint8_t>(begin, begin + values.size() * sizeof(T))};
}

}  // namespace rigidformer
