// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/candidate_batch.hpp"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include "rigidformer/model/threads.hpp"
#include "rigidformer/stop_rules.hpp"

namespace rigidformer {
namespace {

using Stop = CandidateOutcome::Stop;
using Error = CandidateOutcome::Error;

constexpr double kNoLimit_s = 1e9;  // about 32 years: the clock counts nanoseconds in 64 bits, which hold 292 years

/// While several threads take steps, each computes alone.
class OneThreadEach {
 public:
  explicit OneThreadEach(int num_threads) : before_(at::get_num_threads()), is_needed_(num_threads > 1) {
    if (is_needed_) set_num_threads(1);
  }
  ~OneThreadEach() {
    if (is_needed_) set_num_threads(before_);
  }
  OneThreadEach(const OneThreadEach&) = delete;
  OneThreadEach& operator=(const OneThreadEach&) = delete;

 private:
  int before_;
  bool is_needed_;
};

bool all_dynamic_diverged(const CandidateOutcome& outcome) {
  bool any_moves = false;
  for (std::size_t k = 0; k < outcome.modes.size(); ++k) {
    if (outcome.modes[k] != MotionMode::kDynamic) continue;
    any_moves = true;
    if (outcome.forecast.objects[k].status != ObjectTrajectory::Status::kDiverged) return false;
  }
  return any_moves;
}

std::vector<std::string> known_ids(const std::vector<ObjectState>& states, const std::vector<Candidate>& candidates) {
  std::vector<std::string> ids;
  for (const ObjectState& state : states) ids.push_back(state.id);
  for (const Candidate& candidate : candidates) {
    for (const GivenTrack& track : candidate.tracks) ids.push_back(track.id);
  }
  return ids;
}

}  // namespace

CandidateBatch::CandidateBatch(const StepMaker& maker, const Perceive& perceive, PerceivedObjects scene,
                               std::vector<ObjectState> states, std::vector<ObjectTrajectory> unusable,
                               const std::vector<Candidate>& candidates, const BatchOptions& options, int max_objects)
    : maker_(maker),
      options_(options),
      scene_(std::move(scene)),
      states_(std::move(states)),
      unusable_(std::move(unusable)),
      running_(candidates.size()),
      outcomes_(candidates.size()) {
  if (options.num_threads < 1) {
    throw std::invalid_argument("num_threads is " + std::to_string(options.num_threads) + ", must be at least 1");
  }
  check_rules(options.stop, known_ids(states_, candidates));
  maker_.fidelity = options.fidelity;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    outcomes_[i].name = candidates[i].name;
    try {
      prepare(candidates[i], perceive, max_objects, i);
    } catch (const CandidateError& error) {
      refuse(i, error.kind(), reason_for(error.what()));
    }
  }
  bodies_.clear();
}

/// Whoever names an object that was left out is told why it was.
std::string CandidateBatch::reason_for(const std::string& message) const {
  for (const ObjectTrajectory& object : unusable_) {
    if (message.find("'" + object.id + "'") != std::string::npos) return message + "; it is left out: " + object.reason;
  }
  return message;
}

void CandidateBatch::prepare(const Candidate& candidate, const Perceive& perceive, int max_objects, std::size_t i) {
  std::vector<CandidateObject> objects = candidate_objects(candidate, states_, options_.rollout.time_step_s);
  if (objects.size() > static_cast<std::size_t>(max_objects)) {
    throw CandidateError(Error::kInvalid, "has " + std::to_string(objects.size()) +
                                              " objects, the model takes at most " + std::to_string(max_objects));
  }
  forget_lost_support(scene_.solids, states_, objects);
  for (const CandidateObject& object : objects) {
    outcomes_[i].modes.push_back(object.state.mode);
    if (object.source < 0) running_[i].own.push_back(perceived_body(perceive, object.state));
  }
  running_[i].objects = std::move(objects);
}

std::shared_ptr<const PerceivedObjects> CandidateBatch::perceived_body(const Perceive& perceive,
                                                                       const ObjectState& body) {
  for (const auto& [cloud, perceived] : bodies_) {
    if (cloud.rows() == body.points_reference.rows() && cloud == body.points_reference) return perceived;
  }
  try {
    ObjectState in_place = body;  // what is perceived must not hang on where the first of its tracks begins
    in_place.T_world_previous = in_place.T_world_current = {};
    bodies_.emplace_back(body.points_reference, std::make_shared<PerceivedObjects>(perceive({in_place})));
  } catch (const BodyError& error) {
    throw CandidateError(Error::kInvalid, "kinematic '" + body.id + "': " + error.what());
  }
  return bodies_.back().second;
}

