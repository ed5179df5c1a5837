// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "mujoco_scene.hpp"

#include <limits>
#include <locale>
#include <sstream>

#include "rigidformer/baselines/contact_spring.hpp"

namespace rigidformer {
namespace {

constexpr double kTorsionalFriction = 0.005;  // [m], MuJoCo's default
constexpr double kImpedance = 0.99;  // near rigid (by eye); constant, so that stiffness and damping are what they say

void write_mesh(std::ostream& xml, std::size_t i, const ConvexPart& hull) {
  xml << "<mesh name='mesh" << i << "' vertex='" << hull.vertices.reshaped<Eigen::RowMajor>().transpose() << "' face='"
      << hull.triangles.reshaped<Eigen::RowMajor>().transpose() << "'/>\n";
}

void write_pair(std::ostream& xml, const std::string& geom1, const std::string& geom2, double friction,
                double restitution, double solver_step_s) {
  const ContactSpring spring = contact_spring(restitution, solver_step_s);
  xml << "<pair geom1='" << geom1 << "' geom2='" << geom2 << "' condim='4' friction='" << friction << ' ' << friction
      << ' ' << kTorsionalFriction << " 0.0001 0.0001' solref='" << -spring.stiffness << ' ' << -spring.damping
      << "' solimp='" << kImpedance << ' ' << kImpedance << " 0.001'/>\n";
}

void write_pairs(std::ostream& xml, const std::vector<ObservedBody>& bodies, double solver_step_s) {
  const BulletSettings movi;  // settings of the floor
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::string geom = "geom" + std::to_string(i);
    const BodyProperties& a = bodies[i].properties;
    write_pair(xml, "floor", geom, *a.friction * movi.floor_friction, *a.restitution * movi.floor_restitution,
               solver_step_s);
    for (std::size_t j = 0; j < i; ++j) {
      const BodyProperties& b = bodies[j].properties;
      write_pair(xml, "geom" + std::to_string(j), geom, *a.friction * *b.friction, *a.restitution * *b.restitution,
                 solver_step_s);
    }
  }
}

}  // namespace

std::string mujoco_scene(const std::vector<ObservedBody>& bodies, double gravity, double solver_step_s) {
  std::ostringstream xml;
  xml.imbue(std::locale::classic());
  xml.precision(std::numeric_limits<double>::max_digits10);
  const std::size_t max_contacts = 50 + 20 * bodies.size();
  xml << "<mujoco>\n<option timestep='" << solver_step_s << "' gravity='0 0 " << gravity
      << "' cone='elliptic' impratio='10'><flag multiccd='enable'/></option>\n<size nconmax='" << max_contacts
      << "' njmax='" << 4 * max_contacts << "'/>\n<asset>\n";
  for (std::size_t i = 0; i < bodies.size(); ++i) write_mesh(xml, i, bodies[i].parts.front());
  // Without contact types, geoms touch only in the pairs that are listed below.
  xml << "</asset>\n<default><geom contype='0' conaffinity='0'/></default>\n<worldbody>\n"
      << "<geom name='floor' type='plane' size='0 0 1'/>\n";
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    xml << "<body><freejoint/><geom name='geom" << i << "' type='mesh' mesh='mesh" << i << "' mass='"
        << *bodies[i].properties.mass_kg << "'/></body>\n";
  }
  xml << "</worldbody>\n<contact>\n";
  write_pairs(xml, bodies, solver_step_s);
  xml << "</contact>\n</mujoco>\n";
  return xml.str();
}

}  // namespace rigidformer
