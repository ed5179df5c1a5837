// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/shared_answers.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

namespace rigidformer_ros {
namespace {

using Lead = SharedAnswers<int>::Lead;

TEST(SharedAnswers, WhoAsksTheSameWhileNobodyWorksOnItGetsTheSameAnswer) {
  SharedAnswers<int> answers;
  const auto first = answers.join("rollout of 24 steps");
  const auto second = answers.join("rollout of 24 steps");
  const auto other = answers.join("rollout of 12 steps");
  EXPECT_TRUE(first.leads);
  EXPECT_FALSE(second.leads);
  EXPECT_TRUE(other.leads);
  Lead(answers, "rollout of 24 steps").answer(7);
  EXPECT_EQ(first.result.get(), 7);
  EXPECT_EQ(second.result.get(), 7);
  EXPECT_EQ(other.result.wait_for(std::chrono::seconds(0)), std::future_status::timeout);
}

TEST(SharedAnswers, WhoAsksAfterTheWorkHasBegunWaitsForTheNextAnswer) {
  SharedAnswers<int> answers;
  const auto early = answers.join("q");
  std::optional<Lead> lead(std::in_place, answers, "q");
  lead->begin();
  const auto late = answers.join("q");
  EXPECT_TRUE(late.leads);
  lead->answer(1);
  lead.reset();
  Lead(answers, "q").answer(2);
  EXPECT_EQ(early.result.get(), 1);
  EXPECT_EQ(late.result.get(), 2);
}

TEST(SharedAnswers, WhoWaitsForOneThatFailedIsTold) {
  SharedAnswers<int> answers;
  answers.join("q");
  const auto follower = answers.join("q");
  const auto fail = [&answers] {
    const Lead lead(answers, "q");
    throw std::runtime_error("no answer");
  };
  EXPECT_THROW(fail(), std::runtime_error);
  EXPECT_EQ(follower.result.get(), std::nullopt);
  EXPECT_TRUE(answers.join("q").leads);
}

TEST(SharedAnswers, ManyThreadsAllGetAnswersThatAreNotOlderThanTheirQuestions) {
  SharedAnswers<int> answers;
  std::mutex turn;
  std::atomic<int> num_made{0}, num_given{0}, num_older{0};
  const auto ask = [&] {
    for (int i = 0; i < 200; ++i) {
      const int made_before = num_made;
      const auto place = answers.join("q");
      if (place.leads) {
        const std::lock_guard<std::mutex> lock(turn);
        Lead lead(answers, "q");
        lead.begin();
        lead.answer(++num_made);
      }
      const std::optional<int> answer = place.result.get();
      num_given += answer ? 1 : 0;
      num_older += answer.value_or(0) <= made_before ? 1 : 0;
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back(ask);
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(num_given, 1600);
  EXPECT_EQ(num_older, 0);
}

}  // namespace
}  // namespace rigidformer_ros
