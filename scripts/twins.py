#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""How far two engines disagree on twins: two folders of scenes that generate_scenes made with the same set and seed and
different engines. Prints a Markdown table of the distance between the two fates of an object over time, in shares of
its diameter and in degrees: the half of all objects that disagree least lie below the median.
    scripts/twins.py DIR DIR"""
import json
import math
import pathlib
import statistics
import struct
import sys

FRAMES = (60, 120, 180, 240, 360, 479)  # of 1/240 s after the common start
FORMATS = {'F32': 'f', 'F64': 'd', 'I32': 'i'}


class Archive:
    """The tensors of a scene archive as flat tuples, as far as they are needed here."""

    def __init__(self, path):
        data = path.read_bytes()
        size = struct.unpack('<Q', data[:8])[0]
        header = json.loads(data[8:8 + size])
        metadata = header.pop('__metadata__')
        self.scenes = json.loads(metadata['scenes'])
        self.shapes = json.loads(metadata['shapes'])
        self.num_frames = header['poses']['shape'][1]
        for name, entry in header.items():
            begin, end = entry['data_offsets']
            count = math.prod(entry['shape'])
            values = struct.unpack_from(f"<{count}{FORMATS[entry['dtype']]}", data, 8 + size + begin)
            setattr(self, name, values)

    def pose(self, k, frame):
        start = 7 * (k * self.num_frames + frame)
        return self.poses[start:start + 7]

    def diameters(self):
        """Of every object: twice the largest distance of a vertex from the centre of mass."""
        radius = [0.0] * len(self.shapes)
        vertex = 0
        for shape, count in zip(self.part_shape, self.part_num_vertices):
            for i in range(vertex, vertex + count):
                radius[shape] = max(radius[shape], math.hypot(*self.vertices[3 * i:3 * i + 3]))
            vertex += count
        return [2.0 * radius[shape] * size for shape, size in zip(self.object_shape, self.object_size)]


def angle_deg(a, b):
    cosine = abs(sum(x * y for x, y in zip(a[3:], b[3:]))) / (math.hypot(*a[3:]) * math.hypot(*b[3:]))
    return math.degrees(2.0 * math.acos(min(1.0, cosine)))


def disagreements(first, second):
    """{frame: [(share of the diameter, degrees)]} of all objects of all shards."""
    found = {frame: [] for frame in FRAMES}
    for path in sorted(first.glob('*.safetensors')):
        a, b = Archive(path), Archive(second / path.name)
        if a.object_size != b.object_size or a.object_friction != b.object_friction:
            sys.exit(f'{path.name}: the folders do not hold the same scenes')
        for k, diameter in enumerate(a.diameters()):
            for frame in FRAMES:
                x, y = a.pose(k, frame), b.pose(k, frame)
                found[frame].append((math.dist(x[:3], y[:3]) / diameter, angle_deg(x, y)))
    return found


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    first, second = map(pathlib.Path, sys.argv[1:])
    print('| after | median | mean | within 0.1 diameters and 10° |\n|---|---|---|---|')
    for frame, pairs in disagreements(first, second).items():
        shares, angles = zip(*pairs)
        agree = sum(share < 0.1 and angle < 10.0 for share, angle in pairs) / len(pairs)
        print(f'| {frame / 240:.2f} s | {statistics.median(shares):.3f} / {statistics.median(angles):.1f} | '
              f'{statistics.mean(shares):.3f} / {statistics.mean(angles):.1f} | {100 * agree:.0f} % |')


if __name__ == '__main__':
    main()
