// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>

#include "rigidformer/data/scene_archive.hpp"
#include "rigidformer/io/tensor_file.hpp"
#include "rigidformer/io/text_file.hpp"
#include "scene_archive_format.hpp"

namespace rigidformer {
namespace {

using namespace scene_archive_format;
using Json = nlohmann::ordered_json;

/// Typed, checked access to the tensors of one file.
class Reader {
 public:
  Reader(const std::filesystem::path& path, const TensorFile& file) : path_(path), file_(file) {}

  [[noreturn]] void fail_here(const std::string& defect) const { fail(path_, defect); }

  const std::string& text(const std::string& key) const {
    const auto entry = file_.metadata.find(key);
    if (entry == file_.metadata.end()) fail_here("metadata '" + key + "' is missing");
    return entry->second;
  }

  /// The values of a tensor whose shape must equal `shape`; a negative extent matches any.
  template <typename T>
  std::vector<T> values(const std::string& name, TensorType type, const std::vector<std::int64_t>& shape) const {
    const RawTensor& tensor = find(name);
    bool fits = tensor.type == type && tensor.shape.size() == shape.size();
    for (std::size_t i = 0; fits && i < shape.size(); ++i) fits = shape[i] < 0 || shape[i] == tensor.shape[i];
    if (!fits) fail_here("tensor '" + name + "' has an unexpected type or shape");
    std::vector<T> result(static_cast<std::size_t>(tensor.num_elements()));
    if (!result.empty()) std::memcpy(result.data(), tensor.bytes.data(), tensor.bytes.size());
    return result;
  }

  std::vector<std::int32_t> indices(const std::string& name, std::int64_t count, std::int64_t limit) const {
    const auto list = values<std::int32_t>(name, TensorType::kInt32, {count});
    for (const std::int32_t index : list) {
      if (index < 0 || index >= limit) {
        fail_here("tensor '" + name + "' holds " + std::to_string(index) + ", allowed is 0..." +
                  std::to_string(limit - 1));
      }
    }
    return list;
  }

  bool has(const std::string& tensor) const { return file_.tensors.count(tensor) > 0; }

  Json json(const std::string& key) const {
    if (nests_too_deeply(text(key))) fail_here("metadata '" + key + "' is nested too deeply");
    return Json::parse(text(key));
  }

  const RawTensor& find(const std::string& name) const {
    const auto entry = file_.tensors.find(name);
    if (entry == file_.tensors.end()) fail_here("tensor '" + name + "' is missing");
    return entry->second;
  }

