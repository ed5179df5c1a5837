// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <clocale>
#include <locale>

#include "example_archive.hpp"
#include "rigidformer/data/kubasic.hpp"
#include "rigidformer/data/kubric.hpp"

namespace rigidformer {
namespace {

/// Numbers as in Germany: 1.234,5.
class DecimalComma : public std::numpunct<char> {
 protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// A process whose streams, and where such a language is installed also its C functions, write decimal commas.
class LocaleTest : public ::testing::Test {
 protected:
  LocaleTest() : streams_(std::locale::global(std::locale(std::locale::classic(), new DecimalComma))) {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
      if (std::setlocale(LC_NUMERIC, name) != nullptr) break;
    }
  }
  ~LocaleTest() override {
    std::locale::global(streams_);
    std::setlocale(LC_NUMERIC, "C");
  }

 private:
  std::locale streams_;
};

TEST_F(LocaleTest, P49_ShapesAndScenesAreWrittenAndReadWithDecimalPoints) {
  const TemporaryFolder folder;
  Shape shape = tetrahedron();
  shape.parts[0].vertices *= 1234.5F;
  shape.mass_kg = 1234.5;
  write_kubasic_shape(folder.path(), shape);
  const Shape read = load_kubasic_shape(folder.path() / shape.name);
  EXPECT_EQ(read.parts[0].vertices, shape.parts[0].vertices);
  EXPECT_EQ(read.mass_kg, shape.mass_kg);

  const SceneRecording scene = example_archive().scenes[1];
  write_kubric_scene(folder.path() / "1", scene);
  EXPECT_LT(pose_difference(read_kubric_scene(folder.path() / "1").objects[1], scene.objects[1]), 1e-7);

  const SceneArchive archive = example_archive();
  write_scene_archive(folder.path() / "a.safetensors", archive);
  const SceneArchive loaded = read_scene_archive(folder.path() / "a.safetensors");
  EXPECT_EQ(loaded.scenes[0].frame_rate_hz, archive.scenes[0].frame_rate_hz);
  EXPECT_EQ(loaded.shapes[0].mass_kg, archive.shapes[0].mass_kg);
}

}  // namespace
}  // namespace rigidformer
