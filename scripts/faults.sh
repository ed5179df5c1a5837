#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# What happens to the running node when things around it break. Prints one line per fault; needs root for the full disk.
#   scripts/faults.sh [--workspace DIR] [FAULT ...]
# FAULTS: node_killed publisher_killed master_killed interrupt_idle interrupt_loading interrupt_rollout disk_full ports
set -uo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
workspace=$root/build/catkin_ws
if [ "${1:-}" = --workspace ]; then workspace=$(realpath -m "$2"); shift 2; fi
faults=("$@")
[ ${#faults[@]} -gt 0 ] || faults=(node_killed publisher_killed master_killed interrupt_idle interrupt_loading
  interrupt_rollout disk_full ports)

port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
export PATH=/usr/bin:/bin:$PATH ROS_HOSTNAME=localhost ROS_HOME=$workspace/ros_home ROS_MASTER_URI=http://localhost:$port
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 OMP_WAIT_POLICY=passive
set +u
# shellcheck disable=SC1091
source "$workspace/devel/setup.bash"
set -u
programs=$workspace/devel/lib/rigidformer_ros
logs=$workspace/faults
mkdir -p "$logs"
master=
node=
publisher=

# Processes that this script started, by their ids.
start_master() { rosmaster --core -p "$port" >"$logs/master.log" 2>&1 & master=$!; wait_for 20 rosparam list; }
start_node() { "$programs/prediction_node" "$@" >"$logs/node.log" 2>&1 & node=$!; }
start_publisher() { "$programs/demo_publisher" >"$logs/publisher.log" 2>&1 & publisher=$!; }
stop_all() {
  for process in $publisher $node $master; do kill -9 "$process" 2>/dev/null; done
  wait 2>/dev/null
  master='' node='' publisher=''
}
trap stop_all EXIT

# wait_for SECONDS COMMAND...: until the command succeeds.
wait_for() {
  local end=$((SECONDS + $1))
  shift
  until "$@" >/dev/null 2>&1; do
    [ "$SECONDS" -lt "$end" ] || return 1
    sleep 0.2
  done
}
has_forecast() { timeout 15 rostopic echo -n 1 /forecast/header/stamp; }
is_ready() { rosservice call /get_model_info '{}' | grep -q 'ready: True'; }
is_gone() { ! kill -0 "$1"; }

start_all() {
  start_master && start_node && start_publisher && wait_for 60 is_ready && wait_for 60 has_forecast
}

# Seconds of wall time, with a decimal, until process $1 has ended after SIGINT.
interrupt() {
  local start
  start=$(date +%s%N)
  kill -INT "$1"
  wait_for 20 is_gone "$1"
  awk -v from="$start" -v to="$(date +%s%N)" 'BEGIN {printf "%.1f", (to - from) / 1e9}'
}
ends_in_time() { awk -v s="$1" 'BEGIN {exit !(s < 2.0)}' && echo "ended after $1 s" && return; echo "took $1 s"; return 1; }

node_killed() {
  start_all || { echo "no forecast to begin with"; return 1; }
  kill -9 "$node"
  start_node
  wait_for 60 is_ready && wait_for 30 has_forecast && echo "forecasts again after a restart of the node"
}

publisher_killed() {
  start_all || { echo "no forecast to begin with"; return 1; }
  kill -9 "$publisher"
  sleep 2
  kill -0 "$node" || { echo "the node died"; return 1; }
  start_publisher
  wait_for 30 has_forecast && echo "forecasts again after a restart of the publisher"
}

master_killed() {
  start_all || { echo "no forecast to begin with"; return 1; }
  kill -9 "$master"
  sleep 3
  kill -0 "$node" || { echo "the node died with the master"; return 1; }
  start_master
  wait_for 20 is_gone "$node" || { echo "the node goes on, unknown to the new master"; return 1; }
  wait "$node"
  local code=$?
  grep -q 'master was restarted' "$logs/node.log" && [ "$code" -eq 1 ] &&
    echo "runs on without a master; ends with code 1 and an explanation when a new one does not know it"
}

interrupt_idle() {
  start_master && start_node && wait_for 60 is_ready && ends_in_time "$(interrupt "$node")"
}

# A header that promises much and a pipe that never delivers would not be a regular file: a large file loads slowly enough.
interrupt_loading() {
  start_master
  start_node _model/warmup_runs:=100
  wait_for 20 rosservice info /get_model_info
  ends_in_time "$(interrupt "$node")"
}

interrupt_rollout() {
  start_all || { echo "no forecast to begin with"; return 1; }
  timeout 60 rosservice call /predict_rollout '{num_steps: 500, max_state_age: 30.0}' >"$logs/rollout.log" 2>&1 &
  sleep 2
  ends_in_time "$(interrupt "$node")"
}

# A disk of 64 KiB: the writer says so and leaves nothing that could be taken for a scene.
disk_full() {
  local disk=$logs/disk code
  mkdir -p "$disk"
  mount -t tmpfs -o size=64k tmpfs "$disk" || return 1
  "$programs/generate_scenes" --set movi_b --scenes 2 --seed 1 --out "$disk/scenes" >"$logs/generate.log" 2>&1
  code=$?
  local left
  left=$(find "$disk" -name '*.safetensors*')
  umount "$disk"
  [ "$code" -ne 0 ] && [ -z "$left" ] && grep -qi 'cannot write\|No space left' "$logs/generate.log" &&
    echo "generate_scenes ends with code $code and '$(grep -i 'cannot write\|No space left' "$logs/generate.log" | tail -n 1)'"
}

# The two sockets of roscpp: for the master's calls, and for topics and services.
ports() {
  start_all || { echo "no forecast to begin with"; return 1; }
  local count
  count=$(ss -ltnpH | grep -c "pid=$node,")
  echo "the node listens on $count ports, $(ss -lunpH | grep -c "pid=$node,") of UDP"
  [ "$count" -eq 2 ] && [ -z "$(ss -lunpH | grep "pid=$node,")" ]
}

failed=0
for fault in "${faults[@]}"; do
  outcome=ok
  text=$($fault 2>"$logs/$fault.err") || outcome=FAILED
  stop_all
  [ "$outcome" = ok ] || failed=$((failed + 1))
  printf '%-6s  %-18s  %s\n' "$outcome" "$fault" "$text"
done
exit "$failed"
