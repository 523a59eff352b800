#!/usr/bin/env python3
"""Checks that what a beat can run takes its elementary functions from cca::math, which has the same bits everywhere.

usage: elementary.py [ROOT of the repository]

In FOLDERS no file calls sin, exp, pow or their like of the C++ library, the C library or a compiler. Nor does it use what calls them:
Eigen's functions of arrays, its rotations by an angle, the distributions of <random>. sqrt, floor, ceil, round and trunc are the same
everywhere, but those of the C++ library are calls in a beat. OUTSIDE lists the files that no beat runs, each with a reason.
"""
import pathlib
import re
import sys

FOLDERS = ["include", "robots/include", "sim/include", "hardware/include", "dds/include", "record/include", "mpi/include", "examples", "page/wasm", "tools/cca_new/templates"]
OWN = "include/cca/base/math"
TRAINS = "a search before the run; its result is a file"
OUTSIDE = {
    "examples/trot/report/statistics.hpp": "a report after the run",
    "examples/trot/report/svg.hpp": "a report after the run",
    "examples/walking_policy/evolution.hpp": TRAINS,
    "examples/walking_policy/imitation.hpp": TRAINS,
    "examples/walking_policy/way.hpp": "a report after the run",
    "page/wasm/arm_scene.hpp": "places bodies in a picture",
    "record/include/cca/record/messages/urdf_functions.hpp": "writes the description of a robot before the run",
}
NAMES = ("sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot|fmod|remainder|remquo"
         "|erf|erfc|tgamma|lgamma|sincos")
FORBIDDEN = [
    (re.compile(r"\bstd::(sqrt|floor|ceil|round|trunc)\("), "std::{0} may be a call: use cca::math"),
    (re.compile(rf"\bstd::({NAMES})[fl]?\b(?!:)"), "std::{0} has other bits on each machine: use cca::math"),
    (re.compile(rf"(?:(?<![\w>:])::|\b__builtin_)({NAMES})[fl]?\("), "{0} of the C library has other bits on each machine: use cca::math"),
    (re.compile(rf"(?:[=(,*/+?:&|{{<>!-]|\breturn)\s*(?<!::)({NAMES})[fl]?\("), "{0} without cca::math:: may be that of the C library, which has other bits on each machine"),
    (re.compile(rf"\.({NAMES})\(\)"), ".{0}() of Eigen calls the C library or has its own bits: loop over cca::math"),
    (re.compile(r"\bEigen::(AngleAxis|Quaternion|Rotation2D)[df]?\b"), "Eigen::{0} calls the C library: use cca::rotation"),
    (re.compile(r"\.(slerp|angularDistance|eulerAngles)\("), ".{0} of Eigen calls the C library: use cca::rotation"),
    (re.compile(r"\bstd::(\w+_distribution)\b"), "std::{0} differs from library to library: make the numbers from the bits"),
]
# Comments and texts.
SILENT = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"', re.S)
DECLARED = re.compile(rf"\b(?:inline|constexpr|static|CCA_INLINE)\s[^;{{}}()=]*?\b({NAMES})\((?=const\b|\w+ \w)")


def code_of(text):
    """The text without comments and texts, line by line."""
    return SILENT.sub(lambda m: "\n" * m.group().count("\n"), text)


def calls(text):
    """(line, why) of each forbidden call."""
    for number, line in enumerate(code_of(text).split("\n"), 1):
        if DECLARED.search(line):
            continue
        for pattern, why in FORBIDDEN:
            if found := pattern.search(line):
                yield number, why.format(found[1])
                break


def problems(root):
    met = set()
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*.[ch]pp")):
            name = file.relative_to(root).as_posix()
            if name.startswith(OWN):
                continue
            found = list(calls(file.read_text()))
            if name in OUTSIDE:
                if found:
                    met.add(name)
                continue
            for line, why in found:
                yield f"{name}:{line}: {why}"
    for name in sorted(set(OUTSIDE) - met):
        yield f"tests/scripts/elementary.py: {name} calls none, or does not exist: it needs no reason"


if __name__ == "__main__":
    found = list(problems(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
    print("\n".join(found) if found else "the elementary functions of a beat are the library's own")
    sys.exit(bool(found))
