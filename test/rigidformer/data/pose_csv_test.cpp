// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/data/pose_csv.hpp"

#include <gtest/gtest.h>

#include "example_archive.hpp"
#include "rigidformer/io/text_file.hpp"

namespace rigidformer {
namespace {

class PoseCsvTest : public testing::Test {
 protected:
  std::vector<MeasuredRecording> read(const std::string& text) {
    write_text_file(path_, text);
    return read_pose_csv(path_, "toss");
  }

  std::string refusal(const std::string& text) {
    return error_of([&] { read(text); });
  }

  const TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_.path() / "poses.csv";
};

TEST_F(PoseCsvTest, ColumnsComeInAnyOrderAndOthersArePassedOver) {
  const auto recordings = read(
      "qw,toss,frame, time ,id,x,y,z,qx,qy,qz\r\n"
      "1,7,0,0.5,cup,1,2,3,0,0,0\r\n"
      "0,7,0,0.5,box,4,5,6,0,0,1\r\n"
      "\r\n"
      "1,8,1,-0.25,cup,1e-1,0,0,0,0,0\r\n"
      "1,7,1,0.75,cup,2,2,3,0,0,0\r\n");
  ASSERT_EQ(recordings.size(), 2U);
  EXPECT_EQ(recordings[0].name, "7");
  EXPECT_EQ(recordings[1].name, "8");
  ASSERT_EQ(recordings[0].tracks.size(), 2U);
  EXPECT_EQ(recordings[0].tracks[0].id, "cup");
  EXPECT_EQ(recordings[0].tracks[0].times_s, (std::vector<double>{0.5, 0.75}));
  EXPECT_EQ(recordings[0].tracks[0].T_world_object[1].translation, Eigen::Vector3d(2, 2, 3));
  EXPECT_EQ(recordings[0].tracks[1].T_world_object[0].rotation.z(), 1.0);
  EXPECT_EQ(recordings[1].tracks[0].T_world_object[0].translation.x(), 0.1);
}

TEST_F(PoseCsvTest, WithoutColumnsForThemAFileIsOneRecordingOfOneObject) {
  const auto recordings = read("t,x,y,z,qx,qy,qz,qw\n0,0,0,1,0,0,0,1.001\n");
  ASSERT_EQ(recordings.size(), 1U);
  EXPECT_EQ(recordings[0].name, "poses");
  EXPECT_EQ(recordings[0].tracks.at(0).id, "object");
  EXPECT_NEAR(recordings[0].tracks[0].T_world_object[0].rotation.norm(), 1.0, 1e-12);
}

TEST_F(PoseCsvTest, ErrorsNameFileLineAndWhatIsAccepted) {
  const std::string names = "t,x,y,z,qx,qy,qz,qw\n", pose = ",0,0,1,0,0,0,1\n";
  for (const auto& [text, expected] : std::vector<std::pair<std::string, std::string>>{
           {"t,x,y,z,qx,qy,qz\n", "line 1: there is no column 'qw'"},
           {"x,y,z,qx,qy,qz,qw\n", "line 1: there is no column 't'"},
           {names, "holds no pose"},
           {names + "0" + pose + "1,2\n", "line 3: has 2 columns, the first line names 8"},
           {names + "0,0,high,1,0,0,0,1\n", "line 2: column 'y' is 'high', must be a finite number"},
           {names + "0,0,nan,1,0,0,0,1\n", "line 2: column 'y' is 'nan'"},
           {names + "0,0,0,1,0,0,0,2\n", "line 2: the quaternion has length 2.000000, must be 1"},
           {names + "1" + pose + "1" + pose, "line 3: object 'object': time 1.000000 does not come after 1.000000"}}) {
    const std::string error = refusal(text);
    EXPECT_NE(error.find(expected), std::string::npos) << error;
    EXPECT_NE(error.find("poses.csv"), std::string::npos) << error;
  }
  EXPECT_NE(error_of([] { read_pose_csv("/nonexistent/poses.csv", "toss"); }).find("/nonexistent/poses.csv"),
            std::string::npos);
}

}  // namespace
}  // namespace rigidformer
