// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/camera/depth_camera_recorder.hpp"

#include <rosbag/bag.h>
#include <tf2_msgs/TFMessage.h>

#include <filesystem>
#include <stdexcept>

#include "rigidformer_ros/simulated/camera/camera_messages.hpp"

namespace rigidformer_ros::camera {
namespace {

// [s] stamp of the first frame: any round number but 0, which would mean "no clock yet".
constexpr double kStart_s = 1000.0;

template <typename Message>
void write_latched(rosbag::Bag& bag, const std::string& topic, const ros::Time& stamp, const Message& message) {
  const auto header = boost::make_shared<ros::M_string>();
  (*header)["type"] = ros::message_traits::datatype(message);
  (*header)["md5sum"] = ros::message_traits::md5sum(message);
  (*header)["message_definition"] = ros::message_traits::definition(message);
  (*header)["callerid"] = "/depth_camera";
  (*header)["latching"] = "1";
  bag.write(topic, stamp, message, header);
}

void write_frame(rosbag::Bag& bag, const FrameMessages& messages, const CameraOptions& options) {
  const ros::Time& stamp = messages.cloud.header.stamp;
  if (options.object_frames && !messages.object_frames.empty()) {
    tf2_msgs::TFMessage frames;
    frames.transforms = messages.object_frames;
    bag.write("/tf", stamp, frames);
  }
  bag.write(std::string("/") + kCloudTopic, stamp, messages.cloud);
  if (options.object_clouds) {
    bag.write(std::string("/") + kObjectCloudsTopic, stamp, messages.object_clouds);
  }
}

// Writes all scenes. The bag is opened only when the first scene has shown that the options are usable.
RecordingSummary write_scenes(const std::string& file, const CameraOptions& options, rosbag::Bag& bag) {
  RecordingSummary summary;
  ros::Time start(kStart_s);
  for (; summary.num_scenes < options.num_scenes; ++summary.num_scenes) {
    const CameraScene scene(options, static_cast<std::uint64_t>(summary.num_scenes));
    if (summary.num_scenes == 0) {
      bag.open(file, rosbag::bagmode::Write);
      tf2_msgs::TFMessage frames;
      frames.transforms = {camera_transform(scene, options, start)};
      write_latched(bag, "/tf_static", start, frames);
    }
    write_latched(bag, std::string("/") + kTruthTopic, start, make_truth(scene, options, start));
    for (int frame = 0; frame < scene.num_frames(); ++frame, ++summary.num_frames) {
      const ros::Time stamp = start + ros::Duration(scene.time_s(frame));
      write_frame(bag, make_messages(scene, frame, options, stamp), options);
    }
    start += ros::Duration(scene.time_s(scene.num_frames() - 1) + options.pause);
  }
  return summary;
}

// Removes a half-written bag. The destructor of an open bag writes its index, and on a full disk that would end the
// program: emptying the file first makes room for the index.
void abandon(rosbag::Bag& bag, const std::string& file) {
  if (bag.isOpen()) {
    std::filesystem::resize_file(file, 0);
    bag.close();
    std::filesystem::remove(file);
  }
}

}  // namespace

RecordingSummary record_bag(const std::string& file, const CameraOptions& options) {
  if (options.num_scenes < 1) {
    throw std::invalid_argument("num_scenes: is " + std::to_string(options.num_scenes) +
                                ", must be at least 1 for a recording");
  }
  rosbag::Bag bag;
  try {
    const RecordingSummary summary = write_scenes(file, options, bag);
    bag.close();
    return summary;
  } catch (const rosbag::BagException& error) {
    abandon(bag, file);
    throw std::runtime_error("bag '" + file + "': cannot write: " + error.what());
  }
}

}  // namespace rigidformer_ros::camera
