// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "paper_scene.hpp"
#include "ratio_reporter.hpp"
#include "rigidformer/engine/engine_step.hpp"
#include "rigidformer/model/features.hpp"
#include "rigidformer/model/nearest.hpp"
#include "rigidformer/model/rigidformer.hpp"

namespace rigidformer {
namespace {

/// A network with random weights, and the inputs of its parts on the paper's scene. Time
/// does not depend on the weights.
struct Fixture {
  RigidFormer model{nullptr};
  SceneBatch batch;
  SceneState state;
  Tensor centre, points_world, anchors_world, features;
  Tensor engine_at_points;  ///< Features of the engine's step, [B, K, N, 0 or 6]
  EngineStep engine;
  TokenPositions positions;
  Encoding encoding;
  std::vector<Tensor> decoder_outputs;

  Fixture(const std::string& preset, torch::ScalarType type) {
    torch::manual_seed(1);
    const auto objects = paper_scene();
    batch = as_batch(objects);
    state = as_state(objects);
    model = RigidFormer(model_preset(preset));
    model->eval();
    model->to(type);
    model->set_compute_type(type);
    centre = model->centre_of_mass(batch, state.current);
    points_world = state.current.apply(batch.points_reference);
    anchors_world = gather_points(points_world, batch.anchor_index);
    const Nearest nearest = nearest_by_distance_matrix(batch, state.current, points_world);
    const BaseMotion base = make_base_motion(model->options, batch, state, centre);
    features = vertex_features(model->options, batch, state, base, points_world, nearest).to(type);
    engine = make_engine_step(model->options, batch, centre);
    engine_at_points = features.slice(-1, 0, 0);
    if (engine) {
      engine_at_points = engine_features(batch, state, base, engine(state), batch.points_reference).to(type);
    }
    positions = model->position_encoder(batch, state.current, points_world, anchors_world);
    encoding = encode();
    decoder_outputs = object_interaction();
  }

  Encoding encode() { return model->encoder(torch::cat({features, engine_at_points}, -1), batch.point_mask); }

  TokenSet objects() const { return {encoding.tokens, batch.object_mask, positions.object_angles}; }

  std::vector<Tensor> object_interaction() {
    const Tensor s = batch.step_size.unsqueeze(-1) / 10.0;
    return model->decoder(objects(), torch::cat({s, s.square()}, -1).to(model->compute_type));
  }

  Tensor anchor_interaction() {
    const Tensor pooled =
        model->anchor_vertex_pooling(encoding.vertex_features, points_world, batch.point_mask, anchors_world);
    const Tensor own = gather_points(features, batch.anchor_index);
    const Tensor position = anchors_world.to(model->compute_type);
    const Tensor engine_at_anchors = gather_points(engine_at_points, batch.anchor_index);
    return model->predictor(torch::cat({own, position, pooled, engine_at_anchors}, -1), decoder_outputs, objects(),
                            positions.anchor_angles, positions.anchor_embedding);
  }
};

template <typename Part>
void run_part(benchmark::State& state, const std::string& preset, torch::ScalarType type, Part part) {
  torch::NoGradGuard no_grad;
  Fixture fixture(preset, type);
  for (auto _ : state) {
    part(fixture);
  }
}

template <typename Part>
void register_part(const std::string& name, const std::string& preset, torch::ScalarType type, Part part) {
  const std::string full_name = preset + (type == torch::kBFloat16 ? "/bfloat16/" : "/float32/") + name;
  benchmark::RegisterBenchmark(full_name.c_str(), [=](benchmark::State& state) {
    run_part(state, preset, type, part);
  })->Unit(benchmark::kMillisecond);
  if (type == torch::kBFloat16) {
    RatioReporter::compare(full_name, preset + "/float32/" + name);
  }
}

const bool kRegistered = [] {
  for (const std::string preset : {"paper", "small"}) {
    for (const auto type : {torch::kFloat32, torch::kBFloat16}) {
      register_part("encoder", preset, type, [](Fixture& f) { f.encode(); });
      register_part("object_interaction", preset, type, [](Fixture& f) { f.object_interaction(); });
      register_part("anchor_interaction", preset, type, [](Fixture& f) { f.anchor_interaction(); });
    }
    if (model_preset(preset).engine_motion) {
      register_part("physics_engine", preset, torch::kFloat32, [](Fixture& f) { f.engine(f.state); });
    }
    // The alternative: one whole step as it is written in the paper, with float32, padded
    // points and a full distance matrix.
    register_part("step_with_distance_matrix", preset, torch::kFloat32, [](Fixture& f) {
      f.model->forward(f.batch, f.state, f.centre, nearest_by_distance_matrix, f.engine);
    });
  }
  return true;
}();

}  // namespace
}  // namespace rigidformer
