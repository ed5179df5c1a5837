#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that docs/conventions.md tells the thresholds that the code has for what moves little, and all of them."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = [ROOT / 'src' / 'rigidformer', ROOT / 'include' / 'rigidformer', ROOT / 'src' / 'rigidformer_ros']
# How a threshold of this kind is called.
THRESHOLD = re.compile(r'double (k(?:Rest|Still|Carried|Certain|Touching|Settle|Sleep)\w*) =|(?:^|, )(kStill\w*) =')


def section():
    text = (ROOT / 'docs' / 'conventions.md').read_text(encoding='utf-8')
    return text.split('## At rest')[1].split('\n## ')[0]


def rows():
    """(file, [(name, number), ...]) of every row of the table."""
    for line in section().splitlines():
        spans = re.findall(r'`([^`]+)`', line)
        if line.startswith('| ') and spans:
            yield spans[0], [span.split(' = ') for span in spans[1:] if ' = ' in span]


class AtRest(unittest.TestCase):
    def test_thresholds_are_those_of_the_code(self):
        self.assertGreaterEqual(len(list(rows())), 8)
        for name, thresholds in rows():
            files = [folder / name for folder in FOLDERS if (folder / name).exists()]
            with self.subTest(file=name):
                self.assertEqual(len(files), 1)
                for constant, number in thresholds:
                    self.assertRegex(files[0].read_text(encoding='utf-8'), rf'\b{constant} = {re.escape(number)}\b')

    def test_no_threshold_is_missing(self):
        for folder in FOLDERS:
            for path in folder.rglob('*.[ch]pp'):
                for names in THRESHOLD.findall(path.read_text(encoding='utf-8')):
                    with self.subTest(path=path.name):
                        self.assertIn(''.join(names), section())


if __name__ == '__main__':
    unittest.main()
