#!/usr/bin/env python3
"""Compiles same_bits.cpp, runs it and compares what it prints with hashes.txt.

usage: same_bits.py PROGRAM [--run COMMAND...] -- COMPILER...

COMMAND runs the program: an emulator, node. `avx2` is this machine, or QEMU where its processor has no AVX2.
After a change that is meant to change results: same_bits.py PROGRAM --write -- COMPILER... writes hashes.txt.
"""
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent


def main():
    split = sys.argv.index("--")
    program, *options = sys.argv[1:split]
    compiler = sys.argv[split + 1:]
    emulator = [word for word in options if word not in ("--run", "--write", "")]
    emulator = [word for words in emulator for word in words.split(";")]
    if emulator == ["avx2"]:
        emulator = [] if " avx2 " in pathlib.Path("/proc/cpuinfo").read_text() else ["qemu-x86_64", "-cpu", "max"]
    try:
        subprocess.run([*compiler, str(HERE / "same_bits.cpp"), "-o", program], check=True)
        result = subprocess.run([*emulator, program], stdout=subprocess.PIPE, text=True)
    except FileNotFoundError as error:
        sys.exit(f"{error.filename} is not installed: ./bootstrap installs it")
    if result.returncode:
        sys.exit(result.stdout + f"the program ended with {result.returncode}: lanes differ from doubles")
    hashes = HERE / "hashes.txt"
    if "--write" in options:
        hashes.write_text(result.stdout)
        return
    wanted, got = hashes.read_text().split("\n"), result.stdout.split("\n")
    different = [f"{b}, elsewhere {a.split()[-1]}" for a, b in zip(wanted, got) if a != b]
    if different or len(wanted) != len(got):
        sys.exit("these functions have other bits here:\n  " + "\n  ".join(different))
    print(f"{len(got) - 2} functions have the bits that they have everywhere")


if __name__ == "__main__":
    main()
