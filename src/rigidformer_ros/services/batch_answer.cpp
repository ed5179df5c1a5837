// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/services/batch_answer.hpp"

#include <ros/console.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "rigidformer_ros/messages/conversions.hpp"
#include "rigidformer_ros/services/candidate_rollout.hpp"
#include "rigidformer_ros/services/request_error.hpp"
#include "rigidformer_ros/services/rollout_command.hpp"

namespace rigidformer_ros {

namespace {

using rigidformer::CandidateOutcome;
using Codes = PredictRollout::Response;
using Clock = BatchRun::Clock;

BatchResult failure(std::int32_t code, const std::string& message) {
  BatchResult result;
  result.error_code = code;
  result.message = message;
  return result;
}

/// One request while its candidates are under way.
class BatchInProgress {
 public:
  BatchInProgress(const BatchRequest& request, ReadCandidates read, const RolloutTask& task,
                  std::unique_ptr<BegunBatch> begun)
      : request_(request),
        read_(std::move(read)),
        task_(task),
        begun_(std::move(begun)),
        settings_{*begun_, request_, task.selection.record_every, task.settings.settle, read_.regions},
        is_told_(read_.candidates.size(), false) {}

  /// Takes all steps, unless there is a reason to stop earlier.
  void run(Clock::time_point limit, const BatchWatcher& watcher) {
    while (!read_.candidates.empty() && begun_->run.is_running()) {
      if (watcher.is_cancelled()) {
        return end(CandidateResult::STOP_PREEMPTED, Codes::PREEMPTED, "the goal was preempted");
      }
      if (Clock::now() >= limit) {
        return end(CandidateResult::STOP_WALL_TIME, Codes::TIMED_OUT,
                   "max_wall_time: " + std::to_string(task_.settings.max_wall_time_s) + " s passed");
      }
      begun_->run.advance(std::min(limit, Clock::now() + kLook));
      watcher.tell(progress());
    }
  }

  BatchResult result(const std::string& fixed_frame) const;

 private:
  static constexpr std::chrono::milliseconds kLook{100};  // how soon a cancellation is seen; chosen by eye

  void end(std::uint8_t stop_reason, std::int32_t code, const std::string& message) {
    unfinished_ = {stop_reason, code, message};
  }

  CandidateResult result_of(std::size_t i) const {
    return to_result(begun_->run.outcomes()[i], read_.candidates[i], settings_, unfinished_);
  }

  BatchProgress progress() {
    BatchProgress progress;
    const std::vector<CandidateOutcome>& outcomes = begun_->run.outcomes();
    progress.num_steps = progress.steps_done = task_.settings.options.num_steps;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      if (outcomes[i].stop == CandidateOutcome::Stop::kRunning) {
        const int steps = std::max(1, static_cast<int>(outcomes[i].forecast.times_s.size())) - 1;
        progress.steps_done = std::min(progress.steps_done, steps);
        continue;
      }
      ++progress.num_done;
      if (!is_told_[i]) {
        is_told_[i] = true;
        progress.indices.push_back(static_cast<std::uint32_t>(read_.indices[i]));
        progress.results.push_back(result_of(i));
      }
    }
    return progress;
  }

  void fill_scene(BatchResult& result, const std::string& fixed_frame) const;

  const BatchRequest& request_;
  ReadCandidates read_;
  RolloutTask task_;
  std::unique_ptr<BegunBatch> begun_;
  ResultSettings settings_;
  std::vector<bool> is_told_;
  Unfinished unfinished_;
};

void BatchInProgress::fill_scene(BatchResult& result, const std::string& fixed_frame) const {
  const ObservedScene& scene = begun_->scene;
  result.header.frame_id = fixed_frame;
  result.header.stamp = to_ros_time(scene.stamp);
  result.time_step = scene.time_step_s;
  result.model_id = model_label(begun_->model);
  const int num_steps = task_.settings.options.num_steps;
  const int every = request_.record == BatchRequest::POSES ? task_.selection.record_every : num_steps;
  for (int k = 0; k <= num_steps; k += every) {
    result.times.push_back(k * scene.time_step_s);
  }
  for (const ObservedObject& object : scene.objects) {
    result.object_ids.push_back(object.state.id);
  }
  for (const rigidformer::SkippedObject& skipped : scene.skipped) {
    result.skipped_ids.push_back(skipped.id);
    result.skip_reasons.push_back(skipped.reason);
  }
  for (const rigidformer::ObjectTrajectory& object : begun_->run.unusable()) {
    result.skipped_ids.push_back(object.id);
    result.skip_reasons.push_back(object.reason);
    result.object_ids.erase(std::remove(result.object_ids.begin(), result.object_ids.end(), object.id),
                            result.object_ids.end());
  }
}

BatchResult BatchInProgress::result(const std::string& fixed_frame) const {
  BatchResult result;
  fill_scene(result, fixed_frame);
  for (std::size_t i = 0; i < request_.candidates.size(); ++i) {
    result.results.push_back(refused_result(request_.candidates[i].name, read_.mistakes[i].value_or("")));
  }
  const bool has_begun = !begun_->run.outcomes().empty();
  for (std::size_t i = 0; i < read_.candidates.size(); ++i) {
    CandidateOutcome none;
    none.name = read_.candidates[i].name;
    result.results[read_.indices[i]] =
        has_begun ? result_of(i) : to_result(none, read_.candidates[i], settings_, unfinished_);
  }
  const bool is_whole = unfinished_.error_code == 0;
  result.success = is_whole;
  result.error_code = is_whole ? static_cast<std::int32_t>(Codes::SUCCESS) : unfinished_.error_code;
  result.message = unfinished_.message;
  return result;
}

}  // namespace

