// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/network_steps.hpp"

#include <algorithm>
#include <utility>

#include "rigidformer/engine/contact_search.hpp"
#include "rigidformer/engine/engine_step.hpp"

namespace rigidformer {
namespace {

Tensor index_tensor(const std::vector<std::int64_t>& index, const Tensor& like) {
  return torch::tensor(index, torch::kInt64).to(like.device());
}

bool is_whole(const PerceivedObjects& scene, const std::vector<std::int64_t>& rows) {
  return static_cast<std::int64_t>(rows.size()) == scene.batch.max_objects();
}

/// The rows `rows` of a scene as a scene of their own; solids are numbered anew.
PerceivedObjects take_rows(const PerceivedObjects& scene, const std::vector<std::int64_t>& rows) {
  if (is_whole(scene, rows)) return scene;
  PerceivedObjects taken = gather(std::vector<const PerceivedObjects*>(rows.size(), &scene), rows, scene);
  for (std::size_t i = 0; i < taken.solids.size(); ++i) taken.solids[i].object = static_cast<std::int64_t>(i);
  return taken;
}

EngineStep engine_of(const ModelOptions& options, const PerceivedObjects& objects) {
  return make_engine_step(objects.batch, objects.solids, options.advisers, Sleep::kNever);
}

/// Replaces the pairs of which one may move by those of `found`.
template <typename Pair, typename Moves>
void replace_moving(const std::vector<Pair>& found, const Moves& moves, std::vector<Pair>& pairs) {
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), moves), pairs.end());
  std::copy_if(found.begin(), found.end(), std::back_inserter(pairs), moves);
}

}  // namespace

NetworkView::NetworkView(RigidFormer model, const PerceivedObjects& scene, std::vector<std::int64_t> rows)
    : model_(std::move(model)),
      rows_(std::move(rows)),
      objects_(take_rows(scene, rows_)),
      nearest_(nearest_search(objects_)) {
  if (!is_whole(scene, rows_)) row_index_ = index_tensor(rows_, scene.centre);
  const ModelOptions& options = model_->options;
  if (options.engine_motion) engine_ = watched(engine_of(options, objects_));
  if (options.contact_tokens) contacts_ = watched(make_contact_search(options, objects_.batch, objects_.solids));
}

/// A network's answer depends on all that the engine moves: only where an engine answers alone, nothing is lost by its
/// own sleep.
EngineStep NetworkView::watched(EngineStep step) {
  return [this, step = std::move(step)](const SceneState& state) {
    std::vector<EngineMotion> advice = step(state);
    pressed_ = advice.front().pressed;
    for (PressedPair& pair : pressed_) {
      pair.object = in_scene(pair.object);
      pair.partner = in_scene(pair.partner);
    }
    return advice;
  };
}

ContactSearch NetworkView::watched(ContactSearch search) {
  return [this, search = std::move(search)](const Pose& from, const Pose& to) {
    Contacts contacts = search(from, to);
    met_.clear();
    for (std::int64_t i = 0; i < contacts.count(); ++i) {
      if (contacts.gap[i].item<double>() > kContact_m) continue;
      met_.emplace_back(in_scene(contacts.object[i].item<std::int64_t>()),
                        in_scene(contacts.partner[i].item<std::int64_t>()));
    }
    return contacts;
  };
}

Tensor NetworkView::of_rows(const Tensor& scene_values) const {
  return row_index_.defined() ? scene_values.index_select(1, row_index_) : scene_values;
}

Pose NetworkView::of_rows(const Pose& pose) const { return {of_rows(pose.rotation), of_rows(pose.translation)}; }

StepPrediction NetworkView::step(const SceneBatch& scene, const SceneState& state) {
  objects_.batch.control = scene.control;
  objects_.batch.dynamic_mask = of_rows(scene.dynamic_mask);  // what diverges in a rollout stands still from then on
  const SceneState seen{of_rows(state.first), of_rows(state.previous), of_rows(state.current), of_rows(state.coming)};
  return model_->forward(objects_.batch, seen, objects_.centre, nearest_, engine_, contacts_);
}

NetworkSteps::NetworkSteps(RigidFormer model, const PerceivedObjects& scene)
    : model_(std::move(model)), scene_(scene) {}

StepPrediction NetworkSteps::predict(const SceneState& state, const StepParts& parts) {
  StepPrediction all{Tensor(), state.current, state.current};
  if (parts.seen.empty()) return all;
  NetworkView& view = view_of(parts.seen);
  StepPrediction seen = view.step(scene_.batch, state);
  remember(view, parts.may_move);
  if (parts.is_everybody()) return seen;
  std::vector<std::int64_t> moving, place;  // in the scene and among those seen
  for (std::size_t i = 0; i < parts.seen.size(); ++i) {
    if (!parts.may_move[static_cast<std::size_t>(parts.seen[i])]) continue;
    moving.push_back(parts.seen[i]);
    place.push_back(static_cast<std::int64_t>(i));
  }
  const Tensor to = index_tensor(moving, state.current.translation), from = index_tensor(place, to);
  const auto scatter = [&](const Pose& poses) {
    return Pose{state.current.rotation.index_copy(1, to, poses.rotation.index_select(1, from)),
                state.current.translation.index_copy(1, to, poses.translation.index_select(1, from))};
  };
  return {Tensor(), scatter(seen.pose), scatter(seen.departure)};
}

NetworkView& NetworkSteps::view_of(const std::vector<std::int64_t>& rows) {
  std::unique_ptr<NetworkView>& view = is_whole(scene_, rows) ? whole_ : part_;
  if (!view || view->rows() != rows) view = std::make_unique<NetworkView>(model_, scene_, rows);
  return *view;
}

void NetworkSteps::remember(const NetworkView& view, const std::vector<bool>& may_move) {
  const auto moves = [&](std::int64_t k) { return k >= 0 && may_move[static_cast<std::size_t>(k)]; };
  const auto presses_on = [&](const PressedPair& pair) { return moves(pair.object) || moves(pair.partner); };
  const auto meets = [&](const ObjectPair& pair) { return moves(pair.first) || moves(pair.second); };
  replace_moving(view.pressed(), presses_on, pressed_);
  replace_moving(view.met(), meets, met_);
}

}  // namespace rigidformer
