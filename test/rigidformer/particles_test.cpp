// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/particles.hpp"

#include <algorithm>
#include <set>

#include "rigidformer/candidates_fixture.hpp"

namespace rigidformer {
namespace {

TEST(Particles, DrawsDependOnObjectNumberAndSeedAlone) {
  const BodyProperties drawn = drawn_material("a", 3, 7);
  EXPECT_EQ(*drawn.friction, *drawn_material("a", 3, 7).friction);
  EXPECT_NE(*drawn.friction, *drawn_material("b", 3, 7).friction);
  EXPECT_NE(*drawn.friction, *drawn_material("a", 4, 7).friction);
  EXPECT_NE(*drawn.friction, *drawn_material("a", 3, 8).friction);
  EXPECT_FALSE(drawn_material("a", 0, 7).friction) << "the first particle is the forecast's own world";
}

TEST(Particles, DrawsFillTheirRange) {
  double least = 1.0, most = 0.0, sum = 0.0;
  for (int particle = 1; particle <= 400; ++particle) {
    const double restitution = *drawn_material("a", particle, 1).restitution;
    least = std::min(least, restitution);
    most = std::max(most, restitution);
    sum += restitution / 400.0;
  }
  EXPECT_GT(least, 0.1);
  EXPECT_LT(least, 0.15);
  EXPECT_GT(most, 0.85);
  EXPECT_LT(most, 0.9);
  EXPECT_NEAR(sum, 0.5, 0.05) << "the mean of the forecast";
}

TEST(Particles, WhatIsKnownIsNotDrawn) {
  std::vector<ObjectState> scene{box("a", {0, 0, 1}), box("b", {3, 0, 1}), box("c", {6, 0, 1})};
  scene[0].properties.friction = 0.25;
  scene[2].mode = MotionMode::kStatic;
  Candidate candidate;
  candidate.changes.emplace_back();
  candidate.changes.back().id = "a";
  candidate.changes.back().properties.restitution = 0.75;
  candidate.removed_ids = {"b"};
  const Candidate drawn = in_world_of(2, 1, candidate, scene);
  ASSERT_EQ(drawn.changes.size(), 1u) << "b is removed, c does not move";
  EXPECT_FALSE(drawn.changes[0].properties.friction);
  EXPECT_EQ(*drawn.changes[0].properties.restitution, 0.75);
}

/// Boxes of unknown material that are thrown along the floor.
class ParticleBatchTest : public CandidatesTest {
 protected:
  ParticleBatchTest() {
    for (ObjectState& object : scene_) {
      object.properties = {};
      object.T_world_previous.translation.x() -= 2.0 * kCandidateStep_s;
    }
  }

