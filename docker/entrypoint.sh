#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs a command in the sourced workspace (RIGIDFORMER_WORKSPACE, default /opt/catkin_ws):
#   docker/entrypoint.sh roslaunch rigidformer_ros prediction.launch
set -eo pipefail

# Debian's Python first: catkin's modules belong to it.
export PATH=/usr/bin:/bin:$PATH
# The user of `docker run --user` has no home here; ROS wants to write its log somewhere.
if [ ! -w "${HOME:-/}" ]; then
  HOME=/tmp/home_$(id -u)
  export HOME
  mkdir -p "$HOME"
fi
# Lines of the node's log as they come, not when a buffer is full.
export ROSCONSOLE_STDOUT_LINE_BUFFERED=1

# shellcheck disable=SC1091
source "${RIGIDFORMER_WORKSPACE:-/opt/catkin_ws}/devel/setup.bash"
exec "$@"
