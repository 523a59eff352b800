#!/usr/bin/env python3
"""Checks that each refusal of a door has a test.

usage: refusals.py [ROOT of the repository]

A statement that refuses, in the headers of a door, has a text. tests/runtime/door/refusals.txt has a line for each:

    words of the refusal | file of the test | words of the test

The words of the refusal stand in such a statement, and each such statement has a line. The words of the test stand in its file.
"""
import pathlib
import re
import sys

TABLE = "tests/runtime/door/refusals.txt"
SOURCES = ["door/include/cca/door/**/*.hpp", "include/cca/runtime/observers/begun_anew.hpp"]
REFUSES = re.compile(r"refused_greeting\(|status_message\(\s*2|\brefuse\(|\brefused\(|how::refused|why = |\bfail\(|\.close\(|wrong = "
                     r"|again = |return name \+|complain\(")
SENTENCE = re.compile(r"return\s[^;]*\"[a-z][^\"]{14,}\"")
LITERAL = re.compile(r"\"((?:[^\"\\]|\\.)*)\"")
SHORT = 10  # letters; what is shorter or one word is part of a sentence, or the name of something


def refusals(text):
    """The texts of each statement that refuses: a list of literals."""
    text = re.sub(r"//[^\n]*", "", text)
    for statement in re.split(r"[;{}]\s*\n", text):
        if REFUSES.search(statement) or SENTENCE.search(statement):
            literals = [one for one in LITERAL.findall(statement) if len(one) >= SHORT and " " in one and not one.startswith("/cca")]
            if literals:
                yield literals


def rows(text):
    for line in text.splitlines():
        if line and not line.startswith("#"):
            yield [cell.strip() for cell in line.split(" | ")]


def check(root):
    table = []
    for row in rows((root / TABLE).read_text()):
        if len(row) != 3:
            yield f"{TABLE}: expected three cells: {' | '.join(row)}"
        else:
            table.append(row)
    used = set()
    for pattern in SOURCES:
        for path in sorted(root.glob(pattern)):
            for literals in refusals(path.read_text()):
                having = [row[0] for row in table if any(row[0] in literal for literal in literals)]
                used.update(having)
                if not having:
                    yield f"{path.relative_to(root)}: \"{literals[0]}\": write a test of this refusal, and a line for it in {TABLE}"
    for words, file, of_test in table:
        if words not in used:
            yield f"{TABLE}: no refusal says \"{words}\""
        test = root / file
        if not test.is_file() or of_test not in re.sub(r"\"\s*\n\s*\"", "", test.read_text()):
            yield f"{TABLE}: \"{words}\": {file} has no \"{of_test}\""


if __name__ == "__main__":
    found = list(check(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
    print("\n".join(found))
    sys.exit(bool(found))