  std::vector<CandidateOutcome> with_particles(const std::vector<Candidate>& candidates, int num_particles,
                                               Fidelity fidelity = Fidelity::kModel) {
    BatchOptions batch = options(fidelity, 8);
    batch.rollout.num_particles = num_particles;
    batch.rollout.particle_seed = 5;
    return roll_out(candidates, batch);
  }
};

bool same_poses(const Forecast& a, const Forecast& b) {
  for (std::size_t k = 0; k < a.objects.size(); ++k) {
    for (std::size_t i = 0; i < a.objects[k].poses.size(); ++i) {
      if (a.objects[k].poses[i].translation != b.objects[k].poses[i].translation) return false;
    }
  }
  return a.objects.size() == b.objects.size();
}

TEST_F(ParticleBatchTest, TheForecastIsThatWithoutParticles) {
  const auto with = with_particles({Candidate()}, 4), without = with_particles({Candidate()}, 1);
  EXPECT_TRUE(same_poses(with[0].forecast, without[0].forecast));
  EXPECT_TRUE(without[0].particles.empty());
  ASSERT_EQ(with[0].particles.size(), 3u);
  ASSERT_EQ(with[0].particles[0].size(), 4u);
}

TEST_F(ParticleBatchTest, WorldsPartWhereMaterialMatters) {
  const auto outcome = with_particles({Candidate()}, 4, Fidelity::kEngine)[0];
  std::set<double> ends;
  for (const ParticleOutcome& particle : outcome.particles[0]) ends.insert(particle.T_world_end.translation.x());
  EXPECT_EQ(ends.size(), 4u) << "each slides as far as its friction lets it";
  EXPECT_EQ(outcome.particles[0][0].T_world_end.translation, outcome.forecast.objects[0].poses.back().translation);
}

TEST_F(ParticleBatchTest, ACandidateIsTheSameAmongOthers) {
  Candidate removed;
  removed.removed_ids = {"b"};
  Candidate wrong;
  wrong.removed_ids = {"nobody"};
  const auto alone = with_particles({removed}, 3), among = with_particles({Candidate(), wrong, removed}, 3);
  EXPECT_EQ(among[1].stop, CandidateOutcome::Stop::kRefused);
  ASSERT_EQ(among[2].particles.size(), alone[0].particles.size());
  for (std::size_t k = 0; k < alone[0].particles.size(); ++k) {
    for (std::size_t p = 0; p < 3; ++p) {
      EXPECT_EQ(among[2].particles[k][p].T_world_end.translation, alone[0].particles[k][p].T_world_end.translation);
    }
  }
}

TEST_F(ParticleBatchTest, MaterialThatIsKnownLeavesNothingToDraw) {
  for (ObjectState& object : scene_) object.properties = {1.0, 0.5, 0.5};
  const auto outcome = with_particles({Candidate()}, 3)[0];
  for (const ParticleOutcome& particle : outcome.particles[2]) {
    EXPECT_EQ(particle.T_world_end.translation, outcome.particles[2][0].T_world_end.translation);
  }
}

TEST_F(ParticleBatchTest, NumbersOutOfRangeAreRefused) {
  EXPECT_THROW(with_particles({Candidate()}, 0), std::invalid_argument);
  EXPECT_THROW(with_particles({Candidate()}, 65), std::invalid_argument);
}

/// The same model with a table that takes the spread as it is and 1 cm beside it.
class MeasuredModelTest : public ParticleBatchTest {
 protected:
  MeasuredModelTest() {
    PredictorOptions options;
    options.file = (folder_.path() / "model.safetensors").string();
    options.device = "cpu";
    Checkpoint checkpoint = load_checkpoint(options.file);
    checkpoint.facts.doubt.emplace();
    for (auto& phases : checkpoint.facts.doubt->cells) {
      for (auto& cells : phases) cells.fill({{0.02, 0.02}, {0.01, 0.01}, 1.0, 1.0});
    }
    save_checkpoint(options.file, checkpoint.model, checkpoint.facts);
    predictor_ = std::make_unique<Predictor>(options);
  }
};

double first_speed_mps(const ObjectTrajectory& object) {
  return (object.poses[1].translation - object.poses[0].translation).norm() / kCandidateStep_s;
}

TEST_F(MeasuredModelTest, ForecastsTellTheirDoubt) {
  RolloutOptions rollout = options(Fidelity::kModel, 8).rollout;
  const Forecast alone = predictor_->predict(scene_, rollout);
  for (const ObjectTrajectory& object : alone.objects) {
    ASSERT_EQ(object.position_stddev_m.size(), object.poses.size());
    EXPECT_NEAR(object.position_stddev_m.front(), 0.02 * first_speed_mps(object), 1e-12)
        << "as the table says of 1 m/s";
    for (const double stddev_m : object.position_stddev_m) EXPECT_GT(stddev_m, 0.999 * object.position_stddev_m[0]);
  }
  rollout.num_particles = 4;
  const Forecast with = predictor_->predict(scene_, rollout);
  EXPECT_TRUE(same_poses(alone, with));
  const double beside_m = 0.01 * first_speed_mps(with.objects[0]);
  EXPECT_NEAR(with.objects[0].position_stddev_m.front(), beside_m, 1e-12) << "all begin where it was seen";
  EXPECT_GT(with.objects[0].position_stddev_m.back(), 1.1 * beside_m) << "they slide differently far";
}

TEST_F(MeasuredModelTest, ABatchAndAForecastDoubtAlike) {
  RolloutOptions rollout = options(Fidelity::kModel, 8).rollout;
  rollout.num_particles = 4;
  rollout.particle_seed = 5;
  const Forecast forecast = predictor_->predict(scene_, rollout);
  const auto outcome = with_particles({Candidate()}, 4)[0];
  EXPECT_EQ(outcome.forecast.objects[0].position_stddev_m, forecast.objects[0].position_stddev_m);
  EXPECT_EQ(outcome.forecast.objects[0].rotation_stddev_rad, forecast.objects[0].rotation_stddev_rad);
}

TEST_F(MeasuredModelTest, TheEngineAloneTellsNoDoubt) {
  const auto outcome = with_particles({Candidate()}, 4, Fidelity::kEngine)[0];
  EXPECT_TRUE(outcome.forecast.objects[0].position_stddev_m.empty()) << "the model's errors are not the engine's";
}

}  // namespace
}  // namespace rigidformer
