#!/usr/bin/env python3
"""Checks that no header brings what a user's file did not ask for.

usage: includes_only.py ROOT COMPILER [FLAGS...]

Each header of LIGHT is preprocessed alone, with the definitions of the CMake targets: none may include the physics engine,
CLI11, toml++, Zstandard, Cyclone DDS or one of Eigen's decompositions, but for what it is there for (ALLOWED). Each header is
bounded by the number of files that it includes, of all libraries: so nobody makes them wider without noticing.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

HEAVY = {"the physics engine": r"/ode/", "CLI11": r"/CLI/", "toml++": r"/toml\+\+/", "Zstandard": r"/zstd\.h$", "Cyclone DDS": r"/dds/dds\.h$", "MPI": r"/mpi\.h$",
         "Eigen's decompositions": r"/Eigen/src/(Cholesky|Eigenvalues|LU|QR|SVD)/"}
ALLOWED = {"cca/record.hpp": ["Zstandard"]}
LIGHT = {"cca/cca.hpp": 900, "cca/deployment.hpp": 1030, "cca/modes.hpp": 870, "cca/mapping.hpp": 800, "cca/robot.hpp": 770,
         "cca/config.hpp": 680, "cca/main.hpp": 1080, "cca/record.hpp": 1020, "cca/sim/robot.hpp": 610, "cca/sim/robot/plant.hpp": 600,
         "cca/robots/arm/description.hpp": 570}


def included(command, header, folder):
    source = folder / "only.cpp"
    source.write_text(f"#include <{header}>\n")
    made = subprocess.run([*command, "-M", str(source)], check=True, capture_output=True, text=True).stdout
    return [name for name in made.replace("\\\n", " ").split() if not name.endswith((":", "only.cpp"))]


def main():
    root, *command = sys.argv[1:]
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        for header, most in LIGHT.items():
            names = included(command, header, pathlib.Path(folder))
            print(f"{header}: {len(names)} files, at most {most}")
            if len(names) > most:
                wrong.append(f"{header} includes {len(names)} files, more than {most}")
            for what, pattern in HEAVY.items():
                found = [name for name in names if re.search(pattern, name)]
                if found and what not in ALLOWED.get(header, []):
                    wrong.append(f"{header} brings {what} into a file that did not ask for it: {found[0]}")
    for line in wrong:
        print(line)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
