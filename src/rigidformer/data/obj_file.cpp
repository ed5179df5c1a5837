// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "obj_file.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <locale>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace rigidformer {
namespace {

constexpr std::size_t kMaxQuotedText = 60;

/// A face as it stands in the file.
struct Face {
  std::int64_t line = 0;
  std::vector<std::int64_t> corners;  ///< Indices into all vertices of the file, from 0
};

/// What stands between two `o` or `g` lines.
struct Group {
  std::size_t object = 0;  ///< Number of `o` lines before it
  std::vector<std::size_t> own_vertices;
  std::vector<Face> faces;
};

class ObjReader {
 public:
  explicit ObjReader(const std::filesystem::path& path) : path_(path), groups_(1) {}

  void read(const std::string& text);
  std::vector<ObjPart> parts();

 private:
  [[noreturn]] void fail(std::int64_t line, const std::string& defect) const {
    const std::string place = line > 0 ? "line " + std::to_string(line) + ": " : "";
    throw std::runtime_error("shape '" + path_.string() + "': " + place + defect);
  }

  void read_line(std::int64_t number, const std::string& text);
  void read_vertex(std::int64_t number, std::istringstream& words, const std::string& text);
  void read_face(std::int64_t number, std::istringstream& words, const std::string& text);
  std::int64_t corner_of(std::int64_t number, const std::string& word, const std::string& text) const;
  void check_faces() const;
  std::vector<std::size_t> part_of_groups() const;
  ObjPart make_part(const std::vector<const Group*>& members, const std::vector<bool>& named) const;

  const std::filesystem::path& path_;
  std::size_t num_objects_ = 0;
  std::vector<Eigen::Vector3f> vertices_;
  std::vector<Group> groups_;
};

/// A part of the text that an error may show.
std::string quoted(const std::string& text) {
  return "'" + text.substr(0, kMaxQuotedText) + (text.size() > kMaxQuotedText ? "...'" : "'");
}

/// Lines of Windows end in \r\n, a backslash continues a line, and # begins a comment.
void ObjReader::read(const std::string& text) {
  std::istringstream in(text);
  std::string joined;
  std::int64_t number = 0, first = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (joined.empty()) first = number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty() && line.back() == '\\') {
      line.back() = ' ';
      joined += line;
      continue;
    }
    read_line(first, joined + line);
    joined.clear();
  }
  read_line(first, joined);
}

void ObjReader::read_line(std::int64_t number, const std::string& text) {
  std::istringstream words(text.substr(0, text.find('#')));
  words.imbue(std::locale::classic());
  std::string keyword;
  words >> keyword;
  if (keyword == "o" || keyword == "g") {
    num_objects_ += keyword == "o" ? 1 : 0;
    groups_.push_back({num_objects_, {}, {}});
  }
  if (keyword == "v") read_vertex(number, words, text);
  if (keyword == "f") read_face(number, words, text);
}

void ObjReader::read_vertex(std::int64_t number, std::istringstream& words, const std::string& text) {
  Eigen::Vector3f vertex;
  const bool complete = static_cast<bool>(words >> vertex.x() >> vertex.y() >> vertex.z());
  // A decimal comma would otherwise end the last number without a word.
  if (!complete || !vertex.allFinite() || (!words.eof() && std::isspace(words.peek()) == 0)) {
    fail(number, "broken vertex line " + quoted(text) + ", accepted is v X Y Z with finite numbers like -0.5");
  }
  groups_.back().own_vertices.push_back(vertices_.size());
  vertices_.push_back(vertex);
}

void ObjReader::read_face(std::int64_t number, std::istringstream& words, const std::string& text) {
  Face face{number, {}};
  for (std::string word; words >> word;) face.corners.push_back(corner_of(number, word, text));
  if (face.corners.size() < 3) fail(number, "face " + quoted(text) + " has fewer than three corners");
  groups_.back().faces.push_back(std::move(face));
}

