// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/network.h>
#include <ros/ros.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigidformer_ros::testing {

/// The process id of a running node, as the node itself states it. It is -1 when the node does not answer.
inline int node_pid(const std::string& name) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue payload;
  request[0] = ros::this_node::getName();
  request[1] = name;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::master::execute("lookupNode", request, response, payload, false) ||
      !ros::network::splitURI(static_cast<std::string&>(payload), host, port)) {
    return -1;
  }
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue caller;
  caller[0] = ros::this_node::getName();
  if (!client.execute("getPid", caller, response) || response.getType() != XmlRpc::XmlRpcValue::TypeArray) {
    return -1;
  }
  return static_cast<int&>(response[2]);
}

inline int num_threads_of(int pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  std::string word;
  int threads = -1;
  while (status >> word) {
    if (word == "Threads:") {
      status >> threads;
    }
  }
  return threads;
}

/// What a node is for a topic. The numbers are indices into the lists that the master's getSystemState returns.
enum class Role { kPublisher = 0, kSubscriber = 1 };

/// The topics for which a node has this role.
inline std::set<std::string> topics_of(const std::string& node, Role role) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue state;
  request[0] = ros::this_node::getName();
  std::set<std::string> topics;
  if (!ros::master::execute("getSystemState", request, response, state, false)) {
    return topics;
  }
  XmlRpc::XmlRpcValue& entries = state[static_cast<int>(role)];
  for (int i = 0; i < entries.size(); ++i) {
    for (int j = 0; j < entries[i][1].size(); ++j) {
      if (static_cast<std::string&>(entries[i][1][j]) == node) {
        topics.insert(static_cast<std::string&>(entries[i][0]));
      }
    }
  }
  return topics;
}

inline std::set<std::string> topics_published_by(const std::string& node) { return topics_of(node, Role::kPublisher); }

/// The resident memory of a process [bytes].
inline double resident_bytes(int process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/statm");
  double total_pages = 0.0;
  double resident_pages = 0.0;
  if (!(in >> total_pages >> resident_pages)) {
    throw std::runtime_error("process " + std::to_string(process) + " is gone");
  }
  return resident_pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// The number of internet sockets of a process that have the given state in /proc/net. "0A" is a TCP socket that
/// listens, "07" a UDP socket that is bound.
inline int count_sockets(int process, const std::string& protocol, const std::string& state) {
  const std::string folder = "/proc/" + std::to_string(process);
  std::set<std::string> inodes;
  for (const char* version : {"", "6"}) {
    std::ifstream in(folder + "/net/" + protocol + version);
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      const std::vector<std::string> row{std::istream_iterator<std::string>(words), {}};
      if (row.size() > 9 && row[3] == state) {
        inodes.insert("socket:[" + row[9] + "]");
      }
    }
  }
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder + "/fd")) {
    std::error_code closed_meanwhile;
    count += static_cast<int>(inodes.count(std::filesystem::read_symlink(entry, closed_meanwhile).string()));
  }
  return count;
}

}  // namespace rigidformer_ros::testing
