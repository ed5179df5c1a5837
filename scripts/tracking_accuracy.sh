#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Errors of tracked poses and of forecasts for clouds of a simulated depth camera, by way of correspondence.
#   scripts/tracking_accuracy.sh [--workspace DIR] [option of tracking_accuracy ...]
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
workspace=$root/build/catkin_ws
if [ "${1:-}" = --workspace ]; then
  workspace=$(realpath -m "$2")
  shift 2
fi
export PATH=/usr/bin:/bin:$PATH OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 OMP_WAIT_POLICY=passive
set +u
# shellcheck disable=SC1091
source "$workspace/devel/setup.bash"
set -u
exec rosrun rigidformer_ros tracking_accuracy "$@"
