#!/usr/bin/env python3
"""Checks that the documentation shows what a program prints.

usage: outputs.py [--write] NAME -- PROGRAM [ARGUMENTS...]
       outputs.py [--write] --errors NAME -- COMPILER [FLAGS...]

The block of a .md file that follows `<!-- output of NAME -->` must equal what the program prints. It runs in the root of
the repository and must not crash. With --errors, the compiler must fail, and the block must equal its lines that
hold an error or name the file that is compiled, without folders, line numbers and columns: these differ between machines.
--write copies the output into the pages.
"""
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def blocks(name):
    return re.compile(rf"(?P<head><!-- output of {re.escape(name)} -->\n+```\w*\n)(?P<text>.*?)(?P<tail>^```$)", re.M | re.S)


def errors_in(output, file):
    """The lines of a compiler's output that a user looks for, as they look on every machine."""
    lines = []
    for line in output.splitlines():
        if ": error: " in line or (line.startswith(file) and "In file included" not in line):
            line = re.sub(r"^\S*?([^/\s]+):\d+:\d+:", r"\1:", line)
            lines.append(line)
    return "".join(line + "\n" for line in lines)


def run(arguments):
    """Returns what is wrong, or an empty text."""
    split = arguments.index("--")
    options, command = arguments[:split], arguments[split + 1:]
    write, errors = "--write" in options, "--errors" in options
    names = [o for o in options if not o.startswith("--")]
    if len(names) != 1 or not command:
        return __doc__
    name = names[0]
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env={**os.environ, "LC_ALL": "C"})  # compilers quote in plain ASCII
    shown = errors_in(done.stdout, command[-1]) if errors else done.stdout
    if done.returncode < 0 or (errors and done.returncode == 0):
        return f"{' '.join(command)}: ended with {done.returncode}\n{done.stdout}"
    problems, found = [], False
    for page in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        text = page.read_text()
        for block in blocks(name).finditer(text):
            found = True
            if block["text"] == shown:
                continue
            if write:
                page.write_text(blocks(name).sub(lambda b: b["head"] + shown + b["tail"], text))
            else:
                problems.append(f"{page.relative_to(ROOT)}: this is not the output of {name}:\n{block['text']}"
                                f"--- it is:\n{shown}--- to copy it into the page: tests/scripts/outputs.py --write "
                                f"{'--errors ' if errors else ''}'{name}' -- {' '.join(command)}")
    if not found:
        problems.append(f"no page has a block `<!-- output of {name} -->`")
    return "\n".join(problems)


if __name__ == "__main__":
    if "--" not in sys.argv:
        sys.exit(__doc__)
    problem = run(sys.argv[1:])
    if problem:
        sys.exit(problem)
