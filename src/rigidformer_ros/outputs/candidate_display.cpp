// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/outputs/candidate_display.hpp"

#include <algorithm>

#include "rigidformer_ros/messages/names.hpp"

namespace rigidformer_ros {

namespace {

using visualization_msgs::Marker;

constexpr std::size_t kMostShown = 32;  // candidates; more hide each other; chosen by eye

std_msgs::ColorRGBA color(float red, float green, float blue) {
  std_msgs::ColorRGBA color;
  color.r = red;
  color.g = green;
  color.b = blue;
  color.a = 0.8F;
  return color;
}

std_msgs::ColorRGBA color_of(const CandidateResult& result) {
  switch (result.stop_reason) {
    case CandidateResult::STOP_HORIZON:
      return color(0.2F, 0.8F, 0.2F);
    case CandidateResult::STOP_CONDITION:
      return color(1.0F, 0.6F, 0.1F);
    case CandidateResult::STOP_WALL_TIME:
    case CandidateResult::STOP_PREEMPTED:
      return color(0.5F, 0.5F, 0.5F);
    default:
      return color(0.9F, 0.1F, 0.1F);
  }
}

class Markers {
 public:
  explicit Markers(const std_msgs::Header& header) : header_(header) {
    Marker clear;
    clear.header = header;
    clear.action = Marker::DELETEALL;
    all.markers.push_back(clear);
  }

  Marker& add(const char* ns, std::int32_t type, const std_msgs::ColorRGBA& color, double size_m) {
    Marker marker;
    marker.header = header_;
    marker.ns = ns;
    marker.id = static_cast<std::int32_t>(all.markers.size());
    marker.type = type;
    marker.color = color;
    marker.scale.x = marker.scale.y = marker.scale.z = size_m;
    marker.pose.orientation.w = 1.0;
    all.markers.push_back(marker);
    return all.markers.back();
  }

  void add_path(const char* ns, const std::vector<geometry_msgs::Pose>& poses, const std_msgs::ColorRGBA& color,
                double width_m) {
    Marker& path = add(ns, Marker::LINE_STRIP, color, width_m);
    for (const geometry_msgs::Pose& pose : poses) {
      path.points.push_back(pose.position);
    }
  }

  visualization_msgs::MarkerArray all;

 private:
  std_msgs::Header header_;
};

}  // namespace

visualization_msgs::MarkerArray candidate_markers(const BatchRequest& request, const BatchResult& result,
                                                  const DisplayParameters& display) {
  Markers markers(result.header);
  const std::string& frame = request.scene.header.frame_id;
  const bool in_fixed_frame = frame.empty() || frame == result.header.frame_id;
  for (std::size_t i = 0; i < std::min(kMostShown, result.results.size()); ++i) {
    const CandidateResult& candidate = result.results[i];
    for (const ObjectOutcome& object : candidate.objects) {
      if (object.poses.size() > 1) {
        markers.add_path("paths", object.poses, color_of(candidate), display.path_width);
      } else {
        markers.add("ends", Marker::SPHERE, color_of(candidate), 2.0 * display.path_width).pose.position =
            object.end_pose.position;
      }
    }
    for (const KinematicTrack& track : request.candidates.at(i).kinematic) {
      if (in_fixed_frame && track.poses.size() > 1) {
        markers.add_path("tracks", track.poses, color(0.2F, 0.4F, 1.0F), display.path_width);
      }
    }
  }
  return markers.all;
}

CandidateDisplay::CandidateDisplay(ros::NodeHandle& node, const DisplayParameters& display)
    : display_(display),
      publisher_(node.advertise<visualization_msgs::MarkerArray>(names::kCandidateMarkers, /*queue_size=*/1)) {}

void CandidateDisplay::show(const BatchRequest& request, const BatchResult& result) {
  if (publisher_.getNumSubscribers() > 0) {
    publisher_.publish(candidate_markers(request, result, display_));
  }
}

}  // namespace rigidformer_ros
