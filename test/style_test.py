#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks what clang-format leaves open, in every C++ file: braces one way, the two licence lines, files of one idea.

Braces: a statement without them stands on the line of its if, for, while or else; any other has them. clang-tidy says
the same (.clang-tidy), but would have to parse ROS and LibTorch for every source.
"""
import pathlib
import re
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ['include', 'src', 'test', 'benchmark', 'examples', 'fuzz']
MAX_LINES = 300

# Comments and literals are blanked out, so that nothing in them counts; lines stay where they are.
IGNORED = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.DOTALL)
KEYWORD = re.compile(r'(?<!#)\b(?:(if|for|while|switch)\b(?:\s+constexpr)?\s*\(|(else|do)\b)')


def blank(match):
    return re.sub(r'[^\n]', ' ', match.group())


def end_of_parentheses(text, start):
    """Position behind the parenthesis that closes the one before `start`."""
    depth = 1
    while depth > 0 and start < len(text):
        depth += {'(': 1, ')': -1}.get(text[start], 0)
        start += 1
    return start


def statements_without_braces(text):
    """Yields the lines of if, for, while and else whose statement stands on a later line without braces."""
    text = IGNORED.sub(blank, text)
    text = re.sub(r'^[ \t]*#.*(?:\\\n.*)*', blank, text, flags=re.MULTILINE)  # the preprocessor's #if and #else
    for keyword in KEYWORD.finditer(text):
        end = end_of_parentheses(text, keyword.end()) if keyword.group(1) else keyword.end()
        rest = text[end:]
        statement = rest.lstrip()
        begins_later = '\n' in rest[:len(rest) - len(statement)]
        if statement.startswith('{'):
            continue
        nested = KEYWORD.match(statement)  # `else if`, `for (...) if (...)`: that one is looked at on its own
        if begins_later or (not nested and '\n' in statement[:statement.find(';')]):
            yield text.count('\n', 0, keyword.start()) + 1


def sources(root):
    return sorted(path for folder in FOLDERS for path in (root / folder).rglob('*') if path.suffix in ('.hpp', '.cpp'))


def violations(root):
    found = []
    for path in sources(root):
        text = path.read_text(encoding='utf-8')
        name = path.relative_to(root)
        found += [f'{name}:{line}: a statement on a line of its own needs braces'
                  for line in statements_without_braces(text)]
        if not re.match(r'// SPDX-FileCopyrightText: .+\n// SPDX-License-Identifier: BSD-3-Clause\n', text):
            found.append(f'{name}:1: does not begin with the two SPDX lines')
        if text.count('\n') > MAX_LINES:
            found.append(f'{name}: has {text.count(chr(10))} lines, more than {MAX_LINES}')
    return found


class Style(unittest.TestCase):
    def test_project(self):
        self.assertGreater(len(sources(ROOT)), 100, 'the sources were not found')
        found = violations(ROOT)
        self.assertEqual(found, [], '\n' + '\n'.join(found))


class Planted(unittest.TestCase):
    """The check itself: it accepts what is allowed and finds what is not."""

    def test_braces(self):
        for text, expected in [
                ('if (a) return;\n', []),
                ('if (a) {\n  b();\n}\n', []),
                ('if (f(a, (b)))\n  return;\n', [1]),
                ('if (a) return f(b,\n                c);\n', [1]),
                ('for (int i = 0; i < n; ++i) if (a[i]) b();\n', []),
                ('for (int i = 0; i < n; ++i)\n  if (a[i]) b();\n', [1]),
                ('if (a) {\n} else if (b) {\n} else {\n}\n', []),
                ('if (a) {\n} else\n  b();\n', [2]),
                ('while (a) b();  // no more\n', []),
                ('while (a)  // a remark\n  b();\n', [1]),
                ('do {\n} while (a);\n', []),
                ('#if A\n#else\nx();\n#endif\n', []),
                ('// if (a)\n//   b();\nf("if (");\n', []),
                ('if constexpr (a) return;\n', []),
                ('if (char c = \'(\'; a)\n  return;\n', [1])]:
            with self.subTest(text=text):
                self.assertEqual(list(statements_without_braces(text)), expected)

    def test_licence_and_length(self):
        head = '// SPDX-FileCopyrightText: 2026 x\n// SPDX-License-Identifier: BSD-3-Clause\n'
        for text, expected in [(head, 0), ('int x;\n', 1), (head + MAX_LINES * '\n', 1)]:
            with self.subTest(text=text[:20]), tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder) / 'src' / 'a.cpp'
                path.parent.mkdir()
                path.write_text(text, encoding='utf-8')
                self.assertEqual(len(violations(pathlib.Path(folder))), expected)


if __name__ == '__main__':
    unittest.main()
