#!/usr/bin/env python3
"""Checks that every rule of the library has a file in tests/rejects, and every such file a rule.

usage: rules.py [ROOT of the repository]

A rule is a string literal in a header that is, or begins with, its id: "space.mismatch" or "space.mismatch: ...". Those
that graphs are checked by stand also in tests/rejects/many_nodes/mistakes.cpp.
"""
import pathlib
import re
import sys

FAMILIES = ("space wire node graph rate queue strategy component parameters robot frame transform mapping body skeleton learner "
            "criterion latency remote deployment bus drive").split()
LITERAL = re.compile(r'"((?:%s)\.[a-z_]+)[":]' % "|".join(FAMILIES))


def rules(root):
    """Id -> the first header that has it. Comments are left out, and so are wires, whose paths look alike."""
    found = {}
    for base in ("include", "robots/include", "sim/include", "hardware/include"):
        for header in sorted((root / base).rglob("*.hpp")):
            code = re.sub(r"//.*", "", header.read_text())
            code = re.sub(r"(?:wire|expose|latency|observe|get)<[^>]*>", "", code)
            for rule in LITERAL.findall(code):
                found.setdefault(rule, header.relative_to(root))
    return found


def rules_of_graphs(root):
    """The ids in graph/rules.hpp: those that a graph of many nodes must be told briefly, too."""
    header = root / "include/cca/graph/rules.hpp"
    return re.findall(r'^    "([a-z_]+\.[a-z_]+)",', header.read_text(), re.M) if header.exists() else []


def problems(root):
    known = rules(root)
    tested = {file.stem.split("-")[0]: file for file in sorted((root / "tests/rejects").glob("*.cpp"))}
    for rule, header in sorted(known.items()):
        if rule not in tested:
            yield f"{rule} ({header}) has no file tests/rejects/{rule}.cpp"
    mistakes = root / "tests/rejects/many_nodes/mistakes.cpp"
    among_many = set(re.findall(r"^// EXPECT \w+: ([a-z_.\\]+):", mistakes.read_text(), re.M)) if mistakes.exists() else set()
    for rule in rules_of_graphs(root):
        if rule.replace(".", "\\.") not in among_many:
            yield f"{rule} is not in {mistakes.relative_to(root)}"
    for rule, file in tested.items():
        if rule not in known:
            yield f"{file.relative_to(root)}: no header states the rule {rule}"
    if not known:
        yield "no rule found in the headers"


def main(arguments):
    root = pathlib.Path(arguments[0]) if arguments else pathlib.Path(__file__).parents[2]
    found = list(problems(root))
    print("\n".join(found) or f"{len(rules(root))} rules, each with a file in tests/rejects")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
