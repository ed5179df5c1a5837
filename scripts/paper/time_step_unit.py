#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Paper Eq. (10) and (11): the unit of the time step, which the text leaves open. Trains with the paper's loss (weights
10 and 1, Smooth L1 with beta 1) and accelerations in m/s^2 or in m per frame^2."""
from study import Study, print_variants


def main():
    study = Study(__doc__)
    loss = ['loss.position_weight=10', 'loss.acceleration_weight=1', 'loss.beta=1']
    variants = {name: study.variant(f'loss_{unit}', changes=[*loss, f'loss.residual_unit={unit}'])
                for name, unit in (('seconds', 'dt2'), ('frames', 'frames2'))}
    variants["this project's loss"] = study.variant('base')
    print_variants(study, 'Eq. (10), (11): unit of the time step', variants, {})


main()
