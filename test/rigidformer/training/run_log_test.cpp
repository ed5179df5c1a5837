// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/run_log.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/training/quiet_terminal.hpp"

namespace rigidformer {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class RunLogTest : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
  const QuietTerminal quiet_;
};

TEST_F(RunLogTest, AResumedRunAppendsBelowOneHeader) {
  RunLog(folder_.path(), 20, false).write({10, 0.5, 1.25, 1e-3, 40.0, 0.25, 2});
  RunLog(folder_.path(), 20, true).write({20, 0.25, 1.0, 1e-4, 41.0, 0.5, 3});
  EXPECT_EQ(text_of(folder_.path() / "log.csv"),
            "iteration,loss,gradient_norm,learning_rate,windows_per_s,share_of_peak,unroll_steps\n"
            "10,0.5,1.25,0.001,40,0.25,2\n20,0.25,1,0.0001,41,0.5,3\n");
  RunLog(folder_.path(), 20, false).note("fresh");
  EXPECT_EQ(text_of(folder_.path() / "log.csv").find("10,"), std::string::npos);
  EXPECT_EQ(text_of(folder_.path() / "validation.log"), "fresh\n");
}

TEST_F(RunLogTest, ProgressLineShowsTheTimeLeftOnceItIsKnown) {
  RunLog log(folder_.path(), 1000, false);
  log.write({10, 0.5, 1.0, 1e-3, 40.0, 0.123, 1});
  EXPECT_EQ(quiet_.text().find("ETA"), std::string::npos);
  log.write({20, 0.4, 1.0, 1e-3, 40.0, 0.123, 1});
  EXPECT_NE(quiet_.text().find("12 % of the matrix peak"), std::string::npos) << quiet_.text();
  EXPECT_NE(quiet_.text().find("iteration 20/1000"), std::string::npos) << quiet_.text();
  EXPECT_NE(quiet_.text().find("ETA"), std::string::npos) << quiet_.text();
}

TEST_F(RunLogTest, DrawsTheLossWhateverTheFolderIsCalled) {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "gnuplot is not installed";
  }
  const std::filesystem::path folder = folder_.path() / "it's a \"run\"; $(touch x)";
  std::filesystem::create_directory(folder);
  RunLog log(folder, 20, false);
  log.write({10, 0.5, 1.0, 1e-3, 40.0, 0.1, 1});
  log.write({20, 0.25, 1.0, 1e-4, 40.0, 0.1, 1});
  log.plot();
  const std::string svg = text_of(folder / "loss.svg");
  EXPECT_NE(svg.find("training loss"), std::string::npos) << quiet_.text();
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
}

TEST_F(RunLogTest, AFolderThatCannotBeWrittenIsNamed) {
  const std::string message = error_of([&] { RunLog(folder_.path() / "missing", 20, false); });
  EXPECT_NE(message.find("missing"), std::string::npos) << message;
}

}  // namespace
}  // namespace rigidformer
