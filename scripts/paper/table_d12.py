#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Paper Tab. D11 and D12: what is in the data. Counts the objects of 120 generated scenes per set."""
import collections
import json
import struct

from study import NAMES, Study

PAPER = {'movi_a': (7810, 3), 'movi_b': (7712, 11), 'movi_sphere': (7809, 1)}  # instances in 1,200 scenes, types


def read_archive(file):
    """Which shape every object of an archive has, how many scenes it holds and how many frames each has."""
    with open(file, 'rb') as archive:
        length = struct.unpack('<Q', archive.read(8))[0]
        header = json.loads(archive.read(length))

        def integers(name):
            begin, end = header[name]['data_offsets']
            archive.seek(8 + length + begin)
            return struct.unpack(f'<{(end - begin) // 4}i', archive.read(end - begin))

        names = [shape['name'] for shape in json.loads(header['__metadata__']['shapes'])]
        scenes = len(set(integers('object_scene')))
        return [names[i] for i in integers('object_shape')], scenes, header['poses']['shape'][1]


def main():
    study = Study(__doc__)
    print('### Tab. D11 and D12: scenes\n')
    print('| set | scenes | objects per scene (paper) | types (paper) | share of a type | frames |')
    print('|---|---|---|---|---|---|')
    for movi_set, name in NAMES.items():
        shapes, scenes, frames = collections.Counter(), 0, set()
        for file in sorted(study.scenes(movi_set, 'test').glob('*.safetensors')):
            shapes_of_objects, number, length = read_archive(file)
            shapes.update(shapes_of_objects)
            scenes += number
            frames.add(length)
        total = sum(shapes.values())
        instances, types = PAPER[movi_set]
        rarest, most_frequent = (100 * pick(shapes.values()) / total for pick in (min, max))
        print(f'| {name} | {scenes} | {total / scenes:.1f} ({instances / 1200:.1f}) | {len(shapes)} ({types}) | '
              f'{rarest:.0f} to {most_frequent:.0f} % | {", ".join(map(str, sorted(frames)))} |')
    print(f'\nGenerated with seeds of the test scenes (code {study.revision()}).\n')


main()
