// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/world_contacts.hpp"

#include <algorithm>

namespace rigidformer {
namespace {

bool moves_freely(const std::vector<CandidateObject>& objects, std::int64_t k) {
  return k >= 0 && objects[static_cast<std::size_t>(k)].state.mode == MotionMode::kDynamic;
}

/// The contacts of one step, one per pair.
class StepContacts {
 public:
  StepContacts(int step, const std::vector<CandidateObject>& objects) : step_(step), objects_(objects) {}

  /// The contact of the pair, made where there is none yet; null for a pair that nothing can move.
  StepContact* of(std::int64_t a, std::int64_t b) {
    if (!moves_freely(objects_, a) && !moves_freely(objects_, b)) return nullptr;
    const int first = static_cast<int>(std::max(a, b)), second = static_cast<int>(std::min(a, b));
    const auto is_pair = [&](const StepContact& contact) {
      return contact.object_a == first && contact.object_b == second;
    };
    const auto known = std::find_if(contacts_.begin(), contacts_.end(), is_pair);
    if (known != contacts_.end()) return &*known;
    contacts_.push_back({step_, first, second});
    return &contacts_.back();
  }

  std::vector<StepContact> take() { return std::move(contacts_); }

 private:
  int step_;
  const std::vector<CandidateObject>& objects_;
  std::vector<StepContact> contacts_;
};

/// An impulse is real where the masses of all that it moves are.
bool is_real(const std::vector<CandidateObject>& objects, const PressedPair& pair) {
  for (const std::int64_t k : {pair.object, pair.partner}) {
    if (moves_freely(objects, k) && !objects[static_cast<std::size_t>(k)].state.properties.mass_kg) return false;
  }
  return true;
}

}  // namespace

std::vector<StepContact> find_contacts(int step, const std::vector<CandidateObject>& objects,
                                       const std::vector<SolidGap>& gaps, const std::vector<PressedPair>& pressed,
                                       const std::vector<ObjectPair>& met) {
  StepContacts contacts(step, objects);
  for (const SolidGap& gap : gaps) {
    if (StepContact* contact = contacts.of(gap.body, gap.partner)) contact->penetration_m = std::max(0.0, -gap.gap_m);
  }
  for (const PressedPair& pair : pressed) {
    StepContact* contact = contacts.of(pair.object, pair.partner);
    if (contact != nullptr && is_real(objects, pair)) contact->normal_impulse_Ns = pair.normal_impulse_Ns;
  }
  for (const auto& [object, partner] : met) contacts.of(object, partner);
  return contacts.take();
}

}  // namespace rigidformer
