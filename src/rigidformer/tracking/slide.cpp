// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/slide.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace rigidformer {

namespace {

// Thresholds, as in the table of docs/tracking.md ("All thresholds"), all chosen by eye but the derived one.
constexpr float kParallel = 0.3F;        // cosine between a direction and the normal of a face parallel to it, at most
constexpr float kAcross = 0.8F;          // cosine between a direction and the normal of a face that ends it, at least
constexpr float kSamePlane = 0.97F;      // cosine between normals of one plane, or of one strip of a bent face
constexpr float kPlaneDistance = 0.1F;   // [size] along the normal, within one plane; opposite sides are farther apart
constexpr float kOnSurface = 3.0F;       // [noise] from the reference; derived: holds 99.7 % of Gaussian noise
constexpr float kBeyond = 1.5F;          // [voxel] along the surface from a reference point: still known
constexpr double kEnd = 0.005;           // share of the points beyond an end, which stray points must not make
constexpr double kNextToEnd = 0.025;     // share of the points beyond a place just inside an end
constexpr double kBlunt = 2.0;           // depth of an end over the extent; 1 for evenly spread points
constexpr std::size_t kMinPoints = 100;  // points on the faces, below which their ends are not sharp
constexpr double kKnownEnd = 0.4;        // [noise] standard deviation of the ends of the reference
constexpr double kSameExtent = 0.5;      // [voxel] difference of two extents of which none is cut off

struct Plane {
  Eigen::Vector3f point;
  Eigen::Vector3f normal;
};

/// Place of a point along a direction, and how much the point counts.
struct Mark {
  double place;
  double weight;
};

/// The place where a cloud ends along a direction.
struct End {
  double place;
  double depth;  ///< q: how much farther in the next points lie [m], per share of the points
};

struct Extent {
  End lower;
  End upper;
};

// Goes from the first mark on until `weight` has been passed.
template <class Iterator>
double place_after(Iterator mark, Iterator last, double weight) {
  for (; std::next(mark) != last && weight >= mark->weight; ++mark) {
    weight -= mark->weight;
  }
  return mark->place;
}

template <class Iterator>
End end_of(Iterator first, Iterator last, double total) {
  const double place = place_after(first, last, kEnd * total);
  return {place, std::abs(place_after(first, last, kNextToEnd * total) - place) / (kNextToEnd - kEnd)};
}

Extent extent_of(std::vector<Mark> marks) {
  std::sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) { return a.place < b.place; });
  double total = 0.0;
  for (const Mark& mark : marks) {
    total += mark.weight;
  }
  return {end_of(marks.begin(), marks.end(), total), end_of(marks.rbegin(), marks.rend(), total)};
}

// Points that thin out, as towards the tip of a cone, make a blunt end that says little about where the cloud ends.
bool is_sharp(const Extent& extent) {
  return 0.5 * (extent.lower.depth + extent.upper.depth) < kBlunt * (extent.upper.place - extent.lower.place);
}

// Square root of the first term of sigma_s^2: standard deviation of the mean of both ends as
// `num_points` show them, each a quantile.
double standard_deviation(const Extent& extent, double num_points) {
  return 0.5 * std::hypot(extent.lower.depth, extent.upper.depth) * std::sqrt(kEnd / num_points);
}

/// Faces of the reference and of the cloud that are parallel to one direction.
class ParallelFaces {
 public:
  ParallelFaces(const ReferenceCloud& reference, const SurfaceCloud& cloud_object, const Eigen::Vector3f& direction,
                double noise_m)
      : reference_(reference),
        direction_(direction),
        on_surface_m_(kOnSurface * static_cast<float>(noise_m)),
        plane_distance_m_(kPlaneDistance * static_cast<float>(reference.size_m())) {
    find_planes(cloud_object);
    mark_cloud(cloud_object);
    mark_reference();
  }

  const std::vector<Mark>& cloud_marks() const { return cloud_marks_; }
  const std::vector<Mark>& reference_marks() const { return reference_marks_; }

 private:
  using Face = std::vector<Plane>::const_iterator;

  Plane reference_plane(int row) const {
    return {reference_.points().row(row).transpose(), reference_.normals().row(row).transpose()};
  }
  bool is_parallel(const Plane& plane) const {
    return !plane.normal.isZero() && std::abs(plane.normal.dot(direction_)) < kParallel;
  }
  bool is_across(const Plane& plane) const { return std::abs(plane.normal.dot(direction_)) > kAcross; }

