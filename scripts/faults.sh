#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Shows what happens to the running node when things around it break. Prints one line per fault. Needs root for the full
# disk.
#   scripts/faults.sh [--workspace DIR] [FAULT ...]
# FAULTS: node_killed publisher_killed master_killed interrupt_idle interrupt_loading interrupt_rollout
#         interrupt_anytime disk_full ports
# The faults are called by name.
# shellcheck disable=SC2317
set -uo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
workspace=$root/build/catkin_ws
if [ "${1:-}" = --workspace ]; then workspace=$(realpath -m "$2"); shift 2; fi
faults=("$@")
[ ${#faults[@]} -gt 0 ] || faults=(node_killed publisher_killed master_killed interrupt_idle interrupt_loading
  interrupt_rollout interrupt_anytime disk_full ports)

port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
export PATH=/usr/bin:/bin:$PATH ROS_HOSTNAME=localhost
export ROS_HOME=$workspace/ros_home ROS_MASTER_URI=http://localhost:$port
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

# A shell makes its background processes ignore SIGINT, roslaunch does not. The node starts as under roslaunch: until
# roscpp sets a handler, an ignored interrupt would be lost.
start_master() { rosmaster --core -p "$port" >"$logs/master.log" 2>&1 & master=$!; wait_for 20 rosparam list; }
start_node() { env --default-signal=INT "$programs/prediction_node" "$@" >"$logs/node.log" 2>&1 & node=$!; }
start_publisher() { "$programs/demo_publisher" >"$logs/publisher.log" 2>&1 & publisher=$!; }

# Every fault runs in a shell of its own, which ends what it started.
stop_all() {
  for process in $(jobs -p); do kill -9 "$process" 2>/dev/null; done
  wait 2>/dev/null
}

# wait_for SECONDS COMMAND...: until the command succeeds.
wait_for() {
  local end=$((SECONDS + $1))
  shift
  until "$@" >/dev/null 2>&1; do
    [ "$SECONDS" -lt "$end" ] || return 1
    sleep 0.05
  done
}

# start_rollout TIME_STEP LOG [OPTION]: a long one. Whoever was cut off got an answer that says so, or none.
start_rollout() {
  local request="{num_steps: 500, time_step: $1, max_state_age: {secs: 30, nsecs: 0}}"
  timeout 20 rosservice call ${3:+"$3"} /predict_rollout "$request" >"$2" 2>&1 &
}
num_cut_off() { grep -lE 'shuts down|transport error' "$logs"/rollout_*.log | wc -l; }
all_rollouts_were_cut_off() { [ "$(num_cut_off)" -eq "$1" ]; }

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
ends_in_time() {
  awk -v s="$1" 'BEGIN {exit !(s < 2.0)}' && echo "ended after $1 s" && return
  echo "took $1 s"
  return 1
}

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

# Who listens already goes on listening; the clouds and the clock of the publisher come without the master too.
master_killed() {
  start_all || { echo "no forecast to begin with"; return 1; }
  : >"$logs/forecasts.log"
  PYTHONUNBUFFERED=1 rostopic echo /forecast/header/stamp >>"$logs/forecasts.log" &
  wait_for 20 test -s "$logs/forecasts.log" || { echo "nobody hears the forecasts"; return 1; }
  kill -9 "$master"
  sleep 2
  : >"$logs/forecasts.log"
  sleep 3
  kill -0 "$node" || { echo "the node died with the master"; return 1; }
  [ -s "$logs/forecasts.log" ] || { echo "no forecast without the master"; return 1; }
  start_master
  wait_for 20 is_gone "$node" || { echo "the node goes on, unknown to the new master"; return 1; }
  wait "$node"
  local code=$?
  grep -q 'master was restarted' "$logs/node.log" && [ "$code" -eq 1 ] &&
    echo "forecasts on without a master; ends with code 1 and an explanation when a new one does not know it"
}

interrupt_idle() {
  start_master && start_node && wait_for 60 is_ready && ends_in_time "$(interrupt "$node")"
}

# A hundred warm-up runs take longer than this fault does.
interrupt_loading() {
  start_master && start_node _model/warmup_runs:=100 && wait_for 20 rosservice info /get_model_info || return 1
  is_ready && { echo "the model was ready too early"; return 1; }
  ends_in_time "$(interrupt "$node")"
}

# Three planners with different requests, so that none shares the rollout of another.
interrupt_rollout() {
  start_all || { echo "no forecast to begin with"; return 1; }
  local step seconds
  rm -f "$logs"/rollout_*.log
  for step in 0.01 0.02 0.03; do
    start_rollout "$step" "$logs/rollout_$step.log"
  done
  sleep 2
  seconds=$(interrupt "$node")
  wait_for 20 all_rollouts_were_cut_off 3 || { echo "$(num_cut_off) of 3 rollouts were under way"; return 1; }
  ends_in_time "$seconds" | sed 's/$/ with three rollouts under way/'
}

# Sixty starts are interrupted after 0 to 5 s each: before ROS runs, while the model is loaded, idle, in a rollout. A
# process that has no handler yet ends with 128 + SIGINT.
interrupt_anytime() {
  local count=60 slowest=0 delay seconds code
  start_master && start_publisher || return 1
  rm -f "$logs"/rollout_*.log "$logs/interrupts.log"
  for ((i = 0; i < count; ++i)); do
    start_node
    delay=$(awk -v r="$RANDOM" 'BEGIN {printf "%.2f", r / 32768 * 5}')
    start_rollout 0.0 "$logs/rollout_$i.log" --wait
    sleep "$delay"
    seconds=$(interrupt "$node")
    wait "$node"
    code=$?
    [ "$code" -eq 0 ] || [ "$code" -eq 130 ] || { echo "interrupted after $delay s: code $code"; return 1; }
    ends_in_time "$seconds" >/dev/null || { echo "interrupted after $delay s: took $seconds s"; return 1; }
    slowest=$(awk -v a="$slowest" -v b="$seconds" 'BEGIN {print (a > b ? a : b)}')
    echo "interrupted after $delay s: code $code after $seconds s" >>"$logs/interrupts.log"
  done
  sleep 1
  [ "$(num_cut_off)" -gt 0 ] || { echo "no rollout was under way"; return 1; }
  echo "$count interrupts within 5 s after the start, $(num_cut_off) of them in a rollout, no crash;" \
    "the slowest took $slowest s"
}

# On a disk of 64 KiB: the writers of scenes and of bags say so and leave nothing that could be taken for a whole file.
disk_full() {
  local disk=$logs/disk left
  mkdir -p "$disk"
  mount -t tmpfs -o size=64k tmpfs "$disk" || return 1
  "$programs/generate_scenes" --set movi_b --scenes 2 --seed 1 --out "$disk/scenes" 2>&1 |
    tr '\r' '\n' >"$logs/scenes.log"
  local scenes=${PIPESTATUS[0]}
  "$programs/record_depth_camera" "$disk/scene.bag" --duration 1 >"$logs/bag.log" 2>&1
  local bag=$?
  left=$(find "$disk" -name "*.safetensors*" -o -name "*.bag*")
  umount "$disk"
  [ "$scenes" -eq 1 ] && [ "$bag" -eq 1 ] && [ -z "$left" ] && grep -q 'No space left' "$logs/scenes.log" &&
    grep -q 'cannot write' "$logs/bag.log" &&
    echo "generate_scenes and record_depth_camera say so, end with code 1, leave no file"
}

# The sockets of roscpp: of TCP one for calls by the master and other nodes, one for topics and services; of UDP one for
# topics by UDPROS, which roscpp opens even though nothing here uses it.
ports() {
  start_all || { echo "no forecast to begin with"; return 1; }
  local tcp udp
  tcp=$(ss -ltnpH | grep -c "pid=$node,")
  udp=$(ss -lunpH | grep -c "pid=$node,")
  echo "the node listens on $tcp ports of TCP and $udp of UDP"
  [ "$tcp" -eq 2 ] && [ "$udp" -eq 1 ]
}

failed=0
for fault in "${faults[@]}"; do
  outcome=ok
  text=$(trap stop_all EXIT; $fault 2>"$logs/$fault.err") || outcome=FAILED
  [ "$outcome" = ok ] || failed=$((failed + 1))
  printf '%-6s  %-18s  %s\n' "$outcome" "$fault" "$text"
done
exit "$failed"
