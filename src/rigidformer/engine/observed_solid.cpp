// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/observed_solid.hpp"

#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "rigidformer/engine/observed_hull.hpp"
#include "rigidformer/simulation/observed_motion.hpp"

namespace rigidformer {
namespace {

/// Elements of a tensor on the CPU, read where they lie: item() costs a tensor for each.
template <typename T>
T element(const Tensor& tensor, std::initializer_list<std::int64_t> index) {
  std::int64_t offset = 0, dim = 0;
  for (const std::int64_t i : index) offset += i * tensor.stride(dim++);
  return tensor.data_ptr<T>()[offset];
}

/// An element of a tensor of float32 or float64.
double number(const Tensor& tensor, std::initializer_list<std::int64_t> index) {
  return tensor.scalar_type() == torch::kFloat64 ? element<double>(tensor, index) : element<float>(tensor, index);
}

/// The points [N, 3] of object k of scene b in clouds [B, K, M, 3] that a mask [B, K, M] keeps; the first `limit` ones.
Points to_points(const Tensor& clouds, const Tensor& mask, std::int64_t b, std::int64_t k, std::int64_t limit) {
  std::vector<float> numbers;
  for (std::int64_t i = 0; i < limit; ++i) {
    if (!element<bool>(mask, {b, k, i})) continue;
    for (std::int64_t axis = 0; axis < 3; ++axis) {
      numbers.push_back(static_cast<float>(number(clouds, {b, k, i, axis})));
    }
  }
  return Eigen::Map<const Points>(numbers.data(), static_cast<Eigen::Index>(numbers.size() / 3), 3);
}

/// What was seen of object `k` of scene `b`.
Points seen_points(const SceneBatch& batch, std::int64_t b, std::int64_t k) {
  if (batch.surface_points.defined()) {
    return to_points(batch.surface_points, batch.surface_mask, b, k, batch.surface_points.size(2));
  }
  return to_points(batch.points_reference, batch.point_mask, b, k, batch.max_points());
}

/// What is guessed beside it; may be empty.
Points hidden_points(const SceneBatch& batch, std::int64_t b, std::int64_t k) {
  if (!batch.hidden_points.defined()) return {};
  return to_points(batch.hidden_points, batch.point_mask, b, k, batch.hidden_points.size(2));
}

/// Material as far as it is known.
BodyProperties known_properties(const SceneBatch& batch, std::int64_t b, std::int64_t k) {
  const auto property = [&](std::int64_t i) {
    const bool known = number(batch.properties_known, {b, k, i}) > 0.0;
    return known ? std::optional<double>(number(batch.properties, {b, k, i})) : std::nullopt;
  };
  return {property(0), property(1), property(2)};
}

ObservedSolid observe_solid(const SceneBatch& batch, const Tensor& centre_reference, std::int64_t b, std::int64_t k) {
  const auto coordinate = [&](std::int64_t axis) { return number(centre_reference, {b, k, axis}); };
  const Eigen::Vector3d centre(coordinate(0), coordinate(1), coordinate(2));
  const ObservedHull observed = observe_hull(seen_points(batch, b, k), centre, hidden_points(batch, b, k));
  if (!observed.centre_of_mass.allFinite() || !(observed.volume_m3 > 0.0)) {
    throw std::invalid_argument("the hull of its points has no volume");
  }
  ObservedSolid solid;
  solid.object = k;
  solid.dynamic = element<bool>(batch.dynamic_mask, {b, k});
  solid.complete = observed.complete;
  solid.centre_reference = observed.centre_of_mass;
  return with_hull(std::move(solid), observed.hull, observed.volume_m3, known_properties(batch, b, k));
}

}  // namespace

ObservedSolid with_hull(ObservedSolid solid, const ConvexPart& hull, double volume_m3, const BodyProperties& known) {
  solid.hull = std::make_shared<ConvexPart>(hull);
  solid.distances = std::make_shared<SolidHull>(hull);
  solid.shape = std::make_shared<CollisionShape>(Shape{"", 1.0, {hull}}, 1.0);
  solid.volume_m3 = volume_m3;
  solid.radius_m = static_cast<double>(hull.vertices.rowwise().norm().maxCoeff());
  return with_role(solid, solid.object, solid.dynamic, known);
}

ObservedSolid with_role(ObservedSolid solid, std::int64_t object, bool dynamic, const BodyProperties& known) {
  solid.object = object;
  solid.dynamic = dynamic;
  solid.known = known;
  solid.properties = with_means(known, solid.volume_m3);
  return solid;
}

std::vector<ObservedSolid> observe_solids(const SceneBatch& batch, const Tensor& centre_reference, std::int64_t b) {
  std::vector<ObservedSolid> solids;
  for (std::int64_t k = 0; k < batch.max_objects(); ++k) {
    if (!element<bool>(batch.object_mask, {b, k})) continue;
    try {
      solids.push_back(observe_solid(batch, centre_reference, b, k));
    } catch (const std::invalid_argument& error) {
      throw BodyError(k, error.what());
    }
  }
  return solids;
}

}  // namespace rigidformer
