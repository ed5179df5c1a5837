// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/parameters/wildcard.hpp"

#include <gtest/gtest.h>

namespace rigidformer_ros {
namespace {

TEST(Wildcard, MatchesAnyTextAtTheStar) {
  EXPECT_TRUE(matches_wildcard("cup*", "cup"));
  EXPECT_TRUE(matches_wildcard("cup*", "cup_2"));
  EXPECT_TRUE(matches_wildcard("*b*d", "abbcbd"));
  EXPECT_FALSE(matches_wildcard("cup*", "mug"));
  EXPECT_FALSE(matches_wildcard("*a", "ab"));
  EXPECT_FALSE(matches_wildcard("cup", "cup_2"));
}

TEST(Wildcard, TopicPatternHasOneStarAsAWholeSegment) {
  EXPECT_TRUE(is_topic_pattern("/objects/*/points"));
  EXPECT_TRUE(is_topic_pattern("objects/*"));
  EXPECT_FALSE(is_topic_pattern("/objects/points"));
  EXPECT_FALSE(is_topic_pattern("/objects/cup_*/points"));
  EXPECT_FALSE(is_topic_pattern("/*/*/points"));
  EXPECT_FALSE(is_topic_pattern("/ob jects/*"));
}

TEST(Wildcard, TakesTheIdFromTheTopic) {
  EXPECT_EQ(match_topic("/objects/*/points", "/objects/cup_1/points"), "cup_1");
  EXPECT_EQ(match_topic("/objects/*/points", "/objects/cup/lid/points"), std::nullopt);
  EXPECT_EQ(match_topic("/objects/*/points", "/objects//points"), std::nullopt);
  EXPECT_EQ(match_topic("/objects/*/points", "/objects/points"), std::nullopt);
  EXPECT_EQ(match_topic("/objects/*/points", "/other/cup/points"), std::nullopt);
  EXPECT_EQ(match_topic("/objects/*", "/objects/cup"), "cup");
}

}  // namespace
}  // namespace rigidformer_ros
