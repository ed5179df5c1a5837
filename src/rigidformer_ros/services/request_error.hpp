// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace rigidformer_ros {

/// A request that cannot be answered: one of the PredictRollout codes and a sentence naming the field at fault.
class RequestError : public std::runtime_error {
 public:
  RequestError(std::int32_t code, const std::string& message) : std::runtime_error(message), code_(code) {}
  std::int32_t code() const { return code_; }

 private:
  std::int32_t code_;
};

}  // namespace rigidformer_ros
