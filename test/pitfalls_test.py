#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pitfalls that can be seen without running anything: how clouds are read, how the package is built."""
import pathlib
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent

PROJECT = '''cmake_minimum_required(VERSION 3.16)
project(probe LANGUAGES NONE)
include({defaults})
message(STATUS "build type: ${{CMAKE_BUILD_TYPE}}")
'''


def ros_layer():
    for folder in ('include/rigidformer_ros', 'src/rigidformer_ros'):
        for path in (ROOT / folder).rglob('*.[ch]pp'):
            yield path, path.read_text(encoding='utf-8')


def configure(*options):
    """What CMake says about a project with our defaults."""
    with tempfile.TemporaryDirectory() as folder:
        project = PROJECT.format(defaults=ROOT / 'cmake/BuildDefaults.cmake')
        (pathlib.Path(folder) / 'CMakeLists.txt').write_text(project, encoding='utf-8')
        result = subprocess.run(['cmake', '-S', folder, '-B', folder + '/build', *options], check=True, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return result.stdout


class Pitfalls(unittest.TestCase):
    def test_p04_clouds_are_read_without_the_converters_of_pcl(self):
        """They print a warning per missing field and round stamps to microseconds (P33)."""
        converter = re.compile(r'fromROSMsg|fromPCLPointCloud2|pcl_conversions|moveFromROSMsg')
        self.assertEqual([], [path for path, text in ros_layer() if converter.search(text)])

    def test_p34_the_default_build_is_an_optimised_one(self):
        self.assertIn('build type: Release', configure())

    def test_p34_another_build_is_warned_of(self):
        self.assertIn('many times slower', ' '.join(configure('-DCMAKE_BUILD_TYPE=Debug').split()))
        self.assertNotIn('slower', configure('-DCMAKE_BUILD_TYPE=RelWithDebInfo'))

    def test_p58_paths_with_spaces_stay_one_argument(self):
        """roslaunch splits the arguments of a program as a shell does, so every path in them is quoted."""
        for path in sorted((ROOT / 'launch').glob('*.launch')):
            for node in xml.etree.ElementTree.parse(path).iter('node'):
                args = ' '.join(node.get('args', '').split())
                with self.subTest(file=path.name, args=args):
                    self.assertNotRegex(args, r'''(?<!')\$\(arg \w*(bag|config|file|model)\)''')
                    self.assertNotRegex(args, r'''\+ bag\b(?! \+ '")''')


if __name__ == '__main__':
    unittest.main()
