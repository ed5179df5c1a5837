// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/io/tensor_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <tuple>

#include "rigidformer/io/sha256.hpp"
#include "rigidformer/io/text_file.hpp"

namespace rigidformer {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMaxHeaderBytes = 16u << 20;  // [bytes] bound on memory (docs/data_format.md); chosen by eye
constexpr std::uint64_t kMaxFileBytes = 4ull << 30;  // [bytes] a sparse file of any length costs no disk; chosen by eye
constexpr char kHashKey[] = "sha256";
constexpr char kMetadataKey[] = "__metadata__";

struct TypeName {
  TensorType type;
  const char* name;
  std::size_t bytes;
};
constexpr TypeName kTypes[] = {{TensorType::kFloat32, "F32", 4}, {TensorType::kBFloat16, "BF16", 2},
                               {TensorType::kFloat64, "F64", 8}, {TensorType::kInt64, "I64", 8},
                               {TensorType::kInt32, "I32", 4},   {TensorType::kInt16, "I16", 2},
                               {TensorType::kUInt8, "U8", 1}};

const TypeName& type_info(TensorType type) {
  for (const TypeName& entry : kTypes) {
    if (entry.type == type) return entry;
  }
  throw std::invalid_argument("unknown tensor type " + std::to_string(static_cast<int>(type)));
}

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& defect) {
  throw std::runtime_error("tensor file '" + path.string() + "': " + defect);
}

/// Counts the elements; refuses negative and overflowing shapes.
std::uint64_t checked_num_elements(const std::filesystem::path& path, const std::string& name,
                                   const std::vector<std::int64_t>& shape) {
  std::uint64_t count = 1;
  for (const std::int64_t extent : shape) {
    const auto limit = std::numeric_limits<std::uint64_t>::max() / 16;
    if (extent < 0 || (extent > 0 && count > limit / static_cast<std::uint64_t>(extent))) {
      fail(path, "tensor '" + name + "' has an impossible shape");
    }
    count *= static_cast<std::uint64_t>(extent);
  }
  return count;
}

TensorType type_named(const std::filesystem::path& path, const std::string& tensor, const std::string& dtype) {
  for (const TypeName& entry : kTypes) {
    if (dtype == entry.name) return entry.type;
  }
  fail(path, "tensor '" + tensor + "' has unsupported type '" + dtype + "'");
}

/// Place of a tensor in the data.
struct Extent {
  std::uint64_t begin, end;
  std::string name;
  RawTensor tensor;  ///< The tensor without its bytes
};

/// Reads a list of integers. Other entries are refused: they would be converted, out of
/// range even with undefined outcome.
template <typename Integer>
std::vector<Integer> integers(const std::filesystem::path& path, const std::string& tensor, const Json& list) {
  bool fits = list.is_array();
  for (const Json& value : list) fits = fits && value.is_number_integer();
  if (!fits) fail(path, "header is not valid: tensor '" + tensor + "' has something else than a list of integers");
  return list.get<std::vector<Integer>>();
}

Extent parse_extent(const std::filesystem::path& path, const std::string& name, const Json& entry) {
  Extent extent{0, 0, name, {}};
  extent.tensor.type = type_named(path, name, entry.at("dtype").get<std::string>());
  extent.tensor.shape = integers<std::int64_t>(path, name, entry.at("shape"));
  const auto offsets = integers<std::uint64_t>(path, name, entry.at("data_offsets"));
  const std::uint64_t size = checked_num_elements(path, name, extent.tensor.shape) * size_in_bytes(extent.tensor.type);
  if (offsets.size() != 2 || offsets[0] > offsets[1] || offsets[1] - offsets[0] != size) {
    fail(path, "tensor '" + name + "' has a size that does not fit its shape");
  }
  extent.begin = offsets[0];
  extent.end = offsets[1];
  return extent;
}

/// Lists the tensors in the order of their bytes, which they must fill without gap or overlap.
std::vector<Extent> parse_extents(const std::filesystem::path& path, const Json& header, std::uint64_t data_size) {
  std::vector<Extent> extents;
  for (const auto& [name, entry] : header.items()) {
    if (name != kMetadataKey) extents.push_back(parse_extent(path, name, entry));
  }
  std::sort(extents.begin(), extents.end(),
            [](const Extent& a, const Extent& b) { return std::tie(a.begin, a.end) < std::tie(b.begin, b.end); });
  std::uint64_t end = 0;
  for (const Extent& extent : extents) {
    if (extent.end > data_size) fail(path, "tensor '" + extent.name + "' lies outside the file (truncated?)");
    if (extent.begin != end) fail(path, "tensor '" + extent.name + "' leaves a gap or overlaps another");
    end = extent.end;
  }
  if (end != data_size) fail(path, std::to_string(data_size - end) + " bytes belong to no tensor");
  return extents;
}

/// Starts a SHA-256 with the header (its hash left empty), so that an altered configuration
/// is noticed too. The data follow.
Sha256 start_hash(Json header) {
  header[kMetadataKey][kHashKey] = "";
  const std::string text = header.dump();
  Sha256 hash;
  hash.update(text.data(), text.size());
  return hash;
}

Json make_header(const TensorFile& file) {
  Json header;
  std::map<std::string, std::string> metadata = file.metadata;
  metadata[kHashKey] = "";
  header[kMetadataKey] = metadata;
  std::uint64_t offset = 0;
  for (const auto& [name, tensor] : file.tensors) {
    const std::uint64_t end = offset + tensor.bytes.size();
    header[name] = {{"dtype", type_info(tensor.type).name}, {"shape", tensor.shape}, {"data_offsets", {offset, end}}};
    offset = end;
  }
  return header;
}

}  // namespace