  // Tells whether the point lies on the reference, on a parallel face that may have this normal.
  bool is_known(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) const {
    const Plane known = reference_plane(reference_.nearest(point, normal));
    const Eigen::Vector3f offset = point - known.point;
    const float height = known.normal.dot(offset);
    return is_parallel(known) && on_same_face(known.normal, normal) && std::abs(height) < on_surface_m_ &&
           (offset - height * known.normal).norm() < kBeyond * static_cast<float>(reference_.voxel_size_m());
  }

  Face face_of(const Plane& other) const {
    if (is_parallel(other)) {
      return std::find_if(planes_.begin(), planes_.end(), [&](const Plane& plane) {
        return std::abs(plane.normal.dot(other.normal)) > kSamePlane &&
               std::abs(plane.normal.dot(other.point - plane.point)) < plane_distance_m_;
      });
    }
    // Normals are poor close to an edge, but a face ends at its edges: such points count for the face that they lie on.
    return is_across(other) ? planes_.end() : std::find_if(planes_.begin(), planes_.end(), [&](const Plane& plane) {
      return std::abs(plane.normal.dot(other.point - plane.point)) < plane_distance_m_ &&
             is_known(other.point, plane.normal);
    });
  }

  void find_planes(const SurfaceCloud& cloud) {
    for (Eigen::Index i = 0; i < cloud.points.rows(); ++i) {
      const Plane seen{cloud.points.row(i).transpose(), cloud.normals.row(i).transpose()};
      if (is_parallel(seen) && face_of(seen) == planes_.end() && is_known(seen.point, seen.normal)) {
        planes_.push_back(seen);
      }
    }
    counts_.resize(planes_.size(), 0);
  }

  void mark_cloud(const SurfaceCloud& cloud) {
    for (Eigen::Index i = 0; i < cloud.points.rows(); ++i) {
      const Plane seen{cloud.points.row(i).transpose(), cloud.normals.row(i).transpose()};
      const Face face = face_of(seen);
      if (face != planes_.end() && (!is_parallel(seen) || is_known(seen.point, seen.normal))) {
        cloud_marks_.push_back({direction_.dot(seen.point), 1.0});
        ++counts_[static_cast<std::size_t>(face - planes_.begin())];
      }
    }
  }

  // Every face counts as much as it does in the cloud, so that ends which are not square to the direction do no harm.
  void mark_reference() {
    std::vector<std::pair<int, std::size_t>> rows;
    std::vector<int> known_counts(planes_.size(), 0);
    for (int row = 0; row < reference_.points().rows(); ++row) {
      const Face face = face_of(reference_plane(row));
      if (face != planes_.end()) {
        rows.emplace_back(row, face - planes_.begin());
        known_counts[rows.back().second] += static_cast<int>(reference_.seen(row).size());
      }
    }
    for (const auto& [row, face] : rows) {
      const double weight = static_cast<double>(counts_[face]) / known_counts[face];
      for (const Eigen::Vector3f& point : reference_.seen(row)) {
        reference_marks_.push_back({direction_.dot(point), weight});
      }
    }
  }

  const ReferenceCloud& reference_;
  Eigen::Vector3f direction_;
  float on_surface_m_;
  float plane_distance_m_;
  std::vector<Plane> planes_;  ///< Parallel planes that the cloud shows
  std::vector<int> counts_;    ///< Number of the cloud's points on each plane
  std::vector<Mark> cloud_marks_;
  std::vector<Mark> reference_marks_;
};

}  // namespace

std::optional<Slide> measure_slide(const ReferenceCloud& reference, const SurfaceCloud& cloud_object,
                                   const Eigen::Vector3d& direction, double noise_m) {
  const ParallelFaces faces(reference, cloud_object, direction.cast<float>(), noise_m);
  if (std::min(faces.cloud_marks().size(), faces.reference_marks().size()) < kMinPoints) {
    return std::nullopt;
  }
  const Extent cloud = extent_of(faces.cloud_marks());
  const Extent known = extent_of(faces.reference_marks());
  const double lower = cloud.lower.place - known.lower.place;
  const double upper = cloud.upper.place - known.upper.place;
  const double distance_m = 0.5 * (lower + upper);
  // A cloud that has slid far has some points beyond the known end, which are not recognised: the ends may differ more.
  const double tolerance = std::max(kSameExtent * reference.voxel_size_m(), std::abs(distance_m));
  if (!is_sharp(known)) {
    return std::nullopt;
  }
  const double sampling_m = standard_deviation(known, static_cast<double>(faces.cloud_marks().size()));
  return Slide{distance_m, std::hypot(sampling_m, kKnownEnd * noise_m), std::abs(upper - lower) <= tolerance};
}

}  // namespace rigidformer
