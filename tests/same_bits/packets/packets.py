#!/usr/bin/env python3
"""Compiles packets.cpp with Eigen's packets of several sizes and without, and compares what it prints.

usage: packets.py FOLDER --headers="FLAG;..." --flags="FLAG;..." --gnu="FLAG;..."

FLAG: the headers; what keeps products from being fused, for all compilers and for g++. Every line must be the same but the last one,
which is by Eigen's own reductions: it must differ, or there were no packets to compare with.
"""
import argparse
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent


def judged(printed):
    """What is wrong with {how it was compiled: its lines}, the first one being without packets."""
    (first, wanted), *others = printed.items()
    if len(wanted) < 10 or not wanted[-1].startswith("Eigen "):
        yield f"{first}: printed {len(wanted)} lines"
    for how, got in others:
        if len(got) != len(wanted):
            yield f"{how}: printed {len(got)} lines"
            continue
        for a, b in zip(wanted[:-1], got[:-1]):
            if a != b:
                yield f"{how}: {b.rsplit(' ', 1)[0]} has other bits than {first}"
        if wanted[-1] == got[-1]:
            yield f"{how}: Eigen's own sums have the same bits, so it used no packets"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=pathlib.Path)
    for name in ("headers", "flags", "gnu"):
        parser.add_argument(f"--{name}", required=True)
    o = parser.parse_args()
    headers, flags, gnu = ([flag for flag in flags.split(";") if flag] for flags in (o.headers, o.flags, o.gnu))
    o.folder.mkdir(parents=True, exist_ok=True)
    native = [] if " avx2 " in pathlib.Path("/proc/cpuinfo").read_text() else ["qemu-x86_64", "-cpu", "max"]
    ways = {
        "g++ without packets": ([], ["g++", "-O1", "-DEIGEN_DONT_VECTORIZE"]),
        "g++, SSE2": ([], ["g++", "-O2"]),
        "g++, AVX2": (native, ["g++", "-O3", "-march=x86-64-v3", *gnu]),
        "clang, AVX2": (native, ["clang++-19", "-O2", "-march=x86-64-v3"]),
    }
    printed = {}
    for how, (runner, compiler) in ways.items():
        program = o.folder / "packets"
        try:
            subprocess.run([*compiler, "-std=c++20", *flags, *headers, str(HERE / "packets.cpp"), "-o", str(program)], check=True)
            printed[how] = subprocess.run([*runner, str(program)], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()
        except FileNotFoundError as error:
            sys.exit(f"{error.filename} is not installed: ./bootstrap installs it")
        except subprocess.CalledProcessError as error:
            sys.exit(f"{how}: {error}")
    found = list(judged(printed))
    sys.exit("\n".join(found) or print(f"{len(printed[how]) - 1} parts have the same bits by {', '.join(ways)}"))


if __name__ == "__main__":
    main()
