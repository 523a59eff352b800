#!/usr/bin/env python3
"""Checks that no two tests use one temporary file: ctest runs them side by side, each as a process.

usage: temporary.py [ROOT of the repository]

A statement that names a file in the folder of temporary files has the number of its process in the name.
tests/laws/temporary_file.hpp does so.
"""
import pathlib
import re
import sys

STATEMENT = re.compile(r"""[^;{}]*(?:temp_directory_path|"/tmp/)[^;]*;""")


def shared_names(text):
    """The lines of `text` where a statement begins that names a temporary file without the number of the process."""
    for statement in STATEMENT.finditer(text):
        words = statement.group().lstrip()
        if "getpid" not in words and "fresh_name" not in words:
            yield text.count("\n", 0, statement.end() - len(words)) + 1


def check(root):
    for path in sorted((root / "tests").rglob("*.[ch]pp")):
        for line in shared_names(path.read_text()):
            yield f"{path.relative_to(root)}:{line}: other tests may have this file at the same time: use laws::temporary_file"


if __name__ == "__main__":
    found = list(check(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
    print("\n".join(found))
    sys.exit(bool(found))
