#!/usr/bin/env python3
"""Checks that a program compiles within a bound, in the compile time of Eigen alone.

usage: ratio.py FILE MOST MB COMPILER [FLAGS...]

The files FILE-* were written by timed.py when the program was compiled; of its sources the largest counts. Eigen alone, a file
that includes Eigen/Core and multiplies two matrices, is compiled here, as often as it takes to see the machine at its usual speed;
the median counts.
"""
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

ALONE = """#include <Eigen/Core>
Eigen::Matrix3d product(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) { return a * b; }
"""


def eigen_alone(command, folder):
    source = pathlib.Path(folder) / "alone.cpp"
    source.write_text(ALONE)
    times = []
    for _ in range(3):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run([*command, "-c", str(source), "-o", str(source.with_suffix(".o"))], check=True)
        times.append(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
    return statistics.median(times)


def main():
    file, most, most_mb, *command = sys.argv[1:]
    written = [path.read_text().split() for path in pathlib.Path(file).parent.glob(pathlib.Path(file).name + "-*")]
    if not written:
        sys.exit(f"{file}-*: not there: the program was not compiled by timed.py")
    seconds, mb = (max(float(one[i]) for one in written) for i in range(2))
    with tempfile.TemporaryDirectory() as folder:
        alone = eigen_alone(command, folder)
    ratio = seconds / alone
    print(f"{seconds:.1f} s and {mb:.0f} MB, {ratio:.1f} times Eigen alone ({alone:.2f} s); at most {most} times and {most_mb} MB")
    sys.exit(0 if ratio <= float(most) and mb <= float(most_mb) else 1)


if __name__ == "__main__":
    main()
