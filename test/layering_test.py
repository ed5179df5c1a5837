#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks who includes whom. A layer of the core may include itself and the layers before it, a room of the node
itself, the rooms before it and the core; the heavy libraries (ROS, PCL, Bullet, MuJoCo, Qhull, LibTorch) appear only
where ALLOWED says; public headers include public headers only.  layering_test.py [JUNIT_XML]"""
import pathlib
import re
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent

# From the lowest to the highest. The layer `predictor` is the files of FACADE.
LAYERS = ['io', 'geometry', 'scene', 'data', 'simulation', 'tracking', 'model', 'engine', 'predictor', 'windows',
          'training', 'evaluation', 'baselines']
FACADE = {'predictor', 'rollout', 'candidates', 'candidate_batch', 'candidate_objects', 'doubt', 'length_scale',
          'network_rollout', 'network_steps', 'particle_batch', 'particles', 'perceived_objects', 'rollout_record',
          'rollout_world', 'standing', 'step_parts', 'stop_rules', 'usable_rollout', 'world_contacts'}
ROOMS = ['messages', 'parameters', 'forecast', 'health', 'inputs', 'services', 'outputs', 'node', 'simulated']
SIMULATED = ['playback', 'demo', 'camera', 'accuracy']

# What a robot's own project compiles against has to stay small enough to read.
MAX_PUBLIC_HEADERS = 47

LIBRARIES = {
    'ROS': re.compile(r'(ros|tf2?|tf2_\w+|\w+_msgs|std_srvs|message_filters|nodelet|pluginlib|dynamic_reconfigure|'
                      r'actionlib|diagnostic_updater|rigidformer_ros)/'),
    'PCL': re.compile(r'(pcl|pcl_\w+)/'),
    'Bullet': re.compile(r'(bullet/)?((LinearMath|BulletCollision|BulletDynamics|BulletSoftBody|HACD)/|bt[A-Z])'),
    'MuJoCo': re.compile(r'mujoco/'),
    'Qhull': re.compile(r'libqhull\w*/'),
    'LibTorch': re.compile(r'(torch|ATen|c10)/'),
}

# Which layers of the core may use a library, in headers beside sources and in sources. No public header does.
ALLOWED = {
    'Bullet': {'header': {'simulation'}, 'source': {'simulation', 'baselines'}},
    'MuJoCo': {'header': set(), 'source': {'simulation'}},
    'Qhull': {'header': set(), 'source': {'baselines'}},
    'LibTorch': {'header': {'model', 'engine', 'predictor', 'windows', 'training'},
                 'source': {'model', 'engine', 'predictor', 'windows', 'training', 'evaluation'}},
}
NODE_LIBRARIES = {'ROS'}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def layer_of(path_in_core):
    """'geometry/x.hpp' -> 'geometry', 'predictor.hpp' -> 'predictor'."""
    path = pathlib.PurePath(path_in_core)
    return 'predictor' if len(path.parts) == 1 and path.stem in FACADE else path.parts[0]


def kind_of(path, root):
    if (root / 'include') in path.parents:
        return 'public'
    return 'source' if path.suffix == '.cpp' else 'header'


def sources(folder):
    return sorted(path for path in folder.rglob('*') if path.suffix in ('.hpp', '.h', '.cpp', '.cu', '.ipp'))


def library_of(include):
    return next((name for name, pattern in LIBRARIES.items() if pattern.match(include)), None)


def includes_of(path):
    """[(header, is quoted)]: ROS's generated messages lie in rigidformer_ros/ too, and come in angle brackets."""
    return [(header, mark == '"') for mark, header in INCLUDE.findall(path.read_text(encoding='utf-8'))]


def above(order, inner, outer, name):
    """A sentence where `inner` is not known or comes after `outer` in `order`, else None."""
    if inner not in order:
        return f'includes the unknown {name} {inner}'
    return f'includes the higher {name} {inner}' if order.index(inner) > order.index(outer) else None


def check_public(path, header, root):
    if header.startswith(('rigidformer/', 'rigidformer_ros/')) and not (root / 'include' / header).is_file():
        yield f'{path}: a public header includes {header}, which is not public'


def check_core(path, layer, kind, header):
    library = library_of(header)
    if library and layer not in ALLOWED.get(library, {}).get(kind, set()):
        yield f'{path}: layer {layer} ({kind}) includes {header} of {library}'
    if header.startswith('rigidformer/'):
        wrong = above(LAYERS, layer_of(header[len('rigidformer/'):]), layer, 'layer')
        if wrong:
            yield f'{path}: layer {layer} {wrong}'


