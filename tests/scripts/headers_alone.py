#!/usr/bin/env python3
"""Compiles each header alone: what a header of cca uses of cca, it includes.

usage: headers_alone.py ROOT FOLDER N -- COMPILER [FLAGS...]

clang only. What the headers include from outside of cca is precompiled, once, into FOLDER. So a missing <vector> does not
show here; the target all_verify_interface_header_sets of the presets that are run by hand finds it, in three times the time.
Each N-th header is compiled; the hash of the commit says which.
"""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

import reject

ROOTS = ["include", "robots/include", "sim/include", "hardware/include", "dds/include", "record/include", "mpi/include"]


def headers(root):
    return sorted(str(header.relative_to(root / folder)) for folder in ROOTS for header in (root / folder).rglob("*.hpp"))


def share(found, one_of, commit):
    """Each one_of-th header. The commit says which, so over many commits all have their turn."""
    return found[int(commit[:8] or "0", 16) % one_of::one_of]


def includes_from_outside(root):
    found = set()
    for folder in ROOTS:
        for header in (root / folder).rglob("*.hpp"):
            found |= set(re.findall(r"^ *#include (<(?!cca/)[^>]+>)", header.read_text(), re.M))
    return sorted(found)


def precompiled(source, command, target):
    done = subprocess.run([*command, "-x", "c++-header", str(source), "-o", str(target)], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    return done.stdout if done.returncode else ""


def compiled_alone(header, folder, command):
    """What the compiler says of a header, or the empty string. A header is compiled as one, so no template waits for its end."""
    source = folder / header.replace("/", "_")
    source.write_text(f"#include <{header}>\n")
    return precompiled(source, [*command, "-include-pch", str(folder / "outside.pch")], os.devnull)


def refused(found, folder, command):
    """The headers that do not compile, each with what the compiler says."""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        outputs = workers.map(lambda header: compiled_alone(header, folder, command), found)
        return [(header, output) for header, output in zip(found, outputs) if output]


def main(arguments):
    if len(arguments) < 5 or arguments[3] != "--":
        sys.exit(__doc__)
    root, folder, one_of = pathlib.Path(arguments[0]), pathlib.Path(arguments[1]), int(arguments[2])
    command = reject.as_users_have_it(arguments[4:])
    folder.mkdir(parents=True, exist_ok=True)
    outside = folder / "outside.hpp"
    outside.write_text("".join(f"#include {name}\n" for name in includes_from_outside(root)))
    said = precompiled(outside, command, folder / "outside.pch")
    if said:
        sys.exit(f"{said}\n{outside}: what the headers include from outside does not compile")
    commit = subprocess.run(["git", "-C", str(root), "rev-parse", "HEAD"], stdout=subprocess.PIPE, text=True).stdout
    found = share(headers(root), one_of, commit)
    wrong = refused(found, folder, command)
    for header, output in wrong:
        print(f"{output}\n{header}: does not compile alone")
    if wrong or not found:
        sys.exit(f"{len(wrong)} of {len(found)} headers do not compile alone")
    print(f"each of {len(found)} headers compiles alone")


if __name__ == "__main__":
    main(sys.argv[1:])
