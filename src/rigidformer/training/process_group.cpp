// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/process_group.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#ifdef RIGIDFORMER_HAS_GLOO
#include <torch/csrc/distributed/c10d/ProcessGroupGloo.hpp>
#include <torch/csrc/distributed/c10d/TCPStore.hpp>
#endif
#ifdef RIGIDFORMER_HAS_NCCL
#include <torch/csrc/distributed/c10d/ProcessGroupNCCL.hpp>
#endif

namespace rigidformer {

#ifdef RIGIDFORMER_HAS_GLOO
#ifdef RIGIDFORMER_HAS_NCCL
using GpuGroup = c10d::ProcessGroupNCCL;
#else
using GpuGroup = c10d::ProcessGroupGloo;
#endif

struct ProcessGroup::Impl {
  Impl(const ProcessPlace& place, const torch::Device& device) {
    c10d::TCPStoreOptions store_options;
    store_options.port = place.port;
    store_options.isServer = place.rank == 0 && !place.store_is_running;
    store_options.numWorkers = static_cast<std::size_t>(place.size);
    const c10::intrusive_ptr<c10d::Store> store = c10::make_intrusive<c10d::TCPStore>(place.address, store_options);
    const auto options = c10d::ProcessGroupGloo::Options::create();
    options->devices.push_back(place.address == "127.0.0.1"
                                   ? c10d::ProcessGroupGloo::createDeviceForHostname(place.address)
                                   : c10d::ProcessGroupGloo::createDefaultDevice());
    cpu = c10::make_intrusive<c10d::ProcessGroupGloo>(store, place.rank, place.size, options);
#ifdef RIGIDFORMER_HAS_NCCL
    if (device.is_cuda()) gpu = c10::make_intrusive<GpuGroup>(store, place.rank, place.size);
#else
    if (device.is_cuda()) gpu = cpu;
#endif
  }

  /// Calls `communicate(group, tensors)` with the group that can reach the tensor.
  template <typename Communicate>
  void with_group(torch::Tensor& tensor, const Communicate& communicate) const {
    std::vector<torch::Tensor> tensors{tensor};
    if (tensor.is_cuda()) {
      communicate(*gpu, tensors);
    } else {
      communicate(*cpu, tensors);
    }
  }

  c10::intrusive_ptr<c10d::ProcessGroupGloo> cpu;
  c10::intrusive_ptr<GpuGroup> gpu;
};

void ProcessGroup::sum(torch::Tensor& tensor) const {
  if (!impl_) return;
  torch::NoGradGuard no_grad;
  impl_->with_group(tensor, [](auto& group, auto& tensors) { group.allreduce(tensors)->wait(); });
}

void ProcessGroup::copy_from_first(torch::Tensor& tensor) const {
  if (!impl_) return;
  torch::NoGradGuard no_grad;
  impl_->with_group(tensor, [](auto& group, auto& tensors) { group.broadcast(tensors)->wait(); });
}
#else
struct ProcessGroup::Impl {
  Impl(const ProcessPlace& place, const torch::Device&) {
    throw std::runtime_error("WORLD_SIZE is " + std::to_string(place.size) +
                             ", but this build has no c10d: install libgloo-dev and configure again");
  }
};
void ProcessGroup::sum(torch::Tensor&) const {}
void ProcessGroup::copy_from_first(torch::Tensor&) const {}
#endif

ProcessGroup::ProcessGroup(const ProcessPlace& place, const torch::Device& device) : place_(place) {
  if (place.size > 1) impl_ = std::make_unique<Impl>(place, device);
}

ProcessGroup::~ProcessGroup() = default;

bool ProcessGroup::any(bool here) const {
  torch::Tensor count = torch::full({}, here ? 1.0 : 0.0);
  sum(count);
  return count.item<double>() > 0.0;
}

}  // namespace rigidformer
