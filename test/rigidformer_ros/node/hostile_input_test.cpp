// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rigidformer_ros/GetModelInfo.h>
#include <rosgraph_msgs/Log.h>
#include <sys/wait.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "rigidformer_ros/node/node_client.hpp"
#include "rigidformer_ros/node/node_process.hpp"

namespace rigidformer_ros::testing {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// The motion of a body that hovers and turns, so that it can be watched for as long as the test takes.
Flight hovering() {
  Flight flight;
  flight.velocity.setZero();
  flight.gravity = 0.0;
  return flight;
}

class HostileInputTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(client.wait_until([] {
      GetModelInfo info;
      return ros::service::call("get_model_info", info) && info.response.ready;
    }));
    client.reset();
    start = ros::Time::now();
  }

  Points points_at(const ros::Time& stamp) const { return hovering().pose((stamp - start).toSec()).apply(blob()); }

  // Publishes clouds of the object `id` that `spoil` has changed, and whole clouds of "good" beside them, until the log
  // says that clouds were rejected for this reason. Returns false if it never does.
  bool counted(const std::string& id, const std::string& reason,
               const std::function<void(sensor_msgs::PointCloud2&)>& spoil) {
    log.clear();
    return client.wait_until([&] {
      const ros::Time stamp = ros::Time::now();
      sensor_msgs::PointCloud2 cloud = stamped_cloud(points_at(stamp), stamp);
      spoil(cloud);
      client.object(id).publish(cloud);
      client.object("good").publish(stamped_cloud(points_at(stamp), stamp));
      client.wait_until([] { return false; }, 0.02);
      return log.find("Rejected, " + reason) != std::string::npos;
    });
  }

  void expect_forecast_of_good() {
    const ros::Time before = ros::Time::now();
    EXPECT_TRUE(client.wait_until([&] {
      const ros::Time stamp = ros::Time::now();
      client.object("good").publish(stamped_cloud(points_at(stamp), stamp));
      client.wait_until([] { return false; }, 0.02);
      return client.last_forecast.header.stamp > before;
    }));
  }

  NodeClient client;
  ros::NodeHandle node;
  std::string log;
  const ros::Subscriber log_messages = node.subscribe<rosgraph_msgs::Log>(
      "/rosout", 100, [this](const rosgraph_msgs::Log::ConstPtr& message) { log += message->msg + '\n'; });
  ros::Time start;
};

// Sets x of every second point to `value`, while `is_dense` claims that all points are finite.
void spoil_half(sensor_msgs::PointCloud2& cloud, float value) {
  for (std::size_t i = 0; i < cloud.width; i += 2) {
    std::memcpy(cloud.data.data() + i * cloud.point_step, &value, sizeof(value));
  }
  cloud.is_dense = true;
}

TEST_F(HostileInputTest, P01_HalfOfThePointsUnusableIsEnoughForAForecast) {
  for (const float value : {kNan, kInfinity, -kInfinity, 1e30F}) {
    client.reset();
    ASSERT_TRUE(client.wait_until([&] {
      const ros::Time stamp = ros::Time::now();
      sensor_msgs::PointCloud2 cloud = stamped_cloud(points_at(stamp), stamp);
      spoil_half(cloud, value);
      client.object("half").publish(cloud);
      client.wait_until([] { return false; }, 0.03);
      return client.last_forecast.objects.size() == 1;
    })) << value;
    for (const geometry_msgs::Pose& pose : client.last_forecast.objects[0].poses) {
      EXPECT_TRUE(std::isfinite(pose.position.x + pose.position.y + pose.position.z + pose.orientation.w)) << value;
    }
  }
}

TEST_F(HostileInputTest, P01_CloudsWithoutAUsablePointAreCounted) {
  EXPECT_TRUE(counted("nan", "too few points", [](sensor_msgs::PointCloud2& cloud) {
    cloud = stamped_cloud(Points::Constant(30, 3, kNan), cloud.header.stamp);
  }));
  expect_forecast_of_good();
}

