#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the package in a catkin workspace: build/catkin_ws of this repository, or --workspace DIR.
#   scripts/build.sh [--workspace DIR] [--tests] [--install] [--benchmarks]
# Afterwards: source <workspace>/devel/setup.bash
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
workspace=$root/build/catkin_ws
targets=(all)
options=()
while [ $# -gt 0 ]; do
  case $1 in
    --workspace) workspace=$(realpath -m "$2"); shift ;;
    --tests) targets+=(tests) ;;
    --install) targets+=(install) ;;
    --benchmarks) options+=(-DRIGIDFORMER_BENCHMARKS=ON) ;;
    *) echo "usage: $0 [--workspace DIR] [--tests] [--install] [--benchmarks]" >&2; exit 2 ;;
  esac
  shift
done

# A file that includes LibTorch takes about 1.5 GB to compile.
memory_kb=$(awk '/MemAvailable/ {print $2}' /proc/meminfo)
jobs=$((memory_kb / 1500000))
jobs=$((jobs < 1 ? 1 : jobs))
cores=$(env -u OMP_NUM_THREADS nproc)  # nproc would answer with the threads of the tests
jobs=$((jobs < cores ? jobs : cores))

# Another Python in front of Debian's cannot import catkin's modules.
export PATH=/usr/bin:/bin:$PATH

# The package folder holds a link per entry, without the build folders: a link to the whole repository would lead back
# into this workspace, and ROS's tools would find every launch file again and again.
package=$workspace/src/rigidformer_ros
rm -rf "$package"
mkdir -p "$package"
for entry in "$root"/*; do
  case $(basename "$entry") in
    build* | devel | install | logs | data | runs | bundle) ;;
    *) ln -s "$entry" "$package/" ;;
  esac
done
cd "$workspace"
echo "build: $workspace, ${targets[*]}, $jobs jobs"
catkin_make --use-ninja -j"$jobs" -DCMAKE_BUILD_TYPE=Release -DRIGIDFORMER_WERROR=ON \
  -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 "${options[@]}" "${targets[@]}"
