#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Paper Tab. 5: other densities of points. Trains with 128, 256, 512 or 1,024 surface points per object and scores at
768. Two windows per iteration instead of sixteen, because each costs a hundred times as many pairs of points."""
from study import Study, print_variants

PAPER = {
    ('drawn point counts', 10): [(.071, 1.64), (.101, 6.11), (.137, 11.13)],
    ('drawn point counts', 5): [(.082, 3.55), (.113, 8.06), (.161, 14.83)],
    ('drawn point counts', 1): [(.094, 4.38), (.132, 9.21), (.189, 16.22)],
}


def main():
    study = Study(__doc__)
    changes = ['augmentation.point_counts=[128, 256, 512, 1024]', 'augmentation.max_points=1024',
               'augmentation.vertex_probability=0', 'point_sets.points_per_set=1024', 'batch_size=2']
    scores = study.variant('table_5', changes=changes, how=('--points', '768'))
    print_variants(study, 'Tab. 5: 768 points after training with 128 to 1,024', {'drawn point counts': scores}, PAPER)


main()
