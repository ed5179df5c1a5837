#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks who includes whom: a layer of the core may include itself and the layers before it, and the heavy libraries
(ROS, PCL, Bullet, MuJoCo, Qhull, LibTorch) appear only where ALLOWED says.  layering_test.py [JUNIT_XML]"""
import pathlib
import re
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent

# From the lowest layer to the highest. `predictor` is the files predictor.* and predictor_*.*.
LAYERS = ['io', 'geometry', 'scene', 'data', 'simulation', 'model', 'engine', 'predictor', 'windows', 'training',
          'evaluation', 'baselines']

LIBRARIES = {
    'ROS': re.compile(r'(ros|tf2?|tf2_\w+|\w+_msgs|std_srvs|message_filters|nodelet|pluginlib|dynamic_reconfigure|'
                      r'actionlib|diagnostic_updater|rigidformer_ros)/'),
    'PCL': re.compile(r'(pcl|pcl_\w+)/'),
    'Bullet': re.compile(r'(bullet/)?((LinearMath|BulletCollision|BulletDynamics|BulletSoftBody|HACD)/|bt[A-Z])'),
    'MuJoCo': re.compile(r'mujoco/'),
    'Qhull': re.compile(r'libqhull\w*/'),
    'LibTorch': re.compile(r'(torch|ATen|c10)/'),
}

# Which layers may use a library, in headers and in sources.
ALLOWED = {
    'Bullet': {'include': {'simulation'}, 'src': {'simulation', 'baselines'}},
    'MuJoCo': {'include': set(), 'src': {'baselines'}},
    'Qhull': {'include': set(), 'src': {'baselines'}},
    'LibTorch': {'include': {'model', 'engine', 'windows', 'training'},
                 'src': {'model', 'engine', 'windows', 'training', 'evaluation', 'predictor'}},
}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def layer_of(path_in_core):
    """'geometry/x.hpp' -> 'geometry', 'predictor.hpp' -> 'predictor'."""
    first = pathlib.PurePath(path_in_core).parts[0]
    return 'predictor' if re.fullmatch(r'predictor(_\w+)?\.\w+', first) else first


def sources(folder):
    return sorted(path for path in folder.rglob('*') if path.suffix in ('.hpp', '.h', '.cpp', '.cu', '.ipp'))


def library_of(include):
    return next((name for name, pattern in LIBRARIES.items() if pattern.match(include)), None)


def check_file(path, layer, kind):
    """Yields one sentence per include of `path` that the layer may not have."""
    for include in INCLUDE.findall(path.read_text(encoding='utf-8')):
        library = library_of(include)
        if library and layer not in ALLOWED.get(library, {}).get(kind, set()):
            yield f'{path}: layer {layer} ({kind}) includes <{include}> of {library}'
        if include.startswith('rigidformer/'):
            other = layer_of(include[len('rigidformer/'):])
            if other not in LAYERS:
                yield f'{path}: includes {include} of the unknown layer {other}'
            elif LAYERS.index(other) > LAYERS.index(layer):
                yield f'{path}: layer {layer} includes {include} of the higher layer {other}'


def violations(root):
    found = []
    for kind in ('include', 'src'):
        core = root / kind / 'rigidformer'
        for path in sources(core):
            layer = layer_of(path.relative_to(core))
            found += check_file(path, layer, kind) if layer in LAYERS else [f'{path}: unknown layer {layer}']
        for path in sources(root / kind / 'rigidformer_ros'):
            for include in INCLUDE.findall(path.read_text(encoding='utf-8')):
                if library_of(include) in ('LibTorch', 'Bullet', 'MuJoCo', 'Qhull'):
                    found.append(f'{path}: the ROS layer includes <{include}> of {library_of(include)}')
    return found


class Layering(unittest.TestCase):
    def test_project(self):
        self.assertGreater(len(sources(ROOT / 'include' / 'rigidformer')), 5, 'the headers were not found')
        self.assertEqual(violations(ROOT), [])


class Planted(unittest.TestCase):
    """The check itself: it accepts what is allowed and finds what is not."""

    def violations_of(self, path, include):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / path
            file.parent.mkdir(parents=True)
            file.write_text(f'// a comment\n#include <vector>\n{include}\nint x;\n', encoding='utf-8')
            return violations(pathlib.Path(folder))

    def test_forbidden(self):
        for path, include in [
                ('include/rigidformer/geometry/a.hpp', '#include <ros/ros.h>'),
                ('include/rigidformer/scene/a.hpp', '#include <sensor_msgs/PointCloud2.h>'),
                ('src/rigidformer/evaluation/a.cpp', '#include "rigidformer_ros/names.hpp"'),
                ('src/rigidformer/geometry/a.cpp', '#include <pcl/point_types.h>'),
                ('src/rigidformer/geometry/a.cpp', '#  include <pcl_conversions/pcl_conversions.h>'),
                ('src/rigidformer/data/a.cpp', '#include <btBulletDynamicsCommon.h>'),
                ('src/rigidformer/data/a.cpp', '#include <bullet/LinearMath/btVector3.h>'),
                ('src/rigidformer/data/a.cpp', '#include <torch/torch.h>'),
                ('src/rigidformer/simulation/a.cpp', '#include <mujoco/mujoco.h>'),
                ('include/rigidformer/baselines/a.hpp', '#include <mujoco/mjmodel.h>'),
                ('include/rigidformer/baselines/a.hpp', '#include <btBulletDynamicsCommon.h>'),
                ('src/rigidformer/simulation/a.cpp', '#include <libqhull_r/qhull_ra.h>'),
                ('src/rigidformer/evaluation/a.cpp', '#include <HACD/hacdHACD.h>'),
                ('src/rigidformer/evaluation/a.cpp', '#include "rigidformer/baselines/a.hpp"'),
                ('src/rigidformer/simulation/a.cpp', '#include <ATen/ATen.h>'),
                ('include/rigidformer/predictor.hpp', '#include <torch/types.h>'),
                ('include/rigidformer/evaluation/a.hpp', '#include <c10/util/Half.h>'),
                ('include/rigidformer/io/a.hpp', '#include "rigidformer/geometry/rigid_transform.hpp"'),
                ('src/rigidformer/model/a.cpp', '#include "rigidformer/predictor.hpp"'),
                ('src/rigidformer/training/a.cpp', '#include "rigidformer/evaluation/metrics.hpp"'),
                ('src/rigidformer/scene/a.cpp', '#include "rigidformer/nowhere/a.hpp"'),
                ('src/rigidformer/nowhere/a.cpp', '#include <string>'),
                ('src/rigidformer_ros/a.cpp', '#include <torch/torch.h>')]:
            with self.subTest(path=path, include=include):
                self.assertEqual(len(self.violations_of(path, include)), 1)

    def test_allowed(self):
        for path, include in [
                ('src/rigidformer/simulation/a.cpp', '#include <btBulletDynamicsCommon.h>'),
                ('src/rigidformer/baselines/a.cpp', '#include <btBulletDynamicsCommon.h>'),
                ('src/rigidformer/baselines/a.cpp', '#include <mujoco/mujoco.h>'),
                ('src/rigidformer/predictor.cpp', '#include <torch/torch.h>'),
                ('src/rigidformer/predictor_rollout.cpp', '#include "rigidformer/predictor.hpp"'),
                ('include/rigidformer/model/a.hpp', '#include <torch/nn.h>'),
                ('src/rigidformer/evaluation/a.cpp', '#include "rigidformer/predictor.hpp"'),
                ('include/rigidformer/scene/a.hpp', '#include "rigidformer/scene/b.hpp"'),
                ('src/rigidformer/scene/a.cpp', '// #include <ros/ros.h>'),
                ('src/rigidformer_ros/a.cpp', '#include <ros/ros.h>')]:
            with self.subTest(path=path, include=include):
                self.assertEqual(self.violations_of(path, include), [])


def write_junit(path, cases, broken):
    """One test case each, failed when it is a key of `broken`: the format that the C++ tests write too."""
    suite = ElementTree.Element('testsuite', name='layering_test', tests=str(len(cases)), failures=str(len(broken)))
    for name in cases:
        case = ElementTree.SubElement(suite, 'testcase', classname='layering', name=name)
        if name in broken:
            ElementTree.SubElement(case, 'failure').text = broken[name]
    path.parent.mkdir(parents=True, exist_ok=True)
    ElementTree.ElementTree(suite).write(path)


def main():
    suite = unittest.defaultTestLoader.loadTestsFromModule(sys.modules['__main__'])
    cases = [case.id() for group in suite for case in group]
    result = unittest.TextTestRunner().run(suite)
    # A failed subtest carries its parameters behind the name of its case.
    broken = {case.id().split(' ')[0]: trace for case, trace in result.failures + result.errors}
    if len(sys.argv) > 1:
        write_junit(pathlib.Path(sys.argv[1]), cases, broken)
    return 1 if broken else 0


if __name__ == '__main__':
    sys.exit(main())
