// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/usable_rollout.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "rigidformer/engine/engine_step.hpp"
#include "rigidformer/scene/objection.hpp"

namespace rigidformer {
namespace {

constexpr size_t kMaxReasonsTold = 5;

/// One per object of the scene; empty = it is usable.
using Objections = std::vector<std::optional<std::string>>;

Objections find_objections(const std::vector<ObjectState>& objects, int max_objects) {
  Objections objections;
  std::set<std::string> ids;  // of the usable ones
  for (const ObjectState& object : objects) {
    std::optional<std::string> found = objection(object);
    if (!found && ids.count(object.id) > 0) found = "its id appears more than once";
    if (!found && ids.size() >= static_cast<size_t>(max_objects)) {
      found = "the model takes at most " + std::to_string(max_objects) + " objects";
    }
    if (!found) ids.insert(object.id);
    objections.push_back(std::move(found));
  }
  return objections;
}

/// Indices of the usable objects.
std::vector<size_t> usable_indices(const Objections& objections) {
  std::vector<size_t> indices;
  for (size_t k = 0; k < objections.size(); ++k) {
    if (!objections[k]) indices.push_back(k);
  }
  return indices;
}

[[noreturn]] void refuse(const std::vector<ObjectState>& objects, const Objections& objections) {
  std::string message = "no object can be predicted";
  for (size_t k = 0; k < objects.size() && k < kMaxReasonsTold; ++k) {
    message += (k == 0 ? ": '" : "; '") + objects[k].id + "': " + *objections[k];
  }
  const size_t untold = objects.size() - std::min(objects.size(), kMaxReasonsTold);
  throw std::invalid_argument(untold == 0 ? message : message + "; and " + std::to_string(untold) + " more");
}

/// The rollout of some objects of a scene, and beside it the others, which stay where they were observed.
class PartialRollout : public Rollout {
 public:
  PartialRollout(std::unique_ptr<Rollout> usable, const std::vector<ObjectState>& objects, const Objections& objections)
      : usable_(std::move(usable)), indices_(usable_indices(objections)) {
    for (size_t k = 0; k < objects.size(); ++k) {
      forecast_.objects.push_back(
          {objects[k].id, ObjectTrajectory::Status::kUnusable, {objects[k].T_world_current}, {}});
      forecast_.objects.back().reason = objections[k].value_or("");
    }
  }

  const Forecast& advance(int num_steps) override {
    const Forecast& usable = usable_->advance(num_steps);
    forecast_.times_s = usable.times_s;
    forecast_.compute_time_s = usable.compute_time_s;
    for (ObjectTrajectory& object : forecast_.objects) object.poses.resize(usable.times_s.size(), object.poses.front());
    for (size_t i = 0; i < indices_.size(); ++i) forecast_.objects[indices_[i]] = usable.objects[i];
    forecast_.contacts = usable.contacts;
    for (StepContact& contact : forecast_.contacts) {
      contact.object_a = index_of(contact.object_a);
      contact.object_b = index_of(contact.object_b);
    }
    return forecast_;
  }

 private:
  int index_of(int usable) const {
    return usable < 0 ? usable : static_cast<int>(indices_[static_cast<size_t>(usable)]);
  }

  std::unique_ptr<Rollout> usable_;
  std::vector<size_t> indices_;  ///< Of its objects in the scene
  Forecast forecast_;
};

}  // namespace

Objections take_usable(const std::vector<ObjectState>& objects, int max_objects, const TakeUsable& take) {
  Objections objections = find_objections(objects, max_objects);
  while (true) {
    const std::vector<size_t> indices = usable_indices(objections);
    if (indices.empty()) refuse(objects, objections);
    std::vector<ObjectState> usable;
    for (const size_t k : indices) usable.push_back(objects[k]);
    try {
      take(usable);
      return objections;
    } catch (const BodyError& error) {
      objections[indices.at(static_cast<size_t>(error.object()))] = error.what();
    }
  }
}

std::unique_ptr<Rollout> start_usable(const std::vector<ObjectState>& objects, int max_objects,
                                      const StartRollout& start) {
  std::unique_ptr<Rollout> rollout;
  const Objections objections =
      take_usable(objects, max_objects, [&](const std::vector<ObjectState>& usable) { rollout = start(usable); });
  const bool all_usable = usable_indices(objections).size() == objects.size();
  return all_usable ? std::move(rollout) : std::make_unique<PartialRollout>(std::move(rollout), objects, objections);
}

}  // namespace rigidformer
