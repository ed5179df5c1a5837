#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Paper Tab. 2 and 4: accuracy on MOVi-Sphere, A and B for steps of 10, 5 and 1 frames (Tab. 2 is its row s = 1).

Scores the network alone as it is shipped; nothing is trained. The test scenes are those of scripts/score_model.sh.
"""
from study import HORIZONS, NAMES, STEPS, Study, cell

PAPER = {
    ('movi_a', 10): [(.018, 1.47), (.068, 6.98), (.118, 11.93)],
    ('movi_b', 10): [(.029, 1.51), (.069, 5.89), (.115, 10.85)],
    ('movi_sphere', 10): [(.014, 1.09), (.045, 4.30), (.076, 7.47)],
    ('movi_a', 5): [(.035, 3.33), (.083, 8.55), (.148, 15.08)],
    ('movi_b', 5): [(.040, 3.06), (.078, 7.25), (.136, 13.55)],
    ('movi_sphere', 5): [(.021, 2.11), (.047, 5.23), (.086, 9.58)],
    ('movi_a', 1): [(.049, 5.06), (.103, 10.90), (.177, 18.32)],
    ('movi_b', 1): [(.050, 3.97), (.095, 8.51), (.161, 15.33)],
    ('movi_sphere', 1): [(.026, 3.00), (.057, 6.48), (.099, 11.19)],
}


def main():
    study = Study(__doc__)
    study.options.out.mkdir(parents=True, exist_ok=True)
    scores = study.score(study.options.model, NAMES, study.options.out / f'table_4_{study.options.scenes}.json')
    print('### Tab. 2 and 4: step sizes\n')
    print('| set | s | ' + ' | '.join(map(str, HORIZONS)) + ' |')
    print('|---|---|' + '---|' * len(HORIZONS))
    missed = 0
    for movi_set, name in NAMES.items():
        for step in STEPS:
            published = PAPER[movi_set, step]
            ours = [scores[movi_set, step, h] for h in HORIZONS]
            missed += sum(o >= p for us, them in zip(ours, published) for o, p in zip(us, them))
            print(f'| {name} | {step} | ' + ' | '.join(cell([o], p) for o, p in zip(ours, published)) + ' |')
    print(f'\nPosition (m) / orientation (degrees), the network alone, {study.options.scenes} test scenes per set; the '
          f'paper in brackets. {54 - missed} of 54 numbers are better than the paper\'s '
          f'(code {study.revision()}).\n')


main()
