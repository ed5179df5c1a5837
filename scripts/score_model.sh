#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the accuracy numbers of README and model card: simulates test scenes with seeds that no training used, scores
# the model beside the ballistic guess and Bullet on the hull of the same points, for complete clouds and for what one
# camera sees, from mesh vertices and from surface samples, and prints Markdown tables. About an hour on one core.
#   scripts/score_model.sh [--model FILE] [--shapes DIR] [--scenes N] [--out DIR] [--workspace DIR]
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
workspace=$root/build/catkin_ws
out=$root/runs/scores
scenes=120
shapes=()
model=()
while [ $# -gt 0 ]; do
  case $1 in
    --model) model=(--model "$2") ;;
    --shapes) shapes=(--shapes "$2") ;;
    --scenes) scenes=$2 ;;
    --out) out=$2 ;;
    --workspace) workspace=$(realpath -m "$2") ;;
    *) echo "usage: $0 [--model FILE] [--shapes DIR] [--scenes N] [--out DIR] [--workspace DIR]" >&2; exit 2 ;;
  esac
  shift 2
done
tools=$workspace/devel/lib/rigidformer_ros
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1

data=()
seed=770001
for set in movi_sphere movi_a movi_b; do
  "$tools/generate_scenes" --set $set --scenes "$scenes" --seed $seed --out "$out/$set" "${shapes[@]}"
  data+=(--data "$out/$set")
  seed=$((seed + 1))
done
score() { "$tools/evaluate" "${model[@]}" "${data[@]}" "$@"; }
all_starts=(--starts '0,120,240' --horizons '50,75,100')
one_view=(--view --noise 0.002 --properties unknown)
engines=(--baselines 'ballistic,bullet')
# The points of the published protocol are the mesh vertices; a sensor sees samples of the surface.
score --points vertices "${all_starts[@]}" --steps 10 "${engines[@]}" --json "$out/vertices.json"
score --points vertices "${all_starts[@]}" --steps 10 "${engines[@]}" "${one_view[@]}" \
  --json "$out/vertices_one_view.json"
score --points 256 "${all_starts[@]}" --steps 10 "${engines[@]}" --json "$out/samples.json"
score --points 256 "${all_starts[@]}" --steps 10 "${engines[@]}" "${one_view[@]}" --json "$out/samples_one_view.json"
# A step of one frame needs ten times the steps: fewer scenes.
score --points vertices "${all_starts[@]}" --steps 1,5 --baselines ballistic --scenes $((scenes / 6)) \
  --json "$out/short_steps.json"
# Other densities, in the air.
at_start=(--starts 0 --steps 10 --horizons 100 --baselines bullet)
score --points 768 "${at_start[@]}" --json "$out/dense.json"
score --points 768 --starts 0 --steps 1,5 --horizons 50,75,100 --baselines none --scenes $((scenes / 6)) \
  --json "$out/dense_short_steps.json"
score --points vertices --mask 0.25 "${at_start[@]}" --json "$out/masked.json"
# Drift over ten seconds of what lies still six seconds after the start.
resting=()
for set in movi_sphere movi_a movi_b; do
  "$tools/generate_scenes" --set $set --scenes $((scenes / 6)) --seed $seed --first-frame 1440 --frames 2401 \
    --out "$out/resting_$set" "${shapes[@]}"
  resting+=(--data "$out/resting_$set")
  seed=$((seed + 1))
done
"$tools/evaluate" "${model[@]}" "${resting[@]}" --starts 0 --steps 10 --horizons 240,2400 --resting --baselines none \
  --json "$out/resting.json"
"$root/scripts/score_table.py" "$out"/{vertices,vertices_one_view,samples,samples_one_view}.json \
  "$out"/{short_steps,dense,dense_short_steps,masked,resting}.json
