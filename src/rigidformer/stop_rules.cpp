// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/stop_rules.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rigidformer {
namespace {

std::vector<int> objects_of(const StopRule& rule, const CandidateOutcome& outcome) {
  std::vector<int> objects;
  for (std::size_t k = 0; k < outcome.forecast.objects.size(); ++k) {
    const std::string& id = outcome.forecast.objects[k].id;
    const bool is_meant = rule.ids.empty() ? outcome.modes[k] == MotionMode::kDynamic
                                           : std::count(rule.ids.begin(), rule.ids.end(), id) > 0;
    if (is_meant) objects.push_back(static_cast<int>(k));
  }
  return objects;
}

bool is_of(const StepContact& contact, int object) { return contact.object_a == object || contact.object_b == object; }

/// Whether the object touches something, since the last step, that it did not touch at t0.
bool touches_anew(const Forecast& forecast, int object) {
  const int now = static_cast<int>(forecast.times_s.size()) - 1;
  const auto touched_before = [&](const StepContact& contact) {
    return std::any_of(forecast.contacts.begin(), forecast.contacts.end(), [&](const StepContact& other) {
      return other.step == 0 && other.object_a == contact.object_a && other.object_b == contact.object_b;
    });
  };
  return std::any_of(forecast.contacts.rbegin(), forecast.contacts.rend(), [&](const StepContact& contact) {
    return contact.step == now && is_of(contact, object) && !touched_before(contact);
  });
}

bool holds(const StopRule& rule, const BatchOptions& options, const CandidateOutcome& outcome) {
  const std::vector<int> objects = objects_of(rule, outcome);
  const auto poses = [&](int k) -> const std::vector<RigidTransform>& {
    return outcome.forecast.objects[static_cast<std::size_t>(k)].poses;
  };
  const auto tilts = [&](int k) { return max_tilt({poses(k).front(), poses(k).back()}) > rule.value; };
  const auto leaves = [&](int k) { return !rule.region.contains(poses(k).back().translation); };
  const auto settles = [&](int k) { return settled_step(poses(k), options.rollout.time_step_s, options.settle) >= 0; };
  const auto touches = [&](int k) { return touches_anew(outcome.forecast, k); };
  switch (rule.kind) {
    case StopRule::Kind::kTouch:
      return std::any_of(objects.begin(), objects.end(), touches);
    case StopRule::Kind::kTilt:
      return std::any_of(objects.begin(), objects.end(), tilts);
    case StopRule::Kind::kLeave:
      return std::any_of(objects.begin(), objects.end(), leaves);
    default:
      return !objects.empty() && std::all_of(objects.begin(), objects.end(), settles);
  }
}

}  // namespace

void check_rules(const std::vector<StopRule>& rules, const std::vector<std::string>& known_ids) {
  for (std::size_t i = 0; i < rules.size(); ++i) {
    const std::string name = "stop[" + std::to_string(i) + "]";
    for (const std::string& id : rules[i].ids) {
      if (std::count(known_ids.begin(), known_ids.end(), id) == 0) {
        throw std::invalid_argument(name + ".ids: '" + id + "' is not known");
      }
    }
    if (rules[i].kind == StopRule::Kind::kTilt && !(rules[i].value > 0.0)) {
      throw std::invalid_argument(name + ".value: is " + std::to_string(rules[i].value) + " rad, must be above 0");
    }
    const BoxRegion& region = rules[i].region;
    const bool is_box = is_valid(region.T_world_box) && region.size_m.allFinite() && region.size_m.minCoeff() > 0.0;
    if (rules[i].kind == StopRule::Kind::kLeave && !is_box) {
      throw std::invalid_argument(name + ".region: needs a finite pose and a size above 0 along each axis");
    }
  }
}

int rule_that_holds(const BatchOptions& options, const CandidateOutcome& outcome) {
  for (std::size_t i = 0; i < options.stop.size(); ++i) {
    if (holds(options.stop[i], options, outcome)) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace rigidformer
