#!/usr/bin/env python3
"""Checks that the tutorial's commands configure what it builds, with no more packages than it installs.

usage: prepared.py ROOT of the repository FOLDER to configure in

Runs each `cmake --preset release ...` of docs/tutorial, in its order, and looks for each target that a page builds. A package of the
third column is hidden from CMake until a page installs it; ./bootstrap demo installs none of them.
"""
import pathlib
import re
import shlex
import subprocess
import sys

BLOCK = re.compile(r"^```sh\n(.*?)^```", re.M | re.S)
# What CMake finds, and Debian's package of it.
PACKAGES = {"CycloneDDS": "cyclonedds-dev", "MPI": "libopenmpi-dev", "pybind11": "pybind11-dev", "tinyxml2": "libtinyxml2-dev", "yaml-cpp": "libyaml-cpp-dev"}


def pages(folder):
    """README.md, then the steps by their number."""
    steps = sorted(folder.glob("[0-9]*.md"), key=lambda page: int(page.name.split("_")[0]))
    return [folder / "README.md", *steps]


def commands(page):
    """Each command of a page, its continued lines joined, as words."""
    for block in BLOCK.findall(page.read_text()):
        for line in block.replace("\\\n", " ").splitlines():
            for part in line.split("&&"):
                if words := shlex.split(part, comments=True):
                    yield words


def main():
    root, into = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    installed, configured, built = set(), 0, 0
    for page in pages(root / "docs" / "tutorial"):
        for words in commands(page):
            if "apt-get" in words:
                installed |= set(words)
            elif words[0] == "cmake" and "--build" not in words and "release" in words:
                hidden = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}={'OFF' if package in installed else 'ON'}" for name, package in PACKAGES.items()]
                ran = subprocess.run([*words, "-B", str(into), *hidden], cwd=root, capture_output=True, text=True)
                if ran.returncode:
                    sys.exit(f"{page.name}: {shlex.join(words)} fails with the packages that are installed by then:\n{ran.stderr}")
                configured += 1
            elif words[0] == "cmake" and ("release" in words or "build/release" in words):
                rules = (into / "build.ninja").read_text()
                for target in words[words.index("--target") + 1:]:
                    if not re.search(rf"^build {re.escape(target)}: ", rules, re.M):
                        sys.exit(f"{page.name}: {shlex.join(words)}: there is no target {target} after what was configured by then")
                    built += 1
    if configured < 2 or built < 10:
        sys.exit(f"only {configured} commands that configure and {built} targets were found: the pages are written otherwise than this reads them")
    print(f"the tutorial configures {configured} times and has its {built} targets")


if __name__ == "__main__":
    main()
