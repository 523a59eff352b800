#!/usr/bin/env python3
"""Checks which way the headers include one another, and how long they are.

usage: includes.py [ROOT of the repository]

A folder of the core includes only from those to its left in FOLDERS. `runtime` and `config` stand apart, and nothing in
the core includes them; sim and hardware are outside the core. Other libraries are reached from one place each. The tests,
examples and pages that a header's comments name exist.
"""
import pathlib
import re
import sys

MOST_LINES = 300
FOLDERS = ["base", "space", "component", "graph", "skeleton", "adaptive", "mapping", "motor", "robot"]
APART = {"runtime": ["base", "space", "component", "graph"], "config": ["base", "space", "component"]}
TOP = {"cca.hpp": FOLDERS + ["runtime"], "config.hpp": ["config"] + APART["config"],  # directly in cca/: what each may include
       **{f"{folder}.hpp": [folder] for folder in ("adaptive", "mapping", "motor", "robot")}}
SHARED = ["sim/oncilla_model.hpp", "sim/oncilla_spaces.hpp"]  # of the simulator, but without the engine: the real robot's, too
FREE = ["version.hpp"]  # needs nothing, so anything may include it


def allowed(folder):
    if folder in APART:
        return APART[folder] + [folder]
    if folder in FOLDERS:
        return FOLDERS[:FOLDERS.index(folder) + 1]
    return None


def cca_include(where, target, core):
    """What is wrong with `#include <cca/target>` in the header `where` (relative to cca/), or None."""
    if target in FREE:
        return None
    outside = target.split("/")[0] in ("sim", "hardware")
    if not core:
        if target in SHARED:
            return None
        return "an adapter includes another one" if outside and target.split("/")[0] != where.split("/")[0] else None
    if outside:
        return "the core includes an adapter"
    if "/" not in target:
        return f"no header includes {target}: include what is needed"
    may = allowed(where.split("/")[0]) if "/" in where else TOP.get(where)
    if may is None:
        return "this header has no place in the layout"
    return None if target.split("/")[0] in may else f"may include only from: {' '.join(may)}"


def other_include(where, target, core):
    """The same for a header of another library."""
    if target.startswith("toml++/") and not where.startswith(("config/", "config.hpp")):
        return "toml++ belongs in config.hpp and config/"
    if target.startswith("ode/") and (core or not where.startswith("sim/")):
        return "the physics engine belongs in sim/"
    if target == "boost/hana.hpp":
        return "include Hana's granular headers"
    if target.startswith("boost/") and not target.startswith("boost/hana/"):
        return "of Boost only Hana is used"
    return None


def problems(root):
    boost = {}
    for base, core in (("include", True), ("sim/include", False), ("hardware/include", False)):
        top = root / base / "cca"
        for header in sorted(top.rglob("*.hpp")):
            where = header.relative_to(top).as_posix()
            text = header.read_text()
            lines = text.splitlines()
            name = header.relative_to(root)
            if len(lines) > MOST_LINES:
                yield f"{name}: {len(lines)} lines, more than {MOST_LINES}"
            if "#pragma once" not in lines:
                yield f"{name}: no #pragma once"
            if not re.match(r"(#pragma once\s+)?//", text):
                yield f"{name}: does not begin with a comment that says what it is for"
            for number, line in enumerate(lines, 1):
                for named in re.findall(r"(?:tests|examples)/[\w/]+\.[ch]pp|\bdocs/\w+\.md", line) if line.lstrip().startswith("//") else []:
                    if not (root / named).exists():
                        yield f"{name}:{number}: there is no {named}"
                include = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
                if not include:
                    continue
                target = include[2]
                if include[1] == '"':
                    wrong = "write <cca/...>"
                elif target.startswith("cca/"):
                    wrong = cca_include(where, target[len("cca/"):], core)
                else:
                    wrong = other_include(where, target, core)
                    if target.startswith("boost/"):
                        boost.setdefault(name, number)
                if wrong:
                    yield f"{name}:{number}: <{target}>: {wrong}"
    if len(boost) > 1:
        yield "Hana is included by more than one header: " + ", ".join(map(str, boost))


def main(arguments):
    root = pathlib.Path(arguments[0]) if arguments else pathlib.Path(__file__).parents[2]
    found = list(problems(root))
    print("\n".join(found) or "headers include in the right direction")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
