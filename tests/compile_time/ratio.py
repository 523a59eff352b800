#!/usr/bin/env python3
"""Checks that a program compiles within a bound, in the compile time of Eigen alone.

usage: ratio.py FILE MOST MB COMPILER [FLAGS...]

The files FILE-*.json were written by timed.py when the program was compiled; of its sources the slowest counts. Beside other
compilers on the same cores a compiler takes up to twice its time. So what is above the bound is compiled once more, alone.
Eigen alone, a file that includes Eigen/Core and multiplies two matrices, is compiled here, as often as it takes to see the machine
at its usual speed; the median counts.
"""
import json
import pathlib
import statistics
import sys
import tempfile

from timed import compiled

ALONE = """#include <Eigen/Core>
Eigen::Matrix3d product(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) { return a * b; }
"""


def eigen_alone(command, folder):
    source = folder / "alone.cpp"
    source.write_text(ALONE)
    times = []
    for _ in range(3):
        code, seconds, _ = compiled([*command, "-c", str(source), "-o", str(source.with_suffix(".o"))], folder)
        if code:
            sys.exit("Eigen alone does not compile")
        times.append(seconds)
    return statistics.median(times)


def seconds_of(written, most, folder):
    """Of one source: as written in the build, or, where that is more than `most`, compiled alone."""
    if written["seconds"] <= most:
        return written["seconds"]
    print(f"{written['seconds']:.1f} s in the build, beside whatever else it did; once more, alone:")
    command = list(written["command"])
    command[command.index("-o") + 1] = str(folder / "again.o")
    code, seconds, _ = compiled(command, written["folder"])
    if code:
        sys.exit(f"{command[command.index('-c') + 1]} compiled before, and does not now")
    return seconds


def main():
    file, most, most_mb, *command = sys.argv[1:]
    all_written = [json.loads(path.read_text()) for path in pathlib.Path(file).parent.glob(pathlib.Path(file).name + "-*.json")]
    if not all_written:
        sys.exit(f"{file}-*.json: not there: the program was not compiled by timed.py")
    mb = max(one["mb"] for one in all_written)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        alone = eigen_alone(command, folder)
        seconds = max(seconds_of(one, float(most) * alone, folder) for one in all_written)
    ratio = seconds / alone
    print(f"{seconds:.1f} s and {mb:.0f} MB, {ratio:.1f} times Eigen alone ({alone:.2f} s); at most {most} times and {most_mb} MB")
    sys.exit(0 if ratio <= float(most) and mb <= float(most_mb) else 1)


if __name__ == "__main__":
    main()
