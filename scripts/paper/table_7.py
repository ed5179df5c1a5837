#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Paper Tab. 7: how tokens learn where they are."""
from study import Study, print_variants

PAPER = {
    ('sinusoidal', 10): [(.030, 1.55), (.074, 6.04), (.122, 10.91)],
    ('sinusoidal', 5): [(.042, 3.16), (.083, 7.39), (.145, 13.52)],
    ('sinusoidal', 1): [(.051, 4.10), (.100, 8.68), (.172, 15.30)],
    ('learned', 10): [(.030, 1.56), (.073, 5.98), (.122, 11.04)],
    ('learned', 5): [(.042, 3.18), (.082, 7.43), (.146, 13.77)],
    ('learned', 1): [(.054, 4.24), (.103, 9.01), (.176, 15.94)],
    ('obb', 10): [(.033, 1.57), (.079, 5.96), (.133, 11.08)],
    ('obb', 5): [(.045, 3.31), (.087, 7.69), (.155, 14.35)],
    ('obb', 1): [(.060, 4.38), (.114, 9.44), (.189, 16.83)],
    ('pca', 10): [(.107, 2.27), (.499, 9.32), (.918, 16.74)],
    ('pca', 5): [(.240, 5.23), (.647, 12.52), (1.249, 22.62)],
    ('pca', 1): [(.380, 7.02), (.867, 15.11), (1.548, 25.79)],
    ('se3', 10): [(.029, 1.52), (.069, 5.97), (.114, 11.04)],
    ('se3', 5): [(.041, 3.15), (.080, 7.45), (.139, 13.89)],
    ('se3', 1): [(.052, 4.25), (.099, 9.21), (.167, 16.36)],
    ('arope', 10): [(.029, 1.51), (.069, 5.89), (.115, 10.85)],
    ('arope', 5): [(.040, 3.06), (.078, 7.25), (.136, 13.55)],
    ('arope', 1): [(.050, 3.97), (.095, 8.51), (.161, 15.33)],
}


def main():
    study = Study(__doc__)
    variants = {name: study.variant(f'position_{name}', changes=[f'model.position_encoding={name}'])
                for name in ('sinusoidal', 'learned', 'obb', 'pca', 'se3')}
    variants['arope'] = study.variant('base')
    print_variants(study, 'Tab. 7: position encodings', variants, PAPER)


main()
