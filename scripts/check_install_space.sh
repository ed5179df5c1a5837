#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Checks an install space on its own: every file that users need is there, launch files resolve, programs start.
#   scripts/check_install_space.sh WORKSPACE/install
set -eo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
unset CMAKE_PREFIX_PATH ROS_PACKAGE_PATH LD_LIBRARY_PATH
# shellcheck disable=SC1091
source "$1/setup.bash"
share=$(rospack find rigidformer_ros)
[ "$share" = "$1/share/rigidformer_ros" ] || { echo "found the package in $share instead"; exit 1; }

cd "$root"
find launch config models -type f | while read -r file; do
  [ -f "$share/$file" ] || { echo "$file is not installed"; exit 1; }
done
(cd include && find . -name '*.hpp') | while read -r header; do
  [ -f "$1/include/$header" ] || { echo "header $header is not installed"; exit 1; }
done
for file in "$share"/config/*.yaml "$share"/config/*/*.yaml; do
  /usr/bin/python3 -c 'import sys, yaml; yaml.safe_load(open(sys.argv[1]))' "$file"
done
for launch in "$share"/launch/*.launch; do
  roslaunch --nodes "$launch"
  roslaunch --dump-params "$launch" >/dev/null
done
for program in generate_scenes train evaluate model_info; do
  "$1/lib/rigidformer_ros/$program" --help >/dev/null
done
plugins=$(rospack plugins --attrib=plugin nodelet | awk '$1 == "rigidformer_ros" {print $2}')
[ "$plugins" = "$share/config/nodelet_plugins.xml" ] ||
  { echo "the nodelet is not exported"; exit 1; }
if ldd "$1/lib/librigidformer_ros_nodelet.so" | grep 'not found'; then exit 1; fi
for program in prediction_node demo_publisher forecast_report depth_camera record_depth_camera segment_cloud \
  tracking_accuracy; do
  if ldd "$1/lib/rigidformer_ros/$program" | grep 'not found'; then exit 1; fi
done

"$root/scripts/check_public_api.sh" catkin "$1"
"$root/scripts/check_public_api.sh" plain "$1"
