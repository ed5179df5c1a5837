// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/io/member_table.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rigidformer {
namespace {

enum class Colour { kRed, kBlue };

EnumNames<Colour> names_of(Colour) { return {{"red", Colour::kRed}, {"blue", Colour::kBlue}}; }

struct Point {
  double x = 0.5;
};

template <typename Visit>
void for_each_member(Point& o, const Visit& visit) {
  visit("x", o.x, anything(), "[m]");
}

struct Everything {
  bool flag = true;
  int count = 200000;
  double length = 1e-6;
  std::string topic = "/a";
  std::string word = "one";
  std::optional<double> mass;
  std::vector<int> sizes{1, 2};
  Colour colour = Colour::kBlue;
  Point nested;
  std::vector<Point> points{Point()};
  int size_of_preset = 3;
};

template <typename Visit>
void for_each_member(Everything& o, const Visit& visit) {
  visit("flag", o.flag, anything(), "a");
  visit("count", o.count, at_least(1), "b");
  visit("length", o.length, between(0.0, 1e6), "c");
  visit("topic", o.topic, anything(), "d");
  visit("word", o.word, one_of({"one", "two"}), "e");
  visit("mass", o.mass, positive_up_to(3.0).or_word("unknown"), "f");
  visit("sizes", o.sizes, positive(), "g");
  visit("colour", o.colour, anything(), "h");
  visit("nested", o.nested, anything(), "i");
  visit("points", o.points, anything(), "j");
  visit("size_of_preset", o.size_of_preset, positive().fixed(), "k");
}

TEST(MemberTable, WritesWhatMembersHoldAndAccept) {
  EXPECT_EQ(markdown_table(member_rows(Everything())),
            "| name | default | range | meaning |\n"
            "|---|---|---|---|\n"
            "| `flag` | true | true, false | a |\n"
            "| `count` | 200000 | from 1 | b |\n"
            "| `length` | 1e-6 | 0 to 1e6 | c |\n"
            "| `topic` | `/a` | text | d |\n"
            "| `word` | one | one, two | e |\n"
            "| `mass` | unknown | 0 to 3, not 0, or unknown | f |\n"
            "| `sizes` | 1, 2 | above 0 | g |\n"
            "| `colour` | blue | red, blue | h |\n"
            "| `points` | {x: 0.5} | list | j |\n");
}

TEST(MemberTable, KnowsWhatIsAccepted) {
  EXPECT_TRUE(fits(0.0, less_than_all()));
  EXPECT_FALSE(fits(1.0, less_than_all()));
  EXPECT_FALSE(fits(std::numeric_limits<double>::quiet_NaN(), share()));
  EXPECT_TRUE(fits(std::vector<int>{1, 2}, positive()));
  EXPECT_FALSE(fits(std::vector<int>{1, 0}, positive()));
  EXPECT_FALSE(fits(std::string("three"), one_of({"one", "two"})));
  EXPECT_TRUE(fits(std::optional<double>(), positive()));
  EXPECT_FALSE(fits(std::optional<double>(-1.0), positive()));
  EXPECT_EQ(values_text(less_than_all()), "in [0, 1)");
  EXPECT_EQ(values_text(positive()), "> 0");
  EXPECT_EQ(values_text(at_least(3)), ">= 3");
  EXPECT_EQ(values_text(one_of({"one", "two"})), "one | two");
  EXPECT_EQ(enum_value<Colour>("blue"), Colour::kBlue);
  EXPECT_FALSE(enum_value<Colour>("green"));
}

}  // namespace
}  // namespace rigidformer
