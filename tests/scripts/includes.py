#!/usr/bin/env python3
"""Checks which way the headers include one another, how long they are, and how many stand in a folder.

usage: includes.py [ROOT of the repository]

A folder of the core includes only from the folders to its left in FOLDERS. `runtime`, `config`, `trace` and `main` stand apart,
and nothing in the core includes them. A folder that ROOMS lists, or a header there, includes only from those before it; a header
that only forwards from its former place may point anywhere in its folder. Every folder of headers has a place in ROOMS. No two
headers of include/cca have the same name, and macros stand in base/ and runtime/ only. Outside of the core, robots, sim, hardware,
dds, record, door, mpi and python include only from the parts in OUTSIDE. Other libraries are included from one place each. The tests, examples and
pages that a header's comments name exist.
"""
import collections
import pathlib
import re
import sys

MOST_LINES = 340  # an idea of 340 lines is better than two halves that are always read together
MOST_HEADERS = 20  # in a folder
FOLDERS = ["base", "space", "component", "graph", "skeleton", "adaptive", "mapping", "motor", "robot"]
APART = {"runtime": ["base", "space", "component", "graph"], "config": ["base", "space", "component"],
         "trace": ["base", "component", "graph", "runtime"], "main": ["base", "space", "component", "graph", "runtime", "config", "trace"]}
# Headers directly in cca/, and the folders that each may include from.
TOP = {"cca.hpp": FOLDERS + ["runtime"], "deployment.hpp": ["graph", "runtime"], "modes.hpp": ["graph", "runtime"], "config.hpp": ["config"] + APART["config"], "main.hpp": ["main"], "trace.hpp": ["graph", "trace"]} | {
    f"{folder}.hpp": FOLDERS[: FOLDERS.index(folder) + 1] for folder in FOLDERS}
OUTSIDE = {"robots": ["robots"], "sim": ["sim", "robots"], "hardware": ["hardware", "robots"], "dds": ["dds"], "record": ["record"], "door": ["door", "record"], "mpi": ["mpi", "sim"], "python": ["python", "sim"]}  # and from the core
ROOTS = {"include": None, "robots/include": "robots", "sim/include": "sim", "hardware/include": "hardware", "dds/include": "dds", "record/include": "record", "door/include": "door", "mpi/include": "mpi", "python/include": "python"}
FOLDERS_OF_PROGRAMS = ["tools", "examples"]  # their headers are counted, too
# Rooms: each includes only from those before it. "." is what stands directly in the folder, but for the headers that are rooms by
# themselves: few others need them, or they stand for a folder. Every folder with folders of headers is listed, with all of them.
ROOMS = {"base": [".", "math", "math.hpp", "messages", "recording", "response", "separate", "system"],
         "space": ["frame.hpp", "origin.hpp", "quantity.hpp", "dimension.hpp", "limits.hpp", "messages", "methods", "."],
         "component": ["ports", "testing/test_mark.hpp", ".", "testing", "strategies", "strategies.hpp"],
         "graph": ["items", "plan", "diagnosis", "planning", "layout", "verdict", "marks", "modes", "deployment", "."],
         "graph/diagnosis": [".", "rules"],
         "graph/diagnosis/rules": ["wires", "observers", "components", "strategies", "time", "commands", "."],
         "graph/modes": ["mode_info.hpp", "events_of_modes.hpp", "rules", "."],
         "graph/deployment": ["environments.hpp", "placement_events.hpp", "rules", "."],
         "graph/planning": ["steps", "."],
         "adaptive": [".", "numerics", "learning", "extreme_learning_machine.hpp", "ode_odeint.hpp", "ode_solver.hpp", "training.hpp",
                      "sampling.hpp", "module", "plan", "sequence.hpp", "sequencer.hpp", "choice", "assembly", "adaptive_component.hpp"],
         "mapping": ["network", ".", "imported"],
         "motor": ["equations", ".", "modules"],
         "robot": ["body_mistakes.hpp", "body.hpp", "body_tree.hpp", "recorded", ".", "dynamics", "compliance"],
         "runtime": ["signals", "samples", "observers", ".", "live", "modes", "environments", "transports"],
         "runtime/environments": ["exchange", "waiting", "links", "loop", "."],
         "robots": [".", "arm", "oncilla"],
         "hardware": ["bus", "drives", "safety", "robot", "oncilla", "virtual_drives"],
         "hardware/robot": ["boards", "."],
         "sim": ["rollouts", "engine", "robot", "uncertain", "compiled", "oncilla", "."],
         "sim/compiled": ["scalar.hpp", "slots.hpp", "lanes", "branches.hpp", "joint_forces.hpp", "compiled_tree.hpp", "tree_motion.hpp", "around", "limbs", "on_links.hpp", "built", ".", "contacts", "compiled_state.hpp", "readings", "step", "compiled_world.hpp", "together", "robot.hpp", "plant.hpp"],
         "sim/robot": ["model", "tree", "forces", "world", "."],
         "record": ["mcap", "messages", "file", "loops", "replay", "."],
         "dds": ["domain", "nodes", "deployment", "."],
         "door": ["controls.hpp", "settings.hpp", "network", "."],
         "ros2": ["address.hpp", "quality.hpp", "messages", "."]}
