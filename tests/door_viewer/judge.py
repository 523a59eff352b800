#!/usr/bin/env python3
"""Opens a door with a program behind it that only pretends, and judges it with the protocol's own client from npm.

usage: judge.py FOLDER for node_modules cca_door_server
"""
import pathlib
import secrets
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scripts"))
import npm_packages


def main():
    folder, program = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    npm_packages.install(HERE, folder, "@foxglove/ws-protocol")
    token = secrets.token_hex(16)
    server = subprocess.Popen([program, "0", token, "10", "1000"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    try:
        address = server.stdout.readline().split()[1].rstrip(",")
        once = server.stdout.readline().split("once=")[1].strip()
        done = subprocess.run(["node", str(HERE / "judge.mjs"), str(folder), address.rpartition(":")[2], token, once], timeout=60)
    finally:
        server.stdin.close()
        server.wait(timeout=10)
    sys.exit(done.returncode or server.returncode)


if __name__ == "__main__":
    main()
