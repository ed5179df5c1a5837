// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/io/tensor_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "rigidformer/io/sha256.hpp"

namespace rigidformer {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMaxHeaderBytes = 16u << 20;
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

/// Number of elements, refusing negative or overflowing shapes.
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

RawTensor read_tensor(const std::filesystem::path& path, const std::string& name, const Json& entry,
                      const std::vector<std::uint8_t>& data) {
  RawTensor tensor;
  const std::string dtype = entry.at("dtype").get<std::string>();
  const TypeName* info = nullptr;
  for (const TypeName& candidate : kTypes) {
    if (dtype == candidate.name) info = &candidate;
  }
  if (info == nullptr) fail(path, "tensor '" + name + "' has unsupported type '" + dtype + "'");
  tensor.type = info->type;
  tensor.shape = entry.at("shape").get<std::vector<std::int64_t>>();
  const auto offsets = entry.at("data_offsets").get<std::vector<std::uint64_t>>();
  if (offsets.size() != 2 || offsets[0] > offsets[1] || offsets[1] > data.size()) {
    fail(path, "tensor '" + name + "' lies outside the file (truncated?)");
  }
  if (offsets[1] - offsets[0] != checked_num_elements(path, name, tensor.shape) * info->bytes) {
    fail(path, "tensor '" + name + "' has a size that does not fit its shape");
  }
  tensor.bytes.assign(data.begin() + static_cast<std::ptrdiff_t>(offsets[0]),
                      data.begin() + static_cast<std::ptrdiff_t>(offsets[1]));
  return tensor;
}

/// SHA-256 started on the header (hash left empty), so that an altered configuration is noticed too; data follows.
Sha256 start_hash(Json header) {
  header[kMetadataKey][kHashKey] = "";
  const std::string text = header.dump();
  Sha256 hash;
  hash.update(text.data(), text.size());
  return hash;
}

TensorFile parse(const std::filesystem::path& path, const Json& header, const std::vector<std::uint8_t>& data) {
  TensorFile file;
  for (const auto& [name, entry] : header.items()) {
    if (name == kMetadataKey) {
      file.metadata = entry.get<std::map<std::string, std::string>>();
    } else {
      file.tensors.emplace(name, read_tensor(path, name, entry, data));
    }
  }
  const std::string stored = stored_sha256(file);
  if (stored.empty()) fail(path, "no SHA-256 in the header: not written by rigidformer");
  Sha256 hash = start_hash(header);
  hash.update(data.data(), data.size());
  const std::string actual = hash.finish();
  if (stored != actual)
    fail(path, "SHA-256 mismatch (stored " + stored + ", found " + actual + "): damaged or altered");
  return file;
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

TensorFile read_tensor_file(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t file_size = std::filesystem::file_size(path, error);
  if (error) fail(path, "cannot read: " + error.message());
  std::ifstream in(path, std::ios::binary);
  std::uint64_t header_size = 0;
  if (!in.read(reinterpret_cast<char*>(&header_size), sizeof(header_size))) fail(path, "too short to be a tensor file");
  if (header_size > kMaxHeaderBytes || header_size > file_size - sizeof(header_size)) {
    fail(path, "header length " + std::to_string(header_size) + " is impossible: not a tensor file, or truncated");
  }
  std::string text(header_size, '\0');
  std::vector<std::uint8_t> data(file_size - sizeof(header_size) - header_size);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  in.read(reinterpret_cast<char*>(data.data()), static_cast<std::streamsize>(data.size()));
  if (!in) fail(path, "ends too early (truncated)");
  try {
    const Json header = Json::parse(text);
    if (!header.is_object()) fail(path, "header is not a JSON object");
    return parse(path, header, data);
  } catch (const nlohmann::json::exception& exception) {
    fail(path, std::string("header is not valid: ") + exception.what());
  }
}

}  // namespace rigidformer
