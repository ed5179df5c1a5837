#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the poses in bags as the table that `import_poses` reads: recording (the name of the bag), t [s from the first
pose on], id, x, y, z [m], qx, qy, qz, qw.  Poses are those of PoseStamped topics and of direct transforms in tf:
  scripts/bag_to_poses.py throws/*.bag --pose /cup/pose=cup --tf board:die=die --out poses.csv
All must be given in one frame, whose z axis points up. Without `=ID` the id is the topic or the child frame."""
import argparse
import csv
import pathlib
import sys

import rosbag


def split(text):
    """'/cup/pose=cup' -> ('/cup/pose', 'cup')."""
    source, _, name = text.partition('=')
    return source, name or source.strip('/').replace('/', '_')


def poses_of_topics(bag, topics):
    """Yields stamp, id, position, rotation of every message of the topics {topic: id}."""
    for topic, message, _ in bag.read_messages(topics=list(topics)):
        if message._type != 'geometry_msgs/PoseStamped':
            raise ValueError(f'topic {topic} holds {message._type}, accepted is geometry_msgs/PoseStamped')
        yield message.header.stamp.to_sec(), topics[topic], message.pose.position, message.pose.orientation


def poses_of_tf(bag, edges):
    """Yields the same of every transform {(parent, child): id}."""
    for _, message, _ in bag.read_messages(topics=['/tf', '/tf_static']):
        for transform in message.transforms:
            edge = transform.header.frame_id.lstrip('/'), transform.child_frame_id.lstrip('/')
            if edge in edges:
                t = transform.transform
                yield transform.header.stamp.to_sec(), edges[edge], t.translation, t.rotation


def rows_of(path, topics, edges):
    """The rows of one bag in the order of time; a pose that was sent twice counts once."""
    poses = {}
    with rosbag.Bag(str(path)) as bag:
        for source in (poses_of_topics(bag, topics) if topics else (), poses_of_tf(bag, edges) if edges else ()):
            for stamp, name, position, rotation in source:
                poses[stamp, name] = (position.x, position.y, position.z,
                                      rotation.x, rotation.y, rotation.z, rotation.w)
    for source, name in [*topics.items(), *((':'.join(edge), name) for edge, name in edges.items())]:
        if not any(key[1] == name for key in poses):
            raise ValueError(f'there is no pose of {source}')
    begin = min(stamp for stamp, _ in poses)
    return [[path.stem, f'{stamp - begin:.6f}', name, *(f'{value:.7g}' for value in poses[stamp, name])]
            for stamp, name in sorted(poses)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('bags', nargs='+', type=pathlib.Path)
    parser.add_argument('--pose', action='append', default=[], metavar='TOPIC[=ID]', help='geometry_msgs/PoseStamped')
    parser.add_argument('--tf', action='append', default=[], metavar='PARENT:CHILD[=ID]', help='a direct transform')
    parser.add_argument('--out', type=argparse.FileType('w'), default=sys.stdout)
    arguments = parser.parse_args()
    topics = dict(split(text) for text in arguments.pose)
    edges = {}
    for text in arguments.tf:
        source, name = split(text)
        parent, colon, child = source.partition(':')
        if not colon:
            parser.error(f"--tf is '{text}', must look like PARENT:CHILD or PARENT:CHILD=ID")
        edges[parent.lstrip('/'), child.lstrip('/')] = name if '=' in text else child.strip('/')
    if not topics and not edges:
        parser.error('name at least one --pose or --tf')
    table = csv.writer(arguments.out, lineterminator='\n')
    table.writerow(['recording', 't', 'id', 'x', 'y', 'z', 'qx', 'qy', 'qz', 'qw'])
    for path in arguments.bags:
        try:
            table.writerows(rows_of(path, topics, edges))
        except (OSError, ValueError, rosbag.ROSBagException) as error:
            sys.exit(f'bag_to_poses: {path}: {error}')


if __name__ == '__main__':
    main()
