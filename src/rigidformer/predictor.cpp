// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/predictor.hpp"

#include <chrono>
#include <cmath>
#include <stdexcept>

#include "rigidformer/engine/engine_step.hpp"
#include "rigidformer/geometry/nearest_points.hpp"
#include "rigidformer/model/checkpoint.hpp"
#include "rigidformer/model/device.hpp"
#include "rigidformer/model/nearest.hpp"
#include "rigidformer/model/rest.hpp"
#include "rigidformer/model/scene_input.hpp"
#include "rigidformer/model/threads.hpp"

namespace rigidformer {
namespace {

constexpr int kMaxObjects = 256;
constexpr double kTimeStepTolerance = 1e-6;  // [s]

/// Nearest points from one search tree per rigid object, for the CPU.
NearestSearch tree_search(const SceneInput& input) {
  auto trees = std::make_shared<NearestPoints>(input.clouds);
  auto found = std::make_shared<std::vector<NearestNeighbors>>();
  const auto origin_at_zero = std::make_shared<SceneInput>();
  origin_at_zero->origin_world.setZero();
  return [=](const SceneBatch& batch, const Pose& current, const Tensor&) {
    const int64_t K = batch.max_objects(), N = batch.max_points();
    trees->query(to_world(*origin_at_zero, current), *found);
    Nearest nearest{torch::zeros({1, K, N}, torch::kInt64), torch::zeros({1, K, N}, torch::kBool)};
    auto index = nearest.index.accessor<int64_t, 3>();
    auto valid = nearest.found.accessor<bool, 3>();
    for (int64_t k = 0; k < K; ++k) {
      const NearestNeighbors& neighbors = (*found)[static_cast<size_t>(k)];
      for (size_t i = 0; i < neighbors.object.size(); ++i) {
        if (neighbors.object[i] < 0) continue;
        index[0][k][static_cast<int64_t>(i)] = neighbors.object[i] * N + neighbors.point[i];
        valid[0][k][static_cast<int64_t>(i)] = true;
      }
    }
    return nearest;
  };
}

SceneBatch to_device(SceneBatch batch, const torch::Device& device) {
  for (Tensor* tensor :
       {&batch.points_reference, &batch.point_mask, &batch.object_mask, &batch.anchor_index, &batch.properties,
        &batch.properties_known, &batch.dynamic_mask, &batch.step_size, &batch.ground_height, &batch.gravity}) {
    *tensor = tensor->to(device);
  }
  return batch;
}

Pose to_device(const Pose& pose, const torch::Device& device) {
  return {pose.rotation.to(device), pose.translation.to(device)};
}

bool is_finite(const RigidTransform& T) { return T.translation.allFinite() && T.rotation.coeffs().allFinite(); }

/// Two clouds that fall: something to warm up with.
std::vector<ObjectState> warm_up_scene() {
  std::vector<ObjectState> objects(2);
  for (size_t i = 0; i < objects.size(); ++i) {
    objects[i].id = "warm_up_" + std::to_string(i);
    objects[i].points_reference = Points::Random(128, 3);
    objects[i].T_world_current.translation = {3.0 * static_cast<double>(i), 0.0, 3.0};
    objects[i].T_world_previous = objects[i].T_world_current;
  }
  return objects;
}

/// A forecast that holds the observation and all times, but no step yet.
Forecast start_forecast(const std::vector<ObjectState>& objects, const RolloutOptions& rollout) {
  Forecast forecast;
  for (int step = 0; step <= rollout.num_steps; ++step) forecast.times_s.push_back(step * rollout.time_step_s);
  for (const ObjectState& object : objects) {
    forecast.objects.push_back({object.id, ObjectForecast::Status::kOk, {object.T_world_current}});
  }
  return forecast;
}

/// A diverged object stays where it was last finite, so that the others can go on around it.
void freeze(SceneBatch& batch, const SceneState& last, SceneState& next, int64_t k) {
  batch.dynamic_mask[0][k] = false;
  for (const Pose& pose : {next.current, next.previous}) {
    Tensor rotation = pose.rotation[0][k], translation = pose.translation[0][k];
    rotation.copy_(last.current.rotation[0][k]);
    translation.copy_(last.current.translation[0][k]);
  }
}

/// Appends the poses of one step to the forecast.
void record(const SceneInput& input, const SceneState& last, SceneState& next, SceneBatch& batch, Forecast& forecast) {
  const std::vector<RigidTransform> T_world = to_world(input, next.current);
  for (size_t k = 0; k < T_world.size(); ++k) {
    ObjectForecast& object = forecast.objects[k];
    if (object.status == ObjectForecast::Status::kOk && is_finite(T_world[k])) {
      object.poses.push_back(T_world[k]);
    } else {
      object.status = ObjectForecast::Status::kDiverged;
      object.poses.push_back(object.poses.back());
      freeze(batch, last, next, static_cast<int64_t>(k));
    }
  }
}

}  // namespace

struct Predictor::Impl {
  explicit Impl(const PredictorOptions& predictor_options);

  void check(const std::vector<ObjectState>& objects, const RolloutOptions& rollout) const;
  void describe();