FREE = ["version.hpp"]  # includes nothing, so any header may include it


def allowed(folder):
    if folder in APART:
        return APART[folder] + [folder]
    if folder in FOLDERS:
        return FOLDERS[:FOLDERS.index(folder) + 1]
    return None


def room_include(where, target):
    """The mistake in an include from one room of a folder into another."""
    for folder, rooms in ROOMS.items():
        if not where.startswith(f"{folder}/") or not target.startswith(f"{folder}/"):
            continue
        here, there = (room_of(path[len(folder) + 1:], rooms) for path in (where, target))
        if here == "." and "." not in rooms:
            continue  # a header that forwards from its former place
        for room in (here, there):
            if room not in rooms:
                return f"{folder}/ has no place for {room}: state in ROOMS what it may include"
        if rooms.index(there) > rooms.index(here):
            return f"{folder}/{here} may include only from: {' '.join(rooms[:rooms.index(here) + 1])}"
    return None


def room_of(path, rooms):
    if path in rooms:
        return path
    return path.split("/")[0] if "/" in path else "."


def unknown_rooms(root):
    """Folders of headers that have no place in ROOMS, and places there that are no longer used."""
    paths = {header.relative_to(root / base / "cca").as_posix() for base in ROOTS for header in (root / base / "cca").rglob("*.hpp")}
    inside = collections.defaultdict(set)
    for path in paths:
        for folder in list(pathlib.PurePath(path).parents)[1:-1]:
            inside[folder.as_posix()].add(path[len(folder.as_posix()) + 1:].split("/")[0])
    for folder, rooms in sorted(inside.items()):
        for room in sorted(rooms - set(ROOMS.get(folder, []))):
            yield f"{folder}/{room}: a folder of headers that has no place in ROOMS"
    for folder, rooms in ROOMS.items():
        for room in rooms:
            if room != "." and f"{folder}/{room}" not in paths and room not in inside[folder]:
                yield f"{folder}/{room}: has a place in ROOMS, but there is no such header or folder of headers"


def cca_include(where, target, part, forwards):
    """The mistake in `#include <cca/target>` in the header `where` (relative to cca/) of a part outside of the core, or None."""
    if target in FREE:
        return None
    moved = forwards and where.split("/")[-1] == target.split("/")[-1]  # its former place may be in any room
    if wrong := not moved and room_include(where, target):
        return wrong
    folder = target.split("/")[0]
    if part:
        if folder in OUTSIDE and folder not in OUTSIDE[part]:
            return f"{part} may include only from the core and: {' '.join(OUTSIDE[part])}"
        return None
    if folder in OUTSIDE:
        return "the core includes an adapter or a robot"
    if "/" not in target:
        return f"no header includes {target}: include the headers that are needed"
    may = allowed(where.split("/")[0]) if "/" in where else TOP.get(where)
    if may is None:
        return "this header has no place in the layout"
    return None if folder in may else f"may include only from: {' '.join(may)}"


