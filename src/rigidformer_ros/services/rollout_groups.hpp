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

/// Lets requests with the same key share one rollout. They can join it only until it has begun, so that what they get
/// is never older than their question. A request waits for the end of a begun rollout of its key only if that rollout
/// has no more steps than the request itself. So everyone who waits with the same question is answered at once, and no
/// request waits for the end of a longer rollout. The class may be used from any thread.
template <typename Rollout>
class RolloutGroups {
 private:
  struct Group;
  using Groups = std::multimap<std::string, std::unique_ptr<Group>>;

 public:
  /// A function that begins the rollout for requests of the numbers of steps in `ends`. It may throw.
  using Begin = std::function<std::shared_ptr<Rollout>(const std::set<int>& ends)>;

  /// The place of one request in its group. It is held from the question to the answer.
  class Place {
   public:
    Place(RolloutGroups& all, const std::string& key, int num_steps)
        : all_(all), num_steps_(num_steps), entry_(all.join(key, num_steps)) {}
    ~Place() { all_.leave(entry_); }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    /// Gives the rollout of the group, which the first request to come here begins. The result is empty if `limit`
    /// passed while the request waited. Throws what `begin` throws; the next request of the group then tries again.
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
    bool has_begun = false;  // Nobody can join from then on.
    int num_members = 0;
    std::set<int> lengths;  // The numbers of steps that the members want.
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

  // Tells whether a request of this length may begin: no rollout is under way that it has to wait for.
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
