#!/usr/bin/env python3
"""Measures how exact compiled physics is and what it costs, beside the Open Dynamics Engine and MuJoCo, and writes the table
of docs/physics.md.

    physics.py                 everything (half an hour on two cores); builds the programs of bench/physics with clang 19 and g++
    physics.py --only trot     one part: accuracy, stiff, trot, bits, instructions, beside, lanes, rows, compile, worlds; the others keep
                               their figures in bench/physics.json; several: --only trot --only bits
    physics.py --page          only the table, from bench/physics.json

MuJoCo is optional (Debian: libmujoco-dev); without it its rows say that it is not installed. Counts do not depend on how busy
the machine is; times do, and are ratios of one run.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import measure

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
FOLDER = HERE / "physics"
FIGURES = HERE / "physics.json"
PAGE = ROOT / "docs" / "physics.md"
BEGIN, END = "<!-- bench/physics.py writes this table -->", "<!-- end of the table -->"
FLAGS = ["-std=c++20", "-DNDEBUG", "-w", "-ffp-contract=off", "-DCCA_HEADER_ONLY", *measure.INCLUDES, "-I", str(ROOT / "tests/runtime")]
LANES = {4: ["-mavx2"], 8: ["-mavx512f", "-mavx512dq", "-mavx512vl"]}
MUJOCO = pathlib.Path("/usr/include/mujoco/mujoco.h").exists()


def build(work, compiler, name, sources, flags=("-O2",), libraries=()):
    program = work / name
    measure.run([compiler, *FLAGS, *flags, *(str(FOLDER / f"{s}.cpp") for s in sources), "-o", str(program), "-lode", "-lpthread", *libraries])
    return program


def read(program, *words):
    """`name <tab> number` of each line."""
    figures = {}
    for line in measure.run([str(program), *words]).stdout.splitlines():
        name, _, value = line.partition("\t")
        if value:
            figures[name] = value if name == "bits" else float(value)
        else:
            print(line, file=sys.stderr)
    return figures


def accuracy(work):
    return read(build(work, "clang++-19", "accuracy", ["accuracy"]))


def stiff(work):
    return read(build(work, "clang++-19", "stiff", ["stiff"]))


def trot(work):
    return read(build(work, "clang++-19", "trot", ["trot", "commands_of_trot"]), "accuracy")


def bits(work):
    """A hash of the state after a second of trot: of each compiler and level."""
    return {f"{compiler} {level}": read(build(work, compiler, "bits", ["trot", "commands_of_trot"], [level]), "bits")["bits"]
            for compiler in measure.COMPILERS for level in ("-O1", "-O2", "-O3")}


def instructions(work):
    """Of a step of the trot: the difference of two runs."""
    found = {}
    for compiler in measure.COMPILERS:
        program = build(work, compiler, "counted", ["trot", "commands_of_trot"])
        for engine in ("compiled", "ode"):
            lengths = (2000, 2500) if engine == "compiled" else (2000, 2250)
            found[f"{compiler} {engine}"] = measure.instructions(program, "run", engine, lengths=lengths) / 2
    return found


def beside(work):
    found = {"mujoco": MUJOCO}
    for compiler in measure.COMPILERS:
        program = build(work, compiler, "beside", ["beside", "commands_of_trot"], ["-O2", *(["-DBENCH_MUJOCO"] if MUJOCO else [])],
                        ["-lmujoco"] if MUJOCO else [])
        found[compiler] = read(program, "time") | read(program, "check")
    return found


def lanes(work):
    has = pathlib.Path("/proc/cpuinfo").read_text()
    found = {}
    for width, flags in LANES.items():
        if f" {flags[0][2:]} " not in has:
            print(f"lanes: this machine has no {flags[0][2:]}: {width} lanes are not measured", file=sys.stderr)
            continue
        program = build(work, "clang++-19", "lanes", ["lanes", "commands_of_trot"], ["-O2", f"-DBENCH_LANES={width}", *flags])
        found[str(width)] = read(program, "check") | read(program, "time")
    return found


def rows(work):
    """Steps a second of robots of several sizes."""
    return read(build(work, "clang++-19", "rows", ["rows"]))


def worlds(work):
    """Steps a second of a policy at 50 Hz on one core, as Python makes them."""
    has = pathlib.Path("/proc/cpuinfo").read_text()
    width = max((w for w, flags in LANES.items() if f" {flags[0][2:]} " in has), default=0)
    lane_flags = [f"-DBENCH_LANES={width}", *LANES[width]] if width else []
    program = build(work, "clang++-19", "worlds", ["worlds", "commands_of_trot"],
                    ["-O2", "-I", str(ROOT / "python/include"), "-DTOML_HEADER_ONLY=0", "-DTOML_SHARED_LIB=1", *lane_flags, *(["-DBENCH_MUJOCO"] if MUJOCO else [])],
                    ["-ltomlplusplus", *(["-lmujoco"] if MUJOCO else [])])
    return {"width": width} | read(program)


def compile_time(work):
    """Processor time of a file with a world of the Oncilla and its `advance`, g++ -O2, s: the least of three."""
    source = work / "one.cpp"
    source.write_text("#include <cca/robots/oncilla/description.hpp>\n#include <cca/sim/compiled/compiled_world.hpp>\n"
                      "double after_a_beat(std::span<const cca::sim::joint_law> laws) {\n"
                      "  cca::sim::compiled_world<cca::robots::oncilla::description> w;\n  w.advance(laws);\n  return w.joints()[2].angle;\n}\n")
    times = []
    for _ in range(3):
        before = measure.resource.getrusage(measure.resource.RUSAGE_CHILDREN).ru_utime
        measure.run(["g++", "-O2", *FLAGS, "-c", str(source), "-o", str(work / "one.o")])
        times.append(measure.resource.getrusage(measure.resource.RUSAGE_CHILDREN).ru_utime - before)
    return {"seconds": min(times)}


def short(x):
    if x == float("inf"):
        return "stands still (`trouble()`)"
    return f"{x:.1e}" if x and abs(x) < 1e-3 else f"{x:.3g}"


def table(all_figures):
    lines = []

    def row(what, compiled, engine, bound, goal):
        lines.append(f"| {what} | {compiled} | {engine} | {bound} | {goal} |")

    f = {name: part["data"] for name, part in all_figures.items()}
    if "instructions" in f:
        i = f["instructions"]
        row("instructions of a step, trot of the Oncilla, g++ and clang, `-O2`", *(f"{i[f'g++ {e}']:,.0f}; {i[f'clang++-19 {e}']:,.0f}" for e in ("compiled", "ode")), "50,000", "25,000")
    if "beside" in f:
        for compiler, name in (("g++", "g++"), ("clang++-19", "clang")):
            b = f["beside"][compiler]
            row(f"its time, {name}: ns a step, and beside the engine", f"{b['compiled ns']:,.0f}, 1/{b['ode ns'] / b['compiled ns']:.1f}", f"{b['ode ns']:,.0f}", "1/14", "1/25")
            solvers = {k[7:-3]: v for k, v in b.items() if k.startswith("mujoco") and k.endswith(" ns")}
            best = min(solvers, key=solvers.get, default=None)
            row(f"beside MuJoCo, its fastest solver ({best}: {solvers[best]:,.0f} ns)" if best else "beside MuJoCo", f"1/{solvers[best] / b['compiled ns']:.1f}" if best else "MuJoCo is not installed", "", "1/4", "1/6")
    for width, bound, goal in (("4", "0.55", "0.45"), ("8", "0.4", "0.25")):
        if width in f.get("lanes", {}):
            x = f["lanes"][width]
            row(f"time of a robot's step in {width} lanes, beside one alone", f"{x['in lanes ns'] / x['alone ns']:.2f}", "", bound, goal)
    if "accuracy" in f:
        a = f["accuracy"]
        row("accelerations of described and random robots in random states, against the library's dynamics, relative", short(a["accelerations"]), "", "1e-9", "1e-12")
        row("free flight of the Oncilla at up to 2 rad/s, 0.3 s: change of its energy, J", short(a["compiled flight"]), short(a["ode flight"]), "1e-6", "2e-7")
        row("the same with half the step", short(a["compiled flight, half the step"]), short(a["ode flight, half the step"]), "a quarter", "a quarter")
        row("standing load after 10 s, relative", short(a["compiled load"]), short(a["ode load"]), "1e-4", "1e-5")
        row("a block slides down slopes of 38 to 60°: acceleration, relative", short(a["compiled slides"]), short(a["ode slides"]), "1e-5", "1e-6")
        row("it sticks on slopes of 0 to 36°: creep, m/s", short(a["compiled creeps"]), short(a["ode creeps"]), "1e-9", "1e-12")
        row("a disc at 500 rad/s on a free base: angle of nutation after 5 s, relative", short(a["compiled nutation"]), short(a["ode nutation"]), "1e-2", "1e-3")
        row("the same: its rate", short(a["compiled nutation, rate"]), short(a["ode nutation, rate"]), "", "")
    if "trot" in f:
        t = f["trot"]
        both = lambda name: f"{1e3 * t[name + ' trunk']:.2f} mm, {1e3 * t[name + ' joint']:.2g} mrad"
        row("both engines at 1/64 ms with one friction law, after 1 s of trot: trunk, worst joint", both("one friction law"), "", "0.5 mm, 10 mrad", "0.3 mm, 6 mrad")
        row("the same, friction a cone here and a pyramid there", both("cone and pyramid"), "", "", "")
        row("1 s of trot at 0.5 ms from its own limit (1/64 ms)", both("compiled from its limit"), both("ode from its limit"), "5 mm, 60 mrad", "2.5 mm, 30 mrad")
    if "stiff" in f:
        s = f["stiff"]
        for name, what in (("gains x1", "the Oncilla stands: its fastest joint after 30 s, rad/s"), ("gains x100", "the same with gains x100"),
                           ("gains x1000", "with gains x1000"), ("gains and torques x1000", "with gains and torques x1000"),
                           ("heavy trunk", "a trunk of 10,000 times a toe's mass")):
            row(what, short(s[f"compiled {name}"]), short(s[f"ode {name}"]), "at rest", "at rest")
        for ratio in (100, 1000, 10000):
            name = f"chain of 1 to {ratio}"
            row(f"five links that move freely carry {ratio:,} times the mass of each: energy gained in 10 s, J", short(s[f"compiled {name}"]), short(s[f"ode {name}"]), "", "")
    if "bits" in f:
        row("bits after 1 s of trot: g++ and clang, `-O1`, `-O2`, `-O3`", "the same" if len(set(f["bits"].values())) == 1 else "DIFFERENT", "", "the same", "the same")
    if "lanes" in f:
        row("bits of each lane, beside a world alone", "the same" if not any(x["lanes differ"] for x in f["lanes"].values()) else "DIFFERENT", "", "the same", "the same")
    if "compile" in f:
        row("processor time to compile a world, g++ `-O2`, s", f"{f['compile']['seconds']:.1f}", "", "8", "5")
    if "worlds" in f:
        w = f["worlds"]
        for step, bound, goal in (("0.5", "", ""), ("1", "12,000", "50,000")):
            at = lambda what: f"{w[f'{what}, steps of {step} ms']:,.0f}"
            row(f"steps a second of a policy at 50 Hz on one core, trot of the Oncilla in steps of {step} ms: as [worlds of Python](python.md)", at("worlds"), "", bound, goal)
            row("its physics alone" + (f", and in {w['width']} lanes" if w["width"] else ""), at("physics") + (", " + at("lanes") if w["width"] else ""), "", "", "")
            solvers = {name.split()[1].split(",")[0]: value for name, value in w.items() if name.startswith("mujoco") and name.endswith(f"of {step} ms")}
            best = max(solvers, key=solvers.get, default=None)
            row("the same in MuJoCo" + (f", its fastest solver ({best})" if best else ""), f"{solvers[best]:,.0f}" if best else "MuJoCo is not installed", "", "", "")
    if "rows" in f:
        r = f["rows"]
        joined = lambda names: ", ".join(f"{r[name] / 1000:,.0f}" for name in names)
        row("thousand steps a second, clang `-O2`: Oncilla that stands, arm of 7 joints, humanoid of 30 joints in the air", joined(("Oncilla", "arm", "humanoid")), "", "", "")
        row("chains of 4, 8, 12, 16, 24 joints (above 16 in loops)", joined(f"chain of {n}" for n in (4, 8, 12, 16, 24)), "", "", "")
        row("a sledge on 4, 8, 16, 24 feet", joined(f"feet {n}" for n in (4, 8, 16, 24)), "", "", "")
    return "\n".join(["| | compiled | engine | bound | goal |", "|---|---|---|---|---|", *lines])


def main():
    parts = {"accuracy": accuracy, "stiff": stiff, "trot": trot, "bits": bits, "instructions": instructions, "beside": beside, "lanes": lanes, "rows": rows, "compile": compile_time, "worlds": worlds}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", choices=parts, action="append")
    parser.add_argument("--page", action="store_true")
    a = parser.parse_args()
    figures = json.loads(FIGURES.read_text()) if FIGURES.exists() else {}
    if not a.page:
        with tempfile.TemporaryDirectory() as work:
            for name in a.only or parts:
                figures[name] = {"machine": measure.machine(), "data": parts[name](pathlib.Path(work))}
                print(name, figures[name]["data"], flush=True)
                FIGURES.write_text(json.dumps(figures, indent=1) + "\n")
    page = PAGE.read_text()
    if BEGIN not in page or END not in page:
        sys.exit(f"{PAGE}: the lines `{BEGIN}` and `{END}` are missing")
    head, rest = page.split(BEGIN, 1)
    PAGE.write_text(f"{head}{BEGIN}\n\n{table(figures)}\n\n{END}{rest.split(END, 1)[1]}")


if __name__ == "__main__":
    main()
