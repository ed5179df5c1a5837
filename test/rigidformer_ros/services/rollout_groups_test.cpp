// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/services/rollout_groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace rigidformer_ros {
namespace {

using Groups = RolloutGroups<int>;
using Clock = std::chrono::steady_clock;

// A time limit that has passed already (the clock's zero), for requests that must not wait.
const Clock::time_point kNoTime;
// A time limit that never passes: an hour is longer than any test runs.
const Clock::time_point kLongTime = Clock::now() + std::chrono::hours(1);

Groups::Begin give(int value) {
  return [value](const std::set<int>&) { return std::make_shared<int>(value); };
}

std::shared_ptr<int> not_expected(const std::set<int>&) {
  ADD_FAILURE() << "begun twice";
  return nullptr;
}

TEST(RolloutGroups, WhoAsksTheSameBeforeItHasBegunSharesIt) {
  Groups groups;
  Groups::Place first(groups, "scene", 24), second(groups, "scene", 500), third(groups, "scene", 2);
  std::set<int> ends;
  const auto made = first.begin(kNoTime, [&](const std::set<int>& lengths) {
    ends = lengths;
    return std::make_shared<int>(7);
  });
  EXPECT_EQ(*made, 7);
  EXPECT_EQ(second.begin(kNoTime, not_expected), made);
  EXPECT_EQ(third.begin(kNoTime, not_expected), made);
  EXPECT_EQ(ends, std::set<int>({2, 24, 500}));
}

TEST(RolloutGroups, WhoAsksAfterItHasBegunWaitsForItsEndAndGetsTheNext) {
  Groups groups;
  std::optional<Groups::Place> early(std::in_place, groups, "scene", 24);
  EXPECT_EQ(*early->begin(kNoTime, give(1)), 1);
  Groups::Place late(groups, "scene", 24);
  EXPECT_EQ(late.begin(kNoTime, give(2)), nullptr) << "its time was over while it waited";
  early.reset();
  EXPECT_EQ(*late.begin(kNoTime, give(2)), 2);
}

TEST(RolloutGroups, AShortOneDoesNotWaitForALongOne) {
  Groups groups;
  Groups::Place running(groups, "scene", 500);
  running.begin(kNoTime, give(1));
  Groups::Place brief(groups, "scene", 2), middle(groups, "scene", 24), lasting(groups, "scene", 500);
  EXPECT_EQ(lasting.begin(kNoTime, give(0)), nullptr) << "it waits for its like";
  EXPECT_EQ(*brief.begin(kNoTime, give(2)), 2);
  EXPECT_EQ(*lasting.begin(kNoTime, not_expected), 2) << "once begun, it is for all who waited";
  EXPECT_EQ(*middle.begin(kNoTime, not_expected), 2);
}

TEST(RolloutGroups, OtherRolloutsDoNotWait) {
  Groups groups;
  Groups::Place one(groups, "scene", 24), other(groups, "other scene", 24);
  EXPECT_EQ(*one.begin(kNoTime, give(1)), 1);
  EXPECT_EQ(*other.begin(kNoTime, give(2)), 2);
}

TEST(RolloutGroups, WhoLeavesWithoutBeginningHoldsUpNobody) {
  Groups groups;
  std::optional<Groups::Place> left(std::in_place, groups, "scene", 2);
  Groups::Place stays(groups, "scene", 24);
  left.reset();
  EXPECT_EQ(*stays.begin(kNoTime, give(1)), 1);
}

TEST(RolloutGroups, WhenItCannotBeBegunEveryoneIsTold) {
  Groups groups;
  Groups::Place first(groups, "scene", 24), second(groups, "scene", 24), third(groups, "scene", 24);
  const auto fail = [](const std::set<int>&) -> std::shared_ptr<int> { throw std::runtime_error("no scene"); };
  EXPECT_THROW(first.begin(kNoTime, fail), std::runtime_error);
  EXPECT_THROW(second.begin(kNoTime, fail), std::runtime_error);
  EXPECT_EQ(*third.begin(kNoTime, give(3)), 3);
}

TEST(RolloutGroups, WaitingEndsWithWhatOneWaitsFor) {
  Groups groups;
  std::optional<Groups::Place> running(std::in_place, groups, "scene", 24);
  running->begin(kNoTime, give(1));
  auto later = std::async(std::launch::async, [&] {
    Groups::Place place(groups, "scene", 24);
    return *place.begin(kLongTime, give(2));
  });
  running.reset();
  EXPECT_EQ(later.get(), 2);
}

// Rollouts are numbered as they begin, and each shows the state of that moment. A request whose rollout has a number
// that was given before the request came would get an answer older than its question.
TEST(RolloutGroups, ManyThreadsAllGetRolloutsThatAreNotOlderThanTheirQuestions) {
  Groups groups;
  std::atomic<int> num_made{0}, num_given{0}, num_older{0}, num_under_way{0}, most_under_way{0};
  const auto ask = [&](int num_steps) {
    for (int i = 0; i < 200; ++i) {
      const int made_before = num_made;
      Groups::Place place(groups, "scene", num_steps);
      bool begins = false;
      const auto number = place.begin(kLongTime, [&](const std::set<int>&) {
        begins = true;
        most_under_way = std::max<int>(most_under_way, ++num_under_way);
        return std::make_shared<int>(++num_made);
      });
      num_given += number ? 1 : 0;
      num_older += *number <= made_before ? 1 : 0;
      num_under_way -= begins ? 1 : 0;
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back(ask, 24);
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(num_given, 1600);
  EXPECT_EQ(num_older, 0);
  EXPECT_EQ(most_under_way, 1);
}

}  // namespace
}  // namespace rigidformer_ros
