#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the documents are true and the sources within the limits that CONTRIBUTING.md states: parameters and
their defaults, paths, programs, options, topics and layers that documents name, lengths of lines, files and functions,
the README's number of words."""
import pathlib
import re
import sys
import unittest

import yaml

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / 'test'))
import layering_test  # noqa: E402: the tested order of layers and rooms

DOCUMENTS = sorted([ROOT / 'README.md', ROOT / 'CONTRIBUTING.md', *ROOT.glob('docs/*.md'), *ROOT.glob('models/*.md')])
MAX_README_WORDS = 1000
MAX_COLUMNS = 120
MAX_FILE_LINES = 300
MAX_FUNCTION_LINES = 40

# Options of other people's programs that the documents tell to use.
FOREIGN_OPTIONS = set('''--build --no-python --node-rank --nnodes --nproc-per-node --master-addr --master-port --exclude
    --network --rm --env --volume --tag --file --pid --user --test-dir --target --gtest_filter --clock --help --flags
    --duration --once --version --benchmark_filter --recursive --cpus --dirty --always --build-arg
    --restart --ipc'''.split())

# What a document may name although the repository does not hold it: what programs write, and examples of names.
MADE_BY_PROGRAMS = re.compile(r'^(build|bundle|runs|data|devel|install|logs)/|\*|<|DIR|FILE|NAME|/your/|\{')
PATH = re.compile(r'^[\w.-]+(/[\w.*{},-]+)+/?$')
KNOWN_SUFFIXES = {'.cpp', '.hpp', '.md', '.sh', '.py', '.yaml', '.launch', '.msg', '.srv', '.cmake', '.txt', '.rviz'}


def text_of(path):
    return path.read_text(encoding='utf-8')


def sources(*folders):
    files = [path for folder in folders for path in (ROOT / folder).rglob('*')]
    return sorted(path for path in files if path.suffix in ('.cpp', '.hpp'))


def code_spans(text):
    """What stands in backticks, on one line each."""
    return re.findall(r'`([^`\n]+)`', re.sub(r'```.*?```', '', text, flags=re.DOTALL))


def code_blocks(text):
    return re.findall(r'```bash\n(.*?)```', text, flags=re.DOTALL)


def flatten(tree, prefix=''):
    """{'history/min_dt': 0.005, ...} of a tree of parameters; lists count as one value."""
    values = {}
    for key, value in tree.items():
        values.update(flatten(value, f'{prefix}{key}/') if isinstance(value, dict) else {f'{prefix}{key}': value})
    return values


def parameter_tables(text):
    """{'history/min_dt': '0.005 s', ...} of the tables of docs/interface.md; a heading in backticks names the group."""
    documented, group = {}, ''
    for line in text.splitlines():
        heading = re.match(r'#+ .*?`(\w+)/?`', line)
        if line.startswith('#'):
            group = f'{heading[1]}/' if heading else ''
        row = re.match(r'\| `(\w+)` \| (.*?) \|', line)
        if row:
            documented.setdefault(f'{group}{row[1]}', row[2])
    return documented


def number(text):
    """The number that a default begins with: '200,000' -> 200000, '1/24 s' -> 0.0417, '−10 m/s²' -> -10."""
    text = text.replace('−', '-').replace(',', '').strip('`')
    fraction = re.match(r'(\d+)/(\d+)', text)
    if fraction:
        return int(fraction[1]) / int(fraction[2])
    plain = re.match(r'-?\d+(\.\d+)?(e-?\d+)?', text)
    return float(plain[0]) if plain else None


def same_default(documented, value):
    if isinstance(value, bool):
        return documented.startswith(str(value).lower())
    if isinstance(value, (int, float)):
        return number(documented) is not None and abs(number(documented) - value) <= 1e-3 * abs(value)
    if isinstance(value, list) and value:
        return documented.strip('`') == ', '.join(str(element) for element in value)
    if value in ([], '', None):
        return documented.strip('`') in ('none', '""')
    return documented.strip('`') == str(value) or (str(value).startswith('package://') and 'shipped' in documented)


def functions_of(path):
    """(first line, number of lines) of every function of a formatted file that is not inside a class."""
    start = None
    for number_, line in enumerate(text_of(path).splitlines(), 1):
        if start is None and re.match(r'[\w\[:~<].*[){]$', line) and not re.match(
                r'(namespace|struct|class|enum|union|extern|template)\b|.*[=,]\s*\{$', line):
            start = number_
        if line.startswith('}') and start:
            yield start, number_ - start + 1
            start = None
        elif start and line.endswith(';') and not line.startswith(' '):
            start = None  # a declaration


class Parameters(unittest.TestCase):
    def test_every_parameter_is_documented_with_its_default(self):
        values = flatten(yaml.safe_load(text_of(ROOT / 'config' / 'node.yaml')))
        documented = parameter_tables(text_of(ROOT / 'docs' / 'interface.md'))
        self.assertGreater(len(values), 50, 'config/node.yaml was not read')
        for name, value in values.items():
            with self.subTest(parameter=name):
                self.assertTrue(name in documented, 'is not in docs/interface.md')
                self.assertTrue(same_default(documented[name], value), f'{documented[name]!r} is not {value!r}')


