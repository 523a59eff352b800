#!/usr/bin/env python3
"""Checks that the version is written in one place, include/cca/version.hpp, and that CHANGELOG.md has a section for it.

usage: version.py [ROOT of the repository]

The newest section of CHANGELOG.md that is not `Unreleased` must be that of the version. No CMake file may state it, neither
in `project(cca VERSION ...)` nor in `find_package(cca ...)`, and no page may ask for another one.
"""
import pathlib
import re
import sys

from format import files_of

HEADER = pathlib.Path("include/cca/version.hpp")
SECTION = re.compile(r"^## (\d+\.\d+\.\d+)$", re.M)
STATED = re.compile(r"find_package\(cca\s+(\d[\d.]*)|project\(cca\s+VERSION\s+(\d[\d.]*)")


def version_of(root):
    text = (root / HEADER).read_text()
    return ".".join(re.search(rf"version_{part} = (\d+);", text)[1] for part in ("major", "minor", "patch"))


def problems(root):
    version = version_of(root)
    newest = SECTION.search((root / "CHANGELOG.md").read_text())
    if not newest or newest[1] != version:
        yield f"CHANGELOG.md: its newest section is {newest[1] if newest else 'none'}, but {HEADER} says {version}"
    for name in files_of(root, ".txt", ".cmake", ".in", ".md"):
        if name.name == "CHANGELOG.md":
            continue
        text = (root / name).read_text()
        for found in STATED.finditer(text):
            stated, line = found[1] or found[2], text.count("\n", 0, found.start()) + 1
            if name.suffix != ".md":
                yield f"{name}:{line}: states the version {stated}: take it from {HEADER}"
            elif not version.startswith(stated):
                yield f"{name}:{line}: asks for {stated}, but the version is {version}"


def main(arguments):
    root = pathlib.Path(arguments[0]).resolve() if arguments else pathlib.Path(__file__).resolve().parents[2]
    found = list(problems(root))
    print("\n".join(found) or f"the version is {version_of(root)} everywhere")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
