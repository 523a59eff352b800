#!/usr/bin/env python3
"""Checks that the figures of the README are those of docs/performance.md, which bench/measure.py writes.

usage: figures.py [ROOT of the repository]

The README says how many times the instructions of its loop by hand the trot's controller takes, how many times those of the
graph the classical form takes, how many times random graphs take on average and in single ones, and how long a graph of 100 nodes compiles beyond Eigen: each from the least to the most of a
table.
"""
import pathlib
import re
import sys

NUMBER = r"\d[\d,]*(?:\.\d+)?"


def rows_of(text, heading):
    """The cells of the rows of all tables below a heading of the second level."""
    section = re.search(rf"^## {re.escape(heading)}$(.*?)(?=^## |\Z)", text, re.M | re.S)
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in (section[1] if section else "").splitlines() if line.startswith("|")]


def number(text):
    return float(text.replace(",", "").strip("* "))


def figures(page):
    """(what, least, most), as they are written."""
    trot = [row for row in rows_of(page, "The trot's controller") if re.search(r"^\*\*[\d.]+\*\*$", row[3] if len(row) > 3 else "")]
    ratios = [number(row[3]) for row in trot]
    classical = [number(row[2].split("/")[2]) / number(row[2].split("/")[0]) for row in trot]
    untuned = [row for row in rows_of(page, "Graphs that nobody tuned") if len(row) > 4 and row[2].startswith("**")]
    means, single = [number(row[2]) for row in untuned], [number(row[i]) for row in untuned for i in (3, 4)]
    compiling = [row for row in rows_of(page, "Compiling") if len(row) > 4 and row[2] == "100"]
    same = [number(row[4]) for row in compiling if not row[0].endswith("a type each")]
    other = [number(row[4]) for row in compiling if row[0].endswith("a type each")]
    for what, values, digits in (("times the instructions of the same arithmetic by hand", ratios, 2), ("times those of the graph", classical, 1),
                                 ("times on average in graphs that nobody tuned", means, 2), ("times in single ones", single, 2),
                                 ("s more than Eigen's header alone", same, 1), ("s if each node has a type of its own", other, 1)):
        if values:
            yield what, f"{min(values):.{digits}f} to {max(values):.{digits}f}"
        else:
            yield what, None


def problems(root):
    readme = (root / "README.md").read_text()
    for what, right in figures((root / "docs/performance.md").read_text()):
        stated = re.search(rf"({NUMBER} to {NUMBER}) {re.escape(what)}", readme)
        if right is None:
            yield f"docs/performance.md: no table has the figures of `... {what}`"
        elif not stated:
            yield f"README.md: `{right} {what}` is missing"
        elif stated[1] != right:
            yield f"README.md: `{stated[1]} {what}`: docs/performance.md has {right}"


def main(arguments):
    root = pathlib.Path(arguments[0]).resolve() if arguments else pathlib.Path(__file__).resolve().parents[2]
    found = list(problems(root))
    print("\n".join(found) or "the figures of the README are those that were measured")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
