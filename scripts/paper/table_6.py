#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Paper Tab. 6: gated attention and differentiable alignment, each switched off."""
from study import Study, print_variants

PAPER = {
    ('no gate', 10): [(.033, 1.57), (.090, 6.02), (.152, 10.78)],
    ('no gate', 5): [(.050, 3.51), (.107, 7.77), (.191, 13.93)],
    ('no gate', 1): [(.077, 4.70), (.153, 9.98), (.259, 17.12)],
    ('constant alignment', 10): [(.030, 1.55), (.072, 5.98), (.121, 11.04)],
    ('constant alignment', 5): [(.042, 3.14), (.082, 7.39), (.146, 13.75)],
    ('constant alignment', 1): [(.052, 4.08), (.098, 8.79), (.169, 15.79)],
    ('both', 10): [(.029, 1.51), (.069, 5.89), (.115, 10.85)],
    ('both', 5): [(.040, 3.06), (.078, 7.25), (.136, 13.55)],
    ('both', 1): [(.050, 3.97), (.095, 8.51), (.161, 15.33)],
}


def main():
    study = Study(__doc__)
    variants = {
        'no gate': study.variant('no_gate', changes=['model.gated_attention=false']),
        'constant alignment': study.variant('no_alignment', changes=['model.differentiable_alignment=false']),
        'both': study.variant('base'),
    }
    print_variants(study, 'Tab. 6: gate and alignment', variants, PAPER)


main()
