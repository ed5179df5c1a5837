// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/data/obj_file.hpp"

#include <gtest/gtest.h>

#include "example_archive.hpp"

namespace rigidformer {
namespace {

const char kCorners[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const char kFaces[] = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::vector<ObjPart> parse(const std::string& text) { return parse_obj("dir/x.obj", text); }

std::string refusal(const std::string& text) {
  return error_of([&] { parse(text); });
}

/// Every way to write the same tetrahedron.
class ObjDialect : public ::testing::TestWithParam<std::string> {};

TEST_P(ObjDialect, P44_GivesTheSameMesh) {
  const ObjPart expected = parse(std::string("o a\n") + kCorners + kFaces).at(0);
  const std::vector<ObjPart> parts = parse(GetParam());
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].vertices, expected.vertices);
  EXPECT_EQ(parts[0].triangles, expected.triangles);
}

std::string with_windows_line_ends(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return result;
}

const std::string kPlain = std::string(kCorners) + kFaces;

INSTANTIATE_TEST_SUITE_P(
    Dialects, ObjDialect,
    ::testing::Values(kPlain, kPlain.substr(0, kPlain.size() - 1), with_windows_line_ends("o a\n" + kPlain),
                      std::string(kFaces) + kCorners, "g a\n" + kPlain,
                      "# made by hand\nmtllib x.mtl\no a\n" + kPlain + "usemtl none\ns off\n",
                      std::string(kCorners) + "f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n",
                      std::string(kCorners) +
                          "vt 0 0\nvn 0 0 1\nf 1/1 3/1 2/1\nf 1//1 2//1 4//1\nf 1/1/1 4/1/1 3/1/1\n" + "f 2/ 3/ 4/\n",
                      std::string("v 0 0 0 1.0\nv\t1\t0\t0 # x\nv 0 1e0 0\nv 0. .0 +1 0.5 0.5 0.5\n") + kFaces,
                      std::string(kCorners) + "f 1 3 \\\n2\nf 1 \\\r\n2 4\nf 1 4 3 # last\nf 2 3 4 \\",
                      std::string("o a\n") + kCorners + "g x\nf 1 3 2\nf 1 2 4\ng y\nf 1 4 3\nf 2 3 4\n"));

TEST(ObjFile, P44_PolygonsBecomeFans) {
  const std::vector<ObjPart> parts = parse("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\nf 1 2 3 4 5\n");
  ASSERT_EQ(parts.at(0).triangles.size(), 3u);
  EXPECT_EQ(parts[0].triangles[2], Eigen::Vector3i(0, 3, 4));
}

TEST(ObjFile, P44_PartsAreMadeOfTheVerticesThatTheirFacesName) {
  const std::string second = "f 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n";
  const std::string all_vertices = std::string(kCorners) + "v 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\n";
  for (const std::string& text :
       {all_vertices + "g a\n" + kFaces + "g b\n" + second, "o a\n" + all_vertices + kFaces + "o b\n" + second,
        "o both\n" + all_vertices + "g a\n" + kFaces + "g b\n" + second,
        "o a\n" + std::string(kFaces) + "o b\n" + second + all_vertices}) {
    const std::vector<ObjPart> parts = parse(text);
    ASSERT_EQ(parts.size(), 2u) << text;
    ASSERT_EQ(parts[1].vertices.size(), 4u) << text;
    EXPECT_EQ(parts[1].vertices[0].x(), 5.0F);
    EXPECT_EQ(parts[1].triangles[0], Eigen::Vector3i(0, 2, 1));
  }
}

TEST(ObjFile, P44_ErrorsNameFileLineAndWhatIsAccepted) {
  EXPECT_NE(refusal(kPlain + "f 1 2 9\n").find("dir/x.obj': line 9: face index 9 names no vertex: the file has 4"),
            std::string::npos);
  EXPECT_NE(refusal("v 0 0 0\nf -2 1 1\n").find("line 2: face index -2 names no vertex: 1 were read"),
            std::string::npos);
  EXPECT_NE(refusal(kPlain + "f 0 1 2\n").find("face index 0"), std::string::npos);
  EXPECT_NE(refusal(kPlain + "f 1 2 99999999999999999999\n").find("broken face line"), std::string::npos);
  EXPECT_NE(refusal(kPlain + "f 1 2 3.5\n").find("accepted are corners like 3, 3/1"), std::string::npos);
  EXPECT_NE(refusal("v 0 0 0\r\nf 1 1\r\n").find("line 2: face 'f 1 1' has fewer than three"), std::string::npos);
  EXPECT_NE(refusal("v 0 zero 0\n").find("line 1: broken vertex line 'v 0 zero 0'"), std::string::npos);
  EXPECT_NE(refusal("v 0 0 0,5\n").find("broken vertex"), std::string::npos);
  EXPECT_NE(refusal("v 0 0 nan\n").find("broken vertex"), std::string::npos);
  EXPECT_NE(refusal("# nothing\n").find("no vertices"), std::string::npos);
  EXPECT_NE(refusal(kCorners).find("no faces"), std::string::npos);
}

}  // namespace
}  // namespace rigidformer
