// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "rigidformer/data/scene_archive.hpp"
#include "rigidformer/io/tensor_file.hpp"
#include "scene_archive_format.hpp"

namespace rigidformer {
namespace {

using namespace scene_archive_format;
using Json = nlohmann::ordered_json;

void pack_shapes(const SceneArchive& archive, TensorFile& file) {
  std::vector<float> vertices;
  std::vector<std::int32_t> triangles, part_shape, part_vertices, part_triangles;
  for (std::size_t s = 0; s < archive.shapes.size(); ++s) {
    for (const ConvexPart& part : archive.shapes[s].parts) {
      part_shape.push_back(static_cast<std::int32_t>(s));
      part_vertices.push_back(static_cast<std::int32_t>(part.vertices.rows()));
      part_triangles.push_back(static_cast<std::int32_t>(part.triangles.rows()));
      vertices.insert(vertices.end(), part.vertices.data(), part.vertices.data() + part.vertices.size());
      triangles.insert(triangles.end(), part.triangles.data(), part.triangles.data() + part.triangles.size());
    }
  }
  const auto list = [](const std::vector<std::int32_t>& values) {
    return make_raw_tensor(TensorType::kInt32, {signed_size(values.size())}, values);
  };
  file.tensors["part_shape"] = list(part_shape);
  file.tensors["part_num_vertices"] = list(part_vertices);
  file.tensors["part_num_triangles"] = list(part_triangles);
  file.tensors["vertices"] = make_raw_tensor(TensorType::kFloat32, {signed_size(vertices.size() / 3), 3}, vertices);
  file.tensors["triangles"] = make_raw_tensor(TensorType::kInt32, {signed_size(triangles.size() / 3), 3}, triangles);
}

/// The columns of the object table while they grow.
struct ObjectColumns {
  std::vector<std::int32_t> scene, shape, is_static, is_driven;
  std::vector<double> size, mass, friction, restitution;
  std::vector<float> poses;

  /// Poses after the end of the scene repeat the last one.
  void add(std::size_t scene_index, std::int32_t shape_index, const RecordedObject& object, int num_frames) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();  // as docs/data_format.md asks for
    scene.push_back(static_cast<std::int32_t>(scene_index));
    shape.push_back(shape_index);
    size.push_back(object.size);
    mass.push_back(object.properties.mass_kg.value_or(kUnknown));
    friction.push_back(object.properties.friction.value_or(kUnknown));
    restitution.push_back(object.properties.restitution.value_or(kUnknown));
    is_static.push_back(object.is_static ? 1 : 0);
    is_driven.push_back(object.is_driven ? 1 : 0);
    for (std::size_t frame = 0; frame < static_cast<std::size_t>(num_frames); ++frame) {
      const RigidTransform& T = object.T_world_object[std::min(frame, object.T_world_object.size() - 1)];
      for (int i = 0; i < 3; ++i) poses.push_back(static_cast<float>(T.translation[i]));
      for (int i = 0; i < 4; ++i) poses.push_back(static_cast<float>(T.rotation.coeffs()[i]));  // x y z w
    }
  }
};

std::map<std::string, std::int32_t> shape_indices(const std::filesystem::path& path, const SceneArchive& archive) {
  std::map<std::string, std::int32_t> indices;
  for (const Shape& shape : archive.shapes) {
    if (!indices.emplace(shape.name, static_cast<std::int32_t>(indices.size())).second) {
      fail(path, "two shapes are called '" + shape.name + "'");
    }
  }
  return indices;
}

int most_frames(const SceneArchive& archive) {
  int most = 0;
  for (const SceneRecording& scene : archive.scenes) most = std::max(most, scene.num_frames);
  return most;
}

bool has_other_lengths(const SceneArchive& archive) {
  return std::any_of(archive.scenes.begin(), archive.scenes.end(),
                     [&](const SceneRecording& scene) { return scene.num_frames != archive.scenes[0].num_frames; });
}

/// Whether a flag of any object is set.
bool has(const SceneArchive& archive, bool RecordedObject::*flag) {
  return std::any_of(archive.scenes.begin(), archive.scenes.end(), [&](const SceneRecording& scene) {
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [&](const RecordedObject& object) { return object.*flag; });
  });
}

bool has_movi_ground(const SceneRecording& scene) { return scene.ground == SceneRecording().ground; }

