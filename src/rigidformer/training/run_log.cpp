// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/run_log.hpp"

#include <iomanip>
#include <iostream>
#include <stdexcept>

#include "rigidformer/io/gnuplot.hpp"

namespace rigidformer {

RunLog::RunLog(const std::filesystem::path& folder, std::int64_t total_iterations, bool append)
    : folder_(folder), total_iterations_(total_iterations), start_(std::chrono::steady_clock::now()) {
  const auto mode = append ? std::ios::app : std::ios::trunc;
  const bool has_header = append && std::filesystem::exists(folder / "log.csv");
  csv_.open(folder / "log.csv", mode);
  notes_.open(folder / "validation.log", mode);
  if (!csv_ || !notes_) throw std::runtime_error("cannot write to '" + folder.string() + "'");
  if (!has_header) csv_ << "iteration,loss,gradient_norm,learning_rate,windows_per_s,share_of_peak,unroll_steps\n";
}

void RunLog::write(const LogEntry& entry) {
  csv_ << entry.iteration << ',' << entry.loss << ',' << entry.gradient_norm << ',' << entry.learning_rate << ','
       << entry.windows_per_s << ',' << entry.share_of_peak << ',' << entry.unroll_steps << std::endl;
  if (first_iteration_ < 0) first_iteration_ = entry.iteration;
  const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const auto done = static_cast<double>(entry.iteration - first_iteration_);
  const auto left = static_cast<double>(total_iterations_ - entry.iteration);
  std::cerr << "iteration " << entry.iteration << '/' << total_iterations_ << "  loss " << std::setprecision(4)
            << entry.loss << "  |g| " << entry.gradient_norm << "  lr " << entry.learning_rate << "  "
            << static_cast<std::int64_t>(entry.windows_per_s) << " windows/s ("
            << static_cast<std::int64_t>(100.0 * entry.share_of_peak) << " % of the matrix peak)  unroll "
            << entry.unroll_steps;
  if (done > 0.0) std::cerr << "  ETA " << static_cast<std::int64_t>(elapsed_s / done * left) << " s";
  std::cerr << std::endl;
}

void RunLog::note(const std::string& message) {
  notes_ << message << std::endl;
  std::cerr << message << std::endl;
}

void RunLog::plot() const {
  const bool drawn = run_gnuplot(
      "set datafile separator ','; set terminal svg size 900,500; set output " + gnuplot_string(folder_ / "loss.svg") +
      "; set logscale y; set xlabel 'iteration'; set ylabel 'loss'; set grid; plot " +
      gnuplot_string(folder_ / "log.csv") + " every ::1 using 1:2 with lines title 'training loss'\n");
  if (!drawn) std::cerr << "no loss.svg: gnuplot is not installed, or nothing is logged yet\n";
}

}  // namespace rigidformer
