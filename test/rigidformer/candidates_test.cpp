// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>

#include "rigidformer/candidates_fixture.hpp"
#include "rigidformer/evaluation/model_forecaster.hpp"

#ifdef RIGIDFORMER_HAS_SIMULATION
namespace rigidformer {
namespace {

using Stop = CandidateOutcome::Stop;

/// True where every number of two outcomes is the same.
bool same_bytes(const CandidateOutcome& a, const CandidateOutcome& b) {
  const Forecast &f = a.forecast, &g = b.forecast;
  bool same = a.stop == b.stop && a.message == b.message && f.times_s == g.times_s &&
              f.objects.size() == g.objects.size() && f.contacts.size() == g.contacts.size();
  for (std::size_t k = 0; same && k < f.objects.size(); ++k) {
    const auto &p = f.objects[k].poses, &q = g.objects[k].poses;
    same = p.size() == q.size();
    for (std::size_t i = 0; same && i < p.size(); ++i) {
      same = p[i].translation == q[i].translation && p[i].rotation.coeffs() == q[i].rotation.coeffs();
    }
  }
  for (std::size_t i = 0; same && i < f.contacts.size(); ++i) {
    const StepContact &c = f.contacts[i], &d = g.contacts[i];
    const bool both_unknown = std::isnan(c.normal_impulse_Ns) && std::isnan(d.normal_impulse_Ns);
    same = c.step == d.step && c.object_a == d.object_a && c.object_b == d.object_b &&
           c.penetration_m == d.penetration_m && (both_unknown || c.normal_impulse_Ns == d.normal_impulse_Ns);
  }
  return same;
}

/// Candidates of all kinds; the last one is not possible.
std::vector<Candidate> many_candidates(int count) {
  std::vector<Candidate> candidates;
  for (int i = 0; i < count; ++i) {
    Candidate candidate;
    candidate.name = "number " + std::to_string(i);
    const double x = 0.1 * i;
    if (i % 4 == 1) candidate.pushes = {{"a", 0.05 * i, {1.0 + x, 0.0, 0.0}, {0, 0, 0}, {0.0, 0.0, 0.1}}};
    if (i % 4 == 2) candidate.removed_ids = {"b"};
    if (i % 4 == 2) candidate.changes = {{"a", at(x, 0, 1.0 + x), Twist{{0, 0, x}, {x, 0, 0}}, {}}};
    if (i % 4 == 3) candidate.tracks = {{"finger", box_cloud(0.3), {}, {0.0, 1.0}, {at(-0.9, 0, 0.5), at(x, 0, 0.5)}}};
    candidates.push_back(candidate);
  }
  return candidates;
}

TEST_F(CandidatesTest, P25_OneWithoutChangesIsTheForecastOfStart) {
  for (const int num_threads : {1, 2}) {
    const CandidateOutcome outcome = roll_out({Candidate()}, options(Fidelity::kModel, 6, num_threads))[0];
    CandidateOutcome single;
    single.stop = Stop::kHorizon;
    single.forecast = predictor_->predict(scene_, options(Fidelity::kModel, 6).rollout);
    EXPECT_TRUE(same_bytes(outcome, single));
    EXPECT_EQ(outcome.stop, Stop::kHorizon);
  }
}

TEST_F(CandidatesTest, P25_NeitherPlaceNorOthersNorThreadsMatter) {
  for (const Fidelity fidelity : {Fidelity::kModel, Fidelity::kEngine}) {
    const std::vector<Candidate> candidates = many_candidates(16);
    const auto all = roll_out(candidates, options(fidelity, 6, 2));
    const auto backwards =
        roll_out(std::vector<Candidate>(candidates.rbegin(), candidates.rend()), options(fidelity, 6));
    const auto half = roll_out(std::vector<Candidate>(candidates.begin() + 8, candidates.end()), options(fidelity, 6));
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(all[i].name, candidates[i].name);
      EXPECT_EQ(all[i].message, "");
      EXPECT_TRUE(same_bytes(all[i], backwards[all.size() - 1 - i])) << i;
      EXPECT_TRUE(i < 8 || same_bytes(all[i], half[i - 8])) << i;
      EXPECT_TRUE(i >= 4 || same_bytes(all[i], roll_out({candidates[i]}, options(fidelity, 6))[0])) << i;
    }
    EXPECT_FALSE(same_bytes(all[1], all[5])) << "the comparison does see differences";
  }
}

TEST_F(CandidatesTest, P25_OneBadCandidateLeavesTheOthersAlone) {
  const std::vector<Candidate> good = many_candidates(8);
  const auto expected = roll_out(good, options(Fidelity::kModel, 4));
  Candidate unknown, not_a_number, inside, diverging;
  unknown.removed_ids = {"nobody"};
  not_a_number.pushes = {{"a", std::nan("")}};
  inside.changes = {{"a", at(1.3, 0.1, 0.8), {}, {}}};
  diverging.changes = {{"a", {}, Twist{{0.0, 0.0, 1e37}, {0.0, 0.0, 0.0}}, {}}};
  for (const Candidate& bad : {unknown, not_a_number, inside, diverging}) {
    std::vector<Candidate> candidates = good;
    candidates.insert(candidates.begin() + 3, bad);
    const auto outcomes = roll_out(candidates, options(Fidelity::kModel, 4));
    for (std::size_t i = 0; i < good.size(); ++i) {
      EXPECT_TRUE(same_bytes(outcomes[i < 3 ? i : i + 1], expected[i])) << outcomes[3].message << i;
    }
    EXPECT_TRUE(outcomes[3].stop == Stop::kRefused || &bad == &diverging || outcomes[3].stop != Stop::kRunning);
  }
  EXPECT_EQ(roll_out(unknown, 2).error, CandidateOutcome::Error::kUnknownObject);
  const CandidateOutcome refused = roll_out(inside, 2);
  EXPECT_EQ(refused.stop, Stop::kRefused);
  EXPECT_NE(refused.message.find("'a'"), std::string::npos) << refused.message;
  EXPECT_NE(refused.message.find("'b'"), std::string::npos) << refused.message;
}

TEST_F(CandidatesTest, NoneIsMoreThanAStepAheadAndEveryCallTakesOne) {
  const auto rollout = predictor_->start_batch(scene_, many_candidates(5), options(Fidelity::kEngine, 3));
  int calls = 1;
  for (; rollout->advance(0.0); ++calls) {
    std::size_t fewest = 99, most = 0;
    for (const CandidateOutcome& outcome : rollout->outcomes()) {
      const std::size_t steps = std::max<std::size_t>(1, outcome.forecast.times_s.size());
      fewest = std::min(fewest, steps);
      most = std::max(most, steps);
    }
    EXPECT_LE(most - fewest, 1u);
  }
  EXPECT_EQ(calls, 15);
}

TEST_F(CandidatesTest, AForecasterFollowsTracksAsACandidateDoes) {
  scene_[0].mode = MotionMode::kKinematic;
  GivenTrack track;
  track.id = "a";
  track.times_s = {-kCandidateStep_s, 0.0, 3.0 * kCandidateStep_s};
  const RigidTransform start = scene_[0].T_world_current;
  track.T_world_reference = {scene_[0].T_world_previous, start, start};
  track.T_world_reference[2].translation.x() += 0.6;
  Candidate candidate;
  candidate.tracks = {track};
  const BatchOptions batch = options(Fidelity::kModel, 3);
  const Forecast wanted = roll_out(std::vector<Candidate>{candidate}, batch)[0].forecast;
  const auto poses = ModelForecaster(*predictor_).forecast(scene_, batch.rollout, {track});
  ASSERT_EQ(poses.size(), scene_.size());
  EXPECT_NEAR(poses[0][3].translation.x() - start.translation.x(), 0.6, 1e-6);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(poses[i][3].translation, wanted.objects[i].poses[3].translation);
  }
  track.id = "nobody";
  EXPECT_THROW(ModelForecaster(*predictor_).forecast(scene_, batch.rollout, {track}), std::invalid_argument);
}

TEST_F(CandidatesTest, AnObjectThatCannotBePredictedIsLeftOutForAll) {
  scene_.push_back(box("line", {0, 0, 3}));
  scene_.back().points_reference.rightCols(2).setZero();
  Candidate candidate;
  candidate.removed_ids = {"line"};
  const auto rollout = predictor_->start_batch(scene_, {Candidate(), candidate}, options(Fidelity::kEngine, 1));
  rollout->advance();
  ASSERT_EQ(rollout->unusable().size(), 1u);
  EXPECT_EQ(rollout->outcomes()[0].forecast.objects.size(), 3u);
  EXPECT_NE(rollout->outcomes()[1].message.find("left out"), std::string::npos) << rollout->outcomes()[1].message;
}

}  // namespace
}  // namespace rigidformer
#endif
