#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Paper Tab. 3: what carries over from one set to the others. Trains the network alone on each set and scores it on
the other two."""
from study import NAMES, STEPS, Study, cell, print_footer

PAPER = {
    ('movi_sphere', 'movi_a'): {1: [(.107, 11.27), (.183, 17.92)], 5: [(.083, 8.31), (.153, 14.82)],
                                10: [(.070, 6.84), (.120, 11.64)]},
    ('movi_sphere', 'movi_b'): {1: [(.096, 9.42), (.161, 16.81)], 5: [(.079, 7.73), (.134, 14.50)],
                                10: [(.064, 5.58), (.103, 10.57)]},
    ('movi_a', 'movi_sphere'): {1: [(.087, 7.94), (.153, 14.27)], 5: [(.067, 6.22), (.122, 11.75)],
                                10: [(.062, 4.70), (.104, 8.55)]},
    ('movi_a', 'movi_b'): {1: [(.123, 9.29), (.208, 17.08)], 5: [(.099, 7.75), (.173, 14.85)],
                           10: [(.080, 5.70), (.131, 10.93)]},
    ('movi_b', 'movi_sphere'): {1: [(.123, 10.52), (.207, 17.88)], 5: [(.097, 7.69), (.166, 13.99)],
                                10: [(.084, 5.83), (.137, 10.26)]},
    ('movi_b', 'movi_a'): {1: [(.140, 12.25), (.234, 20.28)], 5: [(.109, 9.55), (.190, 16.85)],
                           10: [(.092, 7.82), (.153, 13.25)]},
}


def main():
    study = Study(__doc__)
    trained = {s: study.variant(f'trained_on_{s}', train_sets=[s], test_sets=list(NAMES)) for s in NAMES}
    print('### Tab. 3: from one set to the others\n')
    print('| trained on | scored on | s | 75 | 100 |')
    print('|---|---|---|---|---|')
    for (source, target), published in PAPER.items():
        for step in STEPS:
            cells = [cell([s[target, step, h] for s in trained[source]], p)
                     for h, p in zip((75, 100), published[step])]
            print(f'| {NAMES[source]} | {NAMES[target]} | {step} | ' + ' | '.join(cells) + ' |')
    print_footer(study, list(trained.values()))


main()
