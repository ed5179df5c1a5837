#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Shows which parts of the recipe help, at equal compute. Trains config/train/recipe.yaml and variants of it that differ
# in one thing, each for as many unrolled steps, and the recipe with more and less compute and data. Scores all on
# validation scenes and prints a Markdown table. A variant takes five minutes of one core; what is finished is not done
# again.
#   scripts/recipe.sh --data DIR... --validation DIR... [--out DIR] [--iterations N] [--workspace DIR]
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
workspace=$root/build/catkin_ws
out=$root/runs/recipe
iterations=1200
usage="usage: $0 --data DIR... --validation DIR... [--out DIR] [--iterations N] [--workspace DIR]"
data=()
validation=()
while [ $# -gt 0 ]; do
  option=$1
  shift
  case $option in
    --data) while [ $# -gt 0 ] && [[ $1 != --* ]]; do data+=("$1"); shift; done ;;
    --validation) while [ $# -gt 0 ] && [[ $1 != --* ]]; do validation+=(--data "$1"); shift; done ;;
    --out) out=$1; shift ;;
    --iterations) iterations=$1; shift ;;
    --workspace) workspace=$(realpath -m "$1"); shift ;;
    *) echo "$usage" >&2; exit 2 ;;
  esac
done
if [ ${#data[@]} -eq 0 ] || [ ${#validation[@]} -eq 0 ]; then echo "$usage" >&2; exit 2; fi
tools=$workspace/devel/lib/rigidformer_ros
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
results=()

# variant NAME [KEY=VALUE ...]
variant() {
  local name=$1 folder=$out/$1 overrides=()
  shift
  for assignment in "iterations=$iterations" "$@"; do overrides+=(--set "$assignment"); done
  if [ ! -e "$folder/scores.json" ]; then
    echo "recipe: $name" >&2
    "$tools/train" --config "$root/config/train/recipe.yaml" "${overrides[@]}" --data "${data[@]}" --out "$folder"
    "$tools/evaluate" --model "$folder/model.safetensors" "${validation[@]}" --starts 0,120,240 --steps 10 \
      --horizons 100 --scenes 30 --points vertices --baselines none --json "$folder/scores.json" >&2
  fi
  results+=("$name=$folder/scores.json")
}

variant recipe
variant another_seed seed=2
variant no_inertial_base_motion model.inertial_base_motion=false
variant no_contact_gate model.contact_gate=false
variant no_position_feature model.position_feature=false
variant no_contact_features model.contact_features=false
variant no_own_token model.own_token_in_query=false
variant windows_at_any_time windows.mid_air_probability=0 windows.floor_probability=0 \
  windows.rolling_probability=0 windows.resting_probability=0
variant no_noise augmentation.noise_m=0
variant two_steps "unroll=[{from: 0, steps: 2}]" "iterations=$((iterations / 2))"
variant residual_in_paper_units loss.residual_unit=dt2
variant half_the_compute "iterations=$((iterations / 2))"
variant twice_the_compute "iterations=$((iterations * 2))"
# The first file of each folder holds its first 100 scenes.
data=("${data[@]/%//scenes_000000.safetensors}")
variant the_first_100_scenes_of_each_set
"$root/scripts/comparison_table.py" "${results[@]}"