TEST_F(HostileInputTest, P03_MalformedCloudsAreCounted) {
  const std::pair<const char*, std::function<void(sensor_msgs::PointCloud2&)>> cases[] = {
      {"row_step", [](auto& c) { c.row_step = 1; }},
      {"point_step", [](auto& c) { c.point_step = 0; }},
      {"width x height", [](auto& c) { c.width = c.height = 0xffffffff; }},
      {"offset", [](auto& c) { c.fields[2].offset = 0xffffffff; }},
      {"is_bigendian", [](auto& c) { c.is_bigendian = true; }},
      {"no field 'x'", [](auto& c) { c.fields.erase(c.fields.begin()); }},
      {"bytes", [](auto& c) { c.data.clear(); }}};
  for (const auto& [part, spoil] : cases) {
    EXPECT_TRUE(counted("bad", "malformed cloud", spoil)) << part;
    EXPECT_NE(log.find(part), std::string::npos) << log;
  }
  expect_forecast_of_good();
}

TEST_F(HostileInputTest, P33_AStampKeepsItsNanoseconds) {
  ros::Time stamp;
  ASSERT_TRUE(client.wait_until([&] {
    stamp = ros::Time::now();
    stamp.nsec = stamp.nsec / 1000 * 1000 + 999;
    client.object("good").publish(stamped_cloud(points_at(stamp), stamp));
    return client.wait_until([&] { return client.last_forecast.header.stamp == stamp; }, 0.5);
  }));
  EXPECT_EQ(client.last_forecast.header.stamp.nsec % 1000, 999U);
}

TEST_F(HostileInputTest, NothingListensBeyondThePortsOfRoscpp) {
  const int process = node_pid(ros::names::resolve("prediction_node"));
  EXPECT_EQ(count_sockets(process, "tcp", "0A"), 2) << "one for the master's calls, one for topics and services";
  EXPECT_EQ(count_sockets(process, "udp", "07"), 1) << "roscpp's port for topics over UDP";
}

// Runs the node with the parameter `name` set to `value`. Returns its exit code and what it printed.
std::pair<int, std::string> start_node_with(const std::string& name, const XmlRpc::XmlRpcValue& value) {
  const std::string folder = std::filesystem::read_symlink("/proc/self/exe").parent_path().string();
  ros::param::set("/wrong_node/" + name, value);
  FILE* output = ::popen((folder + "/ballistic_prediction_node __name:=wrong_node 2>&1").c_str(), "r");
  std::string text;
  std::array<char, 256> part{};
  while (std::fgets(part.data(), static_cast<int>(part.size()), output) != nullptr) {
    text += part.data();
  }
  const int status = ::pclose(output);
  ros::param::del("/wrong_node");
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

XmlRpc::XmlRpcValue two_objects_on_one_topic() {
  XmlRpc::XmlRpcValue objects;
  for (int i = 0; i < 2; ++i) {
    objects[i]["id"] = std::string(1, static_cast<char>('a' + i));
    objects[i]["topic"] = std::string("/same");
  }
  return objects;
}

TEST(HostileParameters, P31_ImpossibleConfigurationEndsTheNodeWithTheParametersName) {
  const std::pair<const char*, XmlRpc::XmlRpcValue> cases[] = {{"predict/num_steps", std::string("ten")},
                                                               {"input/queue_size", -1},
                                                               {"predict/time_step", 0.0},
                                                               {"input/objects", two_objects_on_one_topic()},
                                                               {"input/object", std::string("cup")}};
  for (const auto& [name, value] : cases) {
    const auto [exit_code, text] = start_node_with(name, value);
    EXPECT_EQ(exit_code, 1) << name << ": " << text;
    EXPECT_NE(text.find(std::string("parameter ") + name), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "hostile_input_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
