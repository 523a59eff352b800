#!/usr/bin/env python3
"""Runs programs at the same time; each must end by itself with exit code 0.

    together.py -- PROGRAM [ARGUMENT...] [-- PROGRAM [ARGUMENT...]]...
"""
import subprocess
import sys


def main():
    commands = []
    for word in sys.argv[1:]:
        if word == "--":
            commands.append([])
        else:
            commands[-1].append(word)
    programs = [subprocess.Popen(command) for command in commands]
    problems = []
    for program, command in zip(programs, commands):
        try:
            if program.wait(timeout=60) != 0:
                problems.append(f"{' '.join(command)}: ended with {program.returncode}")
        except subprocess.TimeoutExpired:
            program.kill()
            problems.append(f"{' '.join(command)}: did not end within a minute")
    return "\n".join(problems) or None


if __name__ == "__main__":
    sys.exit(main())
