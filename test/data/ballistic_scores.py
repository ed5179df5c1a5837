#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the ballistic guess scores on a scene, worked out apart from the C++ code: the numbers that the tests expect.

test/data/ballistic_scores.py [METADATA_JSON]
"""
import json
import math
import pathlib
import sys

STEP, HORIZON = 10, 100  # frames


def multiply(a, b):
    """Product of two quaternions w x y z."""
    return (a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0])


def inverse(q):
    return (q[0], -q[1], -q[2], -q[3])


def angle_deg(a, b):
    difference = multiply(inverse(a), b)
    return math.degrees(2 * math.atan2(math.hypot(*difference[1:]), abs(difference[0])))


def guess(instance, start, steps, drop):
    """Pose after `steps` steps: the mean velocity and the turn between the two given frames go on; gravity pulls."""
    first, second = (instance['positions'][start + i * STEP] for i in (0, 1))
    position = [a + steps * (b - a) for a, b in zip(first, second)]
    position[2] += drop * steps * (steps - 1) / 2
    rotation = instance['quaternions'][start]
    turn = multiply(instance['quaternions'][start + STEP], inverse(rotation))
    for _ in range(steps):
        rotation = multiply(turn, rotation)
    return position, rotation


def root_mean_square(values):
    return math.sqrt(sum(value * value for value in values) / len(values))


def main():
    default = pathlib.Path(__file__).parent / 'movi_a' / '20' / 'metadata.json'
    scene = json.loads(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else default).read_text(encoding='utf-8'))
    drop = scene['metadata']['gravity'][2] * (STEP / scene['metadata']['frame_rate']) ** 2
    for start in (0, 120, 240):
        distances, angles = [], []
        for instance in scene['instances']:
            position, rotation = guess(instance, start, HORIZON // STEP, drop)
            distances.append(math.dist(position, instance['positions'][start + HORIZON]))
            angles.append(angle_deg(rotation, instance['quaternions'][start + HORIZON]))
        print(f'start {start}: {root_mean_square(distances):.6f} m, {root_mean_square(angles):.4f} deg')


if __name__ == '__main__':
    main()
