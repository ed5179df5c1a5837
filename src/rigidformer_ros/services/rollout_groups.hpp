// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>

namespace rigidformer_ros {

/// Lets requests with the same key share one rollout, as long as it has not begun: what they get is never older than
/// their question. A request waits for a begun rollout of its key only if that one is no longer than itself: the same
/// question asked by many is answered for all who wait at once, and none waits for the end of a longer one. May be used
/// from any thread.
template <typename Rollout>
class RolloutGroups {
 private:
  struct Group;
  using Groups = std::multimap<std::string, std::unique_ptr<Group>>;

 public:
  /// Begins the rollout for requests of these numbers of steps; may throw.
  using Begin = std::function<std::shared_ptr<Rollout>(const std::set<int>& ends)>;

  /// Of one request, from the question to the answer.
  class Place {
   public:
    Place(RolloutGroups& all, const std::string& key, int num_steps)
        : all_(all), num_steps_(num_steps), entry_(all.join(key, num_steps)) {}
    ~Place() { all_.leave(entry_); }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    /// The rollout of the group, begun by the first to come here; empty if `limit` passed while waiting. Throws what
    /// `begin` throws; the next of the group then tries again.
    std::shared_ptr<Rollout> begin(std::chrono::steady_clock::time_point limit, const Begin& begin) {
      Group& group = *entry_->second;
      if (!all_.wait_to_begin(entry_, num_steps_, limit)) {
        return nullptr;
      }
      const std::lock_guard<std::mutex> lock(group.beginning);
      if (!group.rollout) {
        group.rollout = begin(group.lengths);
      }
      return group.rollout;
    }

   private:
    RolloutGroups& all_;
    int num_steps_;
    typename Groups::iterator entry_;
  };

 private:
  struct Group {
    bool has_begun = false;  // nobody joins from then on
    int num_members = 0;
    std::set<int> lengths;  // in steps, of all who joined
    std::mutex beginning;
    std::shared_ptr<Rollout> rollout;
  };

  typename Groups::iterator join(const std::string& key, int num_steps) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto [first, last] = groups_.equal_range(key);
    auto entry = std::find_if(first, last, [](const auto& other) { return !other.second->has_begun; });
    if (entry == last) {
      entry = groups_.emplace(key, std::make_unique<Group>());
    }
    ++entry->second->num_members;
    entry->second->lengths.insert(num_steps);
    return entry;
  }

  void leave(typename Groups::iterator entry) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (--entry->second->num_members == 0) {
      groups_.erase(entry);
      changed_.notify_all();
    }
  }

  bool wait_to_begin(typename Groups::iterator entry, int num_steps, std::chrono::steady_clock::time_point limit) {
    std::unique_lock<std::mutex> lock(mutex_);
    Group& group = *entry->second;
    if (!changed_.wait_until(lock, limit, [&] { return group.has_begun || is_free(entry->first, num_steps); })) {
      return false;
    }
    group.has_begun = true;
    changed_.notify_all();
    return true;
  }

  // Whether no rollout that is worth waiting for is under way.
  bool is_free(const std::string& key, int num_steps) const {
    const auto [first, last] = groups_.equal_range(key);
    return std::none_of(first, last, [num_steps](const auto& other) {
      return other.second->has_begun && *other.second->lengths.rbegin() <= num_steps;
    });
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  Groups groups_;
};

}  // namespace rigidformer_ros
