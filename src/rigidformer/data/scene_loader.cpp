// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/data/scene_loader.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "rigidformer/data/kubasic.hpp"
#include "rigidformer/data/kubric.hpp"

namespace rigidformer {
namespace {

namespace fs = std::filesystem;

constexpr char kArchiveExtension[] = ".safetensors";
constexpr char kSceneFile[] = "metadata.json";
constexpr char kShapesFolder[] = "shapes";
constexpr char kGenerationFile[] = "generation.json";  // written by the scene generator beside its scenes

[[noreturn]] void fail(const fs::path& path, const std::string& defect) {
  throw std::runtime_error("scenes '" + path.string() + "': " + defect);
}

bool is_full(const SceneArchive& archive, int max_scenes) {
  return max_scenes > 0 && static_cast<int>(archive.scenes.size()) >= max_scenes;
}

/// Orders numbered names by their number (2 before 10) and others alphabetically.
bool natural_less(const fs::path& a, const fs::path& b) {
  const std::string x = a.filename().string();
  const std::string y = b.filename().string();
  const auto is_number = [](const std::string& s) {
    return !s.empty() && std::all_of(s.begin(), s.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  if (is_number(x) && is_number(y) && x.size() != y.size()) return x.size() < y.size();
  return x < y;
}

std::vector<fs::path> sorted_entries(const fs::path& folder) {
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(folder)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end(), natural_less);
  return entries;
}

std::vector<fs::path> find_archives(const fs::path& folder) {
  std::vector<fs::path> archives;
  for (const fs::path& entry : sorted_entries(folder)) {
    if (entry.extension() == kArchiveExtension) archives.push_back(entry);
  }
  return archives;
}

/// Finds the scene folders in `folder` itself and one or two levels below.
std::vector<fs::path> find_kubric_scenes(const fs::path& folder, int levels = 2) {
  if (fs::exists(folder / kSceneFile)) return {folder};
  std::vector<fs::path> scenes;
  if (levels == 0) return scenes;
  for (const fs::path& entry : sorted_entries(folder)) {
    if (!fs::is_directory(entry)) continue;
    const std::vector<fs::path> below = find_kubric_scenes(entry, levels - 1);
    scenes.insert(scenes.end(), below.begin(), below.end());
  }
  return scenes;
}

bool same_mesh(const Shape& a, const Shape& b) {
  return a.parts.size() == b.parts.size() &&
         std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), [](const ConvexPart& x, const ConvexPart& y) {
           return x.vertices.rows() == y.vertices.rows() && x.vertices == y.vertices;
         });
}

void append(const fs::path& path, SceneArchive&& shard, SceneArchive& all) {
  if (all.scenes.empty() && all.shapes.empty()) {
    all = std::move(shard);
    return;
  }
  if (shard.set != all.set) fail(path, "is of set '" + shard.set + "', the shards before of '" + all.set + "'");
  for (Shape& shape : shard.shapes) {
    const auto known = std::find_if(all.shapes.begin(), all.shapes.end(),
                                    [&](const Shape& other) { return other.name == shape.name; });
    if (known == all.shapes.end()) {
      all.shapes.push_back(std::move(shape));
    } else if (!same_mesh(*known, shape)) {
      fail(path, "has another mesh for shape '" + shape.name + "' than the shards before");
    }
  }
  all.scenes.insert(all.scenes.end(), std::make_move_iterator(shard.scenes.begin()),
                    std::make_move_iterator(shard.scenes.end()));
}

SceneArchive load_archives(const std::vector<fs::path>& paths, int max_scenes) {
  SceneArchive all;
  for (const fs::path& path : paths) {
    append(path, read_scene_archive(path), all);
    if (is_full(all, max_scenes)) {
      all.scenes.resize(static_cast<std::size_t>(max_scenes));
      break;
    }
  }
  return all;
}

/// The name of the set that the scene generator noted, else the name of the folder.
std::string set_name(const fs::path& folder) {
  std::ifstream in(folder / kGenerationFile);
  if (in) {
    const nlohmann::json note = nlohmann::json::parse(in, nullptr, false);
    if (note.is_object() && note.contains("set") && note["set"].is_string()) return note["set"];
  }
  return fs::absolute(folder).lexically_normal().filename().string();
}

/// Names of all shapes that can be had, and how to get those of a list of names. Meshes that no scene uses are not even
/// looked at.
struct ShapeSource {
  std::vector<std::string> names;
  std::function<Shape(const std::string&)> load;
};

ShapeSource folder_source(const fs::path& folder) {
  return {kubasic_shape_names(folder), [folder](const std::string& name) { return load_kubasic_shape(folder / name); }};
}

ShapeSource list_source(const std::vector<Shape>& shapes) {
  ShapeSource source;
  for (const Shape& shape : shapes) source.names.push_back(shape.name);
  source.load = [&shapes](const std::string& name) {
    return *std::find_if(shapes.begin(), shapes.end(), [&](const Shape& shape) { return shape.name == name; });
  };
  return source;
}

/// Loads the shapes that the scenes use. Throws when one of them is missing.
std::vector<Shape> used_shapes(const SceneArchive& archive, const ShapeSource& source, const fs::path& path) {
  std::set<std::string> names;
  for (const SceneRecording& scene : archive.scenes) {
    for (const RecordedObject& object : scene.objects) names.insert(object.shape);
  }
  std::vector<Shape> used;
  for (const std::string& name : names) {
    if (std::find(source.names.begin(), source.names.end(), name) == source.names.end()) {
      fail(path, "uses shape '" + name + "', which is not among the given shapes");
    }
    used.push_back(source.load(name));
  }
  return used;
}

/// Makes sizes of the extents that some files give.
void resolve_extents(SceneArchive& archive, const fs::path& path) {
  for (SceneRecording& scene : archive.scenes) {
    for (RecordedObject& object : scene.objects) {
      if (!object.largest_extent_m) continue;
      const auto shape = std::find_if(archive.shapes.begin(), archive.shapes.end(),
                                      [&](const Shape& candidate) { return candidate.name == object.shape; });
      const double size = *object.largest_extent_m / shape->largest_extent();
      if (!std::isfinite(size) || size <= 0.0) {
        fail(path, "scene '" + scene.name + "': the scale of '" + object.shape + "' gives no size: its mesh is empty");
      }
      object.size = size;
      object.largest_extent_m.reset();
    }
  }
}

SceneArchive load_kubric(const fs::path& path, const std::vector<fs::path>& folders, const ShapeSource& source,
                         int max_scenes) {
  const bool own_shapes = source.names.empty() && fs::is_directory(path / kShapesFolder);
  if (source.names.empty() && !own_shapes) {
    fail(path, "Kubric scenes carry no meshes: give the folder of their shapes in KuBasic layout (--shapes DIR)");
  }
  SceneArchive archive;
  archive.set = set_name(path);
  for (const fs::path& folder : folders) {
    if (is_full(archive, max_scenes)) break;
    archive.scenes.push_back(read_kubric_scene(folder));
  }
  archive.shapes = used_shapes(archive, own_shapes ? folder_source(path / kShapesFolder) : source, path);
  resolve_extents(archive, path);
  return archive;
}

SceneArchive load(const fs::path& path, const std::function<ShapeSource()>& shapes, int max_scenes) {
  if (!fs::exists(path)) fail(path, "no such file or folder");
  if (!fs::is_directory(path)) return load_archives({path}, max_scenes);
  const std::vector<fs::path> archives = find_archives(path);
  if (!archives.empty()) return load_archives(archives, max_scenes);
  const std::vector<fs::path> folders = find_kubric_scenes(path);
  if (!folders.empty()) return load_kubric(path, folders, shapes(), max_scenes);
  fail(path, "holds neither *.safetensors archives nor folders with a metadata.json");
}

}  // namespace

SceneArchive load_scenes(const fs::path& path, const std::vector<Shape>& shapes, int max_scenes) {
  return load(
      path, [&] { return list_source(shapes); }, max_scenes);
}

SceneArchive load_scenes(const fs::path& path, const fs::path& shapes_dir, int max_scenes) {
  return load(
      path, [&] { return shapes_dir.empty() ? ShapeSource() : folder_source(shapes_dir); }, max_scenes);
}

}  // namespace rigidformer
