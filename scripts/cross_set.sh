#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# What carries over from one set of scenes to the others (paper Tab. 3): trains config/train/cross_set.yaml on each set
# alone, scores it on the test scenes of all three and prints a Markdown table. Six minutes of one core per training,
# about as many for its scores; what is finished is not done again.
#   scripts/cross_set.sh [--shapes DIR] [--scenes N] [--out DIR] [--workspace DIR]
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
workspace=$root/build/catkin_ws
out=$root/runs/cross_set
scenes=120
shapes=()
while [ $# -gt 0 ]; do
  case $1 in
    --shapes) shapes=(--shapes "$2") ;;
    --scenes) scenes=$2 ;;
    --out) out=$2 ;;
    --workspace) workspace=$(realpath -m "$2") ;;
    *) echo "usage: $0 [--shapes DIR] [--scenes N] [--out DIR] [--workspace DIR]" >&2; exit 2 ;;
  esac
  shift 2
done
tools=$workspace/devel/lib/rigidformer_ros
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1

# simulate SET SEED SCENES FOLDER
simulate() {
  [ -e "$4" ] || "$tools/generate_scenes" --set "$1" --seed "$2" --scenes "$3" --out "$4" "${shapes[@]}"
}

test_data=()
for set_and_seed in movi_sphere:770001 movi_a:770002 movi_b:770003; do
  set=${set_and_seed%:*}
  simulate "$set" "${set_and_seed#*:}" "$scenes" "$out/test/$set"
  test_data+=(--data "$out/test/$set")
done
results=()
for set_and_seed in movi_sphere:13 movi_a:12 movi_b:11; do
  set=${set_and_seed%:*}
  folder=$out/trained_on_$set
  simulate "$set" "${set_and_seed#*:}" 300 "$out/train/$set"
  if [ ! -e "$folder/scores.json" ]; then
    echo "cross-set: trained on $set" >&2
    "$tools/train" --config "$root/config/train/cross_set.yaml" --data "$out/train/$set" --out "$folder"
    "$tools/evaluate" --model "$folder/model.safetensors" "${test_data[@]}" --points vertices --starts 0 \
      --steps 1,5,10 --horizons 75,100 --baselines none --json "$folder/scores.json" >&2
  fi
  results+=("trained_on_$set=$folder/scores.json")
done
"$root/scripts/comparison_table.py" "${results[@]}"
