// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/data/kubric.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "rigidformer/io/text_file.hpp"

namespace rigidformer {
namespace {

using Json = nlohmann::json;

constexpr char kFileName[] = "metadata.json";
constexpr std::uintmax_t kMaxFileBytes = 64u << 20;  // [bytes] bound on memory, see docs/data_format.md; chosen by eye

/// A JSON value that knows its place in the file, so that every error names file and key.
class Node {
 public:
  Node(const std::filesystem::path& file, std::string key, const Json& value)
      : file_(file), key_(std::move(key)), value_(value) {}

  [[noreturn]] void fail(const std::string& defect) const {
    throw std::runtime_error("Kubric scene '" + file_.string() + "': " + key_ + " " + defect);
  }

  bool has(const char* name) const { return value_.is_object() && value_.contains(name) && !value_.at(name).is_null(); }

  Node at(const char* name) const {
    if (!has(name)) Node(file_, child_key(name), value_).fail("is missing");
    return {file_, child_key(name), value_.at(name)};
  }

  Node at(std::size_t index) const { return {file_, key_ + '[' + std::to_string(index) + ']', value_.at(index)}; }

  std::size_t array_size() const {
    if (!value_.is_array()) fail("is not a list");
    return value_.size();
  }

  double number() const {
    if (!value_.is_number()) fail("is not a number");
    return value_.get<double>();
  }

  std::uint64_t natural() const {
    if (!value_.is_number_unsigned()) fail("is not an integer >= 0");
    return value_.get<std::uint64_t>();
  }

  std::string text() const {
    if (!value_.is_string()) fail("is not a text");
    return value_.get<std::string>();
  }

  template <int Size>
  Eigen::Matrix<double, Size, 1> vector() const {
    if (array_size() != Size) fail("does not have " + std::to_string(Size) + " numbers");
    Eigen::Matrix<double, Size, 1> result;
    for (std::size_t i = 0; i < Size; ++i) result[static_cast<Eigen::Index>(i)] = at(i).number();
    return result;
  }

 private:
  std::string child_key(const char* name) const { return key_.empty() ? name : key_ + '.' + name; }

  const std::filesystem::path& file_;
  std::string key_;
  const Json& value_;
};

void require_frames(const Node& list, std::size_t num_frames) {
  if (list.array_size() == num_frames) return;
  list.fail("has " + std::to_string(list.array_size()) + " entries, metadata.num_frames says " +
            std::to_string(num_frames));
}

std::vector<Eigen::Vector3d> read_vectors(const Node& list, std::size_t num_frames) {
  require_frames(list, num_frames);
  std::vector<Eigen::Vector3d> vectors;
  vectors.reserve(num_frames);
  for (std::size_t i = 0; i < num_frames; ++i) vectors.push_back(list.at(i).vector<3>());
  return vectors;
}

std::vector<RigidTransform> read_poses(const Node& instance, std::size_t num_frames) {
  const std::vector<Eigen::Vector3d> positions = read_vectors(instance.at("positions"), num_frames);
  const Node quaternions = instance.at("quaternions");
  require_frames(quaternions, num_frames);
  std::vector<RigidTransform> poses;
  poses.reserve(num_frames);
  for (std::size_t i = 0; i < num_frames; ++i) {
    const Eigen::Vector4d wxyz = quaternions.at(i).vector<4>();
    const RigidTransform pose{Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]), positions[i]};
    if (!is_valid(pose)) quaternions.at(i).fail("is not a unit quaternion");
    poses.push_back({pose.rotation.normalized(), pose.translation});
  }
  return poses;
}

std::optional<double> read_optional(const Node& instance, const char* key, double low) {
  if (!instance.has(key)) return std::nullopt;
  const double value = instance.at(key).number();
  if (!(value >= low)) instance.at(key).fail("= " + std::to_string(value) + " is out of range");
  return value;
}

double read_size(const Node& instance) {
  double size = 1.0;
  if (instance.has("size")) size = instance.at("size").number();
  if (!(size > 0.0)) instance.at("size").fail("= " + std::to_string(size) + " must be > 0");
  return size;
}

