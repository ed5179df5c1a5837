#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Feeds damaged input to everything that reads bytes from outside, with libFuzzer, AddressSanitizer and
# UndefinedBehaviorSanitizer. Needs clang-14 and libclang-rt-14-dev.
#   scripts/fuzz.sh [--seconds N] [--target NAME] [--keep]
# Each target (fuzz/NAME_fuzzer.cpp) starts from fuzz/corpus/NAME and runs for N seconds (default 60). A finding ends
# the script and stays in build/fuzz/findings. --keep adds what was new to the kept corpus, in as few files as reach
# the same code.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
build=$root/build/fuzz
seconds=60
target='*'
keep=
while [ $# -gt 0 ]; do
  case $1 in
    --seconds) seconds=$2; shift ;;
    --target) target=$2; shift ;;
    --keep) keep=yes ;;
    *) echo "usage: $0 [--seconds N] [--target NAME] [--keep]" >&2; exit 2 ;;
  esac
  shift
done

export PATH=/usr/bin:/bin:$PATH
command -v clang++-14 >/dev/null || { echo "$0: apt-get install clang-14 libclang-rt-14-dev" >&2; exit 2; }
mkdir -p "$build/findings"
CXX=clang++-14 cmake -S "$root/fuzz" -B "$build" -GNinja >"$build/configure.log"
ninja -C "$build" -j"${RIGIDFORMER_JOBS:-1}"
trap 'rm -rf /dev/shm/rigidformer_fuzz_*' EXIT

for source in "$root"/fuzz/${target}_fuzzer.cpp; do
  name=$(basename "$source" _fuzzer.cpp)
  kept=$root/fuzz/corpus/$name
  found=$build/corpus/$name
  log=$build/$name.log
  options=(-max_len=4096 -timeout=10 -rss_limit_mb=2048 -artifact_prefix="$build/findings/$name-")
  [ -f "$root/fuzz/$name.dict" ] && options+=(-dict="$root/fuzz/$name.dict")
  mkdir -p "$kept" "$found"
  "$build/${name}_fuzzer" "${options[@]}" -max_total_time="$seconds" -print_final_stats=1 "$found" "$kept" \
    >"$log" 2>&1 || { tail -n 40 "$log"; exit 1; }
  if [ -n "$keep" ]; then
    mkdir "$build/merged"
    "$build/${name}_fuzzer" "${options[@]}" -merge=1 "$build/merged" "$kept" "$found" >>"$log" 2>&1
    rm -r "$kept"
    mv "$build/merged" "$kept"
  fi
  executions=$(awk '/stat::number_of_executed_units/ {print $2}' "$log")
  echo "$(date -u +%FT%TZ) $name: $executions executions in $seconds s, no finding" | tee -a "$build/executions.log"
done
