#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes HTML of the public headers (include/) in build/docs. A warning of Doxygen is an error. Needs doxygen.
#   scripts/docs.sh
set -euo pipefail

cd "$(dirname "$0")/.."
command -v doxygen >/dev/null || { echo "$0: apt-get install doxygen" >&2; exit 2; }
mkdir -p build
rm -rf build/docs  # else pages of headers that are gone would stay
doxygen Doxyfile
echo "docs: $(find build/docs -name '*.html' | wc -l) pages, $PWD/build/docs/index.html"
