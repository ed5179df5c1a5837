#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python module of planners on a running node."""
import itertools
import pathlib
import subprocess
import unittest

import numpy as np
import rospy
import rostest
from geometry_msgs.msg import Vector3
from rigidformer_ros import planning
from rigidformer_ros.msg import BatchRequest, ObjectClouds, Region
from rigidformer_ros.srv import GetModelInfo


def box(edge):
    """The surface of a cube about the origin, [54, 3]."""
    grid = [p for p in itertools.product((-1.0, 0.0, 1.0), repeat=3) if max(map(abs, p)) == 1.0]
    return 0.5 * edge * np.array(grid)


def scene():
    clouds = ObjectClouds(ids=['left', 'right'])
    clouds.header.stamp = rospy.Time(100)
    clouds.clouds = [planning.to_cloud(box(1.0) + [x, 0.0, 0.501]) for x in (0.0, 1.4)]
    clouds.properties = [planning.to_properties(1.0, 0.5, 0.2)] * 2
    return clouds


class PlanningModule(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('planning_module_test')
        rospy.wait_for_service('get_model_info', 60.0)
        info = rospy.ServiceProxy('get_model_info', GetModelInfo)
        while not rospy.is_shutdown() and not info().ready:
            rospy.sleep(0.2)

    def test_arrays_in_and_out(self):
        pushes = np.array([[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]])
        candidates = [planning.candidate(impulses=[planning.impulse('left', push)]) for push in pushes]
        candidates.append(planning.candidate(removed=['nobody']))
        candidates.append(planning.candidate(tracks=[
            planning.track('finger', [0.0, 1.0], [[-0.7, 0.0, 0.5], [0.3, 0.0, 0.5]], points=box(0.3), friction=0.5)]))
        candidates.append(planning.candidate(overrides=[planning.override('left', pose=[0.0, -3.0, 2.0])]))
        outcomes = planning.Planner().rollouts(candidates, num_steps=8, engine=True, poses=True, scene=scene())
        self.assertEqual([True, True, True, False, True, True], list(outcomes.ok))
        self.assertIn('nobody', outcomes.errors[3])
        ends = outcomes.end_poses('left')
        self.assertEqual((6, 7), ends.shape)
        self.assertTrue(np.isnan(ends[3]).all())
        start = np.array(outcomes.poses('left')[0][0, :3])
        moved = ends[:, :3] - start
        self.assertLess(np.linalg.norm(moved[0]), 0.01)
        self.assertGreater(moved[1, 0], 0.05)
        self.assertGreater(moved[2, 1], 0.05)
        self.assertGreater(moved[4, 0], 0.02)
        self.assertAlmostEqual(-3.0, ends[5, 1], places=2)
        self.assertEqual((9, 7), outcomes.poses('left')[1].shape)
        self.assertEqual(0, outcomes.first_contact_step('left')[0])
        self.assertEqual(-1, outcomes.first_contact_step('left')[3])
        self.assertTrue(np.isnan(outcomes.max_tilt('left')[3]))
        self.assertGreater(outcomes.path_length('left')[1], 0.05)

    def test_particles_tell_probabilities(self):
        unknown = scene()
        unknown.properties = []
        push = planning.override('left', linear=[3.0, 0.0, 0.0], mass=1.0)
        regions = [Region('all', planning.to_pose([0, 0, 0]), Vector3(1e3, 1e3, 1e3)),
                   Region('none', planning.to_pose([5e3, 0, 0]), Vector3(1e3, 1e3, 1e3))]
        candidates = [planning.candidate(), planning.candidate(overrides=[push]), planning.candidate(removed=['nobody'])]
        options = dict(num_steps=12, engine=True, scene=unknown, regions=regions, tilt_limit=3.0)
        outcomes = planning.Planner().rollouts(candidates, particles=6, seed=3, **options)
        np.testing.assert_array_equal([1.0, 1.0, np.nan], outcomes.in_region('left'))
        np.testing.assert_array_equal([0.0, 0.0, np.nan], outcomes.in_region('left', 1))
        np.testing.assert_array_equal([0.0, 0.0, np.nan], outcomes.tilted('left'))
        np.testing.assert_array_equal([1.0, 0.0], outcomes.settled('left')[:2])
        again = planning.Planner().rollouts(candidates[1:2], particles=6, seed=3, **options)
        self.assertEqual(str(outcomes.message.results[1]), str(again.message.results[0]), 'one seed, the same worlds')
        without = planning.Planner().rollouts(candidates, particles=1, **options)
        self.assertTrue(np.isnan(without.in_region('left')).all())
        self.assertTrue(np.isnan(without.settled('left')).all())
        request = BatchRequest(num_steps=12, candidates=candidates[1:2], fidelity=BatchRequest.ENGINE, scene=unknown,
                               num_particles=6, return_particles=True)
        ends = planning.Planner().ask(request).message.results[0].objects[0].particle_end_poses
        self.assertEqual(6, len({end.position.x for end in ends}), 'each slides as far as its friction lets it')

    def test_the_examples_push_what_the_node_sees(self):
        publisher = rospy.Publisher('object_clouds', ObjectClouds, queue_size=1)
        shown = scene()
        for _ in range(20):
            shown.header.stamp = rospy.Time.now()
            publisher.publish(shown)
            rospy.sleep(0.05)
        root = pathlib.Path(__file__).resolve().parents[3]
        for program in (['rosrun', 'rigidformer_ros', 'push_planner'], [str(root / 'examples/planning/push_planner.py')]):
            done = subprocess.run(program + ['left', '-1.0', '0.0', '1.0'], capture_output=True, text=True, check=False,
                                  timeout=120)
            self.assertEqual(0, done.returncode, done.stderr)
            self.assertIn('from the goal', done.stdout)

    def test_an_error_of_the_request_is_raised(self):
        with self.assertRaises(planning.PlanningError) as caught:
            planning.Planner().rollouts([], scene=scene())
        self.assertIn('candidates', str(caught.exception))
        with self.assertRaises(planning.PlanningError):
            planning.Planner('no_such_service', timeout=0.2).rollouts([planning.candidate()])


if __name__ == '__main__':
    rostest.rosrun('rigidformer_ros', 'planning_module', PlanningModule)
