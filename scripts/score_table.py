#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the JSON files of `evaluate` as Markdown tables: one per step size, position (m) / orientation (deg)."""
import json
import sys


def load(paths):
    """Returns {(step, set, start): {horizon: {model: "position / orientation"}}} and the scenes per step."""
    cells, scenes = {}, {}
    for path in paths:
        with open(path, encoding="utf-8") as file:
            for row in json.load(file)["results"]:
                text = f"{row['position_rmse_m']:.3f} / {row['orientation_rmse_deg']:.1f}"
                key = (row["step"], row["set"], row["start"])
                cells.setdefault(key, {}).setdefault(row["horizon"], {})[row["model"]] = text
                scenes[row["step"]] = row["scenes"]
    return cells, scenes


def print_table(step, cells, scenes):
    rows = {key: value for key, value in cells.items() if key[0] == step}
    horizons = sorted({horizon for value in rows.values() for horizon in value})
    models = sorted({model for value in rows.values() for cell in value.values() for model in cell}, reverse=True)
    print(f"\ns = {step}, {scenes} scenes per set\n")
    print("| set | start | " + " | ".join(f"{model}, {h}" for h in horizons for model in models) + " |")
    print("|---|---|" + "---|" * (len(horizons) * len(models)))
    for (_, name, start), value in rows.items():
        print(f"| {name} | {start} | " + " | ".join(value[h].get(m, "") for h in horizons for m in models) + " |")


def main():
    if len(sys.argv) < 2:
        sys.exit("usage: score_table.py FILE.json [FILE.json ...]")
    cells, scenes = load(sys.argv[1:])
    for step in sorted(scenes, reverse=True):
        print_table(step, cells, scenes[step])


main()
