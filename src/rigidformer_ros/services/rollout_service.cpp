// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/services/rollout_service.hpp"

#include <boost/function.hpp>
#include <string>
#include <utility>

#include "rigidformer_ros/forecast/forecast_messages.hpp"
#include "rigidformer_ros/messages/names.hpp"
#include "rigidformer_ros/services/candidate_rollout.hpp"
#include "rigidformer_ros/services/request_error.hpp"
#include "rigidformer_ros/services/rollout_command.hpp"

namespace rigidformer_ros {

namespace {

using Request = PredictRollout::Request;
using Response = PredictRollout::Response;

Response failure(std::int32_t code, const std::string& message) {
  Response response;
  response.success = false;
  response.error_code = code;
  response.message = message;
  return response;
}

std::uint8_t to_message_reason(StopReason reason) {
  switch (reason) {
    case StopReason::kSettled:
      return Response::STOP_SETTLED;
    case StopReason::kWallTime:
      return Response::STOP_WALL_TIME;
    case StopReason::kDiverged:
      return Response::STOP_DIVERGED;
    default:
      return Response::STOP_HORIZON;
  }
}

void fill_outcome(Response& response, const SceneForecast& forecast, const RolloutSettings& settings) {
  response.success = true;
  response.error_code = Response::SUCCESS;
  if (response.stop_reason == Response::STOP_WALL_TIME) {
    response.success = false;
    response.error_code = Response::TIMED_OUT;
    response.message = "max_wall_time: " + std::to_string(settings.max_wall_time_s) + " s passed after " +
                       std::to_string(response.steps_done) + " of " + std::to_string(settings.options.num_steps) +
                       " steps";
  }
  for (const ObjectForecast& object : forecast.objects) {
    if (object.status == ObjectForecast::DIVERGED) {
      response.success = false;
      response.error_code = Response::DIVERGED;
      response.message = "object '" + object.id + "': its prediction stopped being finite";
    }
  }
}

}  // namespace

RolloutService::RolloutService(ros::NodeHandle& node, const NodeParameters& parameters, SceneForecaster& forecaster,
                               LiveScene& live_scene, const FrameTransformer& frames,
                               const SharedValue<ForecastQuality>& quality, ClientCount& clients)
    : parameters_(parameters),
      forecaster_(forecaster),
      live_scene_(live_scene),
      frames_(frames),
      quality_(quality),
      clients_(clients) {
  predict_rollout_ = node.advertiseService<Request, Response>(
      names::kPredictRollout, boost::function<bool(Request&, Response&)>([this](Request& request, Response& response) {
        response = answer(request);
        return true;
      }));
  get_model_info_ = node.advertiseService<GetModelInfo::Request, GetModelInfo::Response>(
      names::kGetModelInfo, boost::function<bool(GetModelInfo::Request&, GetModelInfo::Response&)>(
                                [this](GetModelInfo::Request&, GetModelInfo::Response& response) {
                                  response = model_info();
                                  return true;
                                }));
  reset_ = node.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>(
      names::kReset, boost::function<bool(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&)>(
                         [this](std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
                           live_scene_.reset();
                           response.success = true;
                           response.message = "all tracks, forecasts and their errors were cleared";
                           return true;
                         }));
}

Response RolloutService::answer(const Request& request) {
  const SharedRollout::Clock::time_point asked = SharedRollout::Clock::now();
  if (!forecaster_.ready()) {
    return failure(Response::NOT_READY, forecaster_.message());
  }
  const ClientCount::Presence presence(clients_);
  if (presence.number() > parameters_.service.max_clients_queued + 1) {
    return failure(Response::BUSY, "more than " + std::to_string(parameters_.service.max_clients_queued) +
                                       " requests are waiting (service/max_clients_queued)");
  }
  try {
    return answer_ready(request, asked);
  } catch (const RequestError& error) {
    return failure(error.code(), error.what());
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("predict_rollout: " << error.what());
    return failure(Response::INTERNAL, error.what());
  }
}

ObservedScene RolloutService::read(const Request& request, const RolloutTask& task) const {
  RequestSources sources;
  sources.live_scene = [this](double time_step_s) { return live_scene_.snapshot(time_step_s); };
  sources.model_for = [this](const ObservedScene& scene) { return forecaster_.model_for(scene); };
  sources.T_fixed_from = [this](const std::string& frame_id, const ros::Time& stamp) {
    return frames_.T_fixed_from(frame_id, stamp);
  };
  return read_scene(request, task.source, parameters_, task.settings.options.time_step_s, sources);
}

std::shared_ptr<BegunRollout> RolloutService::begin(const Request& request, const RolloutTask& task,
                                                    const std::set<int>& ends) {
  rigidformer::RolloutOptions options = task.settings.options;
  ObservedScene scene = read(request, task);
  options.time_step_s = scene.time_step_s;
  options.control = read_control(request, options.num_steps, forecaster_.model_for(scene));
  return forecaster_.begin(std::move(scene), options, ends, JobLane::kRequest);
}

std::optional<SceneRollout> RolloutService::roll_out(const Request& request, RolloutTask& task,
                                                     SharedRollout::Clock::time_point asked) {
  RolloutGroups<BegunRollout>::Place place(groups_, rollout_key(request), task.settings.options.num_steps);
  const std::shared_ptr<BegunRollout> begun = place.begin(
      time_limit(task.settings, asked), [&](const std::set<int>& ends) { return begin(request, task, ends); });
  if (!begun) {
    return std::nullopt;
  }
  check_scene(request, task, begun->scene, parameters_, ros::Time::now());
  read_control(request, task.settings.options.num_steps, begun->model);  // the rollout may be that of a longer request
  task.settings.options.time_step_s = begun->scene.time_step_s;
  return SceneRollout{begun->scene, rigidformer_ros::roll_out(begun->steps, task.settings, asked), begun->model,
                      /*trusted_horizon_s=*/0.0};
}

SceneRollout RolloutService::roll_out_candidate(const Request& request, RolloutTask& task,
                                                SharedRollout::Clock::time_point asked) {
  const rigidformer::Candidate candidate =
      read_candidate_of(request.candidate, parameters_, T_fixed_request(request.scene, parameters_, frames_));
  ObservedScene scene = read(request, task);
  task.settings.options.time_step_s = scene.time_step_s;
  rigidformer::BatchOptions options;
  options.rollout = task.settings.options;
  options.rollout.control = read_control(request, options.rollout.num_steps, forecaster_.model_for(scene));
  options.settle = task.settings.settle;
  if (task.settings.stop_when_settled) {
    options.stop.emplace_back();
  }
  const std::unique_ptr<BegunBatch> begun = forecaster_.begin_batch(std::move(scene), {candidate}, options);
  check_scene(request, task, begun->scene, parameters_, ros::Time::now());
  const SharedRollout::Clock::time_point limit = time_limit(task.settings, asked);
  while (begun->run.is_running() && SharedRollout::Clock::now() < limit) {
    begun->run.advance(limit);
  }
  return rollout_of(*begun, candidate, task.settings);
}

Response RolloutService::answer_ready(const Request& request, SharedRollout::Clock::time_point asked) {
  RolloutTask task = read_task(request, parameters_, forecaster_.default_settings());
  std::optional<SceneRollout> rollout =
      is_empty(request.candidate) ? roll_out(request, task, asked) : roll_out_candidate(request, task, asked);
  if (!rollout) {
    return failure(Response::TIMED_OUT, "max_wall_time: " + std::to_string(task.settings.max_wall_time_s) +
                                            " s passed while other requests were answered");
  }
  skip_unusable(*rollout);
  check_object_ids(request.object_ids, rollout->scene);  // predictor or candidate may have left some of them out
  if (task.source == SceneSource::kLive) {
    rollout->trusted_horizon_s = quality_.get().trusted_horizon_s;  // measured on the live scene
  }

  Response response;
  response.forecast = to_forecast(*rollout, task.selection, parameters_.fixed_frame);
  response.steps_done = static_cast<std::uint32_t>(rollout->outcome.steps_done);
  response.stop_reason = to_message_reason(rollout->outcome.stop_reason);
  if (request.return_points) {
    response.points = to_points_cloud(*rollout, task.selection, parameters_.fixed_frame);
  }
  fill_outcome(response, response.forecast, task.settings);
  return response;
}

GetModelInfo::Response RolloutService::model_info() const {
  GetModelInfo::Response response;
  response.ready = forecaster_.ready();
  response.message = forecaster_.message();
  if (!response.ready) {
    return response;
  }
  const rigidformer::ModelInfo info =
      forecaster_.model_for(live_scene_.snapshot(forecaster_.default_settings().options.time_step_s));
  response.model_id = info.id;
  response.sha256 = info.sha256;
  response.device = info.device;
  response.precision = info.precision;
  response.num_parameters = static_cast<std::uint64_t>(info.num_parameters);
  response.min_time_step = info.min_time_step_s;
  response.max_time_step = info.max_time_step_s;
  response.min_size = info.min_size_m;
  response.max_size = info.max_size_m;
  response.max_speed = info.max_speed_mps;
  response.max_objects = static_cast<std::uint32_t>(info.max_objects);
  response.max_points = static_cast<std::uint32_t>(info.max_points);
  response.control_dim = static_cast<std::uint32_t>(info.control_dim);
  response.model_steps_per_second = info.model_steps_per_s;
  response.engine_steps_per_second = info.engine_steps_per_s;
  return response;
}

}  // namespace rigidformer_ros
