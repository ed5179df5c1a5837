// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/data/kubasic.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <locale>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "obj_file.hpp"
#include "rigidformer/io/text_file.hpp"

namespace rigidformer {
namespace {

constexpr char kGeometryFile[] = "collision_geometry.obj";
constexpr char kDataFile[] = "data.json";
constexpr std::uintmax_t kMaxGeometryBytes = 16u << 20;  // [bytes] bound on memory, as in docs/data_format.md; by eye
constexpr std::uintmax_t kMaxDataBytes = 1u << 20;  // [bytes] bound on memory, see docs/data_format.md; chosen by eye
// A vertex may lie this far outside a face [m]: published hulls are rounded to six digits and
// merged loosely. Chosen by eye.
constexpr double kConvexityTolerance = 2e-3;

const std::map<std::string, double>& mass_table() {
  static const std::map<std::string, double> table = {{"cone", 0.4774},  {"cube", 0.9936},      {"cylinder", 0.7808},
                                                      {"gear", 0.2842},  {"sphere", 0.5225},    {"sponge", 0.5476},
                                                      {"spot", 0.2763},  {"suzanne", 0.3113},   {"teapot", 0.3227},
                                                      {"torus", 0.2627}, {"torus_knot", 0.2724}};
  return table;
}

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& defect) {
  throw std::runtime_error("shape '" + path.string() + "': " + defect);
}

std::string read_geometry(const std::filesystem::path& path) {
  try {
    return read_text_file(path, kMaxGeometryBytes);
  } catch (const std::runtime_error& error) {
    fail(path, error.what());
  }
}

/// Turns every triangle outwards and checks that no vertex lies outside its plane.
void orient_and_check(const std::filesystem::path& path, std::size_t index, ConvexPart& part) {
  const Eigen::Vector3f centre = part.vertices.colwise().mean().transpose();
  for (Eigen::Index f = 0; f < part.triangles.rows(); ++f) {
    const Eigen::Vector3f a = part.vertices.row(part.triangles(f, 0));
    const Eigen::Vector3f b = part.vertices.row(part.triangles(f, 1));
    const Eigen::Vector3f c = part.vertices.row(part.triangles(f, 2));
    Eigen::Vector3f normal = (b - a).cross(c - a);
    if (normal.norm() == 0.0F) continue;
    normal.normalize();
    if (normal.dot(a - centre) < 0.0F) {
      std::swap(part.triangles(f, 1), part.triangles(f, 2));
      normal = -normal;
    }
    const float highest = ((part.vertices * normal).array() - normal.dot(a)).maxCoeff();
    // Slivers have no reliable plane and are not checked.
    const float height = (b - a).cross(c - a).norm() / std::max({(b - a).norm(), (c - a).norm(), (c - b).norm()});
    if (highest > kConvexityTolerance && height > kConvexityTolerance) {
      fail(path, "group " + std::to_string(index) + " is not convex (a vertex lies " + std::to_string(highest) +
                     " m outside a face): decompose the mesh into convex parts");
    }
  }
}

ConvexPart build_part(const std::filesystem::path& path, std::size_t index, const ObjPart& builder) {
  if (builder.vertices.size() < 4 || builder.triangles.size() < 4) {
    fail(path, "group " + std::to_string(index) + " is not a closed mesh (needs at least 4 vertices and 4 faces)");
  }
  ConvexPart part;
  part.vertices.resize(static_cast<Eigen::Index>(builder.vertices.size()), 3);
  for (std::size_t i = 0; i < builder.vertices.size(); ++i) {
    part.vertices.row(static_cast<Eigen::Index>(i)) = builder.vertices[i].transpose();
  }
  part.triangles.resize(static_cast<Eigen::Index>(builder.triangles.size()), 3);
  for (std::size_t i = 0; i < builder.triangles.size(); ++i) {
    part.triangles.row(static_cast<Eigen::Index>(i)) = builder.triangles[i].transpose();
  }
  orient_and_check(path, index, part);
  return part;
}

double volume(const Shape& shape) {
  double total = 0.0;
  for (const ConvexPart& part : shape.parts) {
    for (Eigen::Index f = 0; f < part.triangles.rows(); ++f) {
      const Eigen::Vector3d a = part.vertices.row(part.triangles(f, 0)).cast<double>();
      const Eigen::Vector3d b = part.vertices.row(part.triangles(f, 1)).cast<double>();
      const Eigen::Vector3d c = part.vertices.row(part.triangles(f, 2)).cast<double>();
      total += a.dot(b.cross(c)) / 6.0;
    }
  }
  return std::abs(total);
}

/// Whether data.json says that the shape is what stands behind the objects (Kubric: kwargs.background). What cannot be
/// read says nothing.
bool is_background(const std::filesystem::path& path) {
  try {
    const nlohmann::json sheet = nlohmann::json::parse(read_text_file(path, kMaxDataBytes));
    const auto says_so = [](const nlohmann::json& group) {
      return group.is_object() && group.value("background", nlohmann::json()) == true;
    };
    return says_so(sheet) || says_so(sheet.value("kwargs", nlohmann::json()));
  } catch (const std::exception&) {
    return false;
  }
}

/// Reads the mass from data.json; returns 0 and the defect when it cannot be read.
double mass_from_data_file(const std::filesystem::path& path, std::string& defect) {
  try {
    const nlohmann::json sheet = nlohmann::json::parse(read_text_file(path, kMaxDataBytes));
    const double mass = sheet.at("kwargs").at("mass").get<double>();
    if (mass > 0.0 && std::isfinite(mass)) return mass;
    defect = "kwargs.mass is not > 0";
  } catch (const std::exception& exception) {
    defect = exception.what();
  }
  return 0.0;
}

}  // namespace