/// Vertices count from 1; -1 is the one read last.
std::int64_t ObjReader::corner_of(std::int64_t number, const std::string& word, const std::string& text) const {
  std::int64_t index = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, index);
  if (error != std::errc() || (rest != end && *rest != '/')) {
    fail(number, "broken face line " + quoted(text) + ", accepted are corners like 3, 3/1, 3/1/2, 3//2 or -1");
  }
  const auto count = static_cast<std::int64_t>(vertices_.size());
  if (index == 0 || index < -count) {
    fail(number, "face index " + std::to_string(index) + " names no vertex: " + std::to_string(count) +
                     " were read before, accepted are indices from 1, or from -1 backwards");
  }
  return index > 0 ? index - 1 : count + index;
}

/// Faces may stand before their vertices, so that indices can be judged at the end only.
void ObjReader::check_faces() const {
  const auto count = static_cast<std::int64_t>(vertices_.size());
  bool any = false;
  for (const Group& group : groups_) {
    for (const Face& face : group.faces) {
      any = true;
      const std::int64_t largest = *std::max_element(face.corners.begin(), face.corners.end());
      if (largest >= count) {
        fail(face.line,
             "face index " + std::to_string(largest + 1) + " names no vertex: the file has " + std::to_string(count));
      }
    }
  }
  if (vertices_.empty()) fail(0, "holds no vertices");
  if (!any) fail(0, "is not a closed mesh: it holds no faces");
}

/// The number of the first group of the part that each group belongs to.
std::vector<std::size_t> ObjReader::part_of_groups() const {
  std::vector<std::size_t> parent(groups_.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t g) {
    while (parent[g] != g) g = parent[g] = parent[parent[g]];
    return g;
  };
  std::vector<std::size_t> last_user(vertices_.size(), groups_.size());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (const Face& face : groups_[g].faces) {
      for (const std::int64_t corner : face.corners) {
        std::size_t& user = last_user[static_cast<std::size_t>(corner)];
        if (user < g && groups_[user].object == groups_[g].object) {
          const std::size_t a = root(user), b = root(g);
          parent[std::max(a, b)] = std::min(a, b);
        }
        user = g;
      }
    }
  }
  for (std::size_t g = 0; g < groups_.size(); ++g) parent[g] = root(g);
  return parent;
}

ObjPart ObjReader::make_part(const std::vector<const Group*>& members, const std::vector<bool>& named) const {
  std::vector<std::size_t> used;
  for (const Group* group : members) {
    for (const std::size_t vertex : group->own_vertices) {
      if (!named[vertex]) used.push_back(vertex);
    }
    for (const Face& face : group->faces) used.insert(used.end(), face.corners.begin(), face.corners.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  ObjPart part;
  for (const std::size_t vertex : used) part.vertices.push_back(vertices_[vertex]);
  const auto local = [&](std::int64_t corner) {
    const auto found = std::lower_bound(used.begin(), used.end(), static_cast<std::size_t>(corner));
    return static_cast<int>(found - used.begin());
  };
  for (const Group* group : members) {
    for (const Face& face : group->faces) {
      for (std::size_t i = 2; i < face.corners.size(); ++i) {
        part.triangles.emplace_back(local(face.corners[0]), local(face.corners[i - 1]), local(face.corners[i]));
      }
    }
  }
  return part;
}

std::vector<ObjPart> ObjReader::parts() {
  check_faces();
  std::vector<bool> named(vertices_.size(), false);
  std::map<std::size_t, std::vector<const Group*>> members;
  const std::vector<std::size_t> part_of = part_of_groups();
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (const Face& face : groups_[g].faces) {
      for (const std::int64_t corner : face.corners) named[static_cast<std::size_t>(corner)] = true;
    }
    if (!groups_[g].faces.empty()) members[part_of[g]].push_back(&groups_[g]);
  }
  std::vector<ObjPart> result;
  for (const auto& part : members) result.push_back(make_part(part.second, named));
  return result;
}

}  // namespace

std::vector<ObjPart> parse_obj(const std::filesystem::path& path, const std::string& text) {
  ObjReader reader(path);
  reader.read(text);
  return reader.parts();
}

}  // namespace rigidformer
