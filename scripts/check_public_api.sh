#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds a project that uses the installed libraries: every public header compiles by itself, without a header of
# LibTorch, and a program that calls into each library links and runs.
#   scripts/check_public_api.sh catkin|plain INSTALL_FOLDER
# catkin: find_package(catkin COMPONENTS rigidformer_ros), all headers. plain: find_package(rigidformer), those of the
# core, as a project without ROS would. The environment of the install space must be set up for catkin.
set -euo pipefail

kind=$1
prefix=$(realpath "$2")
consumer=$(mktemp -d)
trap 'rm -rf "$consumer"' EXIT

folders=(rigidformer)
[ "$kind" = catkin ] && folders+=(rigidformer_ros)
mapfile -t headers < <(cd "$prefix/include" && find "${folders[@]}" -name '*.hpp' | sort)
[ ${#headers[@]} -gt 0 ] || { echo "no header is installed in $prefix/include"; exit 1; }
[ ${#headers[@]} -le 45 ] || { echo "${#headers[@]} headers are installed, at most 45 are a public API"; exit 1; }
for i in "${!headers[@]}"; do
  printf '#include <%s>\n#ifdef TORCH_VERSION\n#error "a header of LibTorch came along"\n#endif\n' "${headers[$i]}" \
    >"$consumer/header_$i.cpp"
done

cat >"$consumer/main.cpp" <<'CPP'
#include <rigidformer/data/scene_loader.hpp>
#include <rigidformer/evaluation/ballistic.hpp>
#include <rigidformer/predictor.hpp>
#include <rigidformer/simulation/builtin_shapes.hpp>
#include <rigidformer/tracking/track_store.hpp>
#include <iostream>
#ifdef WITH_ROS
#include <rigidformer_ros/PredictRollout.h>
#include <rigidformer_ros/messages/conversions.hpp>
#include <rigidformer_ros/node/prediction_node.hpp>
#endif
int main(int argc, char** argv) {
  const rigidformer::TrackStore tracks{rigidformer::TrackingOptions()};
  std::cout << rigidformer::builtin_shapes().size() << " shapes, " << tracks.records().size() << " tracks\n";
  rigidformer::PredictorOptions options;
  options.file = argv[0];
  if (argc > 1) std::cout << rigidformer::Predictor(options).info().id << '\n';
#ifdef WITH_ROS
  std::cout << rigidformer_ros::to_pose({}).orientation.w
            << rigidformer_ros::PredictRollout::Request().num_steps << '\n';
  if (argc > 1) return rigidformer_ros::run_prediction_node();
#endif
  return 0;
}
CPP

cat >"$consumer/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.16)
project(consumer LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 17)
file(GLOB sources *.cpp)
add_executable(consumer ${sources})
target_compile_options(consumer PRIVATE -O0 -Wall -Wextra)
CMAKE
if [ "$kind" = catkin ]; then
  cat >>"$consumer/CMakeLists.txt" <<'CMAKE'
find_package(catkin REQUIRED COMPONENTS rigidformer_ros)
target_compile_definitions(consumer PRIVATE WITH_ROS)
target_include_directories(consumer SYSTEM PRIVATE ${catkin_INCLUDE_DIRS})
target_link_libraries(consumer ${catkin_LIBRARIES})
CMAKE
else
  cat >>"$consumer/CMakeLists.txt" <<'CMAKE'
find_package(rigidformer REQUIRED)
target_link_libraries(consumer rigidformer::core rigidformer::simulation rigidformer::rigidformer)
CMAKE
fi
cmake -S "$consumer" -B "$consumer/build" -GNinja -DPYTHON_EXECUTABLE=/usr/bin/python3 -DCMAKE_PREFIX_PATH="$prefix"
cmake --build "$consumer/build"
if grep -i torch "$consumer/build/build.ninja" | grep -v "$prefix"; then
  echo "LibTorch is in the consumer's flags"
  exit 1
fi
"$consumer/build/consumer"
echo "${#headers[@]} public headers compile by themselves and link ($kind)"
