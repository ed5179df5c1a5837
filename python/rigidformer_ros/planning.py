# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Rollouts of many candidates for planners, numpy in and out.

    planner = Planner()                                  # the node whose services lie in this namespace
    pushes = [candidate(impulses=[impulse('cup', v)]) for v in np.random.randn(64, 3)]
    outcomes = planner.rollouts(pushes, num_steps=24, engine=True)
    best = np.nanargmin(np.linalg.norm(outcomes.end_poses('cup')[:, :2] - goal, axis=1))

All units are SI; poses are rows x y z qx qy qz qw in the frame of the request.
"""
import numpy as np
import rospy
from geometry_msgs.msg import Point, Pose, Quaternion, Vector3
from rigidformer_ros.msg import (BatchRequest, Impulse, KinematicTrack, PhysicalProperties, RolloutCandidate,
                                 StateOverride)
from rigidformer_ros.srv import PredictRollouts
from sensor_msgs.msg import PointCloud2, PointField

SUCCESS = 1


class PlanningError(RuntimeError):
    """The request as a whole could not be answered; `code` is one of PredictRollout, 0 = no node answered."""

    def __init__(self, code, message):
        super().__init__(message)
        self.code = code


def to_pose(row):
    """A pose of seven numbers x y z qx qy qz qw, or of three with no rotation."""
    row = [float(value) for value in row]
    rotation = row[3:] or [0.0, 0.0, 0.0, 1.0]
    return Pose(Point(*row[:3]), Quaternion(*rotation))


def to_row(pose):
    p, q = pose.position, pose.orientation
    return [p.x, p.y, p.z, q.x, q.y, q.z, q.w]


def to_cloud(points):
    """Points [N, 3] m as a message without header."""
    points = np.ascontiguousarray(points, dtype='<f4')
    fields = [PointField(name, 4 * i, PointField.FLOAT32, 1) for i, name in enumerate('xyz')]
    return PointCloud2(height=1, width=len(points), fields=fields, point_step=12, row_step=12 * len(points),
                       data=points.tobytes(), is_dense=True)


def to_properties(mass=None, friction=None, restitution=None):
    values = (mass, friction, restitution)
    known = sum(1 << i for i, value in enumerate(values) if value is not None)
    return PhysicalProperties(known, *(0.0 if value is None else float(value) for value in values))


def impulse(object_id, linear=(0, 0, 0), time=0.0, angular=(0, 0, 0), point=(0, 0, 0)):
    """A push [N s] at a point of the object frame, `time` seconds after t0."""
    return Impulse(object_id, float(time), Vector3(*map(float, linear)), Vector3(*map(float, angular)),
                   Point(*map(float, point)))


def track(object_id, times, poses, points=None, max_speed=0.0, **properties):
    """The given motion of a body: times [T] s and poses [T, 7] or [T, 3]; `points` [N, 3] of a body nobody observes."""
    cloud = PointCloud2() if points is None else to_cloud(points)
    return KinematicTrack(object_id, cloud, to_properties(**properties), [float(t) for t in times],
                          [to_pose(row) for row in poses], float(max_speed))


def override(object_id, pose=None, linear=None, angular=None, mode=None, **properties):
    """Another state at t0; what is None stays as observed."""
    message = StateOverride(id=object_id)
    message.pose.orientation.w = 1.0
    if pose is not None:
        message.fields |= StateOverride.POSE
        message.pose = to_pose(pose)
    if linear is not None or angular is not None:
        message.fields |= StateOverride.TWIST
        message.twist.linear = Vector3(*map(float, (0, 0, 0) if linear is None else linear))
        message.twist.angular = Vector3(*map(float, (0, 0, 0) if angular is None else angular))
    if mode is not None:
        message.fields |= StateOverride.MODE
        message.mode = mode
    if properties:
        message.fields |= StateOverride.PROPERTIES
        message.properties = to_properties(**properties)
    return message


def candidate(name='', removed=(), overrides=(), impulses=(), tracks=()):
    """What shall be different from the observed scene."""
    return RolloutCandidate(name, list(removed), list(overrides), list(impulses), list(tracks))


class Outcomes:
    """The results as arrays, row i = candidate i; NaN (or -1 for steps) where a candidate failed."""

    def __init__(self, message):
        self.message = message
        self.ok = np.array([result.error_code == SUCCESS for result in message.results])
        self.errors = [result.message for result in message.results]
        self.steps_done = np.array([result.steps_done for result in message.results])
        self.times = np.array(message.times)

    def _values(self, object_id, value_of, missing):
        rows = []
        for result, ok in zip(self.message.results, self.ok):
            found = [value_of(o) for o in result.objects if o.id == object_id] if ok else []
            rows.append(found[0] if found else missing)
        return np.array(rows)

    def end_poses(self, object_id):
        """[N, 7] x y z qx qy qz qw in the fixed frame."""
        return self._values(object_id, lambda o: to_row(o.end_pose), [np.nan] * 7)

    def max_tilt(self, object_id):
        """[N] rad."""
        return self._values(object_id, lambda o: o.max_tilt, np.nan)

    def path_length(self, object_id):
        """[N] m."""
        return self._values(object_id, lambda o: o.path_length, np.nan)

    def first_contact_step(self, object_id):
        """[N] -1 = never."""
        return self._values(object_id, lambda o: o.first_contact_step, -1)

    def settled_step(self, object_id):
        """[N] -1 = not at rest at the end."""
        return self._values(object_id, lambda o: o.settled_step, -1)

    def settled(self, object_id):
        """[N] share of the particles in which it comes to rest; NaN without particles."""
        return self._values(object_id, lambda o: o.p_settled, np.nan)

    def tilted(self, object_id):
        """[N] share of the particles in which it tilts by more than tilt_limit; NaN without particles."""
        return self._values(object_id, lambda o: o.p_tilted, np.nan)

    def in_region(self, object_id, region=0):
        """[N] share of the particles in which it ends in region number `region`; NaN without particles."""
        return self._values(object_id, lambda o: o.p_in_region[region] if o.p_in_region else np.nan, np.nan)

    def poses(self, object_id):
        """One array [T, 7] per candidate, with poses=True; empty where it failed."""
        return [np.array([to_row(pose) for o in result.objects if o.id == object_id for pose in o.poses]).reshape(-1, 7)
                for result in self.message.results]


class Planner:
    """Asks the node for rollouts. A node that restarts is found again."""

    def __init__(self, service='predict_rollouts', timeout=10.0):
        self._service, self._timeout = service, timeout

    def ask(self, request):
        """Sends a BatchRequest as it is; raises PlanningError when there are no results."""
        try:
            rospy.wait_for_service(self._service, self._timeout)
            result = rospy.ServiceProxy(self._service, PredictRollouts)(request).result
        except (rospy.ROSException, rospy.ServiceException) as error:
            raise PlanningError(0, str(error)) from error
        if not result.results:
            raise PlanningError(result.error_code, result.message)
        return Outcomes(result)

    def rollouts(self, candidates, num_steps=0, engine=False, poses=False, base=None, scene=None, stop=(), regions=(),
                 max_wall_time=0.0, particles=0, seed=0, tilt_limit=0.0):
        """Rolls all candidates out; the scene is what the node sees, unless one is given (ObjectClouds)."""
        request = BatchRequest(num_steps=num_steps, candidates=list(candidates), stop=list(stop), regions=list(regions))
        request.fidelity = BatchRequest.ENGINE if engine else BatchRequest.MODEL
        request.record = BatchRequest.POSES if poses else BatchRequest.END
        request.max_wall_time = rospy.Duration.from_sec(max_wall_time)
        request.num_particles, request.seed, request.tilt_limit = particles, seed, tilt_limit
        if base is not None:
            request.base = base
        if scene is not None:
            request.scene = scene
        return self.ask(request)
