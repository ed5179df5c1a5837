// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/observed_solid.hpp"

#include <optional>
#include <utility>

#include "rigidformer/engine/observed_hull.hpp"
#include "rigidformer/simulation/observed_motion.hpp"

namespace rigidformer {
namespace {

/// The points [N, 3] of a cloud [M, 3] that a mask [M] keeps.
Points to_points(const Tensor& cloud, const Tensor& mask) {
  const Tensor points = cloud.index({mask}).to(torch::kFloat32).contiguous();
  return Eigen::Map<const Points>(points.data_ptr<float>(), points.size(0), 3);
}

/// What was seen of object `k` of scene `b`.
Points seen_points(const SceneBatch& batch, std::int64_t b, std::int64_t k) {
  if (batch.surface_points.defined()) return to_points(batch.surface_points[b][k], batch.surface_mask[b][k]);
  return to_points(batch.points_reference[b][k], batch.point_mask[b][k]);
}

/// What is guessed beside it; may be empty.
Points hidden_points(const SceneBatch& batch, std::int64_t b, std::int64_t k) {
  if (!batch.hidden_points.defined()) return {};
  const std::int64_t P = batch.hidden_points.size(2);
  return to_points(batch.hidden_points[b][k], batch.point_mask[b][k].slice(0, 0, P));
}

/// Material as far as it is known.
BodyProperties known_properties(const SceneBatch& batch, std::int64_t b, std::int64_t k) {
  const Tensor known = batch.properties_known[b][k] > 0.0;
  const Tensor properties = batch.properties[b][k];
  const auto property = [&](std::int64_t i) {
    return known[i].item<bool>() ? std::optional<double>(properties[i].item<double>()) : std::nullopt;
  };
  return {property(0), property(1), property(2)};
}

ObservedSolid observe_solid(const SceneBatch& batch, const Tensor& centre_reference, std::int64_t b, std::int64_t k) {
  const Tensor c = centre_reference[b][k];
  const Eigen::Vector3d centre(c[0].item<double>(), c[1].item<double>(), c[2].item<double>());
  const ObservedHull observed = observe_hull(seen_points(batch, b, k), centre, hidden_points(batch, b, k));
  if (!observed.centre_of_mass.allFinite() || !(observed.volume_m3 > 0.0)) {
    throw std::invalid_argument("the hull of its points has no volume");
  }
  ObservedSolid solid;
  solid.hull = std::make_shared<ConvexPart>(observed.hull);
  solid.distances = std::make_shared<SolidHull>(observed.hull);
  solid.shape = std::make_shared<CollisionShape>(Shape{"", 1.0, {observed.hull}}, 1.0);
  solid.volume_m3 = observed.volume_m3;
  solid.radius_m = static_cast<double>(observed.hull.vertices.rowwise().norm().maxCoeff());
  solid.complete = observed.complete;
  solid.centre_reference = observed.centre_of_mass;
  return with_role(std::move(solid), k, batch.dynamic_mask[b][k].item<bool>(), known_properties(batch, b, k));
}

}  // namespace

ObservedSolid with_role(ObservedSolid solid, std::int64_t object, bool dynamic, const BodyProperties& known) {
  solid.object = object;
  solid.dynamic = dynamic;
  solid.properties = with_means(known, solid.volume_m3);
  solid.fully_known = solid.complete && known.mass_kg && known.friction && known.restitution;
  return solid;
}

std::vector<ObservedSolid> observe_solids(const SceneBatch& batch, const Tensor& centre_reference, std::int64_t b) {
  std::vector<ObservedSolid> solids;
  for (std::int64_t k = 0; k < batch.max_objects(); ++k) {
    if (!batch.object_mask[b][k].item<bool>()) continue;
    try {
      solids.push_back(observe_solid(batch, centre_reference, b, k));
    } catch (const std::invalid_argument& error) {
      throw BodyError(k, error.what());
    }
  }
  return solids;
}

}  // namespace rigidformer
