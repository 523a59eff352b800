#!/usr/bin/env python3
"""Checks that a family of drives is whole: what `How to add a drive` in CONTRIBUTING.md asks for.

usage: drives.py [ROOT of the repository]

A family is a header in hardware/drives/ that decodes frames. Each part that it lacks is told, with the step that makes it.
"""
import pathlib
import re
import sys

HARDWARE = "hardware/include/cca/hardware"
DECODES = re.compile(r"static constexpr bool decode\(")

# For the family {0}: a file, a pattern that must be in it, the step of CONTRIBUTING.md, and a name for the part.
PARTS = [
    (HARDWARE + "/{0}.hpp", r"#include <cca/hardware/drives/{0}\.hpp>", 2, "the short path for programs"),
    (HARDWARE + "/virtual_drives/virtual_{0}.hpp", "", 2, "its virtual drive"),
    (HARDWARE + "/virtual_drives/virtual_of.hpp", r"virtual_{0}\.hpp>", 2, "virtual_robot finds its virtual drive"),
    (HARDWARE + "/virtual_{0}.hpp", r"#include <cca/hardware/virtual_drives/virtual_{0}\.hpp>", 2, "the short path of the virtual drive"),
    ("tests/runtime/hardware/{0}.cpp", r"drive_laws\.hpp", 3, "the laws of drives"),
    ("tests/runtime/drive_chain/virtual_drives.cpp", r"\bvirtual_{0}<", 4, "the laws of virtual drives"),
    ("tests/fuzz/{0}.cpp", r"fuzz::hears<", 5, "a fuzz target of the decoder"),
    ("docs/drives.md", r"<cca/hardware/{0}\.hpp>", 6, "a row in the table of headers"),
    ("docs/drives.md", r"(?m)^\| \|.*`virtual_{0}`", 6, "a column in the table of virtual drives"),
    ("docs/drives.md", r"(?m)^\| \|.*`{0}(_drive)?`", 6, "a column in the table of drives"),
    (HARDWARE + "/drives/drive.hpp", r"Models:[^.]*(\.hpp[^.]*)*\b{0}\.hpp", 6, "its name in the list of models"),
    (HARDWARE + "/virtual_drives/virtual_drive.hpp", r"\bvirtual_{0}\.hpp", 6, "its name in the list of models"),
    ("docs/README.md", r"\[Drives\]\(drives\.md\).*(?i:\b{1}\b)", 6, "its name in the list of pages"),
    ("tools/cca_can/drives/drive_name.hpp", r"virtual_{0}\.hpp>", 7, "cca-can names it"),
    ("tools/cca_can/commands/help.hpp", r"(?i:\b{0}\b)", 7, "the help of cca-can names it"),
]


def families(root):
    for header in sorted((root / HARDWARE / "drives").glob("*.hpp")):
        if header.stem != "drive" and DECODES.search(header.read_text()):
            yield header.stem


def problems(root):
    found = list(families(root))
    if not found:
        yield f"{HARDWARE}/drives: no family of drives found"
    for name in found:
        title = re.sub(r"(?<=[a-z])(?=\d)", " ?", name)  # cia402 is written CiA 402
        for file, words, step, what in PARTS:
            path = root / file.format(name)
            if not path.is_file() or not re.search(words.format(name, title), path.read_text()):
                yield f"{file.format(name)}: the drive `{name}` lacks {what} (step {step} of How to add a drive)"
        corpus = root / "tests/fuzz/corpus" / name
        if not corpus.is_dir() or not any(corpus.iterdir()):
            yield f"tests/fuzz/corpus/{name}: the drive `{name}` lacks a first frame for its fuzz target (step 5 of How to add a drive)"


def main(arguments):
    found = list(problems(pathlib.Path(arguments[0] if arguments else ".")))
    print("\n".join(found) or "each drive is whole")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
