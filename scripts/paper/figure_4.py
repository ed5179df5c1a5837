#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Paper Fig. 4: a quarter of every object's points is missing, at random or inside a box. The paper shows pictures and
gives no numbers. The network is the shipped one, which was not trained for it."""
from study import HORIZONS, NAMES, STEPS, Study, cell

MASKS = {'all points': (), 'a quarter missing at random': ('--mask', '0.25'),
         'a quarter missing inside a box': ('--mask-box', '0.25')}


def main():
    study = Study(__doc__)
    study.options.out.mkdir(parents=True, exist_ok=True)
    print('### Fig. 4: partial clouds\n')
    print('| points | set | s | ' + ' | '.join(map(str, HORIZONS)) + ' |')
    print('|---|---|---|' + '---|' * len(HORIZONS))
    for name, mask in MASKS.items():
        file = study.options.out / f"figure_4_{name.replace(' ', '_')}_{study.options.scenes}.json"
        scores = study.score(study.options.model, NAMES, file, '--points', 'vertices', *mask)
        for movi_set in NAMES:
            for step in STEPS:
                cells = [cell([scores[movi_set, step, h]]) for h in HORIZONS]
                print(f'| {name} | {NAMES[movi_set]} | {step} | ' + ' | '.join(cells) + ' |')
    print(f'\nPosition (m) / orientation (degrees), the network alone, {study.options.scenes} test scenes per set, mesh '
          f'vertices (code {study.revision()}).\n')


main()