class Names(unittest.TestCase):
    """What the documents name exists."""

    def places(self, name):
        bases = [ROOT, ROOT / 'src' / 'rigidformer', ROOT / 'src' / 'rigidformer_ros', ROOT / 'include' / 'rigidformer',
                 ROOT / 'include', ROOT / 'include' / 'rigidformer_ros', ROOT / 'docs', ROOT / 'test', ROOT / 'scripts', ROOT / 'config' / 'train']
        return any((base / name).exists() for base in bases)

    def test_paths(self):
        for document in DOCUMENTS:
            for span in code_spans(text_of(document)):
                is_path = PATH.match(span) and (pathlib.PurePath(span).suffix in KNOWN_SUFFIXES or span.endswith('/'))
                if is_path and not MADE_BY_PROGRAMS.search(span):
                    with self.subTest(document=document.name, path=span):
                        self.assertTrue(self.places(span.rstrip('/')))

    def test_links(self):
        for document in DOCUMENTS:
            for target in re.findall(r'\]\(([^)#\s]+)', text_of(document)):
                if not target.startswith('http'):
                    with self.subTest(document=document.name, link=target):
                        self.assertTrue((document.parent / target).exists())

    def test_programs(self):
        lists = [path for folder in ('src', 'examples', 'benchmark', 'test')
                 for path in (ROOT / folder).rglob('CMakeLists.txt')]
        built = ' '.join(text_of(path) for path in lists)
        for document in DOCUMENTS:
            for program in re.findall(r'rosrun rigidformer_ros ([a-z]\w+)', text_of(document)):
                with self.subTest(document=document.name, program=program):
                    self.assertRegex(built, rf'\b{program}\b')

    def test_launch_files(self):
        for document in DOCUMENTS:
            for name in re.findall(r'roslaunch rigidformer_ros (\S+\.launch)', text_of(document)):
                with self.subTest(document=document.name, launch=name):
                    self.assertTrue((ROOT / 'launch' / name).exists())

    def test_options(self):
        files = sources('src', 'benchmark', 'test')
        files += sorted(ROOT.glob('scripts/*.sh')) + sorted(ROOT.glob('scripts/*.py'))
        code = ''.join(text_of(path) for path in files)
        for document in DOCUMENTS:
            text = text_of(document)
            for option in set(re.findall(r'(?<![\w-])--[a-z][\w-]+', ' '.join(code_blocks(text) + code_spans(text)))):
                if option not in FOREIGN_OPTIONS:
                    with self.subTest(document=document.name, option=option):
                        # Options of the simulated camera are made from the names of its settings.
                        self.assertTrue(option in code or f'"{option[2:]}"' in code)

    def test_topics_and_services(self):
        rooms = [f'src/rigidformer_ros/{room}' for room in ('messages', 'parameters', 'health')]
        names = ''.join(text_of(path) for path in sources(*rooms))
        section = text_of(ROOT / 'docs' / 'interface.md').split('## Parameters')[0]
        found = re.findall(r'^\| `(/?[a-z_]+)[`/]', section, flags=re.MULTILINE)
        for name in set(found) - {'input', 'ordered', 'registration', 'pose'}:
            with self.subTest(name=name):
                self.assertTrue(name.startswith('/') or f'"{name}' in names)

    def test_layers(self):
        for document in ('docs/architecture.md', 'CONTRIBUTING.md'):
            text = re.sub(r'\s+', ' ', text_of(ROOT / document))
            for order in (layering_test.LAYERS, layering_test.ROOMS):
                with self.subTest(document=document):
                    self.assertIn(', '.join(f'`{name}`' for name in order), text)


class Lengths(unittest.TestCase):
    def test_readme(self):
        self.assertLessEqual(len(text_of(ROOT / 'README.md').split()), MAX_README_WORDS)

    def test_lines(self):
        files = DOCUMENTS + sources('include', 'src', 'test', 'benchmark', 'examples', 'fuzz')
        files += [path for pattern in ('scripts/*.*', 'launch/*', 'config/**/*.yaml', 'msg/*', 'srv/*', '*.txt')
                  for path in ROOT.glob(pattern)]
        for path in files:
            for i, line in enumerate(text_of(path).splitlines(), 1):
                if len(line) > MAX_COLUMNS:
                    with self.subTest(file=str(path.relative_to(ROOT)), line=i):
                        self.fail(f'{len(line)} characters')

    def test_files(self):
        for path in sources('include', 'src'):
            with self.subTest(file=str(path.relative_to(ROOT))):
                self.assertLessEqual(len(text_of(path).splitlines()), MAX_FILE_LINES)

    def test_functions(self):
        counted = 0
        for path in sources('include', 'src'):
            for first, length in functions_of(path):
                counted += 1
                with self.subTest(file=str(path.relative_to(ROOT)), line=first):
                    self.assertLessEqual(length, MAX_FUNCTION_LINES)
        self.assertGreater(counted, 500, 'functions were not found')


class Planted(unittest.TestCase):
    """The checks themselves find what is wrong."""

    def test_defaults(self):
        self.assertTrue(same_default('1/24 s', 1 / 24))
        self.assertTrue(same_default('2,000,000', 2000000))
        self.assertTrue(same_default('""', ''))
        self.assertFalse(same_default('0.2 s', 0.1))
        self.assertFalse(same_default('true', False))
        self.assertFalse(same_default('registration', 'ordered'))

    def test_tables(self):
        table = '### `history/`\n| name | default |\n|---|---|\n| `min_dt` | 0.005 s | 0 to 1 |\n'
        self.assertEqual(parameter_tables(table), {'history/min_dt': '0.005 s'})


if __name__ == '__main__':
    unittest.main()
