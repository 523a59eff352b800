#!/usr/bin/env python3
"""Runs a controller by several compilers and machines, each told the same of what a robot sensed: every sample that it publishes
must have the same bits.

usage: controllers.py NAME --in FOLDER --root REPOSITORY --flags="FLAG;..." --gnu="FLAG;..." [--extract PROGRAM -- PROGRAM ARGUMENTS...]

NAME.cpp in this folder is the controller. If it is told something, its first comment names the topics of what was sensed, PROGRAM records
a run (--record FILE is added), and `extract` takes the topics out of it. Without PROGRAM the robot is simulated in NAME.cpp.
FLAG: those of cca::same_bits, for all, and for g++.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent


def run(command, **options):
    done = subprocess.run([str(word) for word in command], **options)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}")


def difference(wanted, got):
    """Where the outputs of two machines first differ, or None."""
    for a, b in zip(wanted, got):
        if a != b:
            return f"beat {b.split()[0]}, {b.split()[1]}" if a.split()[:2] == b.split()[:2] else f"`{b}` where the other has `{a}`"
    return None if len(wanted) == len(got) else f"{len(got)} samples, elsewhere {len(wanted)}"


def main():
    split = sys.argv.index("--") if "--" in sys.argv else len(sys.argv)
    parser = argparse.ArgumentParser()
    parser.add_argument("name")
    parser.add_argument("--in", dest="folder", type=pathlib.Path, required=True)
    parser.add_argument("--root", type=pathlib.Path, required=True)
    parser.add_argument("--extract")
    parser.add_argument("--flags", required=True)
    parser.add_argument("--gnu", default="")
    o = parser.parse_args(sys.argv[1:split])
    flags, gnu = ([flag for flag in flags.split(";") if flag] for flags in (o.flags, o.gnu))
    folder = o.folder / o.name
    folder.mkdir(parents=True, exist_ok=True)

    recording, sensed = folder / "run.mcap", folder / "sensed"
    with sensed.open("wb") as to:
        if recorded := sys.argv[split + 1:]:
            run([*recorded, "--record", recording], cwd=folder, stdout=subprocess.DEVNULL)
            comment = re.match(r"(//.*\n)+", (HERE / f"{o.name}.cpp").read_text())[0]
            run([o.extract, recording, *re.findall(r"(?<= )/\w[\w/]*", comment)], stdout=to)
            recording.unlink()
    shutil.copy(o.root / "examples/combination_of_skills/trot.shape", folder)

    # Never -I/usr/include for WebAssembly: these are the headers of this machine.
    headers = folder / "headers"
    headers.mkdir(exist_ok=True)
    for library in ("boost", "eigen3"):
        if not (headers / library).exists():
            (headers / library).symlink_to(f"/usr/include/{library}")
    common = ["-std=c++20", *(f"-I{o.root}/{room}include" for room in ("", "robots/", "sim/")), "-isystem", headers, "-isystem", headers / "eigen3", *flags]
    page = o.root / "page/wasm"
    native = [] if " avx2 " in pathlib.Path("/proc/cpuinfo").read_text() else ["qemu-x86_64", "-cpu", "max"]
    machines = {
        "g++ -O2, x86-64-v2": ([], ["g++", "-O2", "-march=x86-64-v2", *gnu]),
        "g++ -O3, x86-64-v3": (native, ["g++", "-O3", "-march=x86-64-v3", *gnu]),
        "clang -O2, x86-64-v3": (native, ["clang++-19", "-O2", "-march=x86-64-v3"]),
        "WebAssembly -O2": (["node", "--no-warnings", HERE / "run_wasi.mjs"],
                            ["clang++-19", "--target=wasm32-wasi", "-O2", "-include", page / "stand_ins.hpp", f"-I{page}/single_thread", page / "exceptions.cpp",
                             "-Wl,-z,stack-size=1048576"]),
    }
    without_packets = ["-DCCA_SAME_BITS", "-DEIGEN_DONT_VECTORIZE"]
    if o.name == "simulated_trot":  # its parts have the same bits with packets, too
        machines["g++ -O2, Eigen with packets"] = ([], ["g++", "-O2", *gnu])
    first, problems = None, []
    for machine, (runner, compiler) in machines.items():
        program = folder / "program"
        given = [flag for flag in common if flag not in without_packets] if "with packets" in machine else common
        run([*compiler, *given, HERE / f"{o.name}.cpp", "-o", program])
        with sensed.open("rb") as told:
            done = subprocess.run([*map(str, runner), str(program), *([str(sensed)] if "node" in runner else [])], stdin=told, cwd=folder,
                                  stdout=subprocess.PIPE, text=True)
        if done.returncode:
            sys.exit(f"{machine}: exit code {done.returncode}")
        lines = done.stdout.splitlines()
        first = first or lines
        if len(first) < 1000:
            sys.exit(f"{machine}: {len(first)} samples only")
        if where := difference(first, lines):
            problems.append(f"{machine} differs from {next(iter(machines))}: {where}")
    sys.exit("\n".join(problems) or print(f"{len(first)} samples have the same bits by {', '.join(machines)}"))


if __name__ == "__main__":
    main()
