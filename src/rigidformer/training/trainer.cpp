// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/trainer.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "rigidformer/data/scene_loader.hpp"
#include "rigidformer/model/checkpoint.hpp"
#include "rigidformer/model/cost.hpp"
#include "rigidformer/model/device.hpp"
#include "rigidformer/model/nearest.hpp"
#include "rigidformer/model/tensor_conversion.hpp"
#include "rigidformer/model/threads.hpp"
#include "rigidformer/model/weight_transfer.hpp"
#include "rigidformer/training/losses.hpp"
#include "rigidformer/training/optimizer.hpp"
#include "rigidformer/training/process_group.hpp"
#include "rigidformer/training/run_log.hpp"
#include "rigidformer/training/training_data.hpp"
#include "rigidformer/training/validation.hpp"
#include "rigidformer/training/window_loader.hpp"

namespace rigidformer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kBackwardCost = 2.0;  // forward passes; gradients of inputs and of weights cost one each

/// The device of a process: with several processes per machine, each takes the GPU of its number.
torch::Device device_of(const std::string& name, const ProcessPlace& place) {
  const torch::Device device = select_device(name);
  if (!device.is_cuda() || device.index() >= 0 || place.size == 1) return device;
  return select_device("cuda:" + std::to_string(place.local_rank));
}

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The state of a run, with everything that it needs to go on, and the loop over iterations.
class Trainer {
 public:
  Trainer(const TrainingOptions& options, const TrainingPaths& paths, const TrainingMachine& machine);
  void run();

 private:
  void load_weights();
  void measure_peak();
  void learn_once(LogEntry& entry);
  void add_gradient(std::int64_t micro_batch, int unroll_steps);
  BatchRequest request_after(std::int64_t micro_batch) const;
  void log(LogEntry entry);
  void validate();
  void save();
  void restore();
  void synchronise();
  int unroll_steps(std::int64_t iteration) const;
  double progress(std::int64_t iteration) const {
    return static_cast<double>(iteration) / static_cast<double>(options_.iterations);
  }

  TrainingOptions options_;
  TrainingPaths paths_;
  TrainingMachine machine_;
  ProcessPlace place_;
  torch::Device device_;
  ProcessGroup group_;
  TrainingData data_;
  std::unique_ptr<WindowLoader> loader_;
  RigidFormer model_{nullptr};
  std::unique_ptr<FlatAdamW> optimizer_;
  std::unique_ptr<RunLog> log_;
  std::int64_t iteration_ = 0, windows_ = 0, windows_logged_ = 0;
  Clock::time_point last_log_;
  Tensor loss_sum_, norm_sum_;
  double matrix_peak_ = 0.0, multiply_adds_ = 0.0;  ///< Per second; the latter by this process since the last log line
};

Trainer::Trainer(const TrainingOptions& options, const TrainingPaths& paths, const TrainingMachine& machine)
    : options_(options),
      paths_(paths),
      machine_(machine),
      place_(read_process_place(&std::getenv)),
      device_(device_of(machine.device, place_)),
      group_(place_, device_) {
  if (options.micro_batches % group_.size() != 0) {
    throw std::invalid_argument("micro_batches is " + std::to_string(options.micro_batches) +
                                ", must be a multiple of the " + std::to_string(group_.size()) + " processes");
  }
  use_vector_units();
  set_num_threads(machine.num_threads);
  keep_freed_memory();
  std::filesystem::create_directories(paths.output);
  data_ = load_training_data(paths, options, device_);
  if (group_.is_first()) std::cerr << data_.summary << "device " << device_ << '\n';
  load_weights();
  loader_ = std::make_unique<WindowLoader>(data_, options_);
  optimizer_ = std::make_unique<FlatAdamW>(*model_, options_.optimizer);
  if (machine.resume && group_.is_first()) restore();
  synchronise();
  if (group_.is_first()) log_ = std::make_unique<RunLog>(paths.output, options_.iterations, machine.resume);
  loss_sum_ = torch::zeros({}, device_);
  norm_sum_ = torch::zeros({}, device_);
  measure_peak();
}

void Trainer::measure_peak() {
  const auto type = options_.precision == "bfloat16" ? torch::kBFloat16 : torch::kFloat32;
  matrix_peak_ = measure_matrix_peak(device_, type);
  if (!group_.is_first()) return;
  std::cerr << "matrix products of " << options_.precision << ": " << static_cast<std::int64_t>(2e-9 * matrix_peak_)
            << " GFLOP/s on this device\n";
}

