// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "rigidformer/data/kubasic.hpp"
#include "rigidformer/data/kubric.hpp"
#include "rigidformer/simulation/movi_scene.hpp"
#include "test_data.hpp"

namespace rigidformer {
namespace {

struct Difference {
  double position_m = 0.0;
  double orientation_deg = 0.0;
};

/// Of two recordings at `frame`, RMS over the objects.
Difference difference_at(const SceneRecording& a, const SceneRecording& b, int frame) {
  Difference sum;
  const auto f = static_cast<std::size_t>(frame);
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    const RigidTransform& T_a = a.objects[i].T_world_object[f];
    const RigidTransform& T_b = b.objects[i].T_world_object[f];
    sum.position_m += (T_a.translation - T_b.translation).squaredNorm();
    sum.orientation_deg += std::pow(rotation_angle(T_a.rotation, T_b.rotation) * 180.0 / M_PI, 2);
  }
  const auto count = static_cast<double>(a.objects.size());
  return {std::sqrt(sum.position_m / count), std::sqrt(sum.orientation_deg / count)};
}

/// Between a recording and what the simulation makes of its frame 0.
Difference resimulation_error(const SceneRecording& recorded, const std::vector<Shape>& shapes,
                              const BulletSettings& settings, int frame) {
  return difference_at(recorded, simulate(recorded, shapes, settings, frame + 1), frame);
}

struct Bound {
  int frame;
  double position_m;
  double orientation_deg;
};

// Rounding of another processor stays below a tenth of these, the effect of a wrong constant is above (README of the
// data).
constexpr Bound kShippedBounds[] = {{160, 0.003, 0.08}, {240, 0.01, 1.0}};

TEST(ShippedSceneFidelity, ResimulationFollows) {
  const SceneRecording scene = read_kubric_scene(shipped_movi_a() / "20");
  const std::vector<Shape> shapes = load_kubasic_shapes(shipped_movi_a() / "shapes");
  for (const Bound& bound : kShippedBounds) {
    const Difference error = resimulation_error(scene, shapes, movi_bullet_settings(MoviSet::kA), bound.frame);
    EXPECT_LT(error.position_m, bound.position_m) << "at frame " << bound.frame;
    EXPECT_LT(error.orientation_deg, bound.orientation_deg) << "at frame " << bound.frame;
  }
}

/// The bounds would notice a constant that changed.
TEST(ShippedSceneFidelity, WrongConstantsAreSeen) {
  const SceneRecording scene = read_kubric_scene(shipped_movi_a() / "20");
  const std::vector<Shape> shapes = load_kubasic_shapes(shipped_movi_a() / "shapes");
  const auto expect_seen = [&](const char* constant, double BulletSettings::*member, double wrong) {
    BulletSettings settings = movi_bullet_settings(MoviSet::kA);
    settings.*member = wrong;
    for (const Bound& bound : kShippedBounds) {
      const Difference error = resimulation_error(scene, shapes, settings, bound.frame);
      EXPECT_GT(error.position_m, bound.position_m) << constant << " at frame " << bound.frame;
      EXPECT_GT(error.orientation_deg, bound.orientation_deg) << constant << " at frame " << bound.frame;
    }
  };
  expect_seen("floor_friction", &BulletSettings::floor_friction, 0.25);
  expect_seen("floor_restitution", &BulletSettings::floor_restitution, 0.45);
  expect_seen("contact_erp", &BulletSettings::contact_erp, 0.2);
  expect_seen("hull_margin_m", &BulletSettings::hull_margin_m, 0.01);
}

struct Published {
  const char* scene;
  MoviSet set;
  Bound reached;  ///< Errors of the reference re-simulation
};

/// Chaos limits how far a published scene can be followed; these errors are what the best known settings reach.
class PublishedSceneFidelity : public ::testing::TestWithParam<Published> {};

TEST_P(PublishedSceneFidelity, ResimulationFollows) {
  const auto& [scene, set, reached] = GetParam();
  const std::filesystem::path folder = published_data() / "movi_sample" / scene;
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "published scene is not there: " << folder;
  const Difference error =
      resimulation_error(read_kubric_scene(folder), load_kubasic_shapes(published_data() / "kubasic"),
                         movi_bullet_settings(set), reached.frame);
  EXPECT_LT(error.position_m, 1.5 * reached.position_m);
  EXPECT_LT(error.orientation_deg, 1.5 * reached.orientation_deg);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PublishedSceneFidelity,
                         ::testing::Values(Published{"MOVi-A/8", MoviSet::kA, {160, 0.016, 3.3}},
                                           Published{"MOVi-A/8", MoviSet::kA, {240, 0.130, 18.4}},
                                           Published{"MOVi-spheres/8", MoviSet::kSphere, {160, 0.023, 1.3}},
                                           Published{"MOVi-spheres/8", MoviSet::kSphere, {240, 0.025, 3.6}}));

}  // namespace
}  // namespace rigidformer
