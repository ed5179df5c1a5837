#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# How far forecasts move what stands on real tables: every PCD file of a folder (default: ../shared/data/table_scenes
# beside the repository, or RIGIDFORMER_TEST_DATA) is played through segmentation, tracking and forecasting.
#   scripts/still_scenes.sh [--workspace DIR] [--scenes DIR] [option of still_scenes ...]
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
workspace=$root/build/catkin_ws
scenes=${RIGIDFORMER_TEST_DATA:-$root/../shared/data}/table_scenes
while [ $# -gt 1 ]; do
  case $1 in
    --workspace) workspace=$(realpath -m "$2") ;;
    --scenes) scenes=$2 ;;
    *) break ;;
  esac
  shift 2
done
shopt -s nullglob
files=("$scenes"/*.pcd)
if [ ${#files[@]} -eq 0 ]; then
  echo "skipped: no PCD files in $scenes"
  exit 0
fi
export PATH=/usr/bin:/bin:$PATH OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 OMP_WAIT_POLICY=passive
set +u
# shellcheck disable=SC1091
source "$workspace/devel/setup.bash"
set -u
exec rosrun rigidformer_ros still_scenes "$@" "${files[@]}"
