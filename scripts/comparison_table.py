#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints JSON files of `evaluate`, each of one model, as one Markdown table. It has a row per file and step size and a
column per set, start and horizon. Cells are position (m) / orientation (deg)."""
import json
import sys


def main():
    if len(sys.argv) < 2:
        sys.exit("usage: comparison_table.py NAME=FILE.json [NAME=FILE.json ...]")
    rows, columns = {}, {}
    for argument in sys.argv[1:]:
        name, path = argument.split("=", 1)
        with open(path, encoding="utf-8") as file:
            results = json.load(file)["results"]
        for result in results:
            if result["model"] != "rigidformer":
                continue
            column = f"{result['set'].removeprefix('movi_')} {result['start']}, {result['horizon']}"
            columns[column] = None
            text = f"{result['position_rmse_m']:.3f} / {result['orientation_rmse_deg']:.1f}"
            rows.setdefault((name, result["step"]), {})[column] = text
    print("| | s | " + " | ".join(columns) + " |")
    print("|---|---|" + "---|" * len(columns))
    for (name, step), cells in rows.items():
        print(f"| {name.replace('_', ' ')} | {step} | " + " | ".join(cells.get(c, "") for c in columns) + " |")


main()
