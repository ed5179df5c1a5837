#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks what a release relies on: one version everywhere, and a CHANGELOG.rst that catkin's tools read whole."""
import pathlib
import re
import unittest

import yaml
from catkin_pkg.changelog import Changelog, populate_changelog_from_rst
from catkin_pkg.package import parse_package
from catkin_pkg.package_version import get_forthcoming_label, rename_section

ROOT = pathlib.Path(__file__).resolve().parent.parent


def text_of(name):
    return (ROOT / name).read_text(encoding='utf-8')


class Release(unittest.TestCase):
    def test_one_version(self):
        version = parse_package(str(ROOT)).version
        self.assertEqual(re.search(r'project\(\w+ VERSION ([\d.]+)', text_of('CMakeLists.txt')).group(1), version)
        self.assertEqual(yaml.safe_load(text_of('CITATION.cff'))['version'], version)

    def test_changelog_has_the_version_or_what_is_to_come(self):
        self.assertRegex(text_of('CHANGELOG.rst'),
                         r'(?m)^(Forthcoming|%s \(.+\))$' % re.escape(parse_package(str(ROOT)).version))

    def test_no_line_of_the_changelog_gets_lost(self):
        rst = text_of('CHANGELOG.rst')
        label = get_forthcoming_label(rst)
        if label:  # as catkin_prepare_release does it
            rst = rename_section(rst, label, '99.0.0 (2099-01-01)')
        changelog = Changelog('rigidformer_ros')
        populate_changelog_from_rst(changelog, rst)
        self.assertEqual(len(re.findall(r'^\* ', rst, re.MULTILINE)),
                         len(re.findall(r'^ *[*-] ', str(changelog), re.MULTILINE)))


if __name__ == '__main__':
    unittest.main()
