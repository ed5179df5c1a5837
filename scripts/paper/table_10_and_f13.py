#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Paper Tab. 10 and F13: time per step on the paper's scene of 10 objects with 4,016 points, part by part. Needs a
workspace that was built with scripts/build.sh --benchmarks. The paper measured on a GPU it does not name."""
import json

from study import Study

PAPER = {'encoder': 2.67, 'object_interaction': 6.01, 'anchor_interaction': 9.94, 'nearest_points': 22.80,
         'kabsch': 0.45, 'total': 41.86}  # ms

MILLISECONDS = {'ns': 1e-6, 'us': 1e-3, 'ms': 1.0, 's': 1e3}


def main():
    study = Study(__doc__)
    study.options.out.mkdir(parents=True, exist_ok=True)
    file = study.options.out / 'table_f13.json'
    study.tool('rigidformer_bench', f'--benchmark_out={file}', '--benchmark_out_format=json',
               '--benchmark_filter=float32/(encoder|object_interaction|anchor_interaction|nearest|kabsch|total)')
    times = {}
    for run in json.loads(file.read_text(encoding='utf-8'))['benchmarks']:
        preset, _, part = run['name'].split('/')[:3]
        times.setdefault(part, {})[preset] = run['real_time'] * MILLISECONDS[run['time_unit']]
    print('### Tab. 10 and F13: milliseconds per step\n')
    print('| part | paper preset | small | the paper, on a GPU |')
    print('|---|---|---|---|')
    for part, of_preset in times.items():
        cells = [f'{of_preset[p]:.1f}' if p in of_preset else '' for p in ('paper', 'small')]
        published = f'{PAPER[part]:.2f}' if part in PAPER else ''
        print(f"| {part.replace('_', ' ')} | {' | '.join(cells)} | {published} |")
    print(f'\nOne thread of this machine\'s processor, float32 (code {study.revision()}).\n')


main()
