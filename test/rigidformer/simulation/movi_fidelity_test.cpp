// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "rigidformer/data/kubasic.hpp"
#include "rigidformer/data/kubric.hpp"
#include "rigidformer/simulation/movi_scene.hpp"

namespace rigidformer {
namespace {

struct Reference {
  const char* scene;
  MoviSet set;
  int frame;
  double position_m;  ///< RMS error of the reference re-simulation
  double orientation_deg;
};

/// Chaos limits how far a published scene can be followed: the reference errors are what the best known settings reach.
class MoviFidelity : public ::testing::TestWithParam<Reference> {};

TEST_P(MoviFidelity, ResimulationFollowsThePublishedScene) {
  const Reference& reference = GetParam();
  const std::filesystem::path data = RIGIDFORMER_SOURCE_DIR "/../shared/data";
  const std::filesystem::path folder = data / "movi_sample" / reference.scene;
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "published scene is not there: " << folder;
  const SceneRecording published = read_kubric_scene(folder);
  const SceneRecording simulated = simulate(published, load_kubasic_shapes(data / "kubasic"),
                                            movi_bullet_settings(reference.set), reference.frame + 1);
  double position = 0.0;
  double orientation = 0.0;
  for (std::size_t i = 0; i < published.objects.size(); ++i) {
    const RigidTransform& a = published.objects[i].T_world_object[static_cast<std::size_t>(reference.frame)];
    const RigidTransform& b = simulated.objects[i].T_world_object[static_cast<std::size_t>(reference.frame)];
    position += (a.translation - b.translation).squaredNorm();
    orientation += std::pow(rotation_angle(a.rotation, b.rotation) * 180.0 / M_PI, 2);
  }
  const auto count = static_cast<double>(published.objects.size());
  EXPECT_LT(std::sqrt(position / count), 1.5 * reference.position_m);
  EXPECT_LT(std::sqrt(orientation / count), 1.5 * reference.orientation_deg);
}

INSTANTIATE_TEST_SUITE_P(Scenes, MoviFidelity,
                         ::testing::Values(Reference{"MOVi-A/8", MoviSet::kA, 160, 0.016, 3.3},
                                           Reference{"MOVi-A/8", MoviSet::kA, 240, 0.130, 18.4},
                                           Reference{"MOVi-spheres/8", MoviSet::kSphere, 160, 0.023, 1.3},
                                           Reference{"MOVi-spheres/8", MoviSet::kSphere, 240, 0.025, 3.6}));

}  // namespace
}  // namespace rigidformer
