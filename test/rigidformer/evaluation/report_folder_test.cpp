// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/report_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/evaluation/scene_results.hpp"

namespace rigidformer {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool has_gnuplot() { return std::system("gnuplot --version > /dev/null 2>&1") == 0; }

class ReportFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    const SceneRecording scene = resting_scene("0007", {"cube", "ball"}, 400);
    ProtocolOptions options;
    options.observation.one_view = true;
    options.observation.noise_m = 0.002;
    ReportFolder report(path_, "bullet", options);
    for (const std::string model : {"bullet", "ballistic"}) {
      SceneResult result = result_of(model, scene, {0.25, 12.5}, {{0.5, 3.0}, {0.125, 4.0}});
      for (int k = 0; k < 24; ++k) result.curve[10 * (k + 1)] = {0.01 * k, 0.5 * k};
      report.add(result);
    }
    report.write({{"bullet", "toys", 120, 10, 100, 1, {0.25, 12.5, 0.5}, 0.0625, {8, 6}},
                  {"ballistic", "toys", 120, 10, 100, 1, {1.5, 50.0, 3.0}, 0.0}});
    markdown_ = text_of(path_ / "report.md");
  }

  void expect_line(const std::string& line) const {
    EXPECT_NE(markdown_.find(line + "\n"), std::string::npos) << line << "\nis missing in\n" << markdown_;
  }

  const TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_.path() / "made" / "here";
  std::string markdown_;
};

TEST_F(ReportFolderTest, TablesHoldEveryScore) {
  expect_line("| toys | 120 | 10 | 100 | bullet | 1 | 0.2500 | 12.50 | 50.0 | 0.0625 |");
  expect_line("| toys | 120 | 10 | 100 | ballistic | 1 | 1.5000 | 50.00 | 300.0 | 0.0000 |");
  expect_line("| toys | 120 | 10 | bullet | 8 | 75.0 |");
  expect_line("| toys | 120 | 10 | ball | bullet | 1 | 0.1250 | 4.00 |");
  expect_line("| toys | 120 | 10 | cube | ballistic | 1 | 0.5000 | 3.00 |");
  expect_line("| toys | 120 | 10 | 2 | bullet | 1 | 0.2500 | 12.50 |");
}

TEST_F(ReportFolderTest, SaysWhatWasSeenAndWhichScenesAreWorst) {
  EXPECT_NE(markdown_.find("256 surface points per object, those that face one camera, noise 2 mm"), std::string::npos);
  expect_line("## Worst scenes of bullet, at frame 100");
  expect_line("- toys, start 120, scene 0007, step 10, 2 objects: 0.2500 m, 12.50 deg");
}

TEST_F(ReportFolderTest, JsonFilesHoldTheSame) {
  const auto scores = nlohmann::json::parse(std::ifstream(path_ / "scores.json"));
  EXPECT_EQ(scores.at("results").size(), 2U);
  EXPECT_EQ(scores.at("conditions").at("one_view"), true);
  const auto parts = nlohmann::json::parse(std::ifstream(path_ / "breakdown.json"));
  EXPECT_EQ(parts.at("by_shape").size(), 4U);
  EXPECT_EQ(parts.at("by_num_objects").at(1).at("position_rmse_m"), 0.25);
  EXPECT_EQ(parts.at("by_num_objects").at(1).at("num_objects"), 2);
  EXPECT_EQ(parts.at("by_frame").size(), 48U);
  EXPECT_EQ(parts.at("by_frame").at(0).at("frame"), 10);
}

TEST_F(ReportFolderTest, PicturesAreThereAndLinked) {
  if (!has_gnuplot()) {
    GTEST_SKIP() << "gnuplot is not installed";
  }
  for (const std::string file : {"error_toys_start_120_step_10_to_100.svg", "error_toys_start_120_step_10_to_240.svg",
                                 "worst_toys_start_120_scene_0007.svg"}) {
    expect_line("![" + file + "](" + file + ")");
    EXPECT_NE(text_of(path_ / file).find("</svg>"), std::string::npos) << file;
  }
  EXPECT_NE(text_of(path_ / "error_toys_start_120_step_10_to_240.svg").find("ballistic"), std::string::npos);
}

TEST(ReportFolder, SaysWhenTheFolderCannotBeMade) {
  EXPECT_THROW(ReportFolder("/proc/none/report", "bullet", {}), std::runtime_error);
}

}  // namespace
}  // namespace rigidformer
