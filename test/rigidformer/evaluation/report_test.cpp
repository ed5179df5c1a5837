// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/report.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "rigidformer/io/full_disk.hpp"
#include "rigidformer/io/text_file.hpp"

namespace rigidformer {
namespace {

std::vector<Score> two_rows() {
  return {{"rigidformer", "movi_a", 120, 10, 75, 40, {0.0512, 7.25}, 0.125},
          {"rigidformer", "movi_a", 120, 10, 100, 40, {0.25, 11.5}, 0.125},
          {"ballistic", "movi_a", 120, 10, 75, 40, {1.05, 37.9}, 0.0},
          {"ballistic", "movi_a", 120, 10, 100, 40, {1.8, 58.4}, 0.0}};
}

TEST(Report, PrintsOneRowPerModelAndNotesInterpolation) {
  std::ostringstream out;
  print_scores(out, two_rows());
  const std::string text = out.str();
  const auto row = text.find("rigidformer");
  ASSERT_NE(row, std::string::npos);
  EXPECT_EQ(text.find("rigidformer", row + 1), std::string::npos);
  EXPECT_NE(text.find("0.0512 /  7.25"), std::string::npos);
  EXPECT_NE(text.find("1.8000 / 58.40"), std::string::npos);
  EXPECT_NE(text.find("frame 75 with step 10 lies between frames 70 and 80"), std::string::npos);
  EXPECT_EQ(text.find("frame 100 with step"), std::string::npos);
}

TEST(Report, WritesEveryScoreToJson) {
  const auto path = std::filesystem::path(testing::TempDir()) / "scores.json";
  ProtocolOptions protocol;
  protocol.observation.one_view = protocol.resting_only = true;
  write_scores_json(path, two_rows(), protocol);
  const auto document = nlohmann::json::parse(std::ifstream(path));
  ASSERT_EQ(document.at("results").size(), 4U);
  const auto& result = document["results"][1];
  EXPECT_EQ(result.at("model"), "rigidformer");
  EXPECT_EQ(result.at("set"), "movi_a");
  EXPECT_EQ(result.at("start"), 120);
  EXPECT_EQ(result.at("step"), 10);
  EXPECT_EQ(result.at("horizon"), 100);
  EXPECT_EQ(result.at("scenes"), 40);
  EXPECT_EQ(result.at("position_rmse_m"), 0.25);
  EXPECT_EQ(result.at("orientation_rmse_deg"), 11.5);
  EXPECT_EQ(document.at("conditions").at("one_view"), true);
  EXPECT_EQ(document["conditions"].at("resting_only"), true);
  EXPECT_EQ(document["conditions"].at("points"), 256);
}

TEST(Report, SaysWhenItCannotWrite) {
  EXPECT_THROW(write_scores_json("/nonexistent/scores.json", {}, {}), std::runtime_error);
}

TEST(Report, AFullDiskKeepsTheScoresThatWereThere) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "scores.json";
  write_scores_json(path, {}, {});
  const std::string before = read_text_file(path, 1000);
  const std::string message = on_a_full_disk([&] { write_scores_json(path, two_rows(), {}); });
  EXPECT_NE(message.find("scores.json': cannot write"), std::string::npos) << message;
  EXPECT_EQ(read_text_file(path, 1000), before);
  EXPECT_EQ(count_files(folder.path()), 1);
}

}  // namespace
}  // namespace rigidformer