const std::vector<std::string>& movi_b_shape_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> keys;
    for (const auto& entry : mass_table()) keys.push_back(entry.first);
    return keys;
  }();
  return names;
}

double movi_shape_mass(const std::string& name) {
  const auto entry = mass_table().find(name);
  return entry == mass_table().end() ? 0.0 : entry->second;
}

Shape load_kubasic_shape(const std::filesystem::path& folder, std::vector<std::string>* warnings) {
  Shape shape;
  shape.name = (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  const std::filesystem::path geometry = folder / kGeometryFile;
  const std::vector<ObjPart> builders = parse_obj(geometry, read_geometry(geometry));
  for (std::size_t i = 0; i < builders.size(); ++i) shape.parts.push_back(build_part(geometry, i, builders[i]));

  std::string defect;
  shape.mass_kg = mass_from_data_file(folder / kDataFile, defect);
  if (shape.mass_kg == 0.0) {
    const bool known = movi_shape_mass(shape.name) > 0.0;
    shape.mass_kg = known ? movi_shape_mass(shape.name) : volume(shape);
    if (warnings != nullptr) {
      warnings->push_back((folder / kDataFile).string() + ": " + defect + "; using " +
                          (known ? "the mass known from MOVi, " : "the volume as mass, ") +
                          std::to_string(shape.mass_kg) + " kg");
    }
  }
  return shape;
}

std::vector<std::string> kubasic_shape_names(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) fail(folder, "no such folder");
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (std::filesystem::exists(entry.path() / kGeometryFile)) names.push_back(entry.path().filename().string());
  }
  if (names.empty()) fail(folder, std::string("no sub-folder holds a ") + kGeometryFile);
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<Shape> load_kubasic_shapes(const std::filesystem::path& folder, std::vector<std::string>* warnings) {
  std::vector<Shape> shapes;
  for (const std::string& name : kubasic_shape_names(folder)) {
    shapes.push_back(load_kubasic_shape(folder / name, warnings));
  }
  return shapes;
}

std::vector<Shape> load_usable_kubasic_shapes(const std::filesystem::path& folder, std::vector<std::string>& warnings) {
  std::vector<Shape> shapes;
  for (const std::string& name : kubasic_shape_names(folder)) {
    if (is_background(folder / name / kDataFile)) {
      warnings.push_back("shape '" + (folder / name).string() + "' is a background and left out");
      continue;
    }
    try {
      shapes.push_back(load_kubasic_shape(folder / name, &warnings));
    } catch (const std::runtime_error& error) {
      warnings.push_back(std::string("left out: ") + error.what());
    }
  }
  if (shapes.empty()) fail(folder, "holds no usable shape; " + warnings.back());
  return shapes;
}

void write_kubasic_shape(const std::filesystem::path& folder, const Shape& shape) {
  const std::filesystem::path target = folder / shape.name;
  std::filesystem::create_directories(target);
  std::ostringstream geometry;
  geometry.imbue(std::locale::classic());
  geometry.precision(9);
  int first = 1;
  for (std::size_t i = 0; i < shape.parts.size(); ++i) {
    const ConvexPart& part = shape.parts[i];
    geometry << "o convex_" << i << '\n';
    for (Eigen::Index v = 0; v < part.vertices.rows(); ++v) {
      geometry << "v " << part.vertices(v, 0) << ' ' << part.vertices(v, 1) << ' ' << part.vertices(v, 2) << '\n';
    }
    for (Eigen::Index f = 0; f < part.triangles.rows(); ++f) {
      geometry << "f " << part.triangles(f, 0) + first << ' ' << part.triangles(f, 1) + first << ' '
               << part.triangles(f, 2) + first << '\n';
    }
    first += static_cast<int>(part.vertices.rows());
  }
  const nlohmann::json sheet = {{"id", shape.name}, {"kwargs", {{"mass", shape.mass_kg}}}};
  try {
    write_text_file(target / kGeometryFile, geometry.str());
    write_text_file(target / kDataFile, sheet.dump(2) + '\n');
  } catch (const std::runtime_error& error) {
    fail(target, error.what());
  }
}

}  // namespace rigidformer
