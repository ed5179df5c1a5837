// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "rigidformer/io/member_table.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {
namespace {

const char* const kDocument = RIGIDFORMER_SOURCE_DIR "/docs/interface.md";

/// The tables by the name of their group; those that are not in a group are called "node".
std::map<std::string, std::string> tables() {
  NodeParameters parameters;
  std::map<std::string, std::string> tables;
  std::vector<rigidformer::MemberRow> top = rigidformer::member_rows(parameters);
  tables["node"] = rigidformer::markdown_table(top);
  for_each_member(parameters, [&](const char* key, auto& value, const Accepts&, const char*) {
    if constexpr (rigidformer::has_members<std::decay_t<decltype(value)>>) {
      tables[key] = rigidformer::markdown_table(rigidformer::member_rows(value));
    }
  });
  return tables;
}

/// The document with each table in its place, between `<!-- parameters:begin GROUP -->` and
/// `<!-- parameters:end -->`.
std::string with_tables(const std::string& document) {
  std::map<std::string, std::string> left = tables();
  std::istringstream lines(document);
  std::string text;
  bool in_table = false;
  const std::string begin = "<!-- parameters:begin ";
  for (std::string line; std::getline(lines, line);) {
    in_table = in_table && line != "<!-- parameters:end -->";
    text += in_table ? "" : line + "\n";
    if (line.compare(0, begin.size(), begin) == 0) {
      const std::string group = line.substr(begin.size(), line.find(' ', begin.size()) - begin.size());
      text += left.at(group);
      left.erase(group);
      in_table = true;
    }
  }
  for (const auto& [group, table] : left) {
    ADD_FAILURE() << kDocument << " has no place for the table of the group " << group;
  }
  return text;
}

// After a change of a parameter: RIGIDFORMER_WRITE_DOCS=1 ros_unit_tests --gtest_filter=ParameterDocs.*
TEST(ParameterDocs, TablesInTheDocumentAreCurrent) {
  std::stringstream written;
  written << std::ifstream(kDocument).rdbuf();
  const std::string current = with_tables(written.str());
  if (std::getenv("RIGIDFORMER_WRITE_DOCS") != nullptr) {
    std::ofstream(kDocument) << current;
  } else {
    EXPECT_EQ(written.str(), current) << "the next run with RIGIDFORMER_WRITE_DOCS=1 brings it up to date";
  }
}

TEST(ParameterDocs, LinesAreShortEnoughToRead) {
  for (const auto& [group, table] : tables()) {
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), 120U) << line;
    }
  }
}

}  // namespace
}  // namespace rigidformer_ros
