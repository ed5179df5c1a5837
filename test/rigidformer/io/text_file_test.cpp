// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/io/text_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

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

TEST(TextFile, TheErrorOfASavedFileNamesIt) {
  EXPECT_NE(error_of([] { save_text_file("/nonexistent/text", "x"); }).find("'/nonexistent/text': cannot write"),
            std::string::npos);
}

TEST(TextFile, APipeStaysAPipe) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int pipe = open(path.c_str(), O_RDWR | O_NONBLOCK);
  write_text_file(path, "text");
  char read_back[8] = {};
  EXPECT_EQ(read(pipe, read_back, sizeof(read_back)), 4);
  EXPECT_STREQ(read_back, "text");
  close(pipe);
  EXPECT_TRUE(std::filesystem::is_fifo(path));
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
