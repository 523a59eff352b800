#!/usr/bin/env python3
"""Checks that a recording shows the robot: its URDF, moved by its messages of joint states, is where /tf says.

usage: shown_body.py FOLDER for node_modules FILE.mcap TOPIC of the joint states NUMBER of joints     (reads it with @mcap/core)
"""
import math
import pathlib
import sys
import xml.etree.ElementTree


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def placed(turn, at):
    return [[*turn[i], at[i]] for i in range(3)] + [[0, 0, 0, 1]]


def about(axis, angle):
    """A turn about an axis (Rodrigues)."""
    x, y, z = axis
    c, s, v = math.cos(angle), math.sin(angle), 1 - math.cos(angle)
    return [[c + v * x * x, v * x * y - s * z, v * x * z + s * y], [v * x * y + s * z, c + v * y * y, v * y * z - s * x],
            [v * x * z - s * y, v * y * z + s * x, c + v * z * z]]


def numbers(element, name, default):
    return [float(x) for x in element.get(name, default).split()] if element is not None else [float(x) for x in default.split()]


def of_urdf(text, positions):
    """The place of each link in the root, from the description and the joints; the root; masses and limits."""
    robot = xml.etree.ElementTree.fromstring(text)
    joints = {joint.find("child").get("link"): joint for joint in robot.iter("joint")}
    links = [link.get("name") for link in robot.iter("link")]
    (root,) = [name for name in links if name not in joints]

    def place(link):
        if link == root:
            return placed(about((0, 0, 1), 0), (0, 0, 0))
        joint = joints[link]
        roll, pitch, yaw = numbers(joint.find("origin"), "rpy", "0 0 0")
        at = placed(about((0, 0, 1), yaw), numbers(joint.find("origin"), "xyz", "0 0 0"))
        at = product(at, product(placed(about((0, 1, 0), pitch), (0, 0, 0)), placed(about((1, 0, 0), roll), (0, 0, 0))))
        if joint.get("type") != "fixed":
            mimic = joint.find("mimic")
            name = joint.get("name") if mimic is None else mimic.get("joint")
            position = positions[name]
            if mimic is not None:
                position = float(mimic.get("multiplier")) * position + float(mimic.get("offset"))
            axis = numbers(joint.find("axis"), "xyz", "1 0 0")
            slides = joint.get("type") == "prismatic"
            at = product(at, placed(about(axis, 0 if slides else position), [position * x if slides else 0 for x in axis]))
        return product(place(joint.find("parent").get("link")), at)

    mass = sum(float(m.get("value")) for m in robot.iter("mass"))
    return {link: place(link) for link in links}, root, mass, robot


def of_transforms(message, root):
    """The place of each frame in the root, from /tf."""
    found = {one["child_frame_id"]: one for one in message["transforms"]}

    def place(frame):
        if frame == root:
            return placed(about((0, 0, 1), 0), (0, 0, 0))
        t = found[frame]["transform"]
        q = [t["rotation"][c] for c in "xyzw"]
        sine = math.sqrt(sum(c * c for c in q[:3]))
        turn = about([c / sine for c in q[:3]], 2 * math.atan2(sine, q[3])) if sine > 0 else about((0, 0, 1), 0)
        return product(place(found[frame]["header"]["frame_id"]), placed(turn, [t["translation"][c] for c in "xyz"]))

    return {frame: place(frame) for frame in found if frame != root}, found


def check(count, last, topic, joint_count, expect):
    """The last messages of a recording."""
    states, tf = last[topic], last["/tf"]
    values = states["position"]  # a typed array comes as an object
    positions = dict(zip(states["name"], values.values() if isinstance(values, dict) else values))
    links, root, mass, robot = of_urdf(last["/robot_description"]["data"], positions)
    moved = [joint for joint in robot.iter("joint") if joint.get("type") != "fixed" and joint.find("mimic") is None]
    expect(count["/robot_description"] == 1 and count["/tf"] == count[topic] > 10, f"{count['/tf']} messages of /tf")
    expect(len(moved) == joint_count and all(joint.get("name") in positions for joint in moved), f"joints {[j.get('name') for j in moved]}")
    expect(all(float(j.find("limit").get("lower")) < float(j.find("limit").get("upper")) for j in moved), "limits of joints")
    expect(mass > 1, f"a mass of {mass} kg")
    frames, found = of_transforms(tf, root)
    expect(states["header"]["stamp"] == tf["transforms"][0]["header"]["stamp"], "the last joint states are not of the last /tf")
    expect(set(frames) == set(links) - {root}, f"frames {sorted(set(frames) ^ set(links))}")
    worst = max(abs(frames[name][i][j] - links[name][i][j]) for name in frames if name in links for i in range(3) for j in range(4))
    expect(worst < 1e-8, f"links and frames are up to {worst} apart")
    return found, mass


def main():
    import read_independently
    folder, file, topic, joint_count = pathlib.Path(sys.argv[1]), *sys.argv[2:4], int(sys.argv[4])
    read_independently.npm_packages.install(read_independently.HERE, folder, "@mcap/core")
    indexed, _ = read_independently.read(folder, file)
    problems = []
    if "error" in indexed:
        sys.exit(f"the indexed reader: {indexed['error']}")
    check(indexed["count"], indexed["last"], topic, joint_count, lambda holds, what: holds or problems.append(what))
    sys.exit("\n".join(problems) or 0)


if __name__ == "__main__":
    main()
