// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/predictor.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "rigidformer/candidate_batch.hpp"
#include "rigidformer/engine/engine_step.hpp"
#include "rigidformer/model/checkpoint.hpp"
#include "rigidformer/model/command.hpp"
#include "rigidformer/model/device.hpp"
#include "rigidformer/model/threads.hpp"
#include "rigidformer/network_rollout.hpp"
#include "rigidformer/particle_batch.hpp"
#include "rigidformer/particles.hpp"
#include "rigidformer/usable_rollout.hpp"

namespace rigidformer {
namespace {

constexpr int kMaxObjects = 256;             // per call; as many as position_encoding.cpp can number
constexpr int kMeasuredObjects = 10;         // of the scene that tells the steps per second
constexpr int kMeasuredSteps = 24;           // of it at most; chosen by eye
constexpr double kMeasuringBudget_s = 0.3;   // for each fidelity; chosen by eye
constexpr double kTimeStepTolerance = 1e-6;  // [s] a time step rounded to microseconds is still in range

/// A command for models that want one; empty for others.
std::vector<std::vector<double>> no_command(const ModelInfo& info) {
  if (info.control_dim == 0) return {};
  return {std::vector<double>(static_cast<size_t>(info.control_dim), 0.0)};
}

/// Clouds that fall: a scene to warm up with.
std::vector<ObjectState> warm_up_scene(int num_objects) {
  std::vector<ObjectState> objects(static_cast<size_t>(num_objects));
  for (size_t i = 0; i < objects.size(); ++i) {
    objects[i].id = "warm_up_" + std::to_string(i);
    objects[i].points_reference = Points::Random(256, 3);
    objects[i].T_world_current.translation = {3.0 * static_cast<double>(i / 2), 0.0, 1.0 + 2.0 * (i % 2)};
    objects[i].T_world_previous = objects[i].T_world_current;
  }
  return objects;
}

/// Stores the matrices of the linear layers by columns. The linear-algebra library copies them at every multiplication,
/// and it copies this order with vector instructions. The numbers stay the same.
void store_by_columns(RigidFormer& model) {
  torch::NoGradGuard no_grad;
  for (Tensor& parameter : model->parameters()) {
    if (parameter.dim() == 2) parameter.set_data(parameter.t().contiguous().t());
  }
}

/// The rollout of a scene without objects, in which only time passes.
class EmptyRollout : public Rollout {
 public:
  explicit EmptyRollout(double time_step_s) : time_step_s_(time_step_s) { forecast_.times_s.push_back(0.0); }

  const Forecast& advance(int num_steps) override {
    for (int i = 0; i < num_steps; ++i) {
      forecast_.times_s.push_back(static_cast<double>(forecast_.times_s.size()) * time_step_s_);
    }
    return forecast_;
  }

 private:
  double time_step_s_;
  Forecast forecast_;
};

}  // namespace

struct Predictor::Impl {
  explicit Impl(const PredictorOptions& predictor_options);

