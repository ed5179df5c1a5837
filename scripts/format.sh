#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Formats all C++ sources; with --check only says which differ and fails then.
set -euo pipefail

cd "$(dirname "$0")/.."
folders=()
for folder in include src test benchmark examples fuzz; do
  [ -d "$folder" ] && folders+=("$folder")
done
mode=(-i)
[ "${1:-}" = --check ] && mode=(--dry-run --Werror)
find "${folders[@]}" \( -name '*.hpp' -o -name '*.cpp' \) -print0 | xargs -0 -r clang-format-14 "${mode[@]}"
