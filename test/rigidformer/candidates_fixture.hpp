// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "rigidformer/box_scene.hpp"
#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/model/checkpoint.hpp"
#include "rigidformer/model/random_scene.hpp"
#include "rigidformer/predictor.hpp"

namespace rigidformer {

constexpr double kCandidateStep_s = 10.0 / 240.0;  // [s]

/// A model with an engine, and a scene of two boxes on the ground beside each other and one that falls.
class CandidatesTest : public ::testing::Test {
 protected:
  CandidatesTest() {
    ModelOptions model = contact_aware(model_preset("tiny"));
    model.engine_motion = model.hidden_side_head = true;
    TrainingFacts facts;
    facts.min_step_frames = 1.0;
    facts.max_step_frames = 10.0;
    PredictorOptions options;
    options.file = (folder_.path() / "model.safetensors").string();
    options.device = "cpu";
    save_checkpoint(options.file, random_model(model, torch::kFloat32), facts);
    predictor_ = std::make_unique<Predictor>(options);
    options.engine_share = 1.0;
    true_to_engine_ = std::make_unique<Predictor>(options);
  }

  static BatchOptions options(Fidelity fidelity, int num_steps, int num_threads = 1) {
    BatchOptions batch;
    batch.rollout.num_steps = num_steps;
    batch.rollout.time_step_s = kCandidateStep_s;
    batch.fidelity = fidelity;
    batch.num_threads = num_threads;
    return batch;
  }

  std::vector<CandidateOutcome> roll_out(const std::vector<Candidate>& candidates, const BatchOptions& batch) {
    const auto rollout = predictor_->start_batch(scene_, candidates, batch);
    while (rollout->advance()) {
    }
    return rollout->outcomes();
  }

  CandidateOutcome roll_out(const Candidate& candidate, int num_steps) {
    return roll_out(std::vector<Candidate>{candidate}, options(Fidelity::kEngine, num_steps))[0];
  }

  const TemporaryFolder folder_;
  std::unique_ptr<Predictor> predictor_, true_to_engine_;
  std::vector<ObjectState> scene_{box("a", {0.0, 0.0, 0.501}), box("b", {1.3, 0.1, 0.501}), box("c", {0, 4, 2})};
};

}  // namespace rigidformer
