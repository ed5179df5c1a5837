#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of scripts/real_tosses.sh.
  toss_table.py DIR development|final        prints what lies in DIR as Markdown
  toss_table.py --choose DIR SEEN ENGINE K   prints friction and restitution that fit the first K tosses best"""
import csv
import json
import math
import pathlib
import re
import sys

HORIZONS = (20, 30, 40, 60)
NAMES = {'rigidformer': 'shipped model', 'network': 'network alone', 'varied': 'network alone, varied physics'}
SEEN = {'complete': '512 points of the whole surface', 'one_view': 'those of them that one camera sees, 2 mm noise'}


def choose(folder, seen, engine, count):
    """The material with the smallest geometric mean over horizons of the mean errors of position and orientation: all
    of them count alike, whatever their unit."""
    best = None
    for path in sorted(folder.glob(f'{seen}.*.csv')):
        with open(path, encoding='utf-8') as file:
            rows = [row for row in csv.DictReader(file) if row['model'] == engine]
        scenes = list(dict.fromkeys(row['scene'] for row in rows))[:count]
        logarithms = []
        for horizon in HORIZONS:
            chosen = [row for row in rows if row['scene'] in scenes and int(row['horizon_frame']) == horizon]
            for error in ('position_rmse_m', 'orientation_rmse_deg'):
                logarithms.append(math.log(sum(float(row[error]) for row in chosen) / len(chosen)))
        friction, restitution = material_of(path.name)
        key = sum(logarithms), friction, restitution
        best = min(best, key) if best else key
    return best[1:]


def material_of(name):
    """'complete.mu_0.3.e_0.csv' -> ('0.3', '0')."""
    return re.match(r'.*\.mu_([\d.]+)\.e_([\d.]+)\.csv$', name).groups()


def rows_of(path):
    """{model: (results by horizon)} of one file of `evaluate`."""
    models = {}
    with open(path, encoding='utf-8') as file:
        for result in json.load(file)['results']:
            models.setdefault(result['model'], {})[result['horizon']] = result
    return models


def line(name, material, results):
    cells = []
    for result in (results[horizon] for horizon in HORIZONS):
        cells.append(f"{1000 * result['position_rmse_m']:.1f} ({100 * result['position_rmse_sizes']:.0f} %) / "
                     f"{result['orientation_rmse_deg']:.1f}")
    last = results[HORIZONS[-1]]
    face = f"{100 * last['right_face'] / last['settled']:.0f}" if last['settled'] else ''
    return f"| {name} | {material} | {' | '.join(cells)} | {face} |"


def table(folder, split, seen):
    lines = []
    for material, words in (('unknown', 'unknown'), ('known', 'as published')):
        for file in ('rigidformer', 'network', 'varied', 'engines'):
            path = folder / f'{split}.{seen}.{material}.{file}.json'
            for model, results in rows_of(path).items():
                lines.append(line(NAMES[file] if file in NAMES else model, words, results))
    for path in fitted_files(folder, f'{split}.{seen}.fitted_*.json'):
        for model, results in rows_of(path).items():
            lines.append(line(model, f'best of a grid on {number_of(path)}', results))
    for path in fitted_files(folder, f'{split}.{seen}.tuned_*.json'):
        for results in rows_of(path).values():
            lines.append(line(NAMES[path.name.split('.')[3]], f'unknown, fine-tuned on {number_of(path)}', results))
    return lines


def fitted_files(folder, pattern):
    """By what was fitted, then by the number of tosses."""
    return sorted(folder.glob(pattern), key=lambda path: (path.name.split('.')[3], number_of(path)))


def number_of(path):
    return int(path.name.split('.')[2].split('_')[1])


def main():
    if len(sys.argv) == 6 and sys.argv[1] == '--choose':
        print(*choose(pathlib.Path(sys.argv[2]), sys.argv[3], sys.argv[4], int(sys.argv[5])))
        return
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    folder, split = pathlib.Path(sys.argv[1]), sys.argv[2]
    scenes = next(iter(rows_of(folder / f'{split}.complete.unknown.network.json').values()))[HORIZONS[0]]['scenes']
    for seen, words in SEEN.items():
        print(f'\n{scenes} tosses ({split}), seen: {words}. Position [mm] (in % of the edge of 104.8 mm) / orientation '
              '[degrees], frames of 148 Hz after the start; of the tosses, those that end on the right face [%].\n')
        print('| | material | ' + ' | '.join(map(str, HORIZONS)) + ' | right face |')
        print('|---|---|' + '---|' * len(HORIZONS) + '---|')
        print('\n'.join(table(folder, split, seen)))


main()
