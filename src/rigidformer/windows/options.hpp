// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "rigidformer/io/members.hpp"

namespace rigidformer {

/// Which moments of which scenes are learned from. A member's name is its YAML key under `windows:`.
struct WindowOptions {
  std::vector<int> step_sizes = {1, 5, 10};
  double any_step_probability = 0.0;
  double mid_air_probability = 0.0;
  double floor_probability = 0.0;
  double rolling_probability = 0.0;
  double resting_probability = 0.0;
  double driven_probability = 0.0;
};

template <typename Visit>
void for_each_member(WindowOptions& o, const Visit& visit) {
  visit("step_sizes", o.step_sizes, anything(), "s drawn from here ...");
  visit("any_step_probability", o.any_step_probability, anything(),
        "... or, with this probability, uniformly from 1 ... max(step_sizes)");
  visit("mid_air_probability", o.mid_air_probability, anything(), "windows around object-object contacts");
  visit("floor_probability", o.floor_probability, anything(), "windows around floor impacts");
  visit("rolling_probability", o.rolling_probability, anything(), "windows in which an object rolls or slides");
  visit("resting_probability", o.resting_probability, anything(), "windows in which an object rests ...");
  visit("driven_probability", o.driven_probability, anything(),
        "... or a driven body moves near one; what is left is uniform in time");
}

/// How a scene is observed and varied. A member's name is its YAML key under `augmentation:`.
struct AugmentationOptions {
  int min_points = 64;
  int max_points = 128;
  std::vector<int> point_counts;
  double vertex_probability = 0.0;
  double view_probability = 0.0;
  double mask_probability = 0.0;
  double masked_share = 0.25;
  double noise_m = 0.0;
  double unknown_probability = 0.0;
  double yaw_probability = 0.5;
  double yaw_step_deg = 5.0;
  bool yaw_per_batch = true;
  double shift_m = 0.0;
  double permutation_probability = 0.5;
};

template <typename Visit>
void for_each_member(AugmentationOptions& o, const Visit& visit) {
  visit("min_points", o.min_points, at_least(4), "points per object, drawn per object between these bounds ...");
  visit("max_points", o.max_points, anything(), "... this is also the padded size");
  visit("point_counts", o.point_counts, anything(), "where given, one of these is drawn per object instead");
  visit("vertex_probability", o.vertex_probability, share(), "windows that use mesh vertices instead of samples");
  visit("view_probability", o.view_probability, share(), "windows that keep only points facing one random camera");
  visit("mask_probability", o.mask_probability, share(),
        "windows whose objects lose points, half of them at random places, half inside a random box ...");
  visit("masked_share", o.masked_share, less_than_all(), "... namely this share of their points (paper, Fig. 4)");
  visit("noise_m", o.noise_m, at_least(0.0), "largest standard deviation of point noise, drawn per window");
  visit("unknown_probability", o.unknown_probability, share(), "windows whose material parameters are hidden");
  visit("yaw_probability", o.yaw_probability, share(), "windows turned about the vertical axis ...");
  visit("yaw_step_deg", o.yaw_step_deg, anything(), "... by a multiple of this angle; 0 = any angle");
  visit("yaw_per_batch", o.yaw_per_batch, anything(),
        "one angle for the whole batch (paper, App. E) or one per window");
  visit("shift_m", o.shift_m, at_least(0.0), "windows are moved horizontally by up to this distance");
  visit("permutation_probability", o.permutation_probability, share(), "objects in random order (paper, App. E)");
}

/// How shapes become point sets. A member's name is its YAML key under `point_sets:`.
struct PointSetOptions {
  int sets_per_shape = 24;
  int points_per_set = 512;
  std::uint64_t seed = 1;
};

template <typename Visit>
void for_each_member(PointSetOptions& o, const Visit& visit) {
  visit("sets_per_shape", o.sets_per_shape, anything(),
        "independent surface samplings per shape; set 0 holds the mesh vertices");
  visit("points_per_set", o.points_per_set, anything(), "upper bound per set, in farthest-point order");
  visit("seed", o.seed, anything(), "of the samplings");
}

}  // namespace rigidformer
