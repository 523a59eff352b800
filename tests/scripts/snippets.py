#!/usr/bin/env python3
"""Checks that the code in the documentation is the code that is built and tested.

usage: snippets.py [--write] [ROOT of the repository]

A block of a .md file that follows `<!-- from <file>: <name> -->` must equal the lines of <file> between the comments that
end in `[<name>]` and `[<name> end]`; indentation may differ. --write copies the lines into the page. A comment
`<!-- from ... -->` that no block follows is an error.
In README.md every C++ block must be cut from a file in this way.
"""
import pathlib
import re
import sys
import textwrap

BLOCK = re.compile(r"(?:<!-- from (?P<file>\S+): (?P<name>[^>]+?) -->\n+)?^```(?P<language>\w*)\n(?P<code>.*?)^```$", re.M | re.S)

MARK = re.compile(r"^<!-- from \S+: [^>]+? -->$", re.M)


def region(source, name):
    lines = source.splitlines(keepends=True)
    marks = [[i for i, line in enumerate(lines) if line.rstrip().endswith(mark)] for mark in (f"[{name}]", f"[{name} end]")]
    if any(len(mark) != 1 for mark in marks) or marks[0] >= marks[1]:
        return None
    return textwrap.dedent("".join(lines[marks[0][0] + 1:marks[1][0]]))


def check(page, root, write):
    """Yields the problems of one .md file."""
    text = page.read_text()
    fresh, last = [], 0
    with_blocks = {block.start() for block in BLOCK.finditer(text)}
    for mark in MARK.finditer(text):
        if mark.start() not in with_blocks:
            line = text.count("\n", 0, mark.start()) + 1
            yield f"{page.relative_to(root)}:{line}: no block of code follows {mark[0]}; write an empty one, and tests/scripts/snippets.py --write fills it"
    for block in BLOCK.finditer(text):
        line = text.count("\n", 0, block.start("code"))
        where = f"{page.relative_to(root)}:{line}"
        if not block["file"]:
            if page.name == "README.md" and block["language"] == "cpp":
                yield f"{where}: a C++ block that is not cut from a tested file"
            continue
        source = root / block["file"]
        code = region(source.read_text(), block["name"]) if source.is_file() else None
        if code is None:
            yield f"{where}: {block['file']} has no region [{block['name']}]"
        elif code != block["code"]:
            fresh += [text[last:block.start("code")], code]
            last = block.end("code")
            if not write:
                yield f"{where}: differs from [{block['name']}] in {block['file']}; tests/scripts/snippets.py --write copies it"
    if write and fresh:
        page.write_text("".join(fresh) + text[last:])
        print(f"{page.relative_to(root)}: updated")


def main(arguments):
    write = "--write" in arguments
    rest = [a for a in arguments if a != "--write"]
    root = pathlib.Path(rest[0]).resolve() if rest else pathlib.Path(__file__).resolve().parents[2]
    pages = [root / "README.md", root / "CONTRIBUTING.md", *sorted((root / "docs").rglob("*.md"))]
    found = [problem for page in pages if page.is_file() for problem in check(page, root, write)]
    print("\n".join(found) or "all code in the documentation is tested code")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
