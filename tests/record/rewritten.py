#!/usr/bin/env python3
"""Records the trot, writes the file again with @mcap/core, without chunks and compressed by lz4, and replays each.

usage: rewritten.py FOLDER for node_modules PROGRAM arguments...     (--record FILE and --replay FILE are added)
"""
import pathlib
import subprocess
import sys

from read_independently import HERE, npm_packages


def main():
    folder = pathlib.Path(sys.argv[1])
    npm_packages.install(HERE, folder, "@mcap/core")
    original = folder / "original.mcap"
    subprocess.run([*sys.argv[2:], "--record", str(original)], check=True)
    said = {}
    for how in ("original", "none", "lz4"):
        file = folder / f"{how}.mcap"
        if how != "original":
            subprocess.run(["node", str(HERE / "rewrite.mjs"), str(folder), str(original), str(file), how], check=True)
        done = subprocess.run([sys.argv[2], "--replay", str(file)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        said[how] = done.stdout.strip()
        if done.returncode != 0 or "bit for bit as recorded" not in said[how] or said[how] != said["original"]:
            sys.exit(f"{how}: the replay ends with {done.returncode} and says {said}")
    print(said["original"])


if __name__ == "__main__":
    main()
