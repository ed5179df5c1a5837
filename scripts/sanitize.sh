#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the tests with compiler instrumentation and runs them; any report of a sanitizer is a failure.
#   scripts/sanitize.sh address|thread [NAME ...]
# address: AddressSanitizer, LeakSanitizer and UndefinedBehaviorSanitizer. thread: ThreadSanitizer.
# NAMES are test programs or .test files without ending; without them all. A test program may carry
# a filter: learning_tests:Predictor*. What third-party code does is suppressed, with reasons, in test/sanitizers.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
kind=${1:-}
case $kind in
  address) flags='-fsanitize=address,undefined -fno-sanitize-recover=all' ;;
  thread) flags='-fsanitize=thread' ;;
  *) echo "usage: $0 address|thread [NAME ...]" >&2; exit 2 ;;
esac
shift
names=("$@")
if [ ${#names[@]} -eq 0 ]; then
  names=(core_tests simulation_tests baseline_tests tracking_tests camera_tests segmentation_tests demo_tests
    accuracy_tests service_tests ros_unit_tests "learning_tests:-MoviBallistic*")  # which plays whole test sets
  for test_file in "$root"/test/rigidformer_ros/*/*.test; do
    name=$(basename "$test_file" .test)
    # A nodelet lives in a program of ROS, and planning_module in one of Python, which are not instrumented.
    [ "$name" = nodelet ] || [ "$name" = planning_module ] || names+=("$name")
  done
fi

build=$root/build/sanitize_$kind
reports=$build/reports
suppressions=$root/test/sanitizers
# A fault in any process of a rostest must be seen: every process writes its reports into one folder.
rm -rf "$reports"
mkdir -p "$reports"
export ASAN_OPTIONS=log_path=$reports/report
export LSAN_OPTIONS=suppressions=$suppressions/leak.supp:print_suppressions=0
export UBSAN_OPTIONS=log_path=$reports/report:print_stacktrace=1
# What libraries without instrumentation do to memory is not judged: how they order it cannot be seen.
export TSAN_OPTIONS=log_path=$reports/report:suppressions=$suppressions/thread.supp:second_deadlock_stack=1
TSAN_OPTIONS+=:ignore_noninstrumented_modules=1
export PATH=/usr/bin:/bin:$PATH ROS_HOSTNAME=localhost ROS_HOME=$build/ros_home
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 OMP_WAIT_POLICY=passive

CXXFLAGS="$flags -fno-omit-frame-pointer -g1" cmake -S "$root" -B "$build" -GNinja -DCATKIN_ENABLE_TESTING=ON \
  -DCMAKE_BUILD_TYPE=Sanitize -DCMAKE_CXX_FLAGS_SANITIZE=-O1 -DPYTHON_EXECUTABLE=/usr/bin/python3 \
  -DPython3_EXECUTABLE=/usr/bin/python3 >"$build/configure.log"

# programs NAME: the programs that NAME.test starts, itself or through launch files.
programs() {
  local files=("$root"/test/rigidformer_ros/*/"$1.test")
  if grep -q '<include' "${files[@]}"; then files+=("$root"/launch/*.launch); fi
  grep -ohE '(type|default)="[a-z_]+"' "${files[@]}" | cut -d'"' -f2
}

for name in "${names[@]}"; do
  case ${name%%:*} in
    *_tests) echo "${name%%:*}" ;;
    *) programs "$name" ;;
  esac
done | sort -u >"$build/wanted"
mapfile -t targets < <(ninja -C "$build" -t targets all | sed -nE 's/^([a-z_]+): phony$/\1/p' | sort -u |
  grep -E '_(tests|test|node)$|camera$|publisher$' | comm -12 - "$build/wanted")
ninja -C "$build" -j"${RIGIDFORMER_JOBS:-1}" "${targets[@]}"
set +u
# shellcheck disable=SC1091
source "$build/devel/setup.bash"
set -u

# run NAME: addresses are not randomised, which ThreadSanitizer needs.
run() {
  local program=${1%%:*} filter=${1#*:}
  if [ "$filter" = "$1" ]; then filter='*'; fi
  case $program in
    *_tests) setarch -R "$build/devel/lib/rigidformer_ros/$program" --gtest_filter="$filter" --gtest_brief=1 ;;
    # A sanitizer keeps freed memory for a while: the growth of a short run says nothing here.
    soak) setarch -R rostest "$root/test/rigidformer_ros/node/soak.test" max_growth:=1000 ;;
    # An instrumented node loses sight of objects whose clouds come faster than it takes them.
    load) setarch -R rostest "$root/test/rigidformer_ros/node/load.test" objects:=2 ;;
    depth_camera_registration) setarch -R rostest "$root/test/rigidformer_ros/node/$program.test" time_scale:=0.03 ;;
    *) setarch -R rostest "$(ls "$root"/test/rigidformer_ros/*/"$program.test")" ;;
  esac
}

failed=0
for name in "${names[@]}"; do
  start=$SECONDS
  log=$build/$(tr -c 'a-zA-Z_\n' _ <<<"$name").log
  outcome=clean
  run "$name" >"$log" 2>&1 || outcome=FAILED
  if [ -n "$(ls -A "$reports")" ]; then
    outcome=REPORTED
    mkdir -p "$build/kept"
    mv "$reports"/* "$build/kept/"
  fi
  [ "$outcome" = clean ] || failed=$((failed + 1))
  echo "$kind: $outcome $name ($((SECONDS - start)) s), $log"
done
[ "$failed" -eq 0 ] || echo "$kind: reports are in $build/kept" >&2
exit "$failed"
