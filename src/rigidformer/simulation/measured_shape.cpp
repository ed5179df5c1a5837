// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "measured_shape.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <utility>
#include <vector>

#include "mesh_volume.hpp"
#include "rigidformer/data/obj_file.hpp"
#include "rigidformer/io/text_file.hpp"
#include "rigidformer/simulation/builtin_shapes.hpp"
#include "rigidformer/simulation/convex_hull.hpp"

namespace rigidformer {
namespace {

constexpr std::uintmax_t kMaxMeshBytes = 16u << 20;  // bound on memory, as for collision meshes
constexpr double kConcave = 1.02;  // a hull this much larger than its mesh is another shape; chosen by eye

[[noreturn]] void refuse(const std::string& text) {
  throw std::invalid_argument("shape '" + text +
                              "': accepted are box:LxWxH, sphere:D, cylinder:DxH with lengths in metres above 0, and "
                              "the path of an OBJ file");
}

/// The lengths of "0.1x0.2x0.3".
std::vector<double> lengths_of(const std::string& text, const std::string& list) {
  std::vector<double> lengths;
  const char* at = list.data();
  const char* const end = list.data() + list.size();
  while (at != end) {
    double length = 0.0;
    const auto [rest, error] = std::from_chars(at, end, length);
    if (error != std::errc() || !(length > 0.0) || (rest != end && (*rest != 'x' || rest + 1 == end))) refuse(text);
    lengths.push_back(length);
    at = rest == end ? end : rest + 1;
  }
  return lengths;
}

ConvexPart box(const Eigen::Vector3d& edges) {
  Points corners(8, 3);
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2 & 1) - 0.5);
    corners.row(i) = corner.cwiseProduct(edges).cast<float>().transpose();
  }
  return convex_hull(corners);
}

/// The built-in shape of that name, stretched so that its extents are `extents`.
ConvexPart stretched(const std::string& name, const Eigen::Vector3d& extents) {
  const auto& shapes = builtin_shapes();
  const auto found = std::find_if(shapes.begin(), shapes.end(), [&](const Shape& shape) { return shape.name == name; });
  Points points = found->parts.front().vertices;
  const Eigen::RowVector3f from = points.colwise().maxCoeff() - points.colwise().minCoeff();
  points.array().rowwise() *= extents.cast<float>().transpose().array() / from.array();
  return convex_hull(points);
}

ConvexPart primitive(const std::string& text, const std::string& kind, const std::vector<double>& sizes) {
  if (kind == "box" && sizes.size() == 3) return box({sizes[0], sizes[1], sizes[2]});
  if (kind == "sphere" && sizes.size() == 1) return stretched("sphere", Eigen::Vector3d::Constant(sizes[0]));
  if (kind == "cylinder" && sizes.size() == 2) return stretched("cylinder", {sizes[0], sizes[0], sizes[1]});
  refuse(text);
}

double volume_of(const ObjPart& mesh) {
  ConvexPart part;
  part.vertices.resize(static_cast<Eigen::Index>(mesh.vertices.size()), 3);
  part.triangles.resize(static_cast<Eigen::Index>(mesh.triangles.size()), 3);
  for (Eigen::Index i = 0; i < part.vertices.rows(); ++i) {
    part.vertices.row(i) = mesh.vertices[static_cast<std::size_t>(i)].transpose();
  }
  for (Eigen::Index i = 0; i < part.triangles.rows(); ++i) {
    part.triangles.row(i) = mesh.triangles[static_cast<std::size_t>(i)].transpose();
  }
  return std::abs(measure_volume(part).volume_m3);
}

std::vector<ConvexPart> hulls_of_file(const std::string& file, std::string& remark) {
  std::string content;
  try {
    content = read_text_file(file, kMaxMeshBytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("shape '" + file + "': " + error.what());
  }
  std::vector<ConvexPart> hulls;
  double hull_volume = 0.0, mesh_volume = 0.0;
  for (const ObjPart& mesh : parse_obj(file, content)) {
    Points points(static_cast<Eigen::Index>(mesh.vertices.size()), 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i) points.row(i) = mesh.vertices[static_cast<std::size_t>(i)];
    hulls.push_back(convex_hull(points));
    hull_volume += measure_volume(hulls.back()).volume_m3;
    mesh_volume += volume_of(mesh);
  }
  if (hull_volume > kConcave * mesh_volume) {
    remark = "shape '" + file + "': hulls took the place of groups that are not convex or not closed (volume " +
             std::to_string(hull_volume) + " instead of " + std::to_string(mesh_volume) + " m^3)";
  }
  return hulls;
}

}  // namespace

MeasuredShape measured_shape(const std::string& name, const std::string& text) {
  MeasuredShape measured;
  measured.shape.name = name;
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const bool is_primitive = colon != std::string::npos && (kind == "box" || kind == "sphere" || kind == "cylinder");
  if (is_primitive) {
    measured.shape.parts = {primitive(text, kind, lengths_of(text, text.substr(colon + 1)))};
  } else {
    if (!std::filesystem::exists(text)) refuse(text);
    measured.shape.parts = hulls_of_file(text, measured.remark);
  }
  measured.centre_object = measure_volume(measured.shape.parts).centroid;
  for (ConvexPart& part : measured.shape.parts) {
    part.vertices.rowwise() -= measured.centre_object.transpose().cast<float>();
  }
  return measured;
}

}  // namespace rigidformer
