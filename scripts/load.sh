#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Loads the node with the shipped model: ten objects of 4016 points each at 30 Hz, and eight planners that call
# predict_rollout without a pause.
#   scripts/load.sh [--seconds N] [--steps N] [--workspace DIR]
# The last line is the result: frames, forecasts, and waiting times of the planners.
set -euo pipefail

# shellcheck source=long_run.sh
source "$(dirname "$0")/long_run.sh"
values=([--seconds]=30.0 [--steps]=24)
read_options "$@"
run_test load 'objects x 4016 points' node:=prediction_node objects:=10 num_steps:="${values[--steps]}" \
  seconds:="${values[--seconds]}" time_limit:=3600
