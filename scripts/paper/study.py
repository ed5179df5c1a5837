# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts of the paper's tables share: scenes, short trainings of the network alone, scores, Markdown.

A variant is config/train/paper_tables.yaml with a few keys changed. Every variant is trained for as many iterations,
once per seed, and scored without any engine and without rest holding on scenes that nothing was trained on. What is
finished is not done again, so that a script can be stopped and started.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SEEDS = (1, 2)
HORIZONS = (50, 75, 100)
STEPS = (10, 5, 1)
TRAINING_SEEDS = {'movi_sphere': 13, 'movi_a': 12, 'movi_b': 11}
TEST_SEEDS = {'movi_sphere': 770001, 'movi_a': 770002, 'movi_b': 770003}
NAMES = {'movi_sphere': 'Sphere', 'movi_a': 'A', 'movi_b': 'B'}


class Study:
    """One table: where its files lie, and how much is spent on it."""

    def __init__(self, description):
        parser = argparse.ArgumentParser(description=description)
        parser.add_argument('--out', type=pathlib.Path, default=ROOT / 'runs' / 'paper', help='folder of all tables')
        parser.add_argument('--workspace', type=pathlib.Path, default=ROOT / 'build' / 'catkin_ws')
        parser.add_argument('--shapes', help='shapes in KuBasic layout; default: the built-in ones')
        parser.add_argument('--iterations', type=int, default=250, help='of every training')
        parser.add_argument('--scenes', type=int, default=16, help='test scenes per set; 120 in the protocol')
        parser.add_argument('--model', default=str(ROOT / 'models' / 'network.safetensors'),
                            help='for tables that need no training')
        self.options = parser.parse_args()
        self.minutes = []

    def tool(self, name, *arguments):
        """Runs a program of the workspace in one thread and returns what it prints."""
        program = self.options.workspace / 'devel' / 'lib' / 'rigidformer_ros' / name
        if not program.exists():
            sys.exit(f'{program} is missing: build the workspace with scripts/build.sh first')
        environment = dict(os.environ, OMP_NUM_THREADS='1', OPENBLAS_NUM_THREADS='1')
        command = [str(program), *map(str, arguments)]
        return subprocess.run(command, env=environment, check=True, text=True, stdout=subprocess.PIPE).stdout

    def scenes(self, movi_set, kind):
        """The folder with 300 training scenes or the test scenes of a set."""
        seeds, number = (TRAINING_SEEDS, 300) if kind == 'train' else (TEST_SEEDS, 120)
        folder = self.options.out / kind / movi_set
        if not folder.exists():
            shapes = ['--shapes', self.options.shapes] if self.options.shapes else []
            self.tool('generate_scenes', '--set', movi_set, '--scenes', number, '--seed', seeds[movi_set],
                      '--out', folder, *shapes)
        return folder

    def score(self, model, test_sets, file, *how):
        """Scores a model: {(set, step, horizon): (position m, orientation deg)}."""
        if not file.exists():
            data = [word for movi_set in test_sets for word in ('--data', self.scenes(movi_set, 'test'))]
            self.tool('evaluate', '--model', model, *data, '--starts', 0, '--steps', ','.join(map(str, STEPS)),
                      '--horizons', ','.join(map(str, HORIZONS)), '--scenes', self.options.scenes,
                      '--rest-speed', 0, '--baselines', 'none', '--json', file, *(how or ('--points', 'vertices')))
        results = json.loads(file.read_text(encoding='utf-8'))['results']
        return {(r['set'], r['step'], r['horizon']): (r['position_rmse_m'], r['orientation_rmse_deg'])
                for r in results if r['model'] == 'rigidformer'}

    def variant(self, name, train_sets=('movi_b',), test_sets=('movi_b',), changes=(), how=()):
        """Trains and scores a variant per seed; a list of what score() returns."""
        scores = []
        for seed in SEEDS:
            folder = self.options.out / 'variants' / f'{name}_{self.options.iterations}_seed_{seed}'
            if not (folder / 'finished').exists():
                print(f'{folder.name}: training', file=sys.stderr)
                overrides = [f'iterations={self.options.iterations}', f'seed={seed}', *changes]
                start = time.monotonic()
                self.tool('train', '--config', ROOT / 'config' / 'train' / 'paper_tables.yaml', '--device', 'cpu',
                          *[word for change in overrides for word in ('--set', change)],
                          '--data', *[self.scenes(movi_set, 'train') for movi_set in train_sets], '--out', folder)
                (folder / 'finished').write_text(f'{(time.monotonic() - start) / 60:.2f}\n', encoding='utf-8')
            self.minutes.append(float((folder / 'finished').read_text(encoding='utf-8')))
            scores.append(self.score(folder / 'model.safetensors', test_sets, folder / 'scores.json', *how))
        return scores

    def revision(self):
        """The commit that the numbers belong to."""
        return subprocess.run(['git', '-C', ROOT, 'describe', '--always', '--dirty'], check=True, text=True,
                              stdout=subprocess.PIPE).stdout.strip()


def cell(values, paper=None):
    """Means over seeds as position / orientation, and the paper's in brackets."""
    position, orientation = (sum(v[i] for v in values) / len(values) for i in (0, 1))
    text = f'{position:.3f} / {orientation:.1f}'
    return f'{text} ({paper[0]:.3f} / {paper[1]:.1f})' if paper else text


def largest_scatter(scores):
    """How far two seeds lie apart at frame 100, in percent of their mean: (position, orientation)."""
    return tuple(max(100 * abs(a[key][i] - b[key][i]) / ((a[key][i] + b[key][i]) / 2)
                     for a, b in scores for key in a if key[2] == HORIZONS[-1]) for i in (0, 1))


def print_variants(study, title, variants, paper):
    """A table of {name: scores per seed} on MOVi-B; paper = {(name, step): [(position, orientation) per horizon]}."""
    print(f'### {title}\n')
    print('| variant | s | ' + ' | '.join(map(str, HORIZONS)) + ' |')
    print('|---|---|' + '---|' * len(HORIZONS))
    for name, scores in variants.items():
        for step in STEPS:
            published = paper.get((name, step), [None] * len(HORIZONS))
            cells = [cell([s['movi_b', step, h] for s in scores], p) for h, p in zip(HORIZONS, published)]
            print(f'| {name} | {step} | ' + ' | '.join(cells) + ' |')
    print_footer(study, list(variants.values()))


def print_footer(study, scores):
    """What was spent, and how far seeds differ beside variants."""
    position, orientation = largest_scatter(scores)
    spent = max(study.minutes)
    print(f'\nPosition (m) / orientation (degrees), mean of {len(SEEDS)} seeds; the paper in brackets. The network '
          f'alone, {study.options.scenes} test scenes, {study.options.iterations} iterations, at most {spent:.1f} '
          f'minutes of one core per training. Seeds differ by up to {position:.0f} % in position and '
          f'{orientation:.0f} % in orientation at frame 100 (code {study.revision()}).\n')
