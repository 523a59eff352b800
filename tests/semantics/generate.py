#!/usr/bin/env python3
"""Random well-formed architectures, each from its seed: as graph types of the library, and as text for the interpreter.

    generate.py OUT --seeds 1 320 --per-file 10     writes OUT/architectures_0.cpp, ...
    generate.py OUT --threads ...                   the same, each with a farm on threads
    generate.py OUT --spread ...                    the same, each spread over two to four environments
    generate.py OUT --spread --dds ...              the same, run by processes over DDS
    generate.py OUT --modes ...                     sets of modes; with --spread deployments of them
    generate.py --text 17                           prints what the interpreter gets
    generate.py --code 17                           prints what the compiler gets
    generate.py --list OUT ...                      prints the names of the files it would write
"""
import argparse
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # nothing of ours beside the sources

from architecture import Architecture  # noqa: E402
from modes import SetOfModes  # noqa: E402
from spelling import code, text  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", nargs="?", type=Path)
    parser.add_argument("--seeds", nargs=2, type=int, default=(1, 320), metavar=("FIRST", "LAST"))
    parser.add_argument("--per-file", type=int, default=10)
    parser.add_argument("--text", type=int)
    parser.add_argument("--code", type=int)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--threads", action="store_true")
    parser.add_argument("--spread", action="store_true")
    parser.add_argument("--dds", action="store_true")
    parser.add_argument("--modes", action="store_true")
    options = parser.parse_args()

    def made(seed):
        if options.modes:
            return SetOfModes(seed, options.spread, options.dds)
        return Architecture(seed, options.threads, options.spread, options.dds)

    if options.text is not None:
        print(text(made(options.text)), end="")
    elif options.code is not None:
        print(code(made(options.code)), end="")
    else:
        seeds = list(range(options.seeds[0], options.seeds[1] + 1))
        for number, first in enumerate(range(0, len(seeds), options.per_file)):
            path = options.out / f"architectures_{number}.cpp"
            if options.list:
                print(path)
                continue
            options.out.mkdir(parents=True, exist_ok=True)
            parts = [code(made(seed), options.dds) for seed in seeds[first:first + options.per_file]]
            header = ("run_threads.hpp" if options.threads else "run_over_dds.hpp" if options.dds else "run_deployed.hpp" if options.spread
                      else "run_modes.hpp" if options.modes else "run.hpp")
            path.write_text(f"// Made by tests/semantics/generate.py.\n#include \"{header}\"\n\n" + "\n".join(parts))


if __name__ == "__main__":
    main()
