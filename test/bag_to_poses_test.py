#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the table that scripts/bag_to_poses.py makes of a bag; skips where Debian's rosbag is not installed."""
import pathlib
import subprocess
import tempfile
import unittest

try:
    import genpy
    import rosbag
    from geometry_msgs.msg import PoseStamped, TransformStamped
    from std_msgs.msg import String
    from tf2_msgs.msg import TFMessage
except ImportError:
    rosbag = None

SCRIPT = pathlib.Path(__file__).resolve().parent.parent / 'scripts' / 'bag_to_poses.py'


def pose(stamp, x):
    message = PoseStamped()
    message.header.stamp = genpy.Time.from_sec(stamp)
    message.pose.position.x = x
    message.pose.orientation.w = 1.0
    return message


def transform(stamp, x, child='die'):
    message = TransformStamped()
    message.header.stamp = genpy.Time.from_sec(stamp)
    message.header.frame_id = '/board'
    message.child_frame_id = child
    message.transform.translation.x = x
    message.transform.rotation.z = 1.0
    return message


@unittest.skipIf(rosbag is None, 'rosbag is not installed')
class BagToPoses(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.bag = pathlib.Path(self.folder.name) / 'throw_3.bag'
        with rosbag.Bag(str(self.bag), 'w') as bag:
            bag.write('/cup/pose', pose(100.5, 2.0))
            bag.write('/cup/pose', pose(100.25, 1.0))
            bag.write('/tf', TFMessage([transform(100.5, 5.0), transform(100.5, 9.0, 'hand')]))
            bag.write('/tf', TFMessage([transform(100.5, 5.0)]))
            bag.write('/words', String('no pose'))

    def run_script(self, *arguments):
        return subprocess.run([str(SCRIPT), str(self.bag), *arguments], capture_output=True, text=True, check=False)

    def test_poses_and_transforms_become_rows_in_the_order_of_time(self):
        result = self.run_script('--pose', '/cup/pose=cup', '--tf', 'board:die')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout.splitlines(), [
            'recording,t,id,x,y,z,qx,qy,qz,qw',
            'throw_3,0.000000,cup,1,0,0,0,0,0,1',
            'throw_3,0.250000,cup,2,0,0,0,0,0,1',
            'throw_3,0.250000,die,5,0,0,0,0,1,0'])

    def test_what_is_not_there_is_named(self):
        for arguments, words in [(('--pose', '/plate/pose'), 'there is no pose of /plate/pose'),
                                 (('--tf', 'board:plate'), 'there is no pose of board:plate'),
                                 (('--pose', '/words'), 'topic /words holds std_msgs/String'),
                                 (('--tf', 'board'), 'must look like PARENT:CHILD'),
                                 ((), 'name at least one --pose or --tf')]:
            with self.subTest(arguments=arguments):
                result = self.run_script(*arguments)
                self.assertNotEqual(result.returncode, 0)
                self.assertIn(words, result.stderr)


if __name__ == '__main__':
    unittest.main()
