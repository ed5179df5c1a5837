// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/contact_search.hpp"

#include <ATen/Parallel.h>

#include <memory>
#include <stdexcept>

#ifdef RIGIDFORMER_HAS_BULLET
#include "contact_scene.hpp"
#endif

namespace rigidformer {

#ifdef RIGIDFORMER_HAS_BULLET

namespace {

/// Numbers of all contacts one after the other, as tensors of `like`'s type and device.
class ContactRows {
 public:
  explicit ContactRows(const Tensor& like) : like_(like) {}

  void add(std::int64_t scene, const FoundContact& contact) {
    scene_.push_back(scene);
    object_.push_back(contact.object);
    partner_.push_back(contact.partner);
    for (const Eigen::Vector3d* v : {&contact.point, &contact.partner_point, &contact.normal}) {
      numbers_.insert(numbers_.end(), v->data(), v->data() + 3);
    }
    numbers_.insert(numbers_.end(), {contact.fraction, contact.gap_m});
  }

  Contacts take() const {
    const auto count = static_cast<std::int64_t>(scene_.size());
    const Tensor rows = torch::tensor(numbers_, torch::kFloat64).reshape({count, 11}).to(like_.options());
    const auto indices = [this](const std::vector<std::int64_t>& values) {
      return torch::tensor(values, torch::kInt64).to(like_.device());
    };
    return {indices(scene_),
            indices(object_),
            indices(partner_),
            rows.slice(1, 0, 3),
            rows.slice(1, 3, 6),
            rows.slice(1, 6, 9),
            rows.select(1, 9),
            rows.select(1, 10),
            Tensor(),
            Tensor()};
  }

 private:
  Tensor like_;
  std::vector<std::int64_t> scene_, object_, partner_;
  std::vector<double> numbers_;
};

using Solids = std::vector<std::vector<ObservedSolid>>;  // of every scene

ContactSearch search_among(const SceneBatch& batch, const Solids& solids) {
  const auto scenes = std::make_shared<std::vector<ContactScene>>();
  const std::int64_t B = batch.num_scenes(), K = batch.max_objects();
  const Tensor ground_height = batch.ground_height.to(torch::kCPU, torch::kFloat64);
  Tensor mass = torch::ones({B, K}, torch::kFloat64);
  Tensor inverse_inertia = torch::zeros({B, K, 3, 3}, torch::kFloat64);
  for (std::int64_t b = 0; b < B; ++b) {
    scenes->emplace_back(solids[static_cast<size_t>(b)], b, ground_height[b].item<double>());
    scenes->back().describe_bodies(mass, inverse_inertia);
  }
  mass = mass.to(batch.points_reference.options());
  inverse_inertia = inverse_inertia.to(batch.points_reference.options());
  return [=](const Pose& from, const Pose& to) {
    torch::NoGradGuard no_grad_in_search;
    const PoseTable start(from), end(to);
    std::vector<std::vector<FoundContact>> found(static_cast<size_t>(B));
    at::parallel_for(0, B, 1, [&](std::int64_t begin, std::int64_t last) {
      for (auto b = static_cast<size_t>(begin); b < static_cast<size_t>(last); ++b) {
        found[b] = (*scenes)[b].search(start, end);
      }
    });
    ContactRows rows(from.translation);
    for (std::int64_t b = 0; b < B; ++b) {
      for (const FoundContact& contact : found[static_cast<size_t>(b)]) rows.add(b, contact);
    }
    Contacts contacts = rows.take();
    contacts.mass = mass;
    contacts.inverse_inertia = inverse_inertia;
    return contacts;
  };
}

}  // namespace

ContactSearch make_contact_search(const ModelOptions& options, const SceneBatch& batch,
                                  const Tensor& centre_reference) {
  if (!options.contact_tokens) return {};
  torch::NoGradGuard no_grad;
  const SceneBatch scene_batch = batch.to(torch::kCPU);  // one transfer per tensor instead of one per number
  const Tensor centre = centre_reference.to(torch::kCPU, torch::kFloat64);
  Solids solids;
  for (std::int64_t b = 0; b < batch.num_scenes(); ++b) solids.push_back(observe_solids(scene_batch, centre, b));
  return search_among(batch, solids);
}

ContactSearch make_contact_search(const ModelOptions& options, const SceneBatch& batch,
                                  const std::vector<ObservedSolid>& solids) {
  return options.contact_tokens ? search_among(batch, {solids}) : ContactSearch();
}

#else

ContactSearch make_contact_search(const ModelOptions& options, const SceneBatch&, const Tensor&) {
  if (!options.contact_tokens) return {};
  throw std::runtime_error("this model searches for contacts with Bullet: install libbullet-dev and build again");
}

ContactSearch make_contact_search(const ModelOptions& options, const SceneBatch& batch,
                                  const std::vector<ObservedSolid>&) {
  return make_contact_search(options, batch, Tensor());
}

#endif

}  // namespace rigidformer
