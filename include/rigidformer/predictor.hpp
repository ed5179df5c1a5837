// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rigidformer/candidates.hpp"
#include "rigidformer/rollout.hpp"
#include "rigidformer/scene/object.hpp"
#include "rigidformer/scene/rollout_options.hpp"

namespace rigidformer {

/// How to run a model. Field names are the YAML keys under `model:`.
struct PredictorOptions {
  std::string file;                   ///< Checkpoint (*.safetensors) to load
  std::string device = "auto";        ///< auto | cpu | cuda | cuda:N; auto = CUDA when usable, else CPU
  std::string precision = "float32";  ///< float32 | bfloat16
  int num_threads = 1;                ///< CPU threads for tensor operations
  int max_points = 0;                 ///< Points per object the network looks at, at least 16; 0 = as the model says
  int warmup_runs = 2;                ///< Dummy predictions made by warm_up()
  double rest_speed = -1.0;           ///< [m/s] what is and would stay slower than this (0 = never) ...
  double rest_spin = -1.0;            ///< [rad/s] ... and this is held still; negative = as the model says
  double engine_share = -1.0;         ///< Share of the physics engine's step, in [0, 1]; negative = as learned
};

/// What a loaded model is and where it can be trusted.
struct ModelInfo {
  std::string id;      ///< Names of preset and training
  std::string sha256;  ///< Hash of the checkpoint's tensors
  std::string device;  ///< Device that the model runs on
  std::string precision;
  std::int64_t num_parameters = 0;
  double min_time_step_s = 0.0, max_time_step_s = 0.0;  ///< Range of time steps that it was trained on
  double min_size_m = 0.0, max_size_m = 0.0;            ///< Range of object diameters that it was trained on
  double max_speed_mps = 0.0;                           ///< Highest speed of points that it was trained on
  int max_objects = 0;                                  ///< Most objects per call
  int max_points = 0;   ///< Points per object that the network looks at; more are thinned
  int control_dim = 0;  ///< Numbers of the command that every step needs (App. I); 0 = none
  /// Steps of a scene of ten objects per second and thread, by Fidelity, as measured by warm_up(); 0 = not measured
  double model_steps_per_s = 0.0, engine_steps_per_s = 0.0;
};

/// Loads a RigidFormer checkpoint and rolls scenes out. Torch stays hidden behind the implementation.
/// Not thread safe: call it from one thread.
class Predictor {
 public:
  /// Throws std::runtime_error (file: missing, truncated, foreign, tampered; device not usable) or
  /// std::invalid_argument (options), naming field and value.
  explicit Predictor(const PredictorOptions& options);
  virtual ~Predictor();
  Predictor(const Predictor&) = delete;
  Predictor& operator=(const Predictor&) = delete;

  /// Runs dummy predictions so that the first real one is as fast as the rest.
  virtual void warm_up();

  /// Rolls all objects out together (paper §3). Throws std::invalid_argument naming the option at fault.
  /// Objects whose prediction stops being finite get Status::kDiverged and keep their last finite pose. Objects that
  /// cannot be predicted get Status::kUnusable with the reason, and the others the forecast that they have without
  /// them: those to which there is an objection (scene/objection.hpp), whose id came before, or that are more than the
  /// model takes. Where that leaves none of a scene, std::invalid_argument tells the reasons. An empty scene gives an
  /// empty forecast.
  virtual Forecast predict(const std::vector<ObjectState>& objects, const RolloutOptions& rollout);

  /// Begins a rollout that goes on in pieces: nothing is predicted before the first
  /// advance(). Throws what predict() throws.
  virtual std::unique_ptr<Rollout> start(const std::vector<ObjectState>& objects, const RolloutOptions& rollout);

  /// Begins the rollouts of many candidates of one scene, which is perceived once. The outcome of a candidate without
  /// changes is the forecast of start(), to the byte. Throws what start() throws for the scene and for what holds for
  /// all candidates; what is wrong with one of them is told in its outcome. Throws std::invalid_argument for a scene
  /// without objects, and std::runtime_error for Fidelity::kEngine where Bullet was not there at build time.
  virtual std::unique_ptr<BatchRollout> start_batch(const std::vector<ObjectState>& objects,
                                                    const std::vector<Candidate>& candidates,
                                                    const BatchOptions& options);

  virtual const ModelInfo& info() const;

 protected:
  Predictor();  ///< For test doubles, which load no model.

 private:
  struct Impl;
  double steps_per_s(Fidelity fidelity);

  std::unique_ptr<Impl> impl_;
};

}  // namespace rigidformer
