#!/usr/bin/env python3
"""Checks that clang-format 19 would change no C++ file of the repository.

usage: format.py [--write] [ROOT of the repository]

--write formats the files. The style is in .clang-format.
"""
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys

PROGRAM = "clang-format-19"  # another version formats differently
FILES_PER_CALL = 16


def files_of(root, *endings):
    """The files with these endings that git knows or would add; without git, all but those in hidden and build folders."""
    listed = subprocess.run(["git", "-C", str(root), "ls-files", "--cached", "--others", "--exclude-standard", "-z"],
                            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    if listed.returncode == 0:
        names = [pathlib.Path(name) for name in listed.stdout.split("\0") if name]
    else:
        names = [file.relative_to(root) for file in root.rglob("*")]
        names = [name for name in names if name.parts[0] != "build" and not any(part.startswith(".") for part in name.parts)]
    return sorted({name for name in names if name.suffix in endings and (root / name).is_file()})


def problems(root, program, write):
    """Yields the files that clang-format would change, each with the first place; with `write` it changes them."""
    files = files_of(root, ".hpp", ".cpp")
    mode = ["-i"] if write else ["--dry-run", "--Werror", "--ferror-limit=1"]

    def call(some):
        done = subprocess.run([program, *mode, *map(str, some)], cwd=root, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        places = [line.partition(": error:")[0] for line in done.stdout.splitlines() if ": error:" in line]
        if done.returncode != 0 and not places:
            places = [f"{program} failed: {done.stdout.strip()}"]
        return [f"{place}: not formatted" if not place.startswith(program) else place for place in places]

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for found in pool.map(call, [files[i:i + FILES_PER_CALL] for i in range(0, len(files), FILES_PER_CALL)]):
            yield from found


def main(arguments):
    write = "--write" in arguments
    rest = [argument for argument in arguments if argument != "--write"]
    root = pathlib.Path(rest[0]).resolve() if rest else pathlib.Path(__file__).resolve().parents[2]
    if not shutil.which(PROGRAM):
        sys.exit(f"format: {PROGRAM} is missing: run ./bootstrap")
    found = list(problems(root, PROGRAM, write))
    if found:
        print("\n".join(found))
        sys.exit("format: run tests/scripts/format.py --write")
    print("every C++ file is formatted")


if __name__ == "__main__":
    main(sys.argv[1:])
