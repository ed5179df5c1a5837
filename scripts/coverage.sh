#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Which lines of src/ the unit tests reach: build/coverage/index.html, and one line with the share. Needs gcovr.
#   scripts/coverage.sh [--ros] [--tests "NAME ..."]
# Builds apart from everything else, without ROS; --ros adds the node's sources and their unit tests, which need no ROS
# master. Default: all test programs. Only sources that these programs need are built, and counted.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
options=(-DRIGIDFORMER_ROS=OFF)
tests=(core_tests simulation_tests tracking_tests baseline_tests learning_tests)
chosen=
while [ $# -gt 0 ]; do
  case $1 in
    --ros)
      options=(-DCATKIN_ENABLE_TESTING=ON -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3)
      tests+=(ros_unit_tests demo_tests camera_tests accuracy_tests service_tests segmentation_tests) ;;
    --tests) chosen=$2; shift ;;
    *) echo "usage: $0 [--ros] [--tests \"NAME ...\"]" >&2; exit 2 ;;
  esac
  shift
done
[ -z "$chosen" ] || read -ra tests <<<"$chosen"

export PATH=/usr/bin:/bin:$PATH OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 OMP_WAIT_POLICY=passive
command -v gcovr >/dev/null || { echo "$0: apt-get install gcovr" >&2; exit 2; }
report=$root/build/coverage
build=$report/build
mkdir -p "$build"
# -O1: as fast as line numbers allow; without optimisation the network's tests take hours.
CXXFLAGS=--coverage cmake -S "$root" -B "$build" -GNinja -DCMAKE_BUILD_TYPE=Coverage -DCMAKE_CXX_FLAGS_COVERAGE=-O1 \
  "${options[@]}" >"$report/configure.log" 2>&1 || { tail -n 20 "$report/configure.log" >&2; exit 1; }
ninja -C "$build" -j"${RIGIDFORMER_JOBS:-1}" "${tests[@]}" >"$report/build.log" ||
  { tail -n 40 "$report/build.log" >&2; exit 1; }

# What earlier runs reached does not count.
find "$build" -name '*.gcda' -delete
for test in "${tests[@]}"; do
  program=$(find "$build" -type f -name "$test" -perm -u+x -print -quit)
  echo "coverage: running $test"
  "$program" --gtest_brief=1 >"$report/$test.log" 2>&1 || { tail -n 40 "$report/$test.log" >&2; exit 1; }
done
find "$report" -maxdepth 1 -name '*.html' -delete
gcovr --root "$root" --object-directory "$build" --filter "$root/src/" --gcov-ignore-parse-errors \
  --html-details "$report/index.html" --html-title "rigidformer_ros: ${tests[*]}" \
  --json-summary "$report/summary.json" \
  >"$report/gcovr.log" 2>&1 || { cat "$report/gcovr.log" >&2; exit 1; }
/usr/bin/python3 - "$report/summary.json" <<'PYTHON'
import json
import sys
with open(sys.argv[1], encoding='utf-8') as file:
    summary = json.load(file)
print('coverage: {line_percent} % of {line_total} lines of src/'.format(**summary))
PYTHON
echo "coverage: $report/index.html"
