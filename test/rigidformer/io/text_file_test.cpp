// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/io/text_file.hpp"

#include <gtest/gtest.h>

#include "rigidformer/io/full_disk.hpp"

namespace rigidformer {
namespace {

TEST(TextFile, ReadsWhatWasWrittenUpToTheLimit) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "text";
  const std::string text("a\0b\r\n", 5);
  write_text_file(path, text);
  EXPECT_EQ(read_text_file(path, 5), text);
  EXPECT_NE(error_of([&] { read_text_file(path, 4); }).find("at most 4"), std::string::npos);
  EXPECT_EQ(count_files(folder.path()), 1);
}

TEST(TextFile, OnlyRegularFilesAreRead) {
  const TemporaryFolder folder;
  EXPECT_NE(error_of([&] { read_text_file(folder.path() / "none", 10); }), "");
  EXPECT_NE(error_of([&] { read_text_file(folder.path(), 10); }), "");
  EXPECT_NE(error_of([&] { read_text_file("/dev/zero", 10); }), "");
}

TEST(TextFile, AFullDiskIsAClearErrorAndKeepsTheOldFile) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "text";
  write_text_file(path, "old");
  const std::string message = on_a_full_disk([&] { write_text_file(path, std::string(100000, 'x')); });
  EXPECT_NE(message.find("cannot write: File too large"), std::string::npos) << message;
  EXPECT_EQ(read_text_file(path, 10), "old");
  EXPECT_EQ(count_files(folder.path()), 1);
}

TEST(JsonNesting, CountsBracketsOutsideOfStrings) {
  EXPECT_FALSE(nests_too_deeply(R"([{"a": [1, 2]}])"));
  EXPECT_FALSE(nests_too_deeply(std::string(64, '[')));
  EXPECT_TRUE(nests_too_deeply(std::string(65, '[')));
  EXPECT_TRUE(nests_too_deeply(R"({"a\\": )" + std::string(65, '{')));
  EXPECT_FALSE(nests_too_deeply(R"({"a\": )" + std::string(65, '{')));  // all brackets are within a string
  std::string flat;
  for (int i = 0; i < 100; ++i) flat += "[],";
  EXPECT_FALSE(nests_too_deeply(flat));
}

}  // namespace
}  // namespace rigidformer
