#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Scores models and engines on real tosses of a cube (ContactNets, CoRL 2020; github.com/DAIRLab/dair_pll), given as
# DIR/tosses.csv with the columns toss, frame, t, x, y, z, qx, qy, qz, qw. Prints Markdown: zero-shot, engines fitted on
# the first k tosses by a grid over friction and restitution, models fine-tuned on the same k. Tosses numbered 300 and
# above are for the final score: they are read with --final only. What is finished in --out is not done again.
#   scripts/real_tosses.sh DIR [--final] [--tosses N] [--fine-tune "K ..."] [--out DIR] [--workspace DIR]
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
workspace=$root/build/catkin_ws
usage="usage: $0 DIR [--final] [--tosses N] [--fine-tune \"K ...\"] [--out DIR] [--workspace DIR]"
source=
final=
tosses=100        # of the development score, those after the ones that are fitted on
fine_tune="1 4 16 64"
out=
while [ $# -gt 0 ]; do
  case $1 in
    --final) final=yes; shift; continue ;;
    --tosses) tosses=$2 ;;
    --fine-tune) fine_tune=$2 ;;
    --out) out=$2 ;;
    --workspace) workspace=$(realpath -m "$2") ;;
    -*) echo "$usage" >&2; exit 2 ;;
    *) source=$1; shift; continue ;;
  esac
  shift 2
done
table=$source/tosses.csv
if [ -z "$source" ] || [ ! -e "$table" ]; then echo "$usage (there is no '$table')" >&2; exit 2; fi
out=${out:-$root/runs/real_tosses}
tools=$workspace/devel/lib/rigidformer_ros
[ -d "$tools" ] || tools=$workspace/src/apps  # a build without ROS
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
mkdir -p "$out/fit"

# The numbers of the tosses below 300, or from 300 on, in the order of the file.
numbers() {
  awk -F, -v final="$1" 'NR > 1 && !seen[$1]++ && ($1 >= 300) == (final == "yes") {print $1}' "$table"
}
mapfile -t development < <(numbers no)
fitted=(1 4 16 64)
largest=${fitted[-1]}
if [ -n "$final" ]; then
  mapfile -t scored < <(numbers yes)
  split=final
else
  scored=("${development[@]:$largest:$tosses}")
  split=development
fi
if [ ${#scored[@]} -eq 0 ]; then echo "real_tosses: '$table' has no tosses of the $split score" >&2; exit 1; fi
join() { local IFS=,; echo "$*"; }

# Lengths of the recordings are 2.15 % short: the fall measures 9.61 m/s^2, and the cube of 104.8 mm rests with its
# centre at 51.2 mm. The published contact has friction 0.18 and restitution 0.125. Both belong to the pair: against the
# floor of the trained scenes (0.3 and 0.5), the cube has 0.6 and 0.25.
import() {
  "$tools/import_poses" --poses "$table" --recording-column toss --recordings "$(join "${@:2}")" \
    --shape object=box:0.1048x0.1048x0.1048 --mass object=0.37 --friction object=0.6 --restitution object=0.25 \
    --length-factor 1.0215 --gravity -9.81 --set tosses --out "$out/$1.safetensors"
}
echo "real_tosses: $split, ${#scored[@]} tosses, fitted on the first ${fitted[*]}" >&2
import "$split" "${scored[@]}"
for k in "${fitted[@]}"; do import "fit_$k" "${development[@]:0:$k}"; done

# 0.131 m are trained as 1 m; s is two frames of 148 Hz, 9 frames of 1/240 s at the trained size.
score() {  # FILE DATA OPTIONS: skips what is there
  [ -e "$1" ] && return
  echo "real_tosses: $(basename "$1")" >&2
  "$tools/evaluate" --data "$out/$2.safetensors" --length-scale 0.131 --points 512 --starts 0 --steps 2 \
    --horizons 20,30,40,60 "${@:3}" >&2
}
see_as() { if [ "$1" = one_view ]; then see=(--view --noise 0.002); else see=(--noise 0); fi; }
declare -A model=([rigidformer]=$root/models/hybrid.safetensors [network]=$root/models/network.safetensors
  [varied]=$root/models/varied.safetensors)
engines=bullet,mujoco
for seen in complete one_view; do
  see_as $seen
  for material in unknown known; do
    name=$split.$seen.$material
    score "$out/$name.engines.json" "$split" "${see[@]}" --properties $material --to-the-end --model none \
      --baselines ballistic,$engines --json "$out/$name.engines.json"
    for contestant in rigidformer network varied; do
      score "$out/$name.$contestant.json" "$split" "${see[@]}" --properties $material --to-the-end \
        --model "${model[$contestant]}" --baselines none --json "$out/$name.$contestant.json"
    done
  done
  # A grid that holds the published contact; the cube's values, against the floor's 0.3 and 0.5.
  for friction in 0.3 0.6 1.0 1.8; do
    for restitution in 0 0.25 0.5 1; do
      file=$out/fit/$seen.mu_$friction.e_$restitution.csv
      score "$file" "fit_$largest" "${see[@]}" --properties known --friction $friction --restitution $restitution \
        --model none --baselines $engines --scene-errors "$file"
    done
  done
  for engine in bullet mujoco; do
    for k in "${fitted[@]}"; do
      read -r friction restitution < <("$root/scripts/toss_table.py" --choose "$out/fit" "$seen" $engine "$k")
      file=$out/fit/$split.$seen.$engine.mu_$friction.e_$restitution.json
      score "$file" "$split" "${see[@]}" --properties known --friction "$friction" --restitution "$restitution" \
        --to-the-end --model none --baselines $engine --json "$file"
      cp "$file" "$out/$split.$seen.fitted_$k.$engine.json"
    done
  done
done

declare -A training=([rigidformer]=tosses.yaml [network]=tosses_network.yaml [varied]=tosses_varied.yaml)
for k in $fine_tune; do
  for name in rigidformer network varied; do
    tuned=$out/tuned/${name}_$k
    if [ ! -e "$tuned/model.safetensors" ]; then
      echo "real_tosses: fine-tuning $name on $k tosses" >&2
      nice -n 5 "$tools/train" --config "$root/config/train/${training[$name]}" --init "${model[$name]}" --device cpu \
        --length-scale 0.131 --data "$out/fit_$k.safetensors" --out "$tuned" >&2
    fi
    for seen in complete one_view; do
      see_as $seen
      file=$out/$split.$seen.tuned_$k.$name.json
      score "$file" "$split" "${see[@]}" --properties unknown --to-the-end --model "$tuned/model.safetensors" \
        --baselines none --json "$file"
    done
  done
done
"$root/scripts/toss_table.py" "$out" $split
