#!/usr/bin/env python3
"""Runs a compiler, and writes down how long it took: the launcher of the programs whose compile time is bounded.

usage: timed.py FILE COMPILER [FLAGS...]

FILE-<name of the source> gets the seconds of processor time (user) and the MB of memory.
"""
import pathlib
import resource
import subprocess
import sys

out, *command = sys.argv[1:]
code = subprocess.run(command).returncode
used = resource.getrusage(resource.RUSAGE_CHILDREN)
if code == 0 and "-c" in command and "-x" not in command:
    source = pathlib.Path(command[command.index("-c") + 1]).stem
    pathlib.Path(f"{out}-{source}").write_text(f"{used.ru_utime:.2f} {used.ru_maxrss // 1024}\n")
sys.exit(code)
