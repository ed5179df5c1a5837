#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks names and braces with clang-tidy 14 as .clang-tidy says. Any finding is a failure.

All headers of the project go through it as one translation unit, which parses ROS, Eigen and LibTorch once: seconds,
and every type, function and member is seen. --sources checks every source as well, each of which parses them again:
minutes. Needs a build made by scripts/build.sh.
"""
import argparse
import json
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
CONFIG = (ROOT / '.clang-tidy').read_text(encoding='utf-8')
CHECKS = '-*,readability-identifier-naming,readability-braces-around-statements'
# Without these, clang 14 would warn of GCC's options and of what GCC's warnings are for.
FOR_CLANG = ['-Wno-everything', '-Qunused-arguments']
HEADER_FOLDERS = ['include', 'src', 'examples']


def include_options(commands):
    """Folders and macros of all libraries and programs together, in the order of their first use."""
    options = []
    for command in commands:
        words = shlex.split(command['command'])
        for i, word in enumerate(words):
            option = [word, words[i + 1]] if word == '-isystem' else [word]
            if word.startswith(('-I', '-D', '-isystem')) and option not in options:
                options.append(option)
    return [word for option in options for word in option]


def run(command):
    """Prints every finding once and returns how many there are; an error counts as one."""
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    output = re.sub(r'\x1b\[[0-9;]*m', '', result.stdout)  # run-clang-tidy wants colours
    findings = sorted(set(re.findall(r'^/\S+:\d+:\d+: (?:warning|error): .*$', output, re.MULTILINE)))
    print(*findings, sep='\n', end='\n' if findings else '')
    if result.returncode != 0 and not findings:
        print(output)
    return max(len(findings), int(result.returncode != 0))


def check_headers(workspace, commands, header_filter):
    headers = sorted(path for folder in HEADER_FOLDERS for path in (ROOT / folder).rglob('*.hpp'))
    unit = workspace / 'tidy' / 'headers.cpp'
    unit.parent.mkdir(exist_ok=True)
    unit.write_text(''.join(f'#include "{path}"\n' for path in headers), encoding='utf-8')
    print(f'tidy: {len(headers)} headers', flush=True)
    return run(['clang-tidy-14', '--quiet', f'--checks={CHECKS}', f'--config={CONFIG}',
                f'--header-filter={header_filter}', str(unit), '--', '-std=c++17', *FOR_CLANG,
                *include_options(commands)])


def check_sources(build, commands, header_filter, jobs):
    files = sorted({command['file'] for command in commands if 'cmake_pch' not in command['file']})
    print(f'tidy: {len(files)} sources', flush=True)
    return run(['run-clang-tidy-14', '-quiet', f'-j{jobs}', f'-p={build}', f'-checks={CHECKS}', f'-config={CONFIG}',
                f'-header-filter={header_filter}', *(f'-extra-arg={word}' for word in FOR_CLANG),
                *map(re.escape, files)])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--workspace', type=pathlib.Path, default=ROOT / 'build' / 'catkin_ws')
    parser.add_argument('--sources', action='store_true', help='every source as well')
    parser.add_argument('--jobs', type=int, default=2)
    arguments = parser.parse_args()
    workspace = arguments.workspace.resolve()
    build = workspace / 'build'
    commands = json.loads((build / 'compile_commands.json').read_text(encoding='utf-8'))
    header_filter = f'^({re.escape(str(ROOT))}|{re.escape(str(workspace))}/src/rigidformer_ros)/'
    findings = check_headers(workspace, commands, header_filter)
    if arguments.sources:
        findings += check_sources(build, commands, header_filter, arguments.jobs)
    print(f'tidy: {findings} findings')
    return 1 if findings else 0


if __name__ == '__main__':
    sys.exit(main())