def check_node(path, place, header, quoted):
    """`place`: the folders of the file inside rigidformer_ros."""
    library = library_of(header)
    if library and library not in NODE_LIBRARIES:
        yield f'{path}: the node includes {header} of {library}'
    if not quoted or not header.startswith('rigidformer_ros/'):
        return
    other = pathlib.PurePath(header).parts[1:]
    wrong = above(ROOMS, other[0], place[0], 'room')
    if not wrong and other[0] == place[0] == 'simulated':
        wrong = above(SIMULATED, other[1], place[1], 'room')
    if wrong:
        yield f'{path}: room {"/".join(place)} {wrong}'


def check_core_file(path, root, folder):
    layer = layer_of(path.relative_to(folder))
    if layer not in LAYERS:
        yield f'{path}: unknown layer {layer}'
        return
    for header, _ in includes_of(path):
        yield from check_core(path, layer, kind_of(path, root), header)


def check_node_file(path, root, folder):
    place = path.relative_to(folder).parts[:-1]
    if not place or place[0] not in ROOMS or (place[0] == 'simulated' and place[1:2] not in [(s,) for s in SIMULATED]):
        yield f'{path}: unknown room {"/".join(place)}'
        return
    for header, quoted in includes_of(path):
        yield from check_node(path, place, header, quoted)


def violations(root):
    found = []
    for base in ('include', 'src'):
        for name, check in (('rigidformer', check_core_file), ('rigidformer_ros', check_node_file)):
            for path in sources(root / base / name):
                found += check(path, root, root / base / name)
    for path in sources(root / 'include'):
        for header, quoted in includes_of(path):
            found += check_public(path, header, root) if quoted else []
    return found


class Layering(unittest.TestCase):
    def test_project(self):
        self.assertGreater(len(sources(ROOT / 'src' / 'rigidformer')), 50, 'the sources were not found')
        self.assertEqual(violations(ROOT), [])

    def test_every_layer_and_room_exists(self):
        for layer in set(LAYERS) - {'predictor'}:
            self.assertTrue((ROOT / 'src' / 'rigidformer' / layer).is_dir(), layer)
        for room in ROOMS:
            self.assertTrue((ROOT / 'src' / 'rigidformer_ros' / room).is_dir(), room)

    def test_public_headers_are_few(self):
        self.assertLessEqual(len(sources(ROOT / 'include')), MAX_PUBLIC_HEADERS)


