// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
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

/// Process of a running node on this machine.
inline int process_id(const std::string& node_name) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue uri;
  request[0] = ros::this_node::getName();
  request[1] = node_name;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::master::execute("lookupNode", request, response, uri, false) ||
      !ros::network::splitURI(static_cast<std::string&>(uri), host, port)) {
    throw std::runtime_error("no node " + node_name);
  }
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue caller;
  caller[0] = ros::this_node::getName();
  if (!client.execute("getPid", caller, response) || response.size() != 3) {
    throw std::runtime_error("node " + node_name + " does not answer");
  }
  return static_cast<int>(response[2]);
}

/// Resident memory of a process [bytes].
inline double resident_bytes(int process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/statm");
  double total_pages = 0.0;
  double resident_pages = 0.0;
  if (!(in >> total_pages >> resident_pages)) {
    throw std::runtime_error("process " + std::to_string(process) + " is gone");
  }
  return resident_pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// Internet sockets of a process in the state `state` of /proc/net: "0A" = TCP that listens, "07" = UDP that is bound.
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
