// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/io/gnuplot.hpp"

#include <cstdio>

namespace rigidformer {

std::string gnuplot_string(const std::filesystem::path& path) {
  std::string text = "'";
  for (const char letter : path.string()) {
    text += letter == '\'' ? std::string("''") : std::string(1, letter);
  }
  return text + "'";
}

bool run_gnuplot(const std::string& commands) {
  // Commands go through gnuplot's standard input, so that no path passes the shell. A missing gnuplot must
  // not end this process by SIGPIPE.
  FILE* gnuplot =
      popen("command -v gnuplot >/dev/null && exec gnuplot 2>/dev/null || { cat >/dev/null; exit 1; }", "w");
  if (gnuplot == nullptr) return false;
  std::fputs(commands.c_str(), gnuplot);
  return pclose(gnuplot) == 0;
}

}  // namespace rigidformer