 private:
  const std::filesystem::path& path_;
  const TensorFile& file_;
};

constexpr std::int64_t kAny = -1;             // any number of rows
constexpr std::int64_t kMaxFrames = 1000000;  // over an hour at 240 Hz, see docs/data_format.md; chosen by eye

std::vector<Shape> unpack_shapes(const Reader& reader) {
  std::vector<Shape> shapes;
  for (const Json& entry : reader.json("shapes")) {
    shapes.push_back({entry.at("name").get<std::string>(), entry.at("mass_kg").get<double>(), {}});
  }
  const auto part_shape = reader.indices("part_shape", kAny, signed_size(shapes.size()));
  const std::int64_t num_parts = signed_size(part_shape.size());
  const auto vertices = reader.values<float>("vertices", TensorType::kFloat32, {kAny, 3});
  const auto triangles = reader.values<std::int32_t>("triangles", TensorType::kInt32, {kAny, 3});
  const auto num_vertices = reader.indices("part_num_vertices", num_parts, signed_size(vertices.size() / 3) + 1);
  const auto num_triangles = reader.indices("part_num_triangles", num_parts, signed_size(triangles.size() / 3) + 1);

  std::size_t vertex = 0;
  std::size_t corner = 0;
  for (std::size_t p = 0; p < part_shape.size(); ++p) {
    const auto vertex_values = 3 * static_cast<std::size_t>(num_vertices[p]);
    const auto corner_values = 3 * static_cast<std::size_t>(num_triangles[p]);
    if (vertex + vertex_values > vertices.size() || corner + corner_values > triangles.size()) {
      reader.fail_here("part " + std::to_string(p) + " lies outside the mesh tensors");
    }
    ConvexPart part;
    part.vertices = Eigen::Map<const Points>(vertices.data() + vertex, num_vertices[p], 3);
    part.triangles = Eigen::Map<const decltype(part.triangles)>(triangles.data() + corner, num_triangles[p], 3);
    const bool valid =
        part.vertices.allFinite() &&
        (part.triangles.size() == 0 || (part.triangles.minCoeff() >= 0 && part.triangles.maxCoeff() < num_vertices[p]));
    if (!valid) reader.fail_here("part " + std::to_string(p) + " has non-finite vertices or bad triangle indices");
    shapes[static_cast<std::size_t>(part_shape[p])].parts.push_back(std::move(part));
    vertex += vertex_values;
    corner += corner_values;
  }
  if (vertex != vertices.size() || corner != triangles.size()) reader.fail_here("mesh tensors hold unused rows");
  return shapes;
}

/// Scenes that end before the others say so.
int frames_of_scene(const Reader& reader, const Json& entry, int num_frames) {
  if (!entry.contains("num_frames")) return num_frames;
  const Json& value = entry.at("num_frames");
  const std::uint64_t given = value.is_number_unsigned() ? value.get<std::uint64_t>() : 0;
  if (given < 1 || given > static_cast<std::uint64_t>(num_frames)) {
    reader.fail_here("scene '" + entry.at("name").get<std::string>() + "' has no num_frames in 1..." +
                     std::to_string(num_frames));
  }
  return static_cast<int>(given);
}

/// Turns NaN, which stands for "not known", into an empty value.
std::optional<double> known(const Reader& reader, const char* name, double value) {
  if (std::isnan(value)) return std::nullopt;
  if (!(value >= 0.0) || std::isinf(value)) reader.fail_here(std::string(name) + " = " + std::to_string(value));
  return value;
}

/// Scenes without this entry have the ground of the MOVi scenes. Null stands for "not known".
GroundProperties ground_of_scene(const Reader& reader, const Json& entry) {
  if (!entry.contains("ground")) return SceneRecording().ground;
  const auto value = [&](const char* key) -> std::optional<double> {
    const Json& number = entry.at("ground").at(key);
    return number.is_null() ? std::nullopt : known(reader, key, number.get<double>());
  };
  const GroundProperties ground{value("friction"), value("restitution")};
  if (ground.restitution.value_or(0.0) > 1.0) reader.fail_here("restitution of the ground is above 1");
  return ground;
}

std::vector<SceneRecording> unpack_scenes(const Reader& reader, int num_frames) {
  std::vector<SceneRecording> scenes;
  for (const Json& entry : reader.json("scenes")) {
    SceneRecording scene;
    scene.name = entry.at("name").get<std::string>();
    if (!entry.at("seed").is_number_unsigned()) reader.fail_here("scene '" + scene.name + "' has no integer seed >= 0");
    scene.seed = entry.at("seed").get<std::uint64_t>();
    scene.frame_rate_hz = entry.at("frame_rate_hz").get<double>();
    scene.num_frames = frames_of_scene(reader, entry, num_frames);
    for (std::size_t i = 0; i < 3; ++i) scene.gravity[static_cast<int>(i)] = entry.at("gravity").at(i).get<double>();
    if (!(scene.frame_rate_hz > 0.0)) reader.fail_here("scene '" + scene.name + "' has no positive frame rate");
    if (!points_down(scene.gravity)) {
      reader.fail_here("scene '" + scene.name + "' has a gravity that does not point along -z: turn it, z must be up");
    }
    scene.ground = ground_of_scene(reader, entry);
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

std::vector<RigidTransform> unpack_poses(const Reader& reader, const float* values, int num_frames) {
  std::vector<RigidTransform> poses;
  poses.reserve(static_cast<std::size_t>(num_frames));
  for (int frame = 0; frame < num_frames; ++frame, values += kPoseSize) {
    RigidTransform T{Eigen::Quaterniond(values[6], values[3], values[4], values[5]),
                     Eigen::Vector3d(values[0], values[1], values[2])};
    if (!is_valid(T)) reader.fail_here("frame " + std::to_string(frame) + " of an object is not a valid pose");
    T.rotation.normalize();
    poses.push_back(T);
  }
  return poses;
}

void unpack_objects(const Reader& reader, int num_frames, SceneArchive& archive) {
  const auto scene = reader.indices("object_scene", kAny, signed_size(archive.scenes.size()));
  const std::int64_t n = signed_size(scene.size());
  const auto shape = reader.indices("object_shape", n, signed_size(archive.shapes.size()));
  const auto size = reader.values<double>("object_size", TensorType::kFloat64, {n});
  const auto mass = reader.values<double>("object_mass", TensorType::kFloat64, {n});
  const auto friction = reader.values<double>("object_friction", TensorType::kFloat64, {n});
  const auto restitution = reader.values<double>("object_restitution", TensorType::kFloat64, {n});
  const auto flags = [&](const char* name) {
    return reader.has(name) ? reader.indices(name, n, 2) : std::vector<std::int32_t>(scene.size(), 0);
  };
  const std::vector<std::int32_t> is_static = flags("object_static"), is_driven = flags("object_driven");
  const auto poses = reader.values<float>("poses", TensorType::kFloat32, {n, num_frames, kPoseSize});
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (!(size[i] > 0.0) || std::isinf(size[i])) reader.fail_here("object_size = " + std::to_string(size[i]));
    RecordedObject object;
    object.shape = archive.shapes[static_cast<std::size_t>(shape[i])].name;
    object.size = size[i];
    object.properties = {known(reader, "object_mass", mass[i]), known(reader, "object_friction", friction[i]),
                         known(reader, "object_restitution", restitution[i])};
    object.is_static = is_static[i] == 1;
    object.is_driven = is_driven[i] == 1;
    if (object.is_static && object.is_driven) {
      reader.fail_here("object " + std::to_string(i) + " is static and driven");
    }
    SceneRecording& recording = archive.scenes[static_cast<std::size_t>(scene[i])];
    object.T_world_object =
        unpack_poses(reader, poses.data() + i * static_cast<std::size_t>(num_frames) * kPoseSize, recording.num_frames);
    recording.objects.push_back(std::move(object));
  }
}

void unpack_control(const Reader& reader, int num_frames, SceneArchive& archive) {
  if (!reader.has("control")) return;
  const auto S = static_cast<std::int64_t>(archive.scenes.size());
  const auto values = reader.values<float>("control", TensorType::kFloat32, {S, num_frames, kAny});
  const std::size_t width = archive.scenes.empty() ? 0 : values.size() / archive.scenes.size() / num_frames;
  if (!std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); })) {
    reader.fail_here("tensor 'control' holds numbers that are not finite");
  }
  const Json directions = reader.json("control_directions");
  if (!directions.is_number_unsigned() || directions.get<std::uint64_t>() * 2 > width) {
    reader.fail_here("control_directions = " + directions.dump() + " does not fit a command of " +
                     std::to_string(width) + " numbers");
  }
  auto value = values.begin();
  for (SceneRecording& scene : archive.scenes) {
    for (int frame = 0; frame < num_frames; ++frame, value += static_cast<std::ptrdiff_t>(width)) {
      if (frame < scene.num_frames) scene.control.emplace_back(value, value + static_cast<std::ptrdiff_t>(width));
    }
    scene.control_directions = directions.get<int>();
  }
}

}  // namespace

SceneArchive read_scene_archive(const std::filesystem::path& path) {
  const TensorFile file = read_tensor_file(path);
  const Reader reader(path, file);
  if (file.metadata.count("format") == 0 || reader.text("format") != kFormat) fail(path, "is not a scene archive");
  const std::string version = reader.text("format_version");
  if (version.size() != 1 || version < std::to_string(kPlainVersion) || version > std::to_string(kVersion)) {
    fail(path, "has format version " + version + ", this program reads " + std::to_string(kPlainVersion) + " to " +
                   std::to_string(kVersion));
  }
  const RawTensor& poses = reader.find("poses");
  if (poses.shape.size() != 3 || poses.shape[1] > kMaxFrames) {
    fail(path, "tensor 'poses' has an unexpected shape");
  }
  const int num_frames = static_cast<int>(poses.shape[1]);
  try {
    SceneArchive archive{reader.text("set"), unpack_shapes(reader), unpack_scenes(reader, num_frames)};
    unpack_objects(reader, num_frames, archive);
    unpack_control(reader, num_frames, archive);
    return archive;
  } catch (const nlohmann::json::exception& exception) {
    fail(path, std::string("metadata is not valid: ") + exception.what());
  }
}

}  // namespace rigidformer
