#!/usr/bin/env python3
"""Checks that what is written for one compiler stands in few places, and that docs/compilers.md says why.

usage: compilers.py [ROOT of the repository]

Only the headers in HOMES name a compiler or ask which one it is. An attribute of a compiler (`[[gnu::...]]`) may stand in base/
and runtime/, which make a beat one function, and in the headers that docs/compilers.md names. A header that refers to
docs/compilers.md is named there, and every header that the page names exists and has an attribute or refers to the page.
"""
import pathlib
import re
import sys

import includes

PAGE = "docs/compilers.md"
HOMES = ["include/cca/base/compiler.hpp", "include/cca/base/inlining.hpp"]
FREE = ("include/cca/base/", "include/cca/runtime/")  # may have attributes
NAME = re.compile(r"g\+\+|\b(gcc|clang|msvc|icc)\b(?!-format|-tidy)", re.IGNORECASE)
QUESTION = re.compile(r"^\s*#\s*(if|elif|ifdef|ifndef)\b.*(__clang|__GNUC|__has_builtin|__apple|_MSC_VER|__AVX)|^\s*#\s*pragma (?!once)|\b_Pragma\b|__builtin_")
ATTRIBUTE = re.compile(r"\b(gnu|clang)::\w+|__attribute__")


def headers(root):
    for base in includes.ROOTS:
        yield from sorted((root / base / "cca").rglob("*.hpp"))


def problems(root):
    page = root / PAGE
    named = set(re.findall(r"`((?:\w+/)*include/cca/[\w/]+\.hpp)`", page.read_text()))
    has_reason = set()
    for header in headers(root):
        where = header.relative_to(root).as_posix()
        if where in HOMES:
            has_reason.add(where)
            continue
        for number, line in enumerate(header.read_text().splitlines(), 1):
            code, _, comment = line.partition("//")
            if ATTRIBUTE.search(code):
                has_reason.add(where)
                if where not in named and not where.startswith(FREE):
                    yield f"{where}:{number}: an attribute of a compiler: say why in {PAGE}"
            if QUESTION.search(code):
                yield f"{where}:{number}: asks for a compiler: only {' and '.join(HOMES)} may"
            if NAME.search(ATTRIBUTE.sub("", line)):
                yield f"{where}:{number}: names a compiler: describe it in {PAGE} and refer to that"
            if PAGE in comment:
                has_reason.add(where)
                if where not in named:
                    yield f"{where}:{number}: refers to {PAGE}, which does not name this header"
    for where in sorted(named - has_reason):
        yield f"{PAGE}: {where} does not exist, has no attribute and does not refer to this page"


def main(arguments):
    root = pathlib.Path(arguments[0]) if arguments else pathlib.Path(__file__).parents[2]
    found = list(problems(root))
    print("\n".join(found) or "what is written for one compiler has its place and its reason")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
