#!/usr/bin/env python3
"""Checks that every rule of the library has a file in tests/rejects, and every such file a rule.

usage: rules.py [ROOT of the repository]

A rule is a string literal in a header that is, or begins with, its id: "space.mismatch" or "space.mismatch: ...". Each rule
of graphs has a header of its own, a line in one of the LISTS, and a mistake in tests/rejects/many_nodes/mistakes.cpp. What else it says, in which case, is compared in tests/static: there stands each
sentence of its header.
"""
import pathlib
import re
import sys

FAMILIES = ("space observe plan wire node graph rate queue strategy component parameters robot frame transform mapping body skeleton learner "
            "criterion latency remote deployment modes part bus drive quantity beat run recording compiler").split()
LITERAL = re.compile(r'"((?:%s)\.[a-z_]+)[":]' % "|".join(FAMILIES))


def rules(root):
    """Id -> the first header that has it. Comments do not count, nor do wires, whose paths look like ids."""
    found = {}
    for base in ("include", "robots/include", "sim/include", "hardware/include", "dds/include", "record/include", "mpi/include"):
        for header in sorted((root / base).rglob("*.hpp")):
            code = re.sub(r"//.*", "", header.read_text())
            code = re.sub(r"(?:wire|wire_inside|expose|latency|observe|get)<[^>]*>", "", code)
            for rule in LITERAL.findall(code):
                found.setdefault(rule, header.relative_to(root))
    return found


# Each list of the rules of graphs, and the headers of its rules.
LISTS = {"include/cca/graph/diagnosis/rules/rules.hpp": "*/*.hpp",
         "include/cca/graph/deployment/rules/rules_of_deployments.hpp": "deployment_*.hpp",
         "include/cca/graph/modes/rules/list_of_modes.hpp": "modes_*.hpp"}


def rules_of_graphs(root):
    """The ids of the rules of graphs, in the order of the lists. A graph of many nodes must get each message briefly, too."""
    ids = []
    for name in LISTS:
        file = root / name
        listed = re.search(r"using (?:rules|type) = list<(.*?)>;", file.read_text(), re.S) if file.exists() else None
        ids += [name.strip().replace("_", ".", 1) for name in listed[1].split(",")] if listed else []
    return list(dict.fromkeys(ids))


def rule_headers(root):
    """Ids by header, of the folders where each rule has one."""
    return {header.relative_to(root): re.findall(r'id = "([^"]+)";', header.read_text())
            for name, headers in LISTS.items() for header in sorted((root / name).parent.glob(headers))}


def literals(code):
    """The string literals, where the compiler joins them."""
    code = re.sub(r"//.*|#include.*", "", code)
    return re.findall(r'"((?:[^"\\\n]|\\.)*)"', re.sub(r'"\s*\n\s*"', "", code))


def untold(root):
    """Each phrase of three words or more in the header of a rule of graphs is part of a text in tests/static, which compares
    whole messages: a case of a rule that no test breaks is missing there."""
    compared = "\n".join(text for file in sorted((root / "tests/static").glob("*.cpp")) for text in literals(file.read_text()))
    for header in rule_headers(root):
        for phrase in literals((root / header).read_text()):
            if len(phrase.split()) > 2 and phrase.strip() not in compared:
                yield f"{header}: no tells<> in tests/static expects `{phrase.strip()}`"


def forgotten_strategies(root):
    """Each header of component/strategies/ holds a strategy of its name, which has a line in the list of strategies.hpp
    and a row in the first table of docs/strategies.md."""
    folder = root / "include/cca/component/strategies"
    file = folder.with_suffix(".hpp")
    listed = re.search(r"using library_strategies = list<(.*?)>;\n", file.read_text(), re.S) if file.exists() else None
    names = set(re.findall(r"\w+", listed[1])) if listed else set()
    page = root / "docs/strategies.md"
    table = re.search(r"\| strategy \|.*\n((?:\|.*\n)+)", page.read_text()) if page.exists() else None
    rows = {name for row in (table[1].splitlines() if table else []) for name in re.findall(r"`(\w+)", row.split("|")[1])}
    for header in sorted(folder.glob("*.hpp")):
        if header.stem not in names:
            yield f"{header.relative_to(root)}: its strategy is not in the list of include/cca/component/strategies.hpp"
        if header.stem not in rows:
            yield f"{header.relative_to(root)}: its strategy has no row in docs/strategies.md"


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
    listed = rules_of_graphs(root)
    for header, ids in rule_headers(root).items():
        if ids != [header.stem.replace("_", ".", 1)]:
            yield f"{header}: its one rule must have the id {header.stem.replace('_', '.', 1)}"
        elif ids[0] not in listed:
            yield f"{header}: its rule is in none of the lists: {', '.join(LISTS)}"
    yield from untold(root)
    yield from forgotten_strategies(root)
    if not known:
        yield "no rule found in the headers"


def main(arguments):
    root = pathlib.Path(arguments[0]) if arguments else pathlib.Path(__file__).parents[2]
    found = list(problems(root))
    print("\n".join(found) or f"{len(rules(root))} rules, each with a file in tests/rejects")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
