#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing, builds, and runs the demo.
#   scripts/demo.sh                       with a display: rviz; without: a table of predicted and true positions
#   scripts/demo.sh --headless            the table in any case
#   scripts/demo.sh --screenshot FILE     a picture of rviz, taken without a display
#   further arguments (name:=value) go to demo.launch
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
workspace=$root/build/catkin_ws
mode=rviz
[ -n "${DISPLAY:-}" ] || mode=headless
picture=
launch_arguments=()
while [ $# -gt 0 ]; do
  case $1 in
    --headless) mode=headless ;;
    --screenshot) mode=screenshot; picture=$(realpath -m "$2"); shift ;;
    --workspace) workspace=$(realpath -m "$2"); shift ;;
    *:=*) launch_arguments+=("$1") ;;
    *) echo "usage: $0 [--headless | --screenshot FILE] [--workspace DIR] [name:=value ...]" >&2; exit 2 ;;
  esac
  shift
done

"$root/scripts/setup.sh"
log=$workspace/build.log
mkdir -p "$workspace"
echo "demo: building (log: $log)"
"$root/scripts/build.sh" --workspace "$workspace" >"$log" 2>&1 || { tail -n 40 "$log" >&2; exit 1; }

export PATH=/usr/bin:/bin:$PATH ROSCONSOLE_STDOUT_LINE_BUFFERED=1
set +u
# shellcheck disable=SC1091
source "$workspace/devel/setup.bash"
set -u

if [ "$mode" = rviz ]; then
  exec roslaunch rigidformer_ros demo.launch rviz:=true "${launch_arguments[@]}"
fi

# A master of its own, so that a running ROS system is not disturbed.
port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI=http://localhost:$port ROS_HOSTNAME=localhost ROS_HOME=$workspace/ros_home
demo_log=$workspace/demo.log
background=()

stop_background() {
  for process in "${background[@]}"; do
    kill "$process" 2>/dev/null || true
  done
  wait
}
trap stop_background EXIT

launch_demo() {
  roslaunch -p "$port" rigidformer_ros demo.launch "$@" "${launch_arguments[@]}" >"$demo_log" 2>&1 &
  background+=($!)
}

wait_for_text() {  # TEXT SECONDS: until the demo's log has the text
  for ((i = 0; i < $2 * 2; ++i)); do
    grep -q "$1" "$demo_log" 2>/dev/null && return 0
    kill -0 "${background[-1]}" 2>/dev/null || break
    sleep 0.5
  done
  echo "demo: '$1' did not appear in $demo_log:" >&2
  tail -n 40 "$demo_log" >&2
  return 1
}

# In slow motion: the table then does not depend on how fast the machine is.
run_headless() {
  launch_demo rviz:=false use_sim_time:=true time_scale:=0.3
  wait_for_text 'started core service\|started roslaunch server' 30
  rosrun rigidformer_ros forecast_report || { tail -n 40 "$demo_log" >&2; return 1; }
}

# The scene stops at a moment with much to see, so that slow software rendering misses nothing.
run_screenshot() {
  local display_file
  display_file=$(mktemp)
  Xvfb -displayfd 3 -screen 0 1280x800x24 +extension GLX 3>"$display_file" 2>/dev/null &
  background+=($!)
  for ((i = 0; i < 40; ++i)); do
    [ -s "$display_file" ] && break
    sleep 0.25
  done
  DISPLAY=:$(cat "$display_file")
  export DISPLAY LIBGL_ALWAYS_SOFTWARE=1 QT_X11_NO_MITSHM=1
  rm "$display_file"
  launch_demo rviz:=true rviz_args:=--fullscreen use_sim_time:=true time_scale:=0.1 hold_at:=0.4
  wait_for_text 'holding the scene' 120
  sleep 6
  import -window root "$picture"
  echo "demo: $picture"
}

"run_$mode"
