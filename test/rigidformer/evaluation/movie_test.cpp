// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/movie.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/evaluation/ballistic.hpp"
#include "rigidformer/evaluation/flying_cubes.hpp"

namespace rigidformer {
namespace {

class Movie : public ::testing::Test {
 protected:
  bool draw(int num_frames) {
    MovieOptions options;
    options.start = 10;
    options.num_steps = 3;
    return draw_movie(gif_, flying_cubes(2, num_frames), Observer({unit_cube()}, {}), ballistic_, options);
  }

  const TemporaryFolder folder_;
  const std::filesystem::path gif_ = folder_.path() / "a movie.gif";
  BallisticForecaster ballistic_;
};

TEST_F(Movie, IsAnAnimatedGif) {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "gnuplot is not installed";
  }
  ASSERT_TRUE(draw(51));
  std::ifstream in(gif_, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(bytes.substr(0, 6), "GIF89a");
  EXPECT_NE(bytes.find("NETSCAPE2.0"), std::string::npos) << "does not loop";
}

TEST_F(Movie, ARecordingThatEndsTooEarlyIsRefusedByName) {
  const std::string message = error_of([&] { draw(50); });
  EXPECT_NE(message.find("flying_cubes"), std::string::npos) << message;
  EXPECT_FALSE(std::filesystem::exists(gif_));
}

}  // namespace
}  // namespace rigidformer
