// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_csv.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "rigidformer/io/text_file.hpp"

namespace rigidformer {
namespace {

constexpr std::uintmax_t kMaxBytes = 1u << 30;  // bound on memory: ten hours of one object at 240 Hz; by eye
constexpr double kUnitTolerance = 0.01;         // quaternions written with three digits are within; chosen by eye
constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr std::array<const char*, 7> kPoseColumns = {"x", "y", "z", "qx", "qy", "qz", "qw"};

std::vector<std::string> cells_of(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> cells;
  std::istringstream text(line + ',');
  for (std::string cell; std::getline(text, cell, ',');) {
    const std::size_t begin = cell.find_first_not_of(" \t\""), end = cell.find_last_not_of(" \t\"");
    cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
  }
  return cells;
}

class PoseCsv {
 public:
  explicit PoseCsv(const std::filesystem::path& path) : path_(path) {}

  std::vector<MeasuredRecording> read(const std::string& recording_column) {
    std::istringstream text(content());
    std::string line;
    std::getline(text, line);
    line_ = 1;
    read_names(cells_of(line), recording_column);
    while (std::getline(text, line)) {
      ++line_;
      if (line.find_first_not_of(" \t\r") != std::string::npos) read_pose(cells_of(line));
    }
    if (recordings_.empty()) fail("holds no pose");
    return std::move(recordings_);
  }

 private:
  [[noreturn]] void fail(const std::string& defect) const {
    throw std::runtime_error("poses '" + path_.string() + "': line " + std::to_string(line_) + ": " + defect);
  }

  std::string content() const {
    try {
      return read_text_file(path_, kMaxBytes);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("poses '" + path_.string() + "': " + error.what());
    }
  }

  std::size_t find(const std::string& name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    return found == names_.end() ? kNone : static_cast<std::size_t>(found - names_.begin());
  }

  std::size_t needed(const std::string& name) const {
    const std::size_t column = find(name);
    if (column == kNone) fail("there is no column '" + name + "'; needed are t (or time), x, y, z, qx, qy, qz, qw");
    return column;
  }

  void read_names(std::vector<std::string> names, const std::string& recording_column) {
    names_ = std::move(names);
    recording_ = find(recording_column);
    id_ = find("id");
    time_ = find("time");
    if (time_ == kNone) time_ = needed("t");
    for (std::size_t i = 0; i < kPoseColumns.size(); ++i) pose_[i] = needed(kPoseColumns[i]);
  }

  double number(const std::vector<std::string>& cells, std::size_t column) const {
    const std::string& cell = cells[column];
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
      fail("column '" + names_[column] + "' is '" + cell + "', must be a finite number");
    }
    return value;
  }

  MeasuredTrack& track_of(const std::vector<std::string>& cells) {
    const std::string name = recording_ == kNone ? path_.stem().string() : cells[recording_];
    const std::string id = id_ == kNone ? "object" : cells[id_];
    if (name.empty() || id.empty()) fail("the name of a recording or of an object is empty");
    const auto [recording, is_new] = index_of_.emplace(name, recordings_.size());
    if (is_new) recordings_.push_back({name, {}});
    std::vector<MeasuredTrack>& tracks = recordings_[recording->second].tracks;
    const auto found = std::find_if(tracks.begin(), tracks.end(), [&](const auto& track) { return track.id == id; });
    return found == tracks.end() ? tracks.emplace_back(MeasuredTrack{id, {}, {}}) : *found;
  }

  void read_pose(const std::vector<std::string>& cells) {
    if (cells.size() != names_.size()) {
      fail("has " + std::to_string(cells.size()) + " columns, the first line names " + std::to_string(names_.size()));
    }
    std::array<double, 7> p{};
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = number(cells, pose_[i]);
    RigidTransform T{Eigen::Quaterniond(p[6], p[3], p[4], p[5]), Eigen::Vector3d(p[0], p[1], p[2])};
    if (!(std::abs(T.rotation.norm() - 1.0) < kUnitTolerance)) {
      fail("the quaternion has length " + std::to_string(T.rotation.norm()) + ", must be 1");
    }
    T.rotation.normalize();
    const double time_s = number(cells, time_);
    MeasuredTrack& track = track_of(cells);
    if (!track.times_s.empty() && !(time_s > track.times_s.back())) {
      fail("object '" + track.id + "': time " + std::to_string(time_s) + " does not come after " +
           std::to_string(track.times_s.back()));
    }
    track.times_s.push_back(time_s);
    track.T_world_object.push_back(T);
  }

  const std::filesystem::path& path_;
  int line_ = 0;
  std::vector<std::string> names_;
  std::size_t recording_ = kNone, id_ = kNone, time_ = kNone;
  std::array<std::size_t, 7> pose_{};
  std::vector<MeasuredRecording> recordings_;
  std::map<std::string, std::size_t> index_of_;
};

}  // namespace

std::vector<MeasuredRecording> read_pose_csv(const std::filesystem::path& path, const std::string& recording_column) {
  return PoseCsv(path).read(recording_column);
}

}  // namespace rigidformer
