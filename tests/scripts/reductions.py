#!/usr/bin/env python3
"""Checks that the library adds in its own order, cca::math (base/math/reductions.hpp): Eigen's depends on the packets of the machine.

usage: reductions.py [ROOT of the repository]

In FOLDERS no file calls a sum, a norm or a dot product of Eigen, multiplies with a transposed matrix on the left, or decomposes a matrix.
A product of two matrices that is written `a * b` can't be told from others by its text: "same bits: reductions" compares what it computes.
OUTSIDE lists the files that may, each with a reason; docs/same_bits.md says so too.
"""
import pathlib
import re
import sys

from elementary import code_of

FOLDERS = ["include", "robots/include", "sim/include", "hardware/include", "dds/include", "record/include", "mpi/include", "door/include", "python/include"]
OWN = "include/cca/base/math/reductions.hpp"
ENGINE = "runs beside the Open Dynamics Engine, which has other bits on another machine"
TRAINS = "learns between beats, by a decomposition of Eigen"
OUTSIDE = {
    "include/cca/adaptive/extreme_learning_machine.hpp": TRAINS,
    "include/cca/adaptive/recursive_least_squares.hpp": TRAINS,
    "include/cca/base/response/frequency_response.hpp": "a report after the run",
}
OUTSIDE_FOLDERS = {"sim/include/cca/sim/robot": ENGINE}

SUMS = "norm|squaredNorm|stableNorm|blueNorm|lpNorm|sum|mean|prod|trace|determinant|normalized|normalize|stableNormalized|stableNormalize|redux"
FORBIDDEN = [
    (re.compile(rf"(?:\.|->)\s*(?:template\s+)?({SUMS})(?:<[^<>;]*>)?\("), "{0}() of Eigen adds in an order that depends on the machine: use cca::math (base/math/reductions.hpp)"),
    (re.compile(r"(?:\.|->)\s*(?:template\s+)?(dot)\((?!\s*\))"), "{0}() of Eigen adds in an order that depends on the machine: use cca::math::dot(a, b)"),
    (re.compile(r"\.(transpose|adjoint)\(\)\s*\*"), "a product with a transposed matrix adds in an order that depends on the machine: use cca::math::product(a, b)"),
    (re.compile(r"\b(LLT|LDLT|PartialPivLU|FullPivLU|HouseholderQR|ColPivHouseholderQR|SelfAdjointEigenSolver|EigenSolver|JacobiSVD|BDCSVD)<"),
     "{0} of Eigen adds in an order that depends on the machine: use positive_matrix or symmetric_eigen, or give a reason in reductions.py"),
    (re.compile(r"\.(llt|ldlt|lu|partialPivLu|fullPivLu|householderQr|colPivHouseholderQr|jacobiSvd|bdcSvd|inverse)\("),
     "{0}() of Eigen adds in an order that depends on the machine: use positive_matrix or symmetric_eigen, or give a reason in reductions.py"),
]
# Of others: figures of a trace, and a picture of a graph.
OTHERS = re.compile(r"\b(?:d|of_mode)\.(?:mean|dot)\(\)")


def calls(text):
    """(line, why) of each forbidden call; a call may begin on the line before."""
    code = OTHERS.sub("", code_of(text))
    found = {}
    for pattern, why in FORBIDDEN:
        for match in pattern.finditer(code):
            found.setdefault(code.count("\n", 0, match.start(1)) + 1, why.format(match[1]))
    yield from sorted(found.items())


def problems(root):
    met = set()
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*.[ch]pp")):
            name = file.relative_to(root).as_posix()
            if name == OWN:
                continue
            found = list(calls(file.read_text()))
            reason = name if name in OUTSIDE else next((one for one in OUTSIDE_FOLDERS if name.startswith(one + "/")), None)
            if reason:
                met |= {reason} if found else set()
                continue
            for line, why in found:
                yield f"{name}:{line}: {why}"
    for name in sorted((set(OUTSIDE) | set(OUTSIDE_FOLDERS)) - met):
        yield f"tests/scripts/reductions.py: {name} calls none, or does not exist: it needs no reason"


if __name__ == "__main__":
    found = list(problems(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
    print("\n".join(found) if found else "the library adds in its own order")
    sys.exit(bool(found))