std::size_t size_in_bytes(TensorType type) { return type_info(type).bytes; }

std::int64_t RawTensor::num_elements() const {
  std::int64_t count = 1;
  for (const std::int64_t extent : shape) count *= extent;
  return count;
}

std::string stored_sha256(const TensorFile& file) {
  const auto entry = file.metadata.find(kHashKey);
  return entry == file.metadata.end() ? std::string() : entry->second;
}

void write_tensor_file(const std::filesystem::path& path, const TensorFile& file) {
  Json json = make_header(file);
  Sha256 hash = start_hash(json);
  for (const auto& [name, tensor] : file.tensors) {
    if (tensor.bytes.size() != static_cast<std::size_t>(tensor.num_elements()) * size_in_bytes(tensor.type)) {
      fail(path, "tensor '" + name + "' has a size that does not fit its shape");
    }
    hash.update(tensor.bytes.data(), tensor.bytes.size());
  }
  json[kMetadataKey][kHashKey] = hash.finish();
  std::string header = json.dump();
  header.append((8 - header.size() % 8) % 8, ' ');  // the format asks for 8-byte alignment of the data
  const std::uint64_t header_size = header.size();

  const std::filesystem::path temporary = path.string() + ".tmp" + std::to_string(::getpid());
  std::ofstream out(temporary, std::ios::binary);
  out.write(reinterpret_cast<const char*>(&header_size), sizeof(header_size));
  out.write(header.data(), static_cast<std::streamsize>(header.size()));
  for (const auto& [name, tensor] : file.tensors) {
    out.write(reinterpret_cast<const char*>(tensor.bytes.data()), static_cast<std::streamsize>(tensor.bytes.size()));
  }
  out.close();
  if (!out) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    fail(path, std::string("cannot write: ") + std::strerror(errno));
  }
  std::filesystem::rename(temporary, path);
}

struct TensorFileReader::Impl {
  explicit Impl(const std::filesystem::path& file);

  std::filesystem::path path;
  std::ifstream in;
  std::map<std::string, std::string> metadata;
  std::vector<Extent> extents;
  std::size_t next = 0;
  std::string stored_hash;
  Sha256 hash;
};

TensorFileReader::Impl::Impl(const std::filesystem::path& file) : path(file), in(file, std::ios::binary) {
  std::error_code error;
  const std::uintmax_t file_size = std::filesystem::file_size(path, error);
  if (error) fail(path, "cannot read: " + error.message());
  if (file_size > kMaxFileBytes) {
    fail(path, "has " + std::to_string(file_size) + " bytes, accepted are at most " + std::to_string(kMaxFileBytes));
  }
  std::uint64_t header_size = 0;
  if (!in.read(reinterpret_cast<char*>(&header_size), sizeof(header_size))) fail(path, "too short to be a tensor file");
  if (header_size > kMaxHeaderBytes || header_size > file_size - sizeof(header_size)) {
    fail(path, "header length " + std::to_string(header_size) + " is impossible: not a tensor file, or truncated");
  }
  std::string text(header_size, '\0');
  if (!in.read(text.data(), static_cast<std::streamsize>(text.size()))) fail(path, "ends too early (truncated)");
  if (nests_too_deeply(text)) fail(path, "header is not valid: it is nested too deeply");
  try {
    const Json header = Json::parse(text);
    if (!header.is_object()) fail(path, "header is not a JSON object");
    if (header.contains(kMetadataKey)) header.at(kMetadataKey).get_to(metadata);
    extents = parse_extents(path, header, file_size - sizeof(header_size) - header_size);
    stored_hash = metadata[kHashKey];
    if (stored_hash.empty()) fail(path, "no SHA-256 in the header: not written by rigidformer");
    hash = start_hash(header);
  } catch (const nlohmann::json::exception& exception) {
    fail(path, std::string("header is not valid: ") + exception.what());
  }
}

TensorFileReader::TensorFileReader(const std::filesystem::path& path) : impl_(std::make_unique<Impl>(path)) {}
TensorFileReader::~TensorFileReader() = default;

const std::map<std::string, std::string>& TensorFileReader::metadata() const { return impl_->metadata; }

std::optional<NamedTensor> TensorFileReader::next() {
  Impl& file = *impl_;
  if (file.next == file.extents.size()) {
    const std::string actual = file.hash.finish();
    if (file.stored_hash == actual) return std::nullopt;
    fail(file.path, "SHA-256 mismatch (stored " + file.stored_hash + ", found " + actual + "): damaged or altered");
  }
  Extent& extent = file.extents[file.next++];
  std::vector<std::uint8_t>& bytes = extent.tensor.bytes;
  bytes.resize(extent.end - extent.begin);
  file.in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file.in) fail(file.path, "ends too early (truncated)");
  file.hash.update(bytes.data(), bytes.size());
  return NamedTensor{std::move(extent.name), std::move(extent.tensor)};
}

TensorFile read_tensor_file(const std::filesystem::path& path) {
  TensorFileReader reader(path);
  TensorFile file;
  file.metadata = reader.metadata();
  while (auto entry = reader.next()) file.tensors.emplace(std::move(entry->name), std::move(entry->tensor));
  return file;
}

}  // namespace rigidformer
