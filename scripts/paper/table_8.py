#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Paper Tab. 8: how many anchors an object has."""
from study import Study, print_variants

PAPER = {
    ('3 anchors', 10): [(.033, 1.63), (.081, 6.74), (.135, 12.71)],
    ('3 anchors', 5): [(.047, 3.63), (.094, 8.67), (.166, 16.80)],
    ('3 anchors', 1): [(.060, 4.82), (.118, 10.64), (.198, 19.01)],
    ('4 anchors', 10): [(.029, 1.51), (.069, 5.89), (.115, 10.85)],
    ('4 anchors', 5): [(.040, 3.06), (.078, 7.25), (.136, 13.55)],
    ('4 anchors', 1): [(.050, 3.97), (.095, 8.51), (.161, 15.33)],
    ('8 anchors', 10): [(.031, 1.51), (.079, 5.53), (.130, 10.07)],
    ('8 anchors', 5): [(.046, 3.14), (.097, 7.20), (.170, 13.38)],
    ('8 anchors', 1): [(.061, 4.08), (.123, 8.67), (.208, 15.26)],
}


def main():
    study = Study(__doc__)
    variants = {
        '3 anchors': study.variant('anchors_3', changes=['model.num_anchors=3']),
        '4 anchors': study.variant('base'),
        '8 anchors': study.variant('anchors_8', changes=['model.num_anchors=8']),
    }
    print_variants(study, 'Tab. 8: number of anchors', variants, PAPER)


main()