BatchAnswerer::BatchAnswerer(const NodeParameters& parameters, SceneForecaster& forecaster, LiveScene& live_scene,
                             const FrameTransformer& frames, ClientCount& clients)
    : parameters_(parameters), forecaster_(forecaster), live_scene_(live_scene), frames_(frames), clients_(clients) {}

BatchResult BatchAnswerer::answer(const BatchRequest& request, const BatchWatcher& watcher) {
  if (!forecaster_.ready()) {
    return failure(Codes::NOT_READY, forecaster_.message());
  }
  const ClientCount::Presence presence(clients_);
  if (presence.number() > parameters_.service.max_clients_queued + 1) {
    return failure(Codes::BUSY, "more than " + std::to_string(parameters_.service.max_clients_queued) +
                                    " requests are waiting (service/max_clients_queued)");
  }
  const Clock::time_point asked = Clock::now();
  try {
    BatchResult result = answer_ready(request, watcher);
    result.compute_time = std::chrono::duration<double>(Clock::now() - asked).count();
    return result;
  } catch (const RequestError& error) {
    return failure(error.code(), error.what());
  } catch (const std::invalid_argument& error) {
    return failure(Codes::INVALID_REQUEST, error.what());
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("predict_rollouts: " << error.what());
    return failure(Codes::INTERNAL, error.what());
  }
}

ObservedScene BatchAnswerer::read(const PredictRollout::Request& question, const RolloutTask& task) const {
  RequestSources sources;
  sources.live_scene = [this](double time_step_s) { return live_scene_.snapshot(time_step_s); };
  sources.model_for = [this](const ObservedScene& scene) { return forecaster_.model_for(scene); };
  sources.T_fixed_from = [this](const std::string& frame_id, const ros::Time& stamp) {
    return frames_.T_fixed_from(frame_id, stamp);
  };
  return read_scene(question, task.source, parameters_, task.settings.options.time_step_s, sources);
}

BatchResult BatchAnswerer::answer_ready(const BatchRequest& request, const BatchWatcher& watcher) {
  const Clock::time_point asked = Clock::now();
  const PredictRollout::Request question = scene_question(request);
  RolloutTask task = read_task(question, parameters_, forecaster_.default_settings());
  check_limits(request, task, parameters_);
  const rigidformer::RigidTransform T_fixed = T_fixed_request(request.scene, parameters_, frames_);
  ReadCandidates read_in = read_candidates(request, parameters_, T_fixed);
  rigidformer::BatchOptions options = read_batch_options(request, task, parameters_, read_in.regions);
  ObservedScene scene = read(question, task);
  task.settings.options.time_step_s = options.rollout.time_step_s = scene.time_step_s;
  options.rollout.control = read_control(question, options.rollout.num_steps, forecaster_.model_for(scene));
  std::unique_ptr<BegunBatch> begun = forecaster_.begin_batch(std::move(scene), read_in.candidates, options);
  check_scene(question, task, begun->scene, parameters_, ros::Time::now());
  check_returned_poses(request, task, begun->scene.objects.size(), parameters_);
  BatchInProgress batch(request, std::move(read_in), task, std::move(begun));
  batch.run(time_limit(task.settings, asked), watcher);
  return batch.result(parameters_.fixed_frame);
}

}  // namespace rigidformer_ros
