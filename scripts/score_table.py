#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the JSON files of `evaluate` as Markdown tables, one per file and step size. Cells are position (m) /
orientation (deg)."""
import json
import sys


def describe(conditions):
    """What the models were given, in words."""
    points = conditions["points"]
    words = ["mesh vertices" if points == "vertices" else f"{points} points per object"]
    if conditions["one_view"]:
        words.append("only those that face one camera")
    if conditions["masked_fraction"]:
        words.append(f"{conditions['masked_fraction']:.0%} of them dropped")
    if conditions["noise_m"]:
        words.append(f"noise {1000 * conditions['noise_m']:g} mm")
    if conditions.get("resting_only"):
        words.append("only objects that lie still")
    words.append(f"properties {conditions['properties']}")
    return ", ".join(words)


def print_table(step, results, conditions):
    """One row per set, start and model; one column per horizon."""
    cells, scenes = {}, set()
    digits = 4 if conditions.get("resting_only") else 3
    for row in results:
        if row["step"] == step:
            text = f"{row['position_rmse_m']:.{digits}f} / {row['orientation_rmse_deg']:.{digits - 2}f}"
            cells.setdefault((row["set"], row["start"], row["model"]), {})[row["horizon"]] = text
            scenes.add(row["scenes"])
    count = " to ".join(str(n) for n in sorted({min(scenes), max(scenes)}))
    horizons = sorted({horizon for row in cells.values() for horizon in row})
    print(f"\ns = {step}, {count} scenes per set, {describe(conditions)}\n")
    print("| set | start | model | " + " | ".join(str(h) for h in horizons) + " |")
    print("|---|---|---|" + "---|" * len(horizons))
    for (name, start, model), row in cells.items():
        print(f"| {name} | {start} | {model} | " + " | ".join(row.get(h, "") for h in horizons) + " |")


def main():
    if len(sys.argv) < 2:
        sys.exit("usage: score_table.py FILE.json [FILE.json ...]")
    for path in sys.argv[1:]:
        with open(path, encoding="utf-8") as file:
            document = json.load(file)
        for step in sorted({row["step"] for row in document["results"]}, reverse=True):
            print_table(step, document["results"], document["conditions"])


main()
