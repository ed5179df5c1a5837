#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Random clouds through the node for a long time: objects that appear, change and vanish, nonsense, a clock that restarts.
#   scripts/soak.sh [--clouds N] [--model] [--workspace DIR]
# Default: 100000 clouds and a predictor of known physics. --model: the shipped model, one step per forecast.
# The last line is the result: waiting times from cloud to forecast, and memory.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
workspace=$root/build/catkin_ws
clouds=100000
arguments=()
while [ $# -gt 0 ]; do
  case $1 in
    --clouds) clouds=$2; shift ;;
    --model) arguments+=(node:=prediction_node num_steps:=1) ;;
    --workspace) workspace=$(realpath -m "$2"); shift ;;
    *) echo "usage: $0 [--clouds N] [--model] [--workspace DIR]" >&2; exit 2 ;;
  esac
  shift
done

export PATH=/usr/bin:/bin:$PATH ROS_HOSTNAME=localhost ROS_HOME=$workspace/ros_home
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 OMP_WAIT_POLICY=passive
set +u
# shellcheck disable=SC1091
source "$workspace/devel/setup.bash"
set -u
rostest --text rigidformer_ros soak.test clouds:="$clouds" time_limit:=36000 "${arguments[@]}" \
  >"$workspace/soak.log" 2>&1 || true
grep -A4 'Failure' "$workspace/soak.log" || true
grep 'cloud to forecast' "$workspace/soak.log"
grep -q 'PASSED.* 1 test' "$workspace/soak.log"
