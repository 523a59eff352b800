#!/usr/bin/env python3
"""Compiles a program, runs it and compares what it says.

usage: start.py SOURCE PROGRAM BEGINNING [--mode MODE] -- COMPILER...

BEGINNING is how its only line begins, MODE its argument. A program for AVX2 runs in QEMU where the processor has none.
"""
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent


def main():
    split = sys.argv.index("--")
    source, program, beginning, *mode = sys.argv[1:split]
    subprocess.run([*sys.argv[split + 1:], str(HERE / source), "-o", program], check=True)
    here = " avx2 " in pathlib.Path("/proc/cpuinfo").read_text() or "-march=x86-64-v3" not in sys.argv
    done = subprocess.run([*([] if here else ["qemu-x86_64", "-cpu", "max"]), program, *mode[1:]], stdout=subprocess.PIPE, text=True)
    print(done.stdout)
    if not done.stdout.startswith(beginning) or bool(done.returncode) != beginning.startswith("math."):
        sys.exit(f"exit code {done.returncode}; it should say: {beginning}")


if __name__ == "__main__":
    main()
