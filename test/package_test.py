#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that package.xml names what the package uses, with keys that rosdep has on Ubuntu 20.04, the system of ROS
Noetic."""
import pathlib
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Keys without a package on Ubuntu 20.04 (null in rosdep's base.yaml): `rosdep install` stops at each of them.
NOTHING_ON_FOCAL = {'cli11', 'libnanoflann-dev'}
# What CMake looks for or a program runs, as text in a file, and its key.
USED = {
    'libqhull': ('cmake/Dependencies.cmake', 'libqhull'),
    'gnuplot': ('src/rigidformer/io/gnuplot.cpp', 'exec gnuplot'),
    'bullet': ('cmake/Dependencies.cmake', 'Bullet'),
    'yaml-cpp': ('cmake/Dependencies.cmake', 'yaml-cpp'),
    'libpcl-all-dev': ('cmake/Dependencies.cmake', 'PCL'),
}


def keys():
    root = ElementTree.parse(ROOT / 'package.xml').getroot()
    return {element.text for element in root if element.tag.endswith('depend')}


class Package(unittest.TestCase):
    def test_keys_stand_for_packages(self):
        self.assertEqual(keys() & NOTHING_ON_FOCAL, set())

    def test_what_is_used_is_declared(self):
        for key, (file, text) in USED.items():
            with self.subTest(key=key):
                self.assertIn(text, (ROOT / file).read_text(encoding='utf-8'))
                self.assertIn(key, keys())


if __name__ == '__main__':
    unittest.main()