void Trainer::load_weights() {
  torch::manual_seed(options_.seed);
  model_ = RigidFormer(options_.model);
  if (!paths_.initial_model.empty()) transfer_weights(paths_.initial_model, model_);
  if (options_.precision == "bfloat16") model_->set_compute_type(torch::kBFloat16);
  model_->to(device_);
  model_->train();
  if (group_.is_first()) {
    std::cerr << "model " << options_.model.preset << ": " << count_parameters(*model_) << " parameters\n";
  }
}

int Trainer::unroll_steps(std::int64_t iteration) const {
  int steps = 1;
  for (const UnrollStage& stage : options_.unroll) {
    if (progress(iteration) >= stage.from) steps = stage.steps;
  }
  return steps;
}

/// Names the micro-batch that this process computes after this one.
BatchRequest Trainer::request_after(std::int64_t micro_batch) const {
  std::int64_t next = micro_batch + group_.size();
  if (next / options_.micro_batches > iteration_) next = (iteration_ + 1) * options_.micro_batches + group_.rank();
  return {next, unroll_steps(next / options_.micro_batches)};
}

void Trainer::add_gradient(std::int64_t micro_batch, int unroll_steps) {
  // All randomness of a micro-batch follows from its number, so that a resumed run repeats the uninterrupted one, and
  // several processes do what one would do.
  torch::manual_seed(options_.seed * 1000003 + static_cast<std::uint64_t>(micro_batch));
  const WindowBatch batch = loader_->take({micro_batch, unroll_steps}, request_after(micro_batch));
  const Tensor loss = window_loss(options_.loss, model_, batch, nearest_by_distance_matrix) / options_.micro_batches;
  loss.backward();
  loss_sum_ += loss.detach();
  multiply_adds_ += (1.0 + kBackwardCost) * static_cast<double>(options_.batch_size * unroll_steps) *
                    multiply_adds(model_, batch.scene.max_objects(), batch.scene.max_points());
}

void Trainer::learn_once(LogEntry& entry) {
  entry.unroll_steps = unroll_steps(iteration_);
  optimizer_->zero_gradient();
  for (int i = group_.rank(); i < options_.micro_batches; i += group_.size()) {
    add_gradient(iteration_ * options_.micro_batches + i, entry.unroll_steps);
  }
  group_.sum(optimizer_->gradient());
  entry.learning_rate = learning_rate_at(options_.optimizer, progress(iteration_));
  norm_sum_ += optimizer_->step(entry.learning_rate);
  windows_ += options_.batch_size * options_.micro_batches;
  entry.iteration = ++iteration_;
}

void Trainer::log(LogEntry entry) {
  const auto iterations =
      static_cast<double>((windows_ - windows_logged_) / (options_.batch_size * options_.micro_batches));
  group_.sum(loss_sum_);
  entry.loss = loss_sum_.item<double>() / iterations;
  entry.gradient_norm = norm_sum_.item<double>() / iterations;
  const double elapsed_s = seconds_since(last_log_);
  entry.windows_per_s = static_cast<double>(windows_ - windows_logged_) / elapsed_s;
  entry.share_of_peak = multiply_adds_ / elapsed_s / matrix_peak_;
  if (log_) log_->write(entry);
  loss_sum_.zero_();
  norm_sum_.zero_();
  multiply_adds_ = 0.0;
  windows_logged_ = windows_;
  last_log_ = Clock::now();
  if (!std::isfinite(entry.loss)) {
    throw std::runtime_error("training diverged: the loss is not finite at iteration " +
                             std::to_string(entry.iteration) + "; lower optimizer.learning_rate");
  }
}

