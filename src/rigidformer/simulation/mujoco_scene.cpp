// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "mujoco_scene.hpp"

#include <algorithm>
#include <limits>
#include <locale>
#include <sstream>

#include "rigidformer/simulation/contact_spring.hpp"
#include "rigidformer/simulation/mesh_volume.hpp"

namespace rigidformer {
namespace {

// Room for the contacts of ten objects of many parts each, and their rows, whose square is the memory that MuJoCo asks
// for (288 MB of addresses, of which it touches what it uses). Chosen by eye; what is beyond is left out by MuJoCo.
constexpr std::size_t kMostContacts = 2000, kMostRows = 6000;
constexpr double kDrivenMass_kg = 1e6;  // so heavy that objects of a scene cannot push it, as in Bullet; by eye

/// One side of a pair, as contacts see it.
struct Surface {
  double friction, restitution;
  double radius_m;  ///< 0 for the floor
};

Surface surface_of(const MujocoBody& body) {
  float radius_m = 0.0F;
  for (const ConvexPart& part : body.parts) radius_m = std::max(radius_m, part.vertices.rowwise().norm().maxCoeff());
  return {*body.properties.friction, *body.properties.restitution, static_cast<double>(radius_m)};
}

std::string geom_name(std::size_t body, std::size_t part) {
  return "geom" + std::to_string(body) + "_" + std::to_string(part);
}

void write_meshes(std::ostream& xml, std::size_t i, const MujocoBody& body) {
  for (std::size_t p = 0; p < body.parts.size(); ++p) {
    xml << "<mesh name='mesh" << i << '_' << p << "' vertex='"
        << body.parts[p].vertices.reshaped<Eigen::RowMajor>().transpose() << "' face='"
        << body.parts[p].triangles.reshaped<Eigen::RowMajor>().transpose() << "'/>\n";
  }
}

double mass_of(const MujocoBody& body) { return body.path ? kDrivenMass_kg : *body.properties.mass_kg; }

/// Inertia of a body of one density about its origin; volume where parts overlap counts twice.
Eigen::Matrix3d inertia(const MujocoBody& body) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  double volume_m3 = 0.0;
  for (const ConvexPart& part : body.parts) {
    const double of_part = measure_volume(part).volume_m3;
    sum += of_part * inertia_per_mass(part);
    volume_m3 += of_part;
  }
  return mass_of(body) / volume_m3 * sum;
}

void write_body(std::ostream& xml, std::size_t i, const MujocoBody& body) {
  if (body.is_static) {
    const Eigen::Quaterniond& q = body.state.T_world_object.rotation;
    xml << "<body pos='" << body.state.T_world_object.translation.transpose() << "' quat='" << q.w() << ' ' << q.x()
        << ' ' << q.y() << ' ' << q.z() << "'>\n";
  } else {
    const Eigen::Matrix3d I = inertia(body);
    xml << "<body><freejoint/><inertial pos='0 0 0' mass='" << mass_of(body) << "' fullinertia='" << I(0, 0) << ' '
        << I(1, 1) << ' ' << I(2, 2) << ' ' << I(0, 1) << ' ' << I(0, 2) << ' ' << I(1, 2) << "'/>\n";
  }
  for (std::size_t p = 0; p < body.parts.size(); ++p) {
    xml << "<geom name='" << geom_name(i, p) << "' type='mesh' mesh='mesh" << i << '_' << p << "'/>\n";
  }
  xml << "</body>\n";
}

/// The attributes of the contacts between two surfaces. Lever arms combine as in Bullet.
std::string pair_attributes(const Surface& a, const Surface& b, const MujocoSettings& settings) {
  const double solver_step_s = 1.0 / (settings.frame_rate_hz * settings.substeps);
  const ContactSpring spring = contact_spring(a.restitution * b.restitution, solver_step_s, settings.steps_per_contact);
  const double friction = a.friction * b.friction;
  const double arm_m = a.radius_m * b.friction + b.radius_m * a.friction;
  const bool resists_rolling = settings.rolling_friction > 0.0;
  std::ostringstream xml;
  xml.imbue(std::locale::classic());
  xml.precision(std::numeric_limits<double>::max_digits10);
  xml << "condim='" << (resists_rolling ? 6 : 4) << "' friction='" << friction << ' ' << friction << ' '
      << std::max(settings.spinning_friction_m, settings.spinning_friction * arm_m) << ' '
      << settings.rolling_friction * arm_m << ' ' << settings.rolling_friction * arm_m << "' solref='"
      << -spring.stiffness << ' ' << -spring.damping << "' solimp='" << settings.impedance << ' ' << settings.impedance
      << " 0.001'";
  return xml.str();
}

void write_pairs(std::ostream& xml, const std::vector<MujocoBody>& bodies, const MujocoSettings& settings) {
  const Surface floor{settings.floor_friction, settings.floor_restitution, 0.0};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Surface own = surface_of(bodies[i]);
    const std::string on_floor = pair_attributes(floor, own, settings);
    for (std::size_t p = 0; p < bodies[i].parts.size() && !bodies[i].is_given(); ++p) {
      xml << "<pair geom1='floor' geom2='" << geom_name(i, p) << "' " << on_floor << "/>\n";
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (bodies[i].is_given() && bodies[j].is_given()) continue;
      const std::string attributes = pair_attributes(surface_of(bodies[j]), own, settings);
      for (std::size_t q = 0; q < bodies[j].parts.size(); ++q) {
        for (std::size_t p = 0; p < bodies[i].parts.size(); ++p) {
          xml << "<pair geom1='" << geom_name(j, q) << "' geom2='" << geom_name(i, p) << "' " << attributes << "/>\n";
        }
      }
    }
  }
}

}  // namespace

std::string mujoco_scene(const std::vector<MujocoBody>& bodies, const MujocoSettings& settings) {
  std::ostringstream xml;
  xml.imbue(std::locale::classic());
  xml.precision(std::numeric_limits<double>::max_digits10);
  std::size_t num_parts = 0;
  for (const MujocoBody& body : bodies) num_parts += body.parts.size();
  const std::size_t max_contacts = std::min(50 + 20 * num_parts, kMostContacts);
  xml << "<mujoco>\n<option timestep='" << 1.0 / (settings.frame_rate_hz * settings.substeps) << "' gravity='"
      << settings.gravity.transpose() << "' cone='elliptic' impratio='" << settings.friction_impedance
      << "'><flag multiccd='enable'/></option>\n<size nconmax='" << max_contacts << "' njmax='"
      << std::min(6 * max_contacts, kMostRows) << "'/>\n<asset>\n";
  for (std::size_t i = 0; i < bodies.size(); ++i) write_meshes(xml, i, bodies[i]);
  xml << "</asset>\n<default><geom contype='0' conaffinity='0'/></default>\n<worldbody>\n"
      << "<geom name='floor' type='plane' size='0 0 1'/>\n";
  for (std::size_t i = 0; i < bodies.size(); ++i) write_body(xml, i, bodies[i]);
  xml << "</worldbody>\n<contact>\n";
  write_pairs(xml, bodies, settings);
  xml << "</contact>\n</mujoco>\n";
  return xml.str();
}

}  // namespace rigidformer
