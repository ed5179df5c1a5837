// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fixtures.hpp"

#include <algorithm>

namespace rigidformer {
namespace {

// All ranges were chosen by eye, [m] where objects are about 1 m large.
constexpr Range kTableLength{2.2, 4.0}, kTableWidth{1.8, 3.0}, kTableHeight{0.5, 1.6}, kThickness{0.1, 0.3};
constexpr Range kShelfLength{2.0, 3.5}, kShelfDepth{1.2, 2.0}, kBoardGap{1.2, 1.8};
constexpr Range kBinLength{2.0, 3.5}, kBinHeight{0.5, 1.6};
constexpr Range kWallLength{2.0, 5.0}, kWallHeight{1.0, 2.5};
constexpr Range kRampLength{2.5, 5.0}, kRampWidth{1.5, 3.0}, kRampSlope_rad{0.09, 0.52};  // 5 to 30 degrees
constexpr Range kPegDiameter{0.15, 0.6}, kPegHeight{0.8, 1.8}, kPegGroup{0.6, 1.6};
constexpr int kMinPegs = 3, kMaxPegs = 5, kMinBoards = 2, kMaxBoards = 3;
constexpr double kAimHeight = 0.5;  // above a surface, so that an object meets it with its lower side

using Eigen::Vector3d;

void add(Fixture& fixture, const Block& block, const Vector3d& centre,
         const Eigen::Quaterniond& rotation = Eigen::Quaterniond::Identity()) {
  fixture.blocks.push_back({block, {rotation, centre}});
  fixture.radius_m = std::max(fixture.radius_m, centre.head<2>().norm() + 0.5 * block.edges.norm());
}

/// A slab with its upper side at `height`, and aims on it.
Block add_board(Fixture& fixture, const Vector3d& edges, double height, double unit_m, Random& random) {
  const Block board = block_of(edges);
  add(fixture, board, {0.0, 0.0, height - 0.5 * board.edges.z()});
  for (int i = 0; i < 2; ++i) {
    const double x = random.uniform(-0.35, 0.35), y = random.uniform(-0.35, 0.35);
    fixture.aims.push_back({{x * board.edges.x(), y * board.edges.y(), height + kAimHeight * unit_m}});
  }
  return board;
}

/// Two slabs that stand at the ends of a board.
void add_sides(Fixture& fixture, const Block& board, double height, double thickness, double inset) {
  const Block side = block_of({thickness, board.edges.y() * (1.0 - inset), height});
  for (const double x : {-0.5, 0.5}) {
    const double place = x * (board.edges.x() * (1.0 - inset) - side.edges.x());
    add(fixture, side, {place, 0.0, height - 0.5 * side.edges.z()});
  }
}

Fixture draw_table(double unit_m, Random& random) {
  Fixture table;
  const double height = unit_m * draw(random, kTableHeight), thickness = unit_m * draw(random, kThickness);
  const Vector3d edges(unit_m * draw(random, kTableLength), unit_m * draw(random, kTableWidth), thickness);
  const Block board = add_board(table, edges, height, unit_m, random);
  add_sides(table, board, height - board.edges.z(), thickness, 0.15);
  table.top = Top{{0.0, 0.0, height}, 0.5 * board.edges.head<2>()};
  return table;
}

Fixture draw_shelf(double unit_m, Random& random) {
  Fixture shelf;
  const double thickness = 0.5 * unit_m * draw(random, kThickness), gap = unit_m * draw(random, kBoardGap);
  const Vector3d edges(unit_m * draw(random, kShelfLength), unit_m * draw(random, kShelfDepth), thickness);
  const int num_boards = random.uniform_int(kMinBoards, kMaxBoards);
  Block board;
  double height = 0.5 * gap;
  for (int i = 0; i < num_boards; ++i, height += gap) {
    board = add_board(shelf, edges, height, unit_m, random);
    if (i + 1 == num_boards) break;
    for (Aim& aim : shelf.aims) {  // only the uppermost board is open above: into others one throws from the front
      if (!aim.heading) aim.heading = Vector3d(0.0, random.uniform_int(0, 1) == 0 ? -1.0 : 1.0, 0.0);
    }
  }
  height -= gap;
  add_sides(shelf, board, height, thickness, 0.0);
  shelf.top = Top{{0.0, 0.0, height}, 0.5 * board.edges.head<2>()};
  return shelf;
}

Fixture draw_bin(double unit_m, Random& random) {
  Fixture bin;
  const double thickness = 0.5 * unit_m * draw(random, kThickness), height = unit_m * draw(random, kBinHeight);
  const Vector3d edges(unit_m * draw(random, kBinLength), unit_m * draw(random, kBinLength), thickness);
  const Block floor = add_board(bin, edges, thickness, unit_m, random);
  for (const int axis : {0, 1}) {
    const double length = floor.edges[1 - axis];
    Vector3d wall_edges(length, length, height);
    wall_edges[axis] = thickness;
    const Block wall = block_of(wall_edges);
    for (const double side : {-0.5, 0.5}) {
      Vector3d centre(0.0, 0.0, 0.5 * wall.edges.z());
      centre[axis] = side * (floor.edges[axis] - wall.edges[axis]);
      add(bin, wall, centre);
    }
  }
  return bin;
}

Fixture draw_wall(double unit_m, Random& random) {
  Fixture wall;
  const Block slab = block_of(
      {unit_m * draw(random, kWallLength), unit_m * draw(random, kThickness), unit_m * draw(random, kWallHeight)});
  add(wall, slab, {0.0, 0.0, 0.5 * slab.edges.z()});
  for (int i = 0; i < 4; ++i) {
    const double side = random.uniform_int(0, 1) == 0 ? -1.0 : 1.0;
    const Vector3d point(random.uniform(-0.4, 0.4) * slab.edges.x(), side * kAimHeight * unit_m,
                         random.uniform(0.3, 1.0) * slab.edges.z());
    wall.aims.push_back({point, Vector3d(0.0, -side, 0.0)});
  }
  return wall;
}

/// The lower edge of its upper side lies on the floor.
Fixture draw_ramp(double unit_m, Random& random) {
  Fixture ramp;
  const Block slab = block_of(
      {unit_m * draw(random, kRampLength), unit_m * draw(random, kRampWidth), unit_m * draw(random, kThickness)});
  const double slope_rad = draw(random, kRampSlope_rad);
  const Eigen::Quaterniond tilt = rotation_about({0.0, -slope_rad, 0.0});
  const Vector3d lower_edge = tilt * Vector3d(-0.5 * slab.edges.x(), 0.0, 0.5 * slab.edges.z());
  add(ramp, slab, {0.0, 0.0, -lower_edge.z()}, tilt);
  for (int i = 0; i < 4; ++i) {
    const Vector3d on_slab(random.uniform(-0.1, 0.45) * slab.edges.x(), random.uniform(-0.3, 0.3) * slab.edges.y(),
                           0.5 * slab.edges.z() + kAimHeight * unit_m);
    ramp.aims.push_back({Vector3d(0.0, 0.0, -lower_edge.z()) + tilt * on_slab});
  }
  return ramp;
}

Fixture draw_pegs(double unit_m, Random& random) {
  Fixture pegs;
  const int count = random.uniform_int(kMinPegs, kMaxPegs);
  const double turn_rad = random.uniform(0.0, 2.0 * M_PI);
  for (int i = 0; i < count; ++i) {
    const Block peg = peg_of(unit_m * draw(random, kPegDiameter), unit_m * draw(random, kPegHeight));
    const double angle_rad = turn_rad + 2.0 * M_PI * i / count, distance = unit_m * draw(random, kPegGroup);
    const Vector3d foot(distance * std::cos(angle_rad), distance * std::sin(angle_rad), 0.0);
    add(pegs, peg, foot + Vector3d(0.0, 0.0, 0.5 * peg.edges.z()));
    pegs.aims.push_back({foot + Vector3d(0.0, 0.0, peg.edges.z() * random.uniform(0.3, 1.2))});
  }
  return pegs;
}

}  // namespace

Fixture draw_fixture(double unit_m, Random& random) {
  using Draw = Fixture (*)(double, Random&);
  constexpr Draw kKinds[] = {draw_table, draw_shelf, draw_bin, draw_wall, draw_ramp, draw_pegs};
  return kKinds[random.uniform_int(0, static_cast<int>(std::size(kKinds)) - 1)](unit_m, random);
}

}  // namespace rigidformer
