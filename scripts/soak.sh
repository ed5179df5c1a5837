#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Sends random clouds through the node for a long time: objects that appear, change and vanish, nonsense, a clock that
# restarts.
#   scripts/soak.sh [--clouds N] [--model] [--workspace DIR]
# Default: 100000 clouds and a predictor of known physics. --model: the shipped model, one step per forecast.
# The last line is the result: waiting times from cloud to forecast, and memory.
set -euo pipefail

# shellcheck source=long_run.sh
source "$(dirname "$0")/long_run.sh"
values=([--clouds]=100000)
flags=([--model]="")
read_options "$@"
node=()
[ -z "${flags[--model]}" ] || node=(node:=prediction_node num_steps:=1)
run_test soak 'cloud to forecast' clouds:="${values[--clouds]}" time_limit:=36000 "${node[@]}"
