#!/usr/bin/env python3
"""Checks the table of components in docs/components.md: which header each one is in.

usage: components.py [ROOT of the repository]

Each row names types that its header declares and that no other row names, and a page that names the header as a user includes it. Each header of
motor/, adaptive/, their parts, mapping/, robot/, robot/dynamics/, robot/compliance/ and skeleton/ that has a component, a type with a `process` outside of namespace detail,
has a row.
"""
import pathlib
import re
import sys

PAGE = "docs/components.md"
FOLDERS = ("motor", "motor/modules", "adaptive", "adaptive/module", "adaptive/plan", "mapping", "robot", "robot/dynamics", "robot/compliance", "skeleton")
PROCESS = re.compile(r"^\s+(?:\[\[.*?\]\] )?(?:auto|void|[\w:<>]+) process\(", re.M)


def rows(text):
    """(names, header, page) of each row."""
    table = text.split("## Components of the library", 1)[-1]
    for names, header, rest in re.findall(r"^\| (`.*?`) \| `([\w/]+\.hpp)` \|(.*)$", table, re.M):
        page = re.search(r"\]\(([\w/]+\.md)[^)]*\) \|$", rest)
        yield re.findall(r"`(\w+)", names), header, page[1] if page else None


def is_declared(name, code):
    return re.search(rf"\b(?:struct|class|using) {name}\b", code)


def problems(root):
    listed, known = set(), set()
    found = list(rows((root / PAGE).read_text()))
    for names, header, page in found:
        listed.add(header)
        for name in set(names):
            if (name, header) in known:
                yield f"{PAGE}: `{name}` has two rows"
            known.add((name, header))
        file = root / "include/cca" / header
        if not file.exists():
            yield f"{PAGE}: there is no header cca/{header}"
            continue
        for name in names:
            if not is_declared(name, file.read_text()):
                yield f"{PAGE}: `{name}` is not in cca/{header}"
        described = root / "docs" / (page or "")
        if not described.is_file() or f"<cca/{header}>" not in described.read_text():
            yield f"{PAGE}: the page of `{names[0]}`, docs/{page}, does not name <cca/{header}>"
    for folder in FOLDERS:
        for file in sorted((root / "include/cca" / folder).glob("*.hpp")):
            header = f"{folder}/{file.name}"
            public = re.sub(r"namespace (cca::)?detail \{.*?\n\}  // namespace (cca::)?detail", "", file.read_text(), flags=re.S)
            if header not in listed and PROCESS.search(public):
                yield f"{PAGE}: cca/{header} has a component, and no row"
    if not found:
        yield f"{PAGE}: no table of components found"


def main(arguments):
    root = pathlib.Path(arguments[0]) if arguments else pathlib.Path(__file__).parents[2]
    found = list(problems(root))
    print("\n".join(found) or "each component stands in the table, with its header")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