  void check(const RolloutOptions& rollout) const;
  void ask_model(const ModelOptions& model);
  void describe();
  StepMaker step_maker() const {
    return {checkpoint.model, {options.rest_speed, options.rest_spin}, Fidelity::kModel, checkpoint.facts.doubt};
  }

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
  if (options.max_points != 0 && options.max_points < 16) {
    throw std::invalid_argument("max_points is " + std::to_string(options.max_points) +
                                ", must be at least 16, or 0 for what the model says");
  }
  if (std::isnan(options.rest_speed) || std::isnan(options.rest_spin)) {
    throw std::invalid_argument("rest_speed is " + std::to_string(options.rest_speed) + " and rest_spin " +
                                std::to_string(options.rest_spin) + ", must be numbers");
  }
  if (!(options.engine_share <= 1.0)) {
    throw std::invalid_argument("engine_share is " + std::to_string(options.engine_share) + ", must be at most 1");
  }
  use_vector_units();
  set_num_threads(options.num_threads);
  keep_freed_memory();
  device = select_device(options.device);
  checkpoint = load_checkpoint(options.file);
  RigidFormer& model = checkpoint.model;
  ask_model(model->options);
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
  if (device.is_cpu()) store_by_columns(model);
  describe();
}

/// What the caller leaves open is what the model was made for.
void Predictor::Impl::ask_model(const ModelOptions& model) {
  if (options.max_points == 0) options.max_points = model.max_points;
  if (options.rest_speed < 0.0) options.rest_speed = model.rest_speed_mps;
  if (options.rest_spin < 0.0) options.rest_spin = model.rest_spin_radps;
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
  info.control_dim = checkpoint.model->options.control_dim;
}

void Predictor::Impl::check(const RolloutOptions& rollout) const {
  validate_options(rollout);
  check_commands(rollout, info.control_dim);
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
  rollout.control = no_command(impl_->info);
  for (int run = 0; run < impl_->options.warmup_runs; ++run) predict(warm_up_scene(2), rollout);
  if (impl_->options.warmup_runs == 0) return;
  impl_->info.model_steps_per_s = steps_per_s(Fidelity::kModel);
  if (has_physics_engine()) impl_->info.engine_steps_per_s = steps_per_s(Fidelity::kEngine);
}

double Predictor::steps_per_s(Fidelity fidelity) {
  BatchOptions options;
  options.rollout.num_steps = kMeasuredSteps;
  options.rollout.time_step_s = impl_->info.max_time_step_s;
  options.rollout.control = no_command(impl_->info);
  options.fidelity = fidelity;
  const auto rollout = start_batch(warm_up_scene(kMeasuredObjects), {Candidate()}, options);
  rollout->advance(kMeasuringBudget_s);
  const Forecast& forecast = rollout->outcomes().front().forecast;
  return static_cast<double>(forecast.times_s.size() - 1) / forecast.compute_time_s;
}

Forecast Predictor::predict(const std::vector<ObjectState>& objects, const RolloutOptions& rollout) {
  return start(objects, rollout)->advance(rollout.num_steps);
}

std::unique_ptr<Rollout> Predictor::start(const std::vector<ObjectState>& objects, const RolloutOptions& rollout) {
  impl_->check(rollout);
  if (objects.empty()) return std::make_unique<EmptyRollout>(rollout.time_step_s);
  const int max_points = impl_->options.max_points;
  return start_usable(objects, impl_->info.max_objects, [&](const std::vector<ObjectState>& usable) {
    return std::make_unique<NetworkRollout>(impl_->step_maker(), impl_->device, max_points, usable, rollout);
  });
}

std::unique_ptr<BatchRollout> Predictor::start_batch(const std::vector<ObjectState>& objects,
                                                     const std::vector<Candidate>& candidates,
                                                     const BatchOptions& options) {
  if (!impl_) throw std::runtime_error("this predictor knows no candidates");  // a test double
  impl_->check(options.rollout);
  const Perceive perceive_objects = [&](const std::vector<ObjectState>& some) {
    c10::InferenceMode inference;
    return perceive(impl_->checkpoint.model, impl_->device, impl_->options.max_points, some, options.rollout);
  };
  std::vector<ObjectState> usable;
  std::optional<PerceivedObjects> scene;
  const auto reasons = take_usable(objects, impl_->info.max_objects, [&](const std::vector<ObjectState>& some) {
    usable = some;
    scene = perceive_objects(some);
  });
  if (options.fidelity == Fidelity::kEngine && !has_physics_engine()) {
    throw std::runtime_error("the physics engine is not built in: install libbullet-dev and build again");
  }
  std::vector<ObjectTrajectory> unusable;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    if (!reasons[k]) continue;
    unusable.push_back({objects[k].id, ObjectTrajectory::Status::kUnusable, {objects[k].T_world_current}, *reasons[k]});
  }
  const auto batch_of = [&](const std::vector<Candidate>& some, const BatchOptions& some_options) {
    return std::make_unique<CandidateBatch>(impl_->step_maker(), perceive_objects, *scene, usable, unusable, some,
                                            some_options, impl_->info.max_objects);
  };
  auto nominal = batch_of(candidates, options);
  if (options.rollout.num_particles == 1) return nominal;
  BatchOptions of_particles = options;
  of_particles.fidelity = maker_of_particles(impl_->step_maker()).fidelity;
  auto particles = batch_of(in_all_worlds(candidates, usable, options.rollout), of_particles);
  return std::make_unique<ParticleBatch>(std::move(nominal), std::move(particles), options,
                                         impl_->checkpoint.facts.doubt);
}

}  // namespace rigidformer
