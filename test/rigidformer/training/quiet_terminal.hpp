// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iostream>
#include <sstream>
#include <string>

namespace rigidformer {

/// Keeps what is written to std::cerr while it lives: progress lines do not belong into the output of a test.
class QuietTerminal {
 public:
  QuietTerminal() : terminal_(std::cerr.rdbuf(text_.rdbuf())) {}
  ~QuietTerminal() { std::cerr.rdbuf(terminal_); }
  QuietTerminal(const QuietTerminal&) = delete;
  QuietTerminal& operator=(const QuietTerminal&) = delete;

  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::streambuf* terminal_;
};

}  // namespace rigidformer
