# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# shellcheck shell=bash
# To be sourced by scripts that run one rostest for a long time. They fill `values` (options with a value and its
# default) and `flags` (options without one; set to 1 when given).
declare -A values=() flags=()
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
workspace=$root/build/catkin_ws

# read_options ARGUMENT...: into `values`, `flags` and `workspace`.
read_options() {
  while [ $# -gt 0 ]; do
    if [ "$1" = --workspace ]; then workspace=$(realpath -m "$2"); shift
    elif [ -n "${values[$1]+known}" ]; then values[$1]=$2; shift
    elif [ -n "${flags[$1]+known}" ]; then flags[$1]=1
    else
      echo "usage: $0$(printf ' [%s N]' "${!values[@]}")$([ ${#flags[@]} -eq 0 ] || printf ' [%s]' "${!flags[@]}")" \
        "[--workspace DIR]" >&2
      exit 2
    fi
    shift
  done
}

# run_test NAME RESULT ARGUMENT...: NAME.test with these arguments; prints failures and the line that has RESULT in it.
run_test() {
  local log=$workspace/$1.log test=$1 result=$2
  shift 2
  export PATH=/usr/bin:/bin:$PATH ROS_HOSTNAME=localhost ROS_HOME=$workspace/ros_home
  export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 OMP_WAIT_POLICY=passive
  set +u
  # shellcheck disable=SC1091
  source "$workspace/devel/setup.bash"
  set -u
  rostest --text rigidformer_ros "$test.test" "$@" >"$log" 2>&1 || true
  grep -A4 'Failure' "$log" || true
  grep "$result" "$log"
  grep -q 'PASSED.* 1 test' "$log"
}
