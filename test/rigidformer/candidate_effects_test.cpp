// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "rigidformer/candidates_fixture.hpp"

#ifdef RIGIDFORMER_HAS_SIMULATION
namespace rigidformer {
namespace {

/// A small cube that comes from the left at 2 cm/s and touches object "a" after 0.5 s.
Candidate slow_finger() {
  Candidate candidate;
  candidate.tracks = {{"finger", box_cloud(0.3), {{}, 0.5, 0.2}, {0.0, 20.0}, {at(-0.66, 0, 0.5), at(-0.26, 0, 0.5)}}};
  return candidate;
}

TEST_F(CandidatesTest, ASlowFingerPushesInsteadOfSinkingIn) {
  const BatchOptions batch = options(Fidelity::kEngine, 240);
  for (Predictor* predictor : {predictor_.get(), true_to_engine_.get()}) {
    BatchOptions wanted = batch;
    wanted.fidelity = predictor == predictor_.get() ? Fidelity::kEngine : Fidelity::kModel;
    const auto rollout = predictor->start_batch(scene_, {slow_finger()}, wanted);
    while (rollout->advance()) {
    }
    const Forecast& forecast = rollout->outcomes()[0].forecast;
    ASSERT_EQ(forecast.objects.size(), 4u) << rollout->outcomes()[0].message;
    const double finger = forecast.objects[3].poses.back().translation.x();
    EXPECT_NEAR(finger, -0.66 + 240 * kCandidateStep_s * 0.02, 1e-6) << "its own path is exact";
    EXPECT_NEAR(forecast.objects[0].poses.back().translation.x() - finger, 0.65, 0.02) << "the object follows";
    EXPECT_LT((forecast.objects[2].poses.back().translation - at(0, 4, 0.5).translation).norm(), 0.05);
    for (const ContactSpan& span : contact_spans(forecast)) {
      EXPECT_LT(span.max_penetration_m, 0.02) << span.object_a << " and " << span.object_b;
    }
  }
}

TEST_F(CandidatesTest, TheGivenPoseIsThatOfTheSameStep) {
  const CandidateOutcome outcome = roll_out(slow_finger(), 12);
  for (int k = 0; k <= 12; ++k) {
    EXPECT_NEAR(outcome.forecast.objects[3].poses[static_cast<std::size_t>(k)].translation.x(),
                -0.66 + 0.02 * k * kCandidateStep_s, 1e-6);
  }
}

TEST_F(CandidatesTest, AnImpulseChangesTheMomentum) {
  scene_ = {box("a", {0.0, 0.0, 5.0})};
  scene_[0].properties.mass_kg = 2.0;
  Candidate candidate;
  candidate.pushes = {{"a", 2.5 * kCandidateStep_s, {3.0, 0.0, 0.0}, {0.0, 0.0, 0.5}}};
  const auto& poses = roll_out(candidate, 6).forecast.objects[0].poses;
  const auto moved = [&](int k) { return (poses[k + 1].translation - poses[k].translation).x() / kCandidateStep_s; };
  EXPECT_NEAR(moved(1), 0.0, 1e-4) << "it acts in the first step that ends after its time";
  EXPECT_NEAR(moved(2), 1.5, 1e-3);
  EXPECT_NEAR(moved(5), 1.5, 1e-3);
  const double spin = 0.5 / (2.0 / 6.0);  // a cube of 1 m has m / 6
  EXPECT_NEAR(rotation_vector(poses[3].rotation * poses[2].rotation.conjugate()).z() / kCandidateStep_s, spin, 5e-3);
}

TEST_F(CandidatesTest, ASmallPushSlidesAndEndsByFriction) {
  Candidate candidate;
  candidate.pushes = {{"a", 0.0, {-0.09, 0.0, 0.0}, {0, 0, 0}, {0.0, 0.0, 0.0}}};
  candidate.changes = {{"a", {}, {}, {}, {{}, 0.1, {}}}};
  const auto& poses = roll_out(candidate, 24).forecast.objects[0].poses;
  EXPECT_LT(poses.back().translation.x(), -0.005) << "slower than what is held at rest, but pushed";
  EXPECT_LT((poses[24].translation - poses[23].translation).norm(), 1e-3);
}

TEST_F(CandidatesTest, ATwistInTheAirIsThatOfTheInstant) {
  Candidate candidate;
  candidate.changes = {{"c", at(0, 4, 20), Twist{{1.0, 0.0, 3.0}, {0, 0, 0}}, {}}};
  const auto& poses = roll_out(candidate, 12).forecast.objects[2].poses;
  const double t = 12 * kCandidateStep_s;
  EXPECT_NEAR(poses[12].translation.x(), t, 2e-3);
  EXPECT_NEAR(poses[12].translation.z(), 20.0 + 3.0 * t - 5.0 * t * t, 5e-3);
}

TEST_F(CandidatesTest, WhatStoodOnARemovedObjectFalls) {
  scene_ = {box("table", {0, 0, 0.501}), box("cup", {0, 0, 1.503})};
  Candidate candidate;
  const CandidateOutcome stays = roll_out(candidate, 24);
  EXPECT_NEAR(stays.forecast.objects[1].poses.back().translation.z(), 1.503, 5e-3);
  candidate.removed_ids = {"table"};
  const CandidateOutcome falls = roll_out(candidate, 48);
  ASSERT_EQ(falls.forecast.objects.size(), 1u);
  EXPECT_NEAR(falls.forecast.objects[0].poses.back().translation.z(), 0.5, 0.02);
  EXPECT_EQ(first_contact_step(stays.forecast, 1), 0);
  EXPECT_NEAR(first_contact_step(falls.forecast, 0), std::sqrt(2.0 / 10.0) / kCandidateStep_s, 1.5);
}

TEST_F(CandidatesTest, ContactsTellWhoHowHardAndHowDeep) {
  scene_ = {box("a", {0.0, 0.0, 2.0})};
  const CandidateOutcome outcome = roll_out({}, 48);
  const auto spans = contact_spans(outcome.forecast);
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(spans[0].object_a, 0);
  EXPECT_EQ(spans[0].object_b, -1);
  const double momentum = std::sqrt(2.0 * 10.0 * 1.5);  // of 1 kg after 1.5 m
  EXPECT_GT(spans[0].max_normal_impulse_Ns, momentum);
  EXPECT_LT(spans[0].max_normal_impulse_Ns, 2.0 * momentum + 10.0 * kCandidateStep_s);
  EXPECT_LT(spans[0].max_penetration_m, 0.1);
  EXPECT_EQ(spans[0].first_step, first_contact_step(outcome.forecast, 0));
  scene_[0].properties.mass_kg.reset();
  EXPECT_TRUE(std::isnan(contact_spans(roll_out({}, 24).forecast)[0].max_normal_impulse_Ns));
}

TEST_F(CandidatesTest, RulesEndACandidate) {
  scene_ = {box("a", {0.0, 0.0, 0.501}), box("c", {0, 4, 2})};
  const auto ended = [&](const StopRule& rule, const Candidate& candidate) {
    BatchOptions batch = options(Fidelity::kEngine, 60);
    batch.stop = {{StopRule::Kind::kTilt, {"c"}, 3.0}, rule};
    return roll_out({candidate}, batch)[0];
  };
  CandidateOutcome outcome = ended({StopRule::Kind::kTouch, {"c"}}, {});
  EXPECT_EQ(outcome.stop, CandidateOutcome::Stop::kRule);
  EXPECT_EQ(outcome.rule, 1);
  EXPECT_EQ(static_cast<int>(outcome.forecast.times_s.size()) - 1, first_contact_step(outcome.forecast, 1));
  EXPECT_EQ(ended({StopRule::Kind::kTouch, {"a"}}, {}).stop, CandidateOutcome::Stop::kHorizon)
      << "it touched the ground before";
  outcome = ended({StopRule::Kind::kAllSettled}, {});
  EXPECT_EQ(outcome.stop, CandidateOutcome::Stop::kRule);
  EXPECT_GE(settled_step(outcome.forecast.objects[1].poses, kCandidateStep_s, SettleCriterion()), 0);
  Candidate tipped;
  tipped.pushes = {{"a", 0.0, {4.0, 0.0, 0.0}, {0, 0, 0}, {0.0, 0.0, 0.5}}};
  outcome = ended({StopRule::Kind::kTilt, {"a"}, 0.3}, tipped);
  EXPECT_EQ(outcome.stop, CandidateOutcome::Stop::kRule);
  EXPECT_GT(max_tilt(outcome.forecast.objects[0].poses), 0.3);
  outcome = ended({StopRule::Kind::kLeave, {"a"}, 0.0, {"table", at(0, 0, 0.5), {0.5, 0.5, 2.0}}}, tipped);
  EXPECT_EQ(outcome.stop, CandidateOutcome::Stop::kRule);
  EXPECT_GT(path_length(outcome.forecast.objects[0].poses), 0.25);
  BatchOptions batch = options(Fidelity::kEngine, 2);
  batch.stop = {{StopRule::Kind::kTouch, {"nobody"}}};
  EXPECT_NE(error_of([&] { roll_out({Candidate()}, batch); }).find("nobody"), std::string::npos);
}

}  // namespace
}  // namespace rigidformer
#endif
