#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts the test cases of all JUnit files below a folder: prints "<passed> <failed> <skipped>".

Names every failed case on stderr. A file that cannot be read counts as one failure, and so does every expected file
that is missing:  count_tests.py FOLDER [EXPECTED_FILE...]
"""
import pathlib
import sys
import xml.etree.ElementTree as ElementTree


def count_file(path):
    """Returns (passed, failed, skipped) of one file."""
    try:
        suite = ElementTree.parse(path).getroot()
    except (ElementTree.ParseError, OSError) as error:
        print(f"unreadable test result {path}: {error}", file=sys.stderr)
        return 0, 1, 0
    passed = failed = skipped = 0
    for case in suite.iter("testcase"):
        if case.find("failure") is not None or case.find("error") is not None:
            failed += 1
            print(f"FAILED {path.stem}: {case.get('classname')}.{case.get('name')}", file=sys.stderr)
        elif case.find("skipped") is not None or case.get("status") == "notrun" or case.get("result") == "skipped":
            skipped += 1
        else:
            passed += 1
    return passed, failed, skipped


def main():
    folder, expected = pathlib.Path(sys.argv[1]), sys.argv[2:]
    files = sorted(folder.rglob("*.xml"))
    totals = [sum(column) for column in zip((0, 0, 0), *map(count_file, files))]
    for name in expected:
        if not any(path.name == name for path in files):
            print(f"FAILED: no test result {name}", file=sys.stderr)
            totals[1] += 1
    print(*totals)


if __name__ == "__main__":
    main()