/// JSON's null stands for "not known".
Json to_json(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

int version_of(const SceneArchive& archive) {
  if (has(archive, &RecordedObject::is_driven)) return kVersion;
  if (!std::all_of(archive.scenes.begin(), archive.scenes.end(), has_movi_ground)) return kGroundVersion;
  return has_other_lengths(archive) || has(archive, &RecordedObject::is_static) ? kMixedVersion : kPlainVersion;
}

void pack_objects(const std::filesystem::path& path, const SceneArchive& archive, TensorFile& file) {
  const std::map<std::string, std::int32_t> indices = shape_indices(path, archive);
  const int num_frames = most_frames(archive);
  ObjectColumns columns;
  for (std::size_t s = 0; s < archive.scenes.size(); ++s) {
    for (const RecordedObject& object : archive.scenes[s].objects) {
      const auto index = indices.find(object.shape);
      if (index == indices.end()) fail(path, "shape '" + object.shape + "' is used but not in the archive");
      const int of_scene = archive.scenes[s].num_frames;
      if (of_scene < 1 || static_cast<int>(object.T_world_object.size()) != of_scene) {
        fail(path, "scene " + std::to_string(s) + " has " + std::to_string(object.T_world_object.size()) +
                       " poses of an object, its num_frames says " + std::to_string(of_scene));
      }
      columns.add(s, index->second, object, num_frames);
    }
  }
  const std::int64_t n = signed_size(columns.scene.size());
  file.tensors["object_scene"] = make_raw_tensor(TensorType::kInt32, {n}, columns.scene);
  file.tensors["object_shape"] = make_raw_tensor(TensorType::kInt32, {n}, columns.shape);
  file.tensors["object_size"] = make_raw_tensor(TensorType::kFloat64, {n}, columns.size);
  file.tensors["object_mass"] = make_raw_tensor(TensorType::kFloat64, {n}, columns.mass);
  file.tensors["object_friction"] = make_raw_tensor(TensorType::kFloat64, {n}, columns.friction);
  file.tensors["object_restitution"] = make_raw_tensor(TensorType::kFloat64, {n}, columns.restitution);
  if (has(archive, &RecordedObject::is_static)) {
    file.tensors["object_static"] = make_raw_tensor(TensorType::kInt32, {n}, columns.is_static);
  }
  if (has(archive, &RecordedObject::is_driven)) {
    file.tensors["object_driven"] = make_raw_tensor(TensorType::kInt32, {n}, columns.is_driven);
  }
  file.tensors["poses"] = make_raw_tensor(TensorType::kFloat32, {n, num_frames, kPoseSize}, columns.poses);
}

/// The commands of all scenes [S, F, C], where there are any; frames after the end of a scene repeat the last one.
void pack_control(const std::filesystem::path& path, const SceneArchive& archive, TensorFile& file) {
  const auto width_of = [](const SceneRecording& scene) {
    return scene.control.empty() ? std::size_t{0} : scene.control.front().size();
  };
  const std::size_t width = archive.scenes.empty() ? 0 : width_of(archive.scenes.front());
  const auto num_frames = static_cast<std::size_t>(most_frames(archive));
  std::vector<float> values;
  for (const SceneRecording& scene : archive.scenes) {
    if (width_of(scene) != width || scene.control_directions != archive.scenes.front().control_directions) {
      fail(path, "scene '" + scene.name + "' has commands of another width than the first one");
    }
    for (std::size_t frame = 0; width > 0 && frame < num_frames; ++frame) {
      const std::vector<double>& command = scene.control[std::min(frame, scene.control.size() - 1)];
      for (const double value : command) values.push_back(static_cast<float>(value));
    }
  }
  if (width == 0) return;
  file.metadata["control_directions"] = std::to_string(archive.scenes.front().control_directions);
  const std::vector<std::int64_t> shape{signed_size(archive.scenes.size()), signed_size(num_frames),
                                        signed_size(width)};
  if (values.size() != archive.scenes.size() * num_frames * width) fail(path, "commands of one scene differ in width");
  file.tensors["control"] = make_raw_tensor(TensorType::kFloat32, shape, values);
}

void pack_metadata(const SceneArchive& archive, TensorFile& file) {
  Json shapes = Json::array();
  for (const Shape& shape : archive.shapes) shapes.push_back({{"name", shape.name}, {"mass_kg", shape.mass_kg}});
  Json scenes = Json::array();
  for (const SceneRecording& scene : archive.scenes) {
    scenes.push_back({{"name", scene.name},
                      {"seed", scene.seed},
                      {"frame_rate_hz", scene.frame_rate_hz},
                      {"gravity", {scene.gravity.x(), scene.gravity.y(), scene.gravity.z()}}});
    if (has_other_lengths(archive)) scenes.back()["num_frames"] = scene.num_frames;
    if (has_movi_ground(scene)) continue;
    scenes.back()["ground"] = {{"friction", to_json(scene.ground.friction)},
                               {"restitution", to_json(scene.ground.restitution)}};
  }
  file.metadata["format"] = kFormat;
  file.metadata["format_version"] = std::to_string(version_of(archive));
  file.metadata["set"] = archive.set;
  file.metadata["shapes"] = shapes.dump();
  file.metadata["scenes"] = scenes.dump();
}

}  // namespace

void write_scene_archive(const std::filesystem::path& path, const SceneArchive& archive) {
  TensorFile file;
  pack_metadata(archive, file);
  pack_shapes(archive, file);
  pack_objects(path, archive, file);
  pack_control(path, archive, file);
  write_tensor_file(path, file);
}

}  // namespace rigidformer
