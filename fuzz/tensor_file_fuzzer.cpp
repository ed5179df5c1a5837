// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "rigidformer/io/tensor_file.hpp"
#include "rigidformer/model/options.hpp"
#include "scratch_file.hpp"
#include "sealed_file.hpp"

namespace {

const ScratchFolder& folder() {
  static const ScratchFolder instance;
  return instance;
}

void read(const std::uint8_t* data, std::size_t size) {
  const std::filesystem::path path = folder().write("file", data, size);
  try {
    const rigidformer::TensorFile file = rigidformer::read_tensor_file(path);
    for (const auto& [name, tensor] : file.tensors) {
      const auto elements = static_cast<std::size_t>(tensor.num_elements());
      if (tensor.bytes.size() != elements * rigidformer::size_in_bytes(tensor.type)) __builtin_trap();
    }
    const auto model = file.metadata.find("model");
    if (model != file.metadata.end()) rigidformer::model_options_from_json(model->second);
  } catch (const std::runtime_error&) {
  } catch (const std::invalid_argument&) {
  }
}

}  // namespace

/// Reads the bytes as a file, and as header and data of a file with the right hash. Checks that every accepted tensor
/// has the bytes that its shape asks for.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 0 && data[0] != '{') {
    read(data, size);
  } else {
    const std::string file = sealed_file(std::string(reinterpret_cast<const char*>(data), size));
    read(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
  }
  return 0;
}