RecordedObject read_object(const Node& instance, std::size_t num_frames) {
  RecordedObject object;
  object.shape = instance.at("asset_id").text();
  object.size = read_size(instance);
  object.properties = {read_optional(instance, "mass", 1e-9), read_optional(instance, "friction", 0.0),
                       read_optional(instance, "restitution", 0.0)};
  object.T_world_object = read_poses(instance, num_frames);
  if (instance.has("velocities")) object.velocities = read_vectors(instance.at("velocities"), num_frames);
  if (instance.has("angular_velocities")) {
    object.angular_velocities = read_vectors(instance.at("angular_velocities"), num_frames);
  }
  return object;
}

Json to_json(const std::vector<Eigen::Vector3d>& vectors) {
  Json list = Json::array();
  for (const Eigen::Vector3d& v : vectors) list.push_back({v.x(), v.y(), v.z()});
  return list;
}

Json to_json(const RecordedObject& object) {
  Json instance = {{"asset_id", object.shape}, {"size", object.size}};
  const BodyProperties& properties = object.properties;
  if (properties.mass_kg) instance["mass"] = *properties.mass_kg;
  if (properties.friction) instance["friction"] = *properties.friction;
  if (properties.restitution) instance["restitution"] = *properties.restitution;
  Json& positions = instance["positions"] = Json::array();
  Json& quaternions = instance["quaternions"] = Json::array();
  for (const RigidTransform& T : object.T_world_object) {
    positions.push_back({T.translation.x(), T.translation.y(), T.translation.z()});
    quaternions.push_back({T.rotation.w(), T.rotation.x(), T.rotation.y(), T.rotation.z()});
  }
  if (!object.velocities.empty()) instance["velocities"] = to_json(object.velocities);
  if (!object.angular_velocities.empty()) instance["angular_velocities"] = to_json(object.angular_velocities);
  return instance;
}

Json parse_file(const std::filesystem::path& file) {
  try {
    return Json::parse(read_text_file(file, kMaxFileBytes));
  } catch (const Json::exception& exception) {
    throw std::runtime_error("Kubric scene '" + file.string() + "': not valid JSON: " + exception.what());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("Kubric scene '" + file.string() + "': " + error.what());
  }
}

}  // namespace

SceneRecording read_kubric_scene(const std::filesystem::path& path) {
  const std::filesystem::path file = std::filesystem::is_directory(path) ? path / kFileName : path;
  const Json json = parse_file(file);
  const Node root(file, "", json);
  const Node metadata = root.at("metadata");

  SceneRecording scene;
  scene.name = file.parent_path().filename().string();
  if (metadata.has("seed")) scene.seed = metadata.at("seed").natural();
  scene.frame_rate_hz = metadata.at("frame_rate").number();
  if (!(scene.frame_rate_hz > 0.0)) metadata.at("frame_rate").fail("must be > 0");
  const double num_frames = metadata.at("num_frames").number();
  if (!(num_frames >= 1.0 && num_frames <= 1e6)) metadata.at("num_frames").fail("must be in 1...1000000");
  scene.num_frames = static_cast<int>(num_frames);
  scene.gravity = metadata.at("gravity").vector<3>();
  const Node instances = root.at("instances");
  for (std::size_t i = 0; i < instances.array_size(); ++i) {
    scene.objects.push_back(read_object(instances.at(i), static_cast<std::size_t>(scene.num_frames)));
  }
  return scene;
}

void write_kubric_scene(const std::filesystem::path& folder, const SceneRecording& scene) {
  std::filesystem::create_directories(folder);
  Json json;
  json["metadata"] = {{"num_frames", scene.num_frames},
                      {"frame_rate", scene.frame_rate_hz},
                      {"gravity", {scene.gravity.x(), scene.gravity.y(), scene.gravity.z()}},
                      {"num_instances", scene.objects.size()},
                      {"seed", scene.seed}};
  Json& instances = json["instances"] = Json::array();
  for (const RecordedObject& object : scene.objects) instances.push_back(to_json(object));

  try {
    write_text_file(folder / kFileName, json.dump());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("Kubric scene '" + (folder / kFileName).string() + "': " + error.what());
  }
}

}  // namespace rigidformer