def other_include(where, target, part):
    """The same for a header of another library."""
    if target.startswith("toml++/") and not where.startswith(("config/", "config.hpp")):
        return "toml++ belongs in config.hpp and config/"
    if target.startswith("CLI/") and not where.startswith("main/"):
        return "CLI11 belongs in main/"
    if target.startswith("ode/") and part != "sim":
        return "the physics engine belongs in sim/"
    if target.startswith("dds/") and part != "dds":
        return "Cyclone DDS belongs in dds/"
    if target == "zstd.h" and part != "record":
        return "Zstandard belongs in record/"
    if target == "mpi.h" and part != "mpi":
        return "MPI belongs in mpi/"
    if target.startswith("pybind11/") and part != "python":
        return "pybind11 belongs in python/"
    if target == "boost/hana.hpp":
        return "include Hana's granular headers"
    if target.startswith("nlohmann/") and not where.startswith("door/network/"):
        return "nlohmann-json belongs in door/network/"
    if target.startswith(("boost/asio/", "boost/beast/")):
        return None if where.startswith(("door/network/", "door/server_functions.hpp")) else "Asio and Beast belong in door/network/"
    if target.startswith("boost/") and not target.startswith("boost/hana/"):
        return "of Boost only Hana is used, and in door/ Asio and Beast"
    return None


def macro_problems(name, where, lines):
    """Macros stand in base/ and runtime/ only; elsewhere a compiler workaround is a function or a type with a name."""
    if where.startswith(("base/", "runtime/")):
        return
    for number, line in enumerate(lines, 1):
        if re.match(r"\s*#\s*define\b", line):
            yield f"{name}:{number}: a macro outside of base/ and runtime/"


def form_problems(name, text, lines):
    if len(lines) > MOST_LINES:
        yield f"{name}: {len(lines)} lines, more than {MOST_LINES}"
    if "#pragma once" not in lines:
        yield f"{name}: no #pragma once"
    if not re.match(r"(#pragma once\s+)?//", text):
        yield f"{name}: does not begin with a comment that says its purpose"


def is_forwarder(text):
    """Only a comment and one include."""
    code = [line for line in text.splitlines() if line and not line.startswith("//") and line != "#pragma once"]
    return len(code) == 1 and code[0].startswith("#include <cca/")


def folder_problems(root):
    """Folders with too many headers, and headers of one name.

    In include/cca no two headers have the same file name. The headers directly in it are exempt: each stands for a folder
    or for a way to use the library (`mapping.hpp` for mapping/, `modes.hpp`), and may include the header of its name. A
    header that only forwards, such as the short path of a drive, is exempt, too, and does not count in its folder.
    """
    names = collections.defaultdict(list)
    for base in [f"{base}/cca" for base in ROOTS] + FOLDERS_OF_PROGRAMS:
        count = collections.Counter(header.parent.relative_to(root) for header in (root / base).rglob("*.hpp") if not is_forwarder(header.read_text()))
        for folder, headers in sorted(count.items()):
            if headers > MOST_HEADERS:
                yield f"{folder}: {headers} headers, more than {MOST_HEADERS}: make folders of its parts"
    top = root / "include/cca"
    for header in sorted(top.rglob("*.hpp")):
        if header.parent != top and not is_forwarder(header.read_text()):
            names[header.name].append(header.relative_to(root))
    for same in names.values():
        if len(same) > 1:
            yield f"{same[1]}: {same[0]} has the same name"


def problems(root):
    boost = {}
    for base, part in ROOTS.items():
        top = root / base / "cca"
        for header in sorted(top.rglob("*.hpp")):
            where = header.relative_to(top).as_posix()
            text = header.read_text()
            lines = text.splitlines()
            name = header.relative_to(root)
            yield from form_problems(name, text, lines)
            yield from macro_problems(name, where, lines)
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
                    wrong = cca_include(where, target[len("cca/"):], part, is_forwarder(text))
                else:
                    wrong = other_include(where, target, part)
                    if target.startswith("boost/hana/"):
                        boost.setdefault(name, number)
                if wrong:
                    yield f"{name}:{number}: <{target}>: {wrong}"
    if len(boost) > 1:
        yield "Hana is included by more than one header: " + ", ".join(map(str, boost))
    yield from folder_problems(root)


def main(arguments):
    root = pathlib.Path(arguments[0]) if arguments else pathlib.Path(__file__).parents[2]
    found = [*problems(root), *unknown_rooms(root)]
    print("\n".join(found) or "headers include in the right direction")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