int CandidateBatch::steps_done(std::size_t i) const {
  return std::max(0, static_cast<int>(outcomes_[i].forecast.times_s.size()) - 1);
}

bool CandidateBatch::advance(double budget_s) {
  const auto limit = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(std::min(budget_s, kNoLimit_s)));
  const OneThreadEach one_thread_each(options_.num_threads);
  std::vector<std::size_t> level = next_level();
  while (!level.empty()) {
    advance_level(level, limit);
    level = next_level();
    if (Clock::now() >= limit) break;
  }
  return !level.empty();
}

/// The candidates that have taken the fewest steps.
std::vector<std::size_t> CandidateBatch::next_level() const {
  std::vector<std::size_t> level;
  int fewest = options_.rollout.num_steps;
  for (std::size_t i = 0; i < outcomes_.size(); ++i) {
    if (outcomes_[i].stop != Stop::kRunning || steps_done(i) > fewest) continue;
    if (steps_done(i) < fewest) level.clear();
    fewest = steps_done(i);
    level.push_back(i);
  }
  return level;
}

void CandidateBatch::advance_level(const std::vector<std::size_t>& level, Clock::time_point limit) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    c10::InferenceMode inference;
    for (std::size_t n = next++; n < level.size(); n = next++) {
      if (n > 0 && Clock::now() >= limit) return;
      advance_one(level[n]);
    }
  };
  std::vector<std::thread> others;
  const std::size_t num_threads = std::min(static_cast<std::size_t>(options_.num_threads), level.size());
  for (std::size_t i = 1; i < num_threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
}

void CandidateBatch::advance_one(std::size_t i) {
  const Clock::time_point start = Clock::now();
  try {
    take_step(i);
    end_where_due(i);
  } catch (const CandidateError& error) {
    refuse(i, error.kind(), error.what());
  } catch (const std::exception& error) {
    refuse(i, Error::kFailed, error.what());
  }
  outcomes_[i].forecast.compute_time_s += std::chrono::duration<double>(Clock::now() - start).count();
}

void CandidateBatch::take_step(std::size_t i) {
  Running& running = running_[i];
  Forecast& forecast = outcomes_[i].forecast;
  if (!running.world && !outcomes_[i].modes.empty()) {
    std::vector<const PerceivedObjects*> parts;
    std::vector<std::int64_t> rows;
    auto own = running.own.begin();
    for (const CandidateObject& object : running.objects) {
      parts.push_back(object.source < 0 ? (own++)->get() : &scene_);
      rows.push_back(std::max(0, object.source));
    }
    PerceivedObjects perceived = gather(parts, rows, scene_);
    running.world = std::make_unique<RolloutWorld>(maker_, std::move(perceived), std::move(running.objects),
                                                   options_.rollout, forecast);
  }
  if (running.world) {
    running.world->step();
    outcomes_[i].knowledge = running.world->knowledge();
    if (!maker_.doubt || maker_.fidelity == Fidelity::kEngine) return;
    return add_doubt(*maker_.doubt, outcomes_[i].knowledge, outcomes_[i].modes, nothing_spreads, forecast);
  }
  if (forecast.times_s.empty()) forecast.times_s.push_back(0.0);  // a scene without objects, in which time passes
  forecast.times_s.push_back(static_cast<double>(forecast.times_s.size()) * options_.rollout.time_step_s);
}

void CandidateBatch::refuse(std::size_t i, Error error, const std::string& message) {
  outcomes_[i].stop = Stop::kRefused;
  outcomes_[i].error = error;
  outcomes_[i].message = message;
  running_[i] = {};
}

void CandidateBatch::end_where_due(std::size_t i) {
  CandidateOutcome& outcome = outcomes_[i];
  outcome.rule = rule_that_holds(options_, outcome);
  if (outcome.rule >= 0) {
    outcome.stop = Stop::kRule;
  } else if (all_dynamic_diverged(outcome)) {
    outcome.stop = Stop::kDiverged;
  } else if (steps_done(i) >= options_.rollout.num_steps) {
    outcome.stop = Stop::kHorizon;
  }
  if (outcome.stop != Stop::kRunning) running_[i] = {};
}

}  // namespace rigidformer
