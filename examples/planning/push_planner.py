#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Which push brings an object nearest to a place? Random pushes of the object that the node sees are rolled out by the
engine. It needs a running node, and the object's mass [kg].  push_planner.py ID X Y MASS"""
import sys

import numpy as np
import rospy
from rigidformer_ros.planning import Planner, candidate, impulse, override

if len(sys.argv) != 5:
    sys.exit(__doc__)
rospy.init_node('push_planner', anonymous=True)
object_id, goal, mass = sys.argv[1], np.array(sys.argv[2:4], dtype=float), float(sys.argv[4])
pushes = np.random.default_rng(1).normal(0.0, 2.0, (64, 2))
candidates = [candidate(impulses=[impulse(object_id, [x, y, 0.0])]) for x, y in pushes]
assumed = candidate(overrides=[override(object_id, mass=mass)])
outcomes = Planner().rollouts(candidates, num_steps=48, engine=True, poses=True, base=assumed)  # rviz draws poses
distance = np.linalg.norm(outcomes.end_poses(object_id)[:, :2] - goal, axis=1)
if not outcomes.ok.any():
    sys.exit(outcomes.errors[0])
best = np.nanargmin(distance)
print(f'push by {pushes[best]} N s: {distance[best]:.3f} m from the goal')
