#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Paper Tab. 9: anchors whose first point is drawn at random, in training and when scored."""
from study import Study, print_variants

PAPER = {
    ('3 anchors', 10): [(.031, 1.72), (.075, 6.36), (.126, 11.74)],
    ('3 anchors', 5): [(.042, 3.72), (.085, 8.40), (.149, 15.12)],
    ('3 anchors', 1): [(.055, 4.80), (.110, 10.46), (.187, 18.19)],
    ('4 anchors', 10): [(.029, 1.59), (.070, 5.76), (.115, 10.39)],
    ('4 anchors', 5): [(.041, 3.21), (.081, 7.23), (.139, 13.38)],
    ('4 anchors', 1): [(.052, 4.41), (.099, 9.31), (.163, 16.16)],
    ('8 anchors', 10): [(.030, 1.52), (.083, 5.58), (.141, 10.06)],
    ('8 anchors', 5): [(.044, 3.23), (.095, 7.28), (.171, 13.29)],
    ('8 anchors', 1): [(.056, 4.04), (.114, 8.64), (.193, 15.17)],
}


def main():
    study = Study(__doc__)
    variants = {f'{count} anchors': study.variant(f'random_anchors_{count}',
                                                  changes=[f'model.num_anchors={count}', 'model.random_anchors=true'])
                for count in (3, 4, 8)}
    print_variants(study, 'Tab. 9: random anchors', variants, PAPER)


main()
