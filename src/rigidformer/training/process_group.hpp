// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <memory>

#include "rigidformer/training/process_place.hpp"

namespace rigidformer {

/// The processes that train one model together, over c10d: NCCL between GPUs where it is built in, else Gloo. A single
/// process is a group of one, for which every call returns at once. All processes must make the same calls.
class ProcessGroup {
 public:
  /// Waits until all processes are there. Throws std::runtime_error when there are several and LibTorch's c10d was not
  /// found at build time, or when the others cannot be reached.
  ProcessGroup(const ProcessPlace& place, const torch::Device& device);
  ~ProcessGroup();

  int rank() const { return place_.rank; }
  int size() const { return place_.size; }
  bool is_first() const { return place_.rank == 0; }

  /// Replaces the tensor by its sum over all processes.
  void sum(torch::Tensor& tensor) const;

  /// Replaces the tensor by that of the first process.
  void copy_from_first(torch::Tensor& tensor) const;

  /// Whether `here` holds in any process.
  bool any(bool here) const;

 private:
  struct Impl;
  ProcessPlace place_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rigidformer