class Planted(unittest.TestCase):
    """The check itself: it accepts what is allowed and finds what is not."""

    def violations_of(self, path, include, other=None):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / path
            file.parent.mkdir(parents=True)
            file.write_text(f'// a comment\n#include <vector>\n{include}\nint x;\n', encoding='utf-8')
            if other:
                beside = pathlib.Path(folder) / other
                beside.parent.mkdir(parents=True, exist_ok=True)
                beside.write_text('int y;\n', encoding='utf-8')
            return violations(pathlib.Path(folder))

    def test_forbidden(self):
        for path, include in [
                ('src/rigidformer/geometry/a.hpp', '#include <ros/ros.h>'),
                ('src/rigidformer/tracking/a.cpp', '#include <ros/time.h>'),
                ('src/rigidformer/scene/a.hpp', '#include <sensor_msgs/PointCloud2.h>'),
                ('src/rigidformer/evaluation/a.cpp', '#include "rigidformer_ros/messages/names.hpp"'),
                ('src/rigidformer/geometry/a.cpp', '#include <pcl/point_types.h>'),
                ('src/rigidformer/geometry/a.cpp', '#  include <pcl_conversions/pcl_conversions.h>'),
                ('src/rigidformer/data/a.cpp', '#include <btBulletDynamicsCommon.h>'),
                ('src/rigidformer/data/a.cpp', '#include <bullet/LinearMath/btVector3.h>'),
                ('src/rigidformer/data/a.cpp', '#include <torch/torch.h>'),
                ('src/rigidformer/baselines/a.cpp', '#include <mujoco/mujoco.h>'),
                ('src/rigidformer/simulation/a.hpp', '#include <mujoco/mjmodel.h>'),
                ('src/rigidformer/baselines/a.hpp', '#include <btBulletDynamicsCommon.h>'),
                ('src/rigidformer/simulation/a.cpp', '#include <libqhull_r/qhull_ra.h>'),
                ('src/rigidformer/evaluation/a.cpp', '#include <HACD/hacdHACD.h>'),
                ('src/rigidformer/evaluation/a.cpp', '#include "rigidformer/baselines/a.hpp"'),
                ('src/rigidformer/tracking/a.cpp', '#include "rigidformer/model/a.hpp"'),
                ('src/rigidformer/simulation/a.cpp', '#include <ATen/ATen.h>'),
                ('src/rigidformer/evaluation/a.hpp', '#include <c10/util/Half.h>'),
                ('include/rigidformer/predictor.hpp', '#include <torch/types.h>'),
                ('include/rigidformer/model/a.hpp', '#include <torch/nn.h>'),
                ('include/rigidformer/simulation/a.hpp', '#include <btBulletDynamicsCommon.h>'),
                ('include/rigidformer/scene/a.hpp', '#include "rigidformer/io/private.hpp"'),
                ('src/rigidformer/io/a.hpp', '#include "rigidformer/geometry/rigid_transform.hpp"'),
                ('src/rigidformer/model/a.cpp', '#include "rigidformer/predictor.hpp"'),
                ('src/rigidformer/engine/a.cpp', '#include "rigidformer/network_rollout.hpp"'),
                ('src/rigidformer/training/a.cpp', '#include "rigidformer/evaluation/metrics.hpp"'),
                ('src/rigidformer/scene/a.cpp', '#include "rigidformer/nowhere/a.hpp"'),
                ('src/rigidformer/nowhere/a.cpp', '#include <string>'),
                ('src/rigidformer_ros/a.cpp', '#include <string>'),
                ('src/rigidformer_ros/cellar/a.cpp', '#include <string>'),
                ('src/rigidformer_ros/simulated/a.cpp', '#include <string>'),
                ('src/rigidformer_ros/node/a.cpp', '#include <torch/torch.h>'),
                ('src/rigidformer_ros/inputs/a.cpp', '#include <pcl/point_types.h>'),
                ('src/rigidformer_ros/messages/a.cpp', '#include "rigidformer_ros/parameters/parameters.hpp"'),
                ('src/rigidformer_ros/inputs/a.cpp', '#include "rigidformer_ros/services/a.hpp"'),
                ('src/rigidformer_ros/node/a.cpp', '#include "rigidformer_ros/simulated/demo/a.hpp"'),
                ('src/rigidformer_ros/node/a.cpp', '#include "rigidformer_ros/cellar/a.hpp"'),
                ('src/rigidformer_ros/simulated/demo/a.cpp', '#include "rigidformer_ros/simulated/camera/a.hpp"')]:
            with self.subTest(path=path, include=include):
                self.assertEqual(len(self.violations_of(path, include)), 1)

    def test_allowed(self):
        for path, include in [
                ('src/rigidformer/simulation/a.cpp', '#include <btBulletDynamicsCommon.h>'),
                ('src/rigidformer/simulation/a.cpp', '#include <mujoco/mujoco.h>'),
                ('src/rigidformer/simulation/a.hpp', '#include <btBulletDynamicsCommon.h>'),
                ('src/rigidformer/baselines/a.cpp', '#include <btBulletDynamicsCommon.h>'),
                ('src/rigidformer/predictor.cpp', '#include <torch/torch.h>'),
                ('src/rigidformer/network_rollout.cpp', '#include "rigidformer/engine/engine_step.hpp"'),
                ('src/rigidformer/model/a.hpp', '#include <torch/nn.h>'),
                ('src/rigidformer/evaluation/a.cpp', '#include "rigidformer/predictor.hpp"'),
                ('src/rigidformer/scene/a.hpp', '#include "rigidformer/scene/b.hpp"'),
                ('src/rigidformer/scene/a.cpp', '// #include <ros/ros.h>'),
                ('src/rigidformer_ros/messages/a.cpp', '#include "rigidformer/tracking/track_store.hpp"'),
                ('src/rigidformer_ros/messages/a.cpp', '#include <rigidformer_ros/PredictRollout.h>'),
                ('src/rigidformer_ros/outputs/a.cpp', '#include "rigidformer_ros/inputs/a.hpp"'),
                ('src/rigidformer_ros/simulated/camera/a.cpp', '#include "rigidformer_ros/simulated/playback/a.hpp"'),
                ('src/rigidformer_ros/node/a.cpp', '#include <ros/ros.h>')]:
            with self.subTest(path=path, include=include):
                self.assertEqual(self.violations_of(path, include), [])

    def test_public_headers_may_include_each_other(self):
        self.assertEqual(self.violations_of('include/rigidformer/scene/a.hpp', '#include "rigidformer/io/b.hpp"',
                                            'include/rigidformer/io/b.hpp'), [])


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