  PredictorOptions options;
  torch::Device device{torch::kCPU};
  Checkpoint checkpoint;
  ModelInfo info;
};

Predictor::Impl::Impl(const PredictorOptions& predictor_options) : options(predictor_options) {
  if (options.precision != "float32" && options.precision != "bfloat16") {
    throw std::invalid_argument("precision is '" + options.precision + "', must be float32 or bfloat16");
  }
  if (options.num_threads < 1) {
    throw std::invalid_argument("num_threads is " + std::to_string(options.num_threads) + ", must be at least 1");
  }
  if (options.max_points < 16) {
    throw std::invalid_argument("max_points is " + std::to_string(options.max_points) + ", must be at least 16");
  }
  if (!(options.rest_speed >= 0.0 && options.rest_spin >= 0.0)) {
    throw std::invalid_argument("rest_speed is " + std::to_string(options.rest_speed) + " and rest_spin " +
                                std::to_string(options.rest_spin) + ", must not be negative");
  }
  if (!(options.engine_share <= 1.0)) {
    throw std::invalid_argument("engine_share is " + std::to_string(options.engine_share) + ", must be at most 1");
  }
  set_num_threads(options.num_threads);
  keep_freed_memory();
  device = select_device(options.device);
  checkpoint = load_checkpoint(options.file);
  RigidFormer& model = checkpoint.model;
  model->eval();
  model->to(device);
  if (options.engine_share >= 0.0) model->fixed_engine_share = options.engine_share;
  if (options.precision == "bfloat16") {
    model->set_compute_type(torch::kBFloat16);
    for (torch::nn::Module* part :
         {static_cast<torch::nn::Module*>(model->encoder.get()), static_cast<torch::nn::Module*>(model->decoder.get()),
          static_cast<torch::nn::Module*>(model->anchor_vertex_pooling.get()),
          static_cast<torch::nn::Module*>(model->predictor.get())}) {
      part->to(torch::kBFloat16);
    }
  }
  describe();
}

void Predictor::Impl::describe() {
  const TrainingFacts& facts = checkpoint.facts;
  info.id = "rigidformer-" + checkpoint.model->options.preset;
  info.sha256 = checkpoint.sha256;
  info.device = device.str();
  info.precision = options.precision;
  info.num_parameters = count_parameters(*checkpoint.model);
  info.min_time_step_s = facts.min_step_frames / kFrameRateHz;
  info.max_time_step_s = facts.max_step_frames / kFrameRateHz;
  info.min_size_m = facts.min_diameter_m;
  info.max_size_m = facts.max_diameter_m;
  info.max_speed_mps = facts.max_speed_mps;
  info.max_objects = kMaxObjects;
  info.max_points = options.max_points;
}

void Predictor::Impl::check(const std::vector<ObjectState>& objects, const RolloutOptions& rollout) const {
  validate_scene(objects, rollout);
  if (objects.size() > static_cast<size_t>(info.max_objects)) {
    throw std::invalid_argument("the scene has " + std::to_string(objects.size()) + " objects, at most " +
                                std::to_string(info.max_objects) + " are allowed");
  }
  if (rollout.time_step_s < info.min_time_step_s - kTimeStepTolerance ||
      rollout.time_step_s > info.max_time_step_s + kTimeStepTolerance) {
    throw std::invalid_argument("time_step_s is " + std::to_string(rollout.time_step_s) +
                                ", the model was trained for " + std::to_string(info.min_time_step_s) + " to " +
                                std::to_string(info.max_time_step_s) + " s");
  }
}

Predictor::Predictor(const PredictorOptions& options) : impl_(std::make_unique<Impl>(options)) {}
Predictor::Predictor() = default;
Predictor::~Predictor() = default;

const ModelInfo& Predictor::info() const { return impl_->info; }

void Predictor::warm_up() {
  RolloutOptions rollout;
  rollout.num_steps = 2;
  rollout.time_step_s = impl_->info.max_time_step_s;
  for (int run = 0; run < impl_->options.warmup_runs; ++run) predict(warm_up_scene(), rollout);
}

Forecast Predictor::predict(const std::vector<ObjectState>& objects, const RolloutOptions& rollout) {
  const auto start = std::chrono::steady_clock::now();
  torch::NoGradGuard no_grad;
  impl_->check(objects, rollout);
  Forecast forecast = start_forecast(objects, rollout);
  if (objects.empty()) return forecast;

  RigidFormer& model = impl_->checkpoint.model;
  const torch::Device& device = impl_->device;
  const SceneInput input = make_scene_input(objects, rollout, model->options, impl_->options.max_points);
  const NearestSearch nearest = device.is_cpu() ? tree_search(input) : NearestSearch(nearest_by_distance_matrix);
  SceneBatch batch = to_device(input.batch, device);
  SceneState state{to_device(input.state.first, device), to_device(input.state.previous, device),
                   to_device(input.state.current, device)};
  const Tensor centre = model->centre_of_mass(batch, state.current);
  batch.hidden_points = model->hidden_side(batch, state.current, centre);
  const EngineStep engine = make_engine_step(model->options, batch, centre);
  const RestLimits rest{impl_->options.rest_speed, impl_->options.rest_spin};
  for (int step = 0; step < rollout.num_steps; ++step) {
    SceneState next = advance(batch, state, model->forward(batch, state, centre, nearest, engine));
    if (rest.speed_mps > 0.0) hold_resting(batch, state, next, rest);
    record(input, state, next, batch, forecast);
    state = next;
  }
  forecast.compute_time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return forecast;
}

}  // namespace rigidformer
