// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/data/kubasic.hpp"

#include <gtest/gtest.h>

#include <map>

#include "example_archive.hpp"

namespace rigidformer {
namespace {

TEST(Kubasic, RoundTripIsExact) {
  const TemporaryFolder folder;
  Shape shape = tetrahedron("wedge");
  shape.parts.push_back(shape.parts[0]);
  shape.parts[1].vertices.array() += 0.123456789F;
  write_kubasic_shape(folder.path(), shape);
  const Shape read = load_kubasic_shape(folder.path() / "wedge");
  EXPECT_EQ(read.name, "wedge");
  EXPECT_EQ(read.mass_kg, shape.mass_kg);
  ASSERT_EQ(read.parts.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.parts[i].vertices, shape.parts[i].vertices);
    EXPECT_EQ(read.parts[i].triangles, shape.parts[i].triangles);
  }
}

TEST(Kubasic, BrokenDataFileIsSurvivedWithAWarning) {
  const TemporaryFolder folder;
  for (const char* name : {"cone", "wedge"}) {
    write_kubasic_shape(folder.path(), tetrahedron(name));
    write_text(folder.path() / name / "data.json", "{\"kwargs\": {\"mass\": 0.5,}}");
  }
  std::vector<std::string> warnings;
  const std::vector<Shape> shapes = load_kubasic_shapes(folder.path(), &warnings);
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_EQ(shapes[0].mass_kg, movi_shape_mass("cone"));  // the mass known from MOVi
  EXPECT_NEAR(shapes[1].mass_kg, 1.0 / 6.0, 1e-6);        // the volume of the tetrahedron
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_NE(warnings[1].find("data.json"), std::string::npos) << warnings[1];
}

TEST(Kubasic, TrianglesAreTurnedOutwards) {
  const TemporaryFolder folder;
  Shape inside_out = tetrahedron("wedge");
  inside_out.parts[0].triangles.col(1).swap(inside_out.parts[0].triangles.col(2));
  write_kubasic_shape(folder.path(), inside_out);
  const ConvexPart part = load_kubasic_shape(folder.path() / "wedge").parts[0];
  const Eigen::Vector3f centre = part.vertices.colwise().mean().transpose();
  for (Eigen::Index f = 0; f < part.triangles.rows(); ++f) {
    const Eigen::Vector3f a = part.vertices.row(part.triangles(f, 0));
    const Eigen::Vector3f b = part.vertices.row(part.triangles(f, 1));
    const Eigen::Vector3f c = part.vertices.row(part.triangles(f, 2));
    EXPECT_GT((b - a).cross(c - a).dot(a - centre), 0.0F);
  }
}

std::string error_for_obj(const std::string& text) {
  const TemporaryFolder folder;
  write_text(folder.path() / "thing" / "collision_geometry.obj", text);
  return error_of([&] { load_kubasic_shapes(folder.path()); });
}

TEST(Kubasic, BrokenGeometryIsAClearError) {
  const std::string corners = "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  EXPECT_EQ(error_for_obj(corners + faces), "");
  EXPECT_NE(error_for_obj("").find("no vertices"), std::string::npos);
  EXPECT_NE(error_for_obj(corners).find("closed mesh"), std::string::npos);
  EXPECT_NE(error_for_obj(corners + "f 1 2 9\n").find("face index 9"), std::string::npos);
  EXPECT_NE(error_for_obj(corners + "f 1 2 -2147483648\n").find("face index -2147483648"), std::string::npos);
  EXPECT_NE(error_for_obj("v 0 zero 0\n").find("broken vertex"), std::string::npos);
  EXPECT_NE(error_for_obj(corners + "v 1 1 1\n" + faces).find("not convex"), std::string::npos);
}

TEST(Kubasic, P43_BackgroundsAndUnusableShapesAreLeftOutByName) {
  const TemporaryFolder folder;
  write_kubasic_shape(folder.path(), tetrahedron("good"));
  write_kubasic_shape(folder.path(), tetrahedron("sky"));
  write_text(folder.path() / "sky" / "data.json", R"({"kwargs": {"mass": 0.0, "background": true}})");
  write_text(folder.path() / "torn" / "collision_geometry.obj", "v 0 0 0\n");
  std::vector<std::string> warnings;
  const std::vector<Shape> shapes = load_usable_kubasic_shapes(folder.path(), warnings);
  ASSERT_EQ(shapes.size(), 1u);
  EXPECT_EQ(shapes[0].name, "good");
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_NE(warnings[0].find("sky' is a background"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[1].find("torn/collision_geometry.obj"), std::string::npos) << warnings[1];
  std::filesystem::remove_all(folder.path() / "good");
  EXPECT_NE(error_of([&] { load_usable_kubasic_shapes(folder.path(), warnings); }).find("no usable shape"),
            std::string::npos);
}

TEST(Kubasic, AFolderWithoutShapesIsAnError) {
  const TemporaryFolder folder;
  EXPECT_NE(error_of([&] { load_kubasic_shapes(folder.path()); }), "");
  EXPECT_NE(error_of([&] { load_kubasic_shapes(folder.path() / "none"); }).find("no such folder"), std::string::npos);
}

TEST(Kubasic, PublishedShapesHaveTheVertexCountsOfThePaper) {
  const std::filesystem::path folder = RIGIDFORMER_SOURCE_DIR "/../shared/data/kubasic";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "KuBasic shapes are not there: " << folder;
  const std::map<std::string, int> expected = {{"cone", 64},    {"cube", 51},    {"cylinder", 64},    {"gear", 569},
                                               {"sphere", 64},  {"sponge", 908}, {"spot", 682},       {"suzanne", 523},
                                               {"teapot", 274}, {"torus", 647},  {"torus_knot", 1142}};  // Tab. D11
  const std::vector<Shape> shapes = load_kubasic_shapes(folder);
  ASSERT_EQ(shapes.size(), expected.size());
  for (const Shape& shape : shapes) {
    ASSERT_EQ(expected.count(shape.name), 1u) << shape.name;
    EXPECT_EQ(shape.vertices().rows(), expected.at(shape.name)) << shape.name;
    EXPECT_EQ(shape.mass_kg, movi_shape_mass(shape.name)) << shape.name;
  }
}

}  // namespace
}  // namespace rigidformer
