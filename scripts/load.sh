#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Ten objects of 4016 points at 30 Hz and eight planners that call predict_rollout without a pause, with the shipped model.
#   scripts/load.sh [--seconds N] [--steps N] [--workspace DIR]
# The last line is the result: frames, forecasts, and waiting times of the planners.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
workspace=$root/build/catkin_ws
seconds=30.0
steps=24
while [ $# -gt 0 ]; do
  case $1 in
    --seconds) seconds=$2; shift ;;
    --steps) steps=$2; shift ;;
    --workspace) workspace=$(realpath -m "$2"); shift ;;
    *) echo "usage: $0 [--seconds N] [--steps N] [--workspace DIR]" >&2; exit 2 ;;
  esac
  shift
done

export PATH=/usr/bin:/bin:$PATH ROS_HOSTNAME=localhost ROS_HOME=$workspace/ros_home
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 OMP_WAIT_POLICY=passive
set +u
# shellcheck disable=SC1091
source "$workspace/devel/setup.bash"
set -u
rostest --text rigidformer_ros load.test node:=prediction_node objects:=10 num_steps:="$steps" seconds:="$seconds" \
  time_limit:=3600 >"$workspace/load.log" 2>&1 || true
grep -A4 'Failure' "$workspace/load.log" || true
grep 'objects x 4016 points' "$workspace/load.log"
grep -q 'PASSED.* 1 test' "$workspace/load.log"