void Trainer::validate() {
  if (!group_.is_first()) return;
  optimizer_->swap_average();
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << "validation at iteration " << iteration_
       << " (s = 10, frame 100; position m / orientation deg, ballistic in brackets)\n";
  for (const auto& [name, tensors] : data_.validation) {
    text << "  " << name << ':';
    for (const RolloutScore& score : validate_rollouts(model_, tensors, options_.validation_scenes, {})) {
      text << "  start " << score.start_frame << ' ' << score.position_m << '/' << std::setprecision(1)
           << score.orientation_deg << std::setprecision(3) << " [" << score.ballistic_position_m << '/'
           << std::setprecision(1) << score.ballistic_orientation_deg << std::setprecision(3) << ']';
    }
    text << '\n';
  }
  for (const auto& [kind, windows] : data_.validation_windows) {
    const OneStepScore score = one_step_error(model_, data_.validation.front().second, windows, 256);
    text << "  one step, " << kind << ": " << std::setprecision(4) << score.model_m << " m (base motion "
         << score.base_m << " m)\n";
  }
  optimizer_->swap_average();
  if (!data_.validation.empty()) log_->note(text.str());
}

void Trainer::save() {
  if (!group_.is_first()) return;
  TensorFile state;
  for (const auto& [name, tensor] : optimizer_->state()) {
    state.tensors.emplace(name, to_raw(tensor, TensorType::kFloat32));
  }
  state.metadata = {{"format", "rigidformer-training-state"},
                    {"iteration", std::to_string(iteration_)},
                    {"windows", std::to_string(windows_)},
                    {"optimizer_steps", std::to_string(optimizer_->num_steps)},
                    {"model", to_json(options_.model)}};
  write_tensor_file(paths_.output / "state.safetensors", state);

  TrainingFacts facts = data_.facts;
  facts.iterations = iteration_;
  facts.windows = windows_;
  facts.seed = options_.seed;
  facts.source_revision = RIGIDFORMER_SOURCE_REVISION;
  facts.min_points = options_.augmentation.min_points;
  facts.max_points = options_.augmentation.max_points;
  optimizer_->swap_average();
  save_checkpoint(paths_.output / "model.safetensors", model_, facts);
  save_checkpoint(paths_.output / "model_bfloat16.safetensors", model_, facts, TensorType::kBFloat16);
  optimizer_->swap_average();
}

void Trainer::restore() {
  const std::filesystem::path file = paths_.output / "state.safetensors";
  const TensorFile state = read_tensor_file(file);
  if (!is_same_network(model_options_from_json(state.metadata.at("model")), options_.model)) {
    throw std::runtime_error("'" + file.string() + "' was written for other model options; use another --out");
  }
  torch::NoGradGuard no_grad;
  for (auto& [name, tensor] : optimizer_->state()) tensor.copy_(from_raw(state.tensors.at(name)));
  iteration_ = std::stoll(state.metadata.at("iteration"));
  windows_ = windows_logged_ = std::stoll(state.metadata.at("windows"));
  optimizer_->num_steps = std::stoll(state.metadata.at("optimizer_steps"));
}

/// Gives every process the state of the first one.
void Trainer::synchronise() {
  for (auto& [name, tensor] : optimizer_->state()) group_.copy_from_first(tensor);
  Tensor counters = torch::tensor({iteration_, windows_, optimizer_->num_steps}, torch::kInt64);
  group_.copy_from_first(counters);
  iteration_ = counters[0].item<std::int64_t>();
  windows_ = windows_logged_ = counters[1].item<std::int64_t>();
  optimizer_->num_steps = counters[2].item<std::int64_t>();
}

void Trainer::run() {
  const Clock::time_point start = Clock::now();
  Clock::time_point last_save = start, last_validation = start;
  last_log_ = start;
  const auto must_stop = [&] {
    const bool has_limit = machine_.max_minutes > 0.0;
    const bool is_late = has_limit && seconds_since(start) > 60.0 * machine_.max_minutes;
    const bool is_asked = machine_.should_stop && machine_.should_stop();
    return (has_limit || machine_.should_stop) && group_.any(is_late || is_asked);
  };
  while (iteration_ < options_.iterations && !must_stop()) {
    LogEntry entry;
    learn_once(entry);
    if (iteration_ % options_.log_every == 0) log(entry);
    if (seconds_since(last_save) > options_.checkpoint_every_s) {
      save();
      last_save = Clock::now();
    }
    if (seconds_since(last_validation) > options_.validate_every_s) {
      validate();
      last_validation = Clock::now();
    }
  }
  save();
  validate();
  if (log_) log_->plot();
}

}  // namespace

void train(const TrainingOptions& options, const TrainingPaths& paths, const TrainingMachine& machine) {
  Trainer(options, paths, machine).run();
}

}  // namespace rigidformer
