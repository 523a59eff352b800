#!/usr/bin/env python3
"""Records the trot and reads the file with @mcap/core: a million messages, whole and cut at random places.

usage: read_independently.py FOLDER for node_modules PROGRAM arguments...     (the file is added as --record FILE)
"""
import json
import pathlib
import random
import subprocess
import sys

import shown_body

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scripts"))
import npm_packages


def read(folder, file):
    done = subprocess.run(["node", str(HERE / "read.mjs"), str(folder), str(file)], stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(done.stdout)


def main():
    folder = pathlib.Path(sys.argv[1])
    npm_packages.install(HERE, folder, "@mcap/core")
    file = folder / "trot.mcap"
    subprocess.run([*sys.argv[2:], "--record", str(file)], check=True)
    indexed, streamed = read(folder, file)
    problems = []

    def expect(holds, what):
        if not holds:
            problems.append(what)

    expect("error" not in indexed, f"the indexed reader: {indexed.get('error')}")
    expect(streamed["ended"] is True, f"the stream reader: {streamed['ended']}")
    if not problems:
        count, last = indexed["count"], indexed["last"]
        expect(indexed["messages"] == streamed["messages"] >= 1_000_000, f"{indexed['messages']} and {streamed['messages']} messages")
        expect("/cca/lost" not in count, "beats were lost")
        beats = count["/limits/safe"]
        expect(count["/gait/angles"] == count["/cpg/phase"] == beats and abs(count["/posture/turn"] - beats / 10) <= 1, f"counts {count}")
        expect(last["/limits/safe"]["beat"] == beats - 1 and 0 <= (beats - 1) * 1_000_000 - last["/limits/safe"]["origin"] < 10_000_000, f"last {last['/limits/safe']}")
        joints = last["/ros2/limits/safe"]
        expect(len(joints["name"]) == len(joints["position"]) == 8 and joints["name"][0] == "left_front_hip", f"JointState {joints}")
        expect(last["/cca/state"]["state"] == "loaded", f"the last state is {last['/cca/state']}")
        found, mass = shown_body.check(count, last, "/ros2/robot/angles/whole", 8, expect)
        expect("world" in found["trunk_frame"]["header"]["frame_id"], f"the trunk is in {found['trunk_frame']['header']}")
        expect(abs(mass - 5.1) < 1e-6, f"a mass of {mass} kg")
        expect("frequency" in last["/cca/parameters/cpg"], f"parameters {last['/cca/parameters/cpg']}")
    whole = file.read_bytes()
    numbers = random.Random(1)
    for _ in range(5):
        size = numbers.randrange(len(whole) // 4, len(whole) - 100_000)
        file.write_bytes(whole[:size])
        _, streamed = read(folder, file)
        share = streamed["messages"] / indexed.get("messages", 1)
        expect(size / len(whole) - 0.05 < share < 1, f"cut at {size} of {len(whole)} bytes: {streamed}")
    file.unlink()
    sys.exit("\n".join(problems) or 0)


if __name__ == "__main__":
    main()
