// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/data/kubric.hpp"

#include <algorithm>
#include <cmath>
#include <locale>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "json_node.hpp"
#include "rigidformer/io/text_file.hpp"

namespace rigidformer {
namespace {

using Json = nlohmann::json;
using Node = JsonNode;

constexpr char kFileName[] = "metadata.json";
constexpr double kMany = 1e12;                       // of a mass or a friction: above it is no number of a real thing
constexpr std::uintmax_t kMaxFileBytes = 64u << 20;  // [bytes] bound on memory, see docs/data_format.md; chosen by eye

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

std::optional<double> read_optional(const Node& instance, const char* key, double low, double high) {
  if (!instance.has(key)) return std::nullopt;
  const double value = instance.at(key).number();
  if (!(value >= low && value <= high)) {
    std::ostringstream range;
    range.imbue(std::locale::classic());
    range << "is out of range, accepted is " << low << " to " << high;
    instance.at(key).refuse(range.str());
  }
  return value;
}

/// A factor, as one number or, as Kubric writes it, one per axis. Meshes are scaled uniformly.
double read_factor(const Node& value, const std::string& asset) {
  constexpr double kEqual = 1e-4;
  Eigen::Vector3d axes = Eigen::Vector3d::Constant(value.is_list() ? 0.0 : value.number());
  if (value.is_list()) axes = value.vector<3>();
  if (!(axes.minCoeff() > 0.0)) value.refuse("of '" + asset + "' must be > 0");
  if (axes.maxCoeff() - axes.minCoeff() > kEqual * axes.maxCoeff()) {
    value.refuse("of '" + asset + "' differs between the axes, accepted is one number or three equal ones");
  }
  return axes.mean();
}

/// MOVi-A and -B write `size`, a factor. MOVi-C to F write `scale`, the largest extent in metres, as one number.
/// Kubric's own `scale` of an object is a list of factors. Where both stand, `size` counts.
void read_size(const Node& instance, RecordedObject& object) {
  if (instance.has("size")) object.size = read_factor(instance.at("size"), object.shape);
  if (!instance.has("scale")) return;
  const double scale = read_factor(instance.at("scale"), object.shape);
  const bool is_factor = instance.at("scale").is_list();
  if (instance.has("size")) {
    if (is_factor && std::abs(scale - object.size) > 1e-2 * object.size) {
      instance.at("scale").refuse("of '" + object.shape + "' contradicts its size");
    }
  } else if (is_factor) {
    object.size = scale;
  } else {
    object.largest_extent_m = scale;
  }
}

/// Whether an object stays where it is in all frames.
bool stays(const std::vector<RigidTransform>& poses) {
  constexpr double kStill_m = 1e-3, kStill_rad = 1e-3;
  return std::all_of(poses.begin(), poses.end(), [&](const RigidTransform& pose) {
    return (pose.translation - poses.front().translation).norm() < kStill_m &&
           rotation_angle(pose.rotation, poses.front().rotation) < kStill_rad;
  });
}

/// MOVi-D to F write `is_dynamic: false` of what lies about at first and may be hit later: what moves is not static.
/// Simulators give what never moves the mass 0.
bool read_static(const Node& instance, const std::vector<RigidTransform>& poses) {
  const bool still = stays(poses);
  for (const char* key : {"static", "is_static"}) {
    if (!instance.flag(key, false)) continue;
    if (!still) instance.at(key).refuse("but the object moves, accepted is one that stays in its place");
    return true;
  }
  if (instance.has("mass") && instance.at("mass").number() == 0.0) {
    if (!still) instance.at("mass").refuse("but the object moves, accepted is > 0, or 0 for what stays in its place");
    return true;
  }
  return still && !instance.flag("is_dynamic", true);
}

RecordedObject read_object(const Node& instance, std::size_t num_frames) {
  RecordedObject object;
  object.shape = instance.at("asset_id").text();
  read_size(instance, object);
  object.T_world_object = read_poses(instance, num_frames);
  object.is_static = read_static(instance, object.T_world_object);
  object.properties = {read_optional(instance, "mass", object.is_static ? 0.0 : 1e-9, kMany),
                       read_optional(instance, "friction", 0.0, kMany),
                       read_optional(instance, "restitution", 0.0, 1.0)};
  if (object.properties.mass_kg == 0.0) object.properties.mass_kg.reset();
  if (instance.has("velocities")) object.velocities = read_vectors(instance.at("velocities"), num_frames);
  if (instance.has("angular_velocities")) {
    object.angular_velocities = read_vectors(instance.at("angular_velocities"), num_frames);
  }
  return object;
}

/// A key of this package: Kubric's own files lack it, and have the ground of the MOVi scenes.
GroundProperties read_ground(const Node& metadata) {
  if (!metadata.has("ground")) return SceneRecording().ground;
  const Node ground = metadata.at("ground");
  return {read_optional(ground, "friction", 0.0, kMany), read_optional(ground, "restitution", 0.0, 1.0)};
}

/// All of `metadata` that is read.
SceneRecording read_metadata(const Node& metadata) {
  SceneRecording scene;
  if (metadata.has("seed")) scene.seed = metadata.at("seed").natural();
  scene.frame_rate_hz = metadata.at("frame_rate").number();
  if (!(scene.frame_rate_hz > 0.0)) metadata.at("frame_rate").refuse("must be > 0");
  const double num_frames = metadata.at("num_frames").number();
  if (!(num_frames >= 1.0 && num_frames <= 1e6 && num_frames == std::floor(num_frames))) {
    metadata.at("num_frames").refuse("must be a whole number in 1...1000000");
  }
  scene.num_frames = static_cast<int>(num_frames);
  scene.gravity = metadata.at("gravity").vector<3>();
  if (!points_down(scene.gravity)) {
    metadata.at("gravity").refuse("does not point along -z: turn the scene so that z is up");
  }
  scene.ground = read_ground(metadata);
  return scene;
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
  if (object.is_static) instance["static"] = true;
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
  SceneRecording scene = read_metadata(root.at("metadata"));
  scene.name = file.parent_path().filename().string();
  const Node instances = root.at("instances");
  for (std::size_t i = 0; i < instances.array_size(); ++i) {
    const Node instance = instances.at(i);
    // What stands behind the objects has no mesh that a physics engine takes; the floor z = 0 is always there.
    if (instance.flag("background", false)) continue;
    scene.objects.push_back(read_object(instance, static_cast<std::size_t>(scene.num_frames)));
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
  if (!(scene.ground == SceneRecording().ground)) {
    Json& ground = json["metadata"]["ground"] = Json::object();
    if (scene.ground.friction) ground["friction"] = *scene.ground.friction;
    if (scene.ground.restitution) ground["restitution"] = *scene.ground.restitution;
  }
  Json& instances = json["instances"] = Json::array();
  for (const RecordedObject& object : scene.objects) instances.push_back(to_json(object));

  try {
    write_text_file(folder / kFileName, json.dump());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("Kubric scene '" + (folder / kFileName).string() + "': " + error.what());
  }
}

}  // namespace rigidformer
