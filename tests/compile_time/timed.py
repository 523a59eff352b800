#!/usr/bin/env python3
"""Runs a compiler, and writes down how long it took: the launcher of the programs whose compile time is bounded.

usage: timed.py FILE COMPILER [FLAGS...]

FILE-<name of the source>.json gets the seconds of processor time (user), the MB of memory, and how to compile it again.
"""
import json
import pathlib
import resource
import subprocess
import sys


def compiled(command, folder):
    """The exit code, the seconds and the MB of one compilation."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    code = subprocess.run(command, cwd=folder).returncode
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return code, used.ru_utime - before, used.ru_maxrss // 1024


def main():
    out, *command = sys.argv[1:]
    folder = pathlib.Path.cwd()
    code, seconds, mb = compiled(command, folder)
    if code == 0 and "-c" in command and "-x" not in command:
        source = pathlib.Path(command[command.index("-c") + 1]).stem
        written = {"seconds": seconds, "mb": mb, "folder": str(folder), "command": command}
        pathlib.Path(f"{out}-{source}.json").write_text(json.dumps(written))
    sys.exit(code)


if __name__ == "__main__":
    main()
