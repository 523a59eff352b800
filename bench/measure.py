#!/usr/bin/env python3
"""Makes all figures of docs/performance.md in one run: builds the programs of this folder with both compilers, checks that
the three forms give the same bits, counts, times, and writes bench/figures.json and docs/performance.md.

    measure.py                 everything (an hour on two cores at rest); `cmake --workflow --preset bench` does this
    measure.py --only compile  one part: trot, synthetic, skeletons, copies, random, skills, arm, drives, dynamics, pinocchio, floating, derivatives, cold, learning, policies, modes, observed, compile, listing; the others keep their figures in figures.json;
                               several parts: --only compile --only synthetic
    measure.py --only random --graphs 5   so many random graphs
    measure.py --quick         a reduced set in some minutes: trot at -O2 and -O3, graphs of up to 100 nodes
    measure.py --page          only the page, from figures.json
    measure.py --programs DIR  where CMake has built latency_<reflectors> and bench_realtime (default: build/bench/bench)
    measure.py --out DIR       where latency.json and realtime.json go (default: build/bench/out)

Counts (instructions, calls, allocations, bytes, instantiations) do not depend on how busy the machine is; times do.
"""
import argparse
import datetime
import json
import math
import os
import pathlib
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile

import generate
import page
import random_graphs

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
COMPILERS = ("g++", "clang++-19")
FORMS = ("graph", "by_hand", "classical")
TROT_FLAGS = (["-O2"], ["-O3"], ["-O2", "-march=x86-64-v3"], ["-O3", "-march=x86-64-v3"])
SIZES = (10, 30, 100, 300)
COPIES_FLAGS = ["-O3", "-march=x86-64-v3"]
RANDOM_FLAGS = (["-O2"], ["-O2", "-march=x86-64-v3"], ["-O3", "-march=x86-64-v3"])
RANDOM_BEATS = 100  # whole periods of the slowest clock
SKILLS_FLAGS = (["-O2"], ["-O3"])
SKILLS_BEATS = (2000, 14000)  # begins when the robot sees the ball; then every skill runs
ARM_FORMS = ("graph", "by_hand", "shared")
ARM_BEATS = (3072, 6144)  # the second time through what is played back
COLD_BEATS = 3000
SYNTHETIC_BEATS = (200, 600)  # whole periods of the slowest clock, few enough for 300 virtual components under callgrind
FAN_OUTS = (1, 2, 4, 8, 16)
COMPILE_SIZES = (10, 30, 100, 300, 1000)
INCLUDES = ["-isystem", "/usr/include/eigen3", "-I", str(ROOT / "include"), "-I", str(ROOT / "robots/include"), "-I", str(ROOT / "sim/include"), "-I", str(ROOT / "hardware/include"), "-I", str(HERE)]


def run(command, **options):
    done = subprocess.run(command, text=True, capture_output=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stderr[:3000]}")
    return done


def build(compiler, flags, source, program, *libraries):
    assembly = pathlib.Path(f"{program}.s")
    run([compiler, "-std=c++20", "-DNDEBUG", *flags, *INCLUDES, "-S", str(source), "-o", str(assembly)])
    # Debian's assembler shortens a move between registers to a form that Debian's valgrind does not know.
    assembly.write_text(re.sub(r"^\tvmovq\t(?=%xmm\d+, %xmm)", "\t{vex3} vmovq\t", assembly.read_text(), flags=re.MULTILINE))
    run([compiler, "-std=c++20", "-DNDEBUG", *flags, *INCLUDES, str(assembly), str(HERE / "counting.cpp"), "-o", str(program),
         "-lbenchmark", "-lpthread", *libraries])


def instructions(program, *form, lengths=(1000, 3000), within=()):
    """Instructions per beat: the difference between runs of two lengths. `within`: count only in these functions."""
    counts = []
    for beats in lengths:
        out = run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *(f"--toggle-collect={name}" for name in within),
                   str(program), *form, str(beats)]).stderr
        counts.append(int(re.search(r"Collected : (\d+)", out)[1]))
    return (counts[1] - counts[0]) / (lengths[1] - lengths[0])


def nanoseconds(program):
    out = run([str(program), "--benchmark_format=json", "--benchmark_repetitions=5", "--benchmark_min_time=0.1"]).stdout
    times = {}
    for entry in json.loads(out)["benchmarks"]:
        if entry["run_type"] == "iteration":
            times.setdefault(entry["name"], []).append(entry["cpu_time"])
    return {form: statistics.median(all_times) for form, all_times in times.items()}


def functions(program):
    """The disassembly: name of each function -> its lines."""
    listing = run(["objdump", "-d", "--no-show-raw-insn", "-C", "--no-addresses", str(program)]).stdout
    found, name = {}, None
    for line in listing.splitlines():
        head = re.match(r"<(.*)>:$", line)
        if head:
            name = head[1]
            found[name] = []
        elif name and line.strip():
            found[name].append(line.strip())
    return found


def loop_of(program):
    """The beat of the graph: advance(), or the function that it was inlined into."""
    all_functions = functions(program)
    # objdump does not read the names that clang gives to functions with constraints.
    for wanted in ("::advance()", "7advanceEv", "::step()", "one_beat<bench::as_graph"):
        for name, lines in all_functions.items():
            if wanted in name and ("cca::controller" in name or "3cca10controller" in name or wanted.startswith("one_beat")):
                return lines
    sys.exit(f"{program}: no beat in its disassembly")


def calls_of(lines):
    """The functions called in the hot part. g++ moves unlikely code into a part of its own."""
    called = {}
    for line in lines:
        call = re.search(r"\b(?:call|jmp)\s+(?:[0-9a-f]+ )?<(.*)>", line)
        if call and "+0x" not in call[1]:
            name = re.sub(r"@plt$", "", call[1])
            called[name] = called.get(name, 0) + 1
    return called


def forms(program, lengths, with_times=True):
    run([str(program), "check"])
    figures = {form: {"instructions": instructions(program, form, lengths=lengths)} for form in FORMS}
    for line in run([str(program), "figures"]).stdout.splitlines():
        form, allocations, size = line.split()
        figures[form].update(allocations=float(allocations), bytes=int(size))
    if with_times:
        for form, time in nanoseconds(program).items():
            figures[form]["ns"] = time
    lines = loop_of(program)
    figures["graph"]["calls"] = calls_of(lines)
    figures["graph"]["size"] = len(lines)
    return figures


def trot(work):
    rows = []
    for compiler in COMPILERS:
        for flags in TROT_FLAGS:
            program = work / "trot"
            # Without contraction to fused multiply-adds, which may differ between functions: the forms must agree to the bit.
            build(compiler, [*flags, "-ffp-contract=off"], HERE / "trot.cpp", program)
            rows.append({"compiler": compiler, "flags": " ".join(flags), **forms(program, (1000, 3000))})
            print("trot", compiler, *flags, {f: rows[-1][f]["instructions"] for f in FORMS}, flush=True)
    return rows


def synthetic(work):
    rows = []
    for compiler in COMPILERS:
        for shape in generate.SHAPES:
            for size in SIZES:
                source, program = work / "synthetic.cpp", work / "synthetic"
                source.write_text(generate.source(shape, size))
                build(compiler, ["-O2"], source, program)
                rows.append({"compiler": compiler, "shape": shape, "nodes": size, **forms(program, SYNTHETIC_BEATS)})
                print(shape, size, compiler, {f: rows[-1][f]["instructions"] for f in FORMS}, flush=True)
    return rows


def skills(work):
    """The Combination of Skills: the graph and the loop by hand, from beat to beat through all skills."""
    rows = []
    for compiler in COMPILERS:
        for flags in SKILLS_FLAGS:
            program = work / "skills"
            build(compiler, [*flags, "-ffp-contract=off"], HERE / "skills.cpp", program)
            run([str(program), "check", str(SKILLS_BEATS[1])])
            row = {"compiler": compiler, "flags": " ".join(flags)}
            for form in ("graph", "by_hand"):
                row[form] = {"instructions": instructions(program, form, lengths=SKILLS_BEATS)}
            for line in run([str(program), "figures"]).stdout.splitlines():
                form, allocations, size = line.split()
                row[form].update(allocations=float(allocations), bytes=int(size))
            row["graph"]["calls"] = calls_of(loop_of(program))
            rows.append(row)
            print("skills", compiler, *flags, {f: row[f]["instructions"] for f in ("graph", "by_hand")}, flush=True)
    return rows


def arm(work):
    """The arm's torque loop: the graph, the same by hand, and by hand with kinematics and mass matrix once a beat."""
    rows = []
    for compiler in COMPILERS:
        for flags in SKILLS_FLAGS:
            program = work / "arm"
            build(compiler, [*flags, "-ffp-contract=off"], HERE / "arm_controller.cpp", program)
            run([str(program), "check", str(ARM_BEATS[1])])
            row = {"compiler": compiler, "flags": " ".join(flags)}
            for form in ARM_FORMS:
                row[form] = {"instructions": instructions(program, form, lengths=ARM_BEATS)}
            for line in run([str(program), "figures"]).stdout.splitlines():
                form, allocations, size = line.split()
                row[form].update(allocations=float(allocations), bytes=int(size))
            rows.append(row)
            print("arm", compiler, *flags, {f: row[f]["instructions"] for f in ARM_FORMS}, flush=True)
    return rows


def drives(work):
    """The trot on eight drives over CAN, without the cost of the pretended buses."""
    rows = []
    for compiler in COMPILERS:
        program = work / "drives"
        build(compiler, ["-O2"], HERE / "drives.cpp", program)
        buses = ("bench::mirror::send*", "bench::mirror::receive*")
        rows.append({"compiler": compiler, "flags": "-O2", "instructions": instructions(program) - instructions(program, within=buses),
                     "allocations": int(run([str(program), "allocations"]).stdout)})
        print("drives", rows[-1], flush=True)
    return rows


def skeletons(work):
    """Each skeleton in a graph and by hand: instructions per beat, allocations of a thousand beats, calls left."""
    rows = []
    for compiler in COMPILERS:
        program = work / "skeletons"
        build(compiler, ["-O2", "-ffp-contract=off"], HERE / "skeletons.cpp", program)
        run([str(program), "check"])
        names = run([str(program), "list"]).stdout.splitlines()
        beats = {name: lines for name, lines in functions(program).items() if re.search(r"::advance\(\)|one_beat<bench::as_graph", name)}
        for name in names:
            row = {"skeleton": name, "compiler": compiler, "allocations": int(run([str(program), name, "allocations"]).stdout)}
            within = ("*bench::one_beat*",) if "threads" in name else ()  # without the threads' work and without waiting for them
            for form in ("graph", "by_hand"):
                row[form] = {"instructions": instructions(program, name, form, within=within)}
            rows.append(row)
        left = {}
        for lines in beats.values():
            for called, count in calls_of(lines).items():
                if "advance()" not in called:
                    left[called] = left.get(called, 0) + count
        rows.append({"compiler": compiler, "calls": left})
        print("skeletons", compiler, left, flush=True)
    return rows


def copies(work):
    """Samples of eight axes through 22 nodes: what handing them over costs."""
    rows = []
    for compiler in COMPILERS:
        program = work / "copies"
        build(compiler, [*COPIES_FLAGS, "-ffp-contract=off"], HERE / "copies.cpp", program)
        for style in ("filled", "returned", "expressions"):
            run([str(program), style, "check"])
            row = {"style": style, "compiler": compiler}
            for form in ("graph", "by_hand"):
                row[form] = {"instructions": instructions(program, style, form)}
            rows.append(row)
            print("copies", compiler, style, {f: row[f]["instructions"] for f in ("graph", "by_hand")}, flush=True)
    return rows


def random_graph(work):
    """Graphs that nobody tuned: components of many styles on samples of eight axes, and the same as one function by hand."""
    rows = []
    for seed in range(1, GRAPHS + 1):
        (work / "random.cpp").write_text(random_graphs.source(seed))
        for compiler in COMPILERS:
            for flags in RANDOM_FLAGS:
                program = work / "random"
                build(compiler, [*flags, "-ffp-contract=off"], work / "random.cpp", program)
                run([str(program), "check"])
                row = {"seed": seed, "compiler": compiler, "flags": " ".join(flags)}
                for form in ("graph", "by_hand"):
                    row[form] = {"instructions": instructions(program, form, lengths=(RANDOM_BEATS, 3 * RANDOM_BEATS))}
                rows.append(row)
                print("random", seed, compiler, *flags, {f: row[f]["instructions"] for f in ("graph", "by_hand")}, page.ratio(row), flush=True)
    print(page.random_table(rows))
    return rows


def modes(work):
    """Beats of two modes, alone and in a set, and a switch between them."""
    rows = []
    for compiler in COMPILERS:
        program = work / "modes"
        build(compiler, ["-O3"], HERE / "modes.cpp", program)
        row = {"compiler": compiler} | {what: instructions(program, what) for what in ("trot", "trot_mode", "stand", "stand_mode")}
        row["switch"] = instructions(program, "switches", within=("*bench::switch_and_back*",)) / 2
        rows.append(row)
        print("modes", row, flush=True)
    return rows


OBSERVED = ("plain", "recordable", "traceable", "both", "recorded", "open", "traced", "both_recorded")


def observed(work):
    """What recordings, doors and traces cost a beat of the trot's controller."""
    rows = []
    for compiler in COMPILERS:
        program = work / "observed"
        build(compiler, ["-O2", "-I", str(ROOT / "record/include"), "-I", str(ROOT / "door/include")], HERE / "observed.cpp", program, "-lzstd")
        row = {"compiler": compiler} | {what: instructions(program, what, within=("*bench::one_beat*",)) for what in OBSERVED}
        rows.append(row)
        print("observed", row, flush=True)
    return rows


def dynamics(work):
    """The dynamics of an arm of seven joints, beside those of Orocos KDL."""
    rows = []
    for compiler in COMPILERS:
        program = work / "dynamics"
        build(compiler, ["-O2"], HERE / "dynamics.cpp", program, "-lorocos-kdl")
        run([str(program), "check"])
        for name in run([str(program), "list"]).stdout.splitlines():
            row = {"quantity": name, "compiler": compiler, "allocations": int(run([str(program), name, "allocations"]).stdout)}
            for form in ("cca", "kdl"):
                row[form] = {"instructions": instructions(program, name, form, lengths=(20, 220))}
            rows.append(row)
            print("dynamics", compiler, name, {f: row[f]["instructions"] for f in ("cca", "kdl")}, flush=True)
    return rows


def pinocchio(work):
    """The same arm, beside Pinocchio, whose headers are in the folder of the option."""
    rows = []
    for compiler in COMPILERS:
        program = work / "pinocchio_dynamics"
        build(compiler, ["-O2", "-isystem", str(PINOCCHIO)], HERE / "pinocchio_dynamics.cpp", program, "-lorocos-kdl")
        run([str(program), "check"])
        for name in run([str(program), "list"]).stdout.splitlines():
            row = {"quantity": name, "compiler": compiler} | {form: instructions(program, name, form, lengths=(20, 220)) for form in ("cca", "pinocchio")}
            rows.append(row)
            print("pinocchio", row, flush=True)
    version = (PINOCCHIO / "pinocchio/config.hpp").read_text()
    return {"version": re.search(r'PINOCCHIO_VERSION "([\d.]+)"', version)[1], "rows": rows}


def beside_loops(work, source):
    """The quantities of a program, recorded and by loops over the links."""
    rows = []
    for compiler in COMPILERS:
        program = work / source
        build(compiler, ["-O2"], HERE / f"{source}.cpp", program)
        run([str(program), "check"])
        for name in run([str(program), "list"]).stdout.splitlines():
            row = {"quantity": name, "compiler": compiler, "allocations": int(run([str(program), name, "allocations"]).stdout)}
            row |= {form: instructions(program, name, form, lengths=(20, 220), within=(f"*once_{form}*",)) for form in ("cca", "loops")}
            rows.append(row)
            print(source, compiler, row, flush=True)
    return rows


def floating(work):
    """The dynamics of a quadruped with a free base."""
    return beside_loops(work, "floating_dynamics")


def derivatives(work):
    """The derivatives of dynamics."""
    return beside_loops(work, "dynamics_derivatives")


def cold(work):
    """Times of recorded dynamics and of loops, one call after another and once between other code."""
    rows = []
    for compiler in COMPILERS:
        program = work / "cold"
        build(compiler, ["-O2"], HERE / "cold_dynamics.cpp", program)
        run([str(program), "check"])
        symbols = [line.split(maxsplit=3) for line in run(["nm", "-S", "-C", str(program)]).stdout.splitlines()]
        lines = run([str(program), str(COLD_BEATS)]).stdout.splitlines()
        for quantity, body, operations, recording, *times in (line.split("\t") for line in lines):
            size = {int(s[1], 16) for s in symbols if len(s) == 4 and f"::{recording}<bench::{body}" in s[3] and "::evaluate<" in s[3]}
            rows.append({"quantity": quantity, "body": body, "compiler": compiler, "operations": int(operations), "bytes": max(size),
                         "ns": {way: [float(t) for t in times[2 * i:2 * i + 2]] for i, way in enumerate(("warm", "code", "data"))}})
            print("cold", rows[-1], flush=True)
    return rows


def learning(work):
    """A beat of each adaptive module while another thread learns a batch, and while nothing is learned."""
    rows = []
    for compiler in COMPILERS:
        program = work / "learning"
        build(compiler, ["-O2"], HERE / "learning.cpp", program)
        for name in run([str(program), "list"]).stdout.splitlines():
            row = {"module": name, "compiler": compiler}
            for state in ("resting", "batch"):
                row[state] = instructions(program, name, state, lengths=(200, 1200), within=("*bench::one_beat*",))
            rows.append(row)
            print("learning", row, flush=True)
    return rows


def policies(work):
    """A learned policy in a graph, beside the products of its matrices and the whole network by hand."""
    rows = []
    for compiler in COMPILERS:
        program = work / "policy"
        build(compiler, ["-O2"], HERE / "learned_policy.cpp", program)
        run([str(program), "check"])
        for name in run([str(program), "list"]).stdout.splitlines():
            row = {"network": name, "compiler": compiler, "allocations": int(run([str(program), name, "allocations"]).stdout)}
            for form in ("policy", "products", "by_hand"):
                row[form] = instructions(program, name, form, lengths=(20, 120))
            rows.append(row)
            print("policies", row, flush=True)
    return rows


def compile_once(compiler, source):
    """User and system seconds, and megabytes."""
    child = subprocess.Popen([compiler, "-std=c++20", "-O2", *INCLUDES, "-c", str(source), "-o", "/dev/null"], stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        sys.exit(f"{source} does not compile with {compiler}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def compile_cost(compiler, source, times):
    """The least of several runs, with runs of Eigen alone in between: the speed of a shared machine changes by the minute."""
    eigen = source.parent / "eigen.cpp"
    eigen.write_text("#include <Eigen/Core>\n")
    runs = [(compile_once(compiler, eigen)[0], *compile_once(compiler, source)) for _ in range(times)]
    beside, seconds, megabytes = zip(*runs)
    return {"seconds": min(seconds), "eigen": min(beside), "megabytes": max(megabytes)}


def instantiations(source, work):
    """How many classes and functions clang instantiates."""
    run(["clang++-19", "-std=c++20", "-O0", *INCLUDES, "-ftime-trace", "-ftime-trace-granularity=0", "-c", str(source), "-o", str(work / "trace.o")])
    events = json.loads((work / "trace.json").read_text())["traceEvents"]
    count = {e["name"]: e["args"]["count"] for e in events if e["name"].startswith("Total Instantiate")}
    return {"classes": count.get("Total InstantiateClass", 0), "functions": count.get("Total InstantiateFunction", 0)}


def exponent(rows):
    """The exponent of growth of the seconds above Eigen alone, between the last two sizes."""
    (n1, s1), (n2, s2) = [(r["nodes"], r["seconds"] / r["eigen"] - 1) for r in rows[-2:]]
    return math.log(s2 / s1) / math.log(n2 / n1) if s1 > 0 and s2 > 0 else float("nan")


def compile_times(work):
    result = {"bases": [], "rows": []}
    for compiler in COMPILERS:
        for what, text in (("Eigen/Core", "#include <Eigen/Core>\n"), ("Eigen/Dense", "#include <Eigen/Dense>\n"), ("cca/cca.hpp", "#include <cca/cca.hpp>\n")):
            source = work / "base.cpp"
            source.write_text(text)
            result["bases"].append({"compiler": compiler, "includes": what, **compile_cost(compiler, source, 5)})
    for shape, own_types in (("chain", False), ("mixed", False), ("chain", True)):
        for compiler in COMPILERS:
            for size in COMPILE_SIZES:
                source = work / "graph.cpp"
                source.write_text(generate.source(shape, size, only_graph=True, own_types=own_types))
                row = {"shape": shape + (", a type each" if own_types else ""), "compiler": compiler, "nodes": size,
                       **compile_cost(compiler, source, 4 if size < 300 else 2)}
                if compiler.startswith("clang"):
                    row.update(instantiations(source, work))
                result["rows"].append(row)
                print(row, flush=True)
    return result


def listing(work):
    source = work / "small.cpp"
    source.write_text(generate.source("chain", 4, only_graph=True))
    result = {}
    for compiler in COMPILERS:
        run([compiler, "-std=c++20", "-O2", "-DNDEBUG", *INCLUDES, "-c", str(source), "-o", str(work / "small.o")])
        for name, lines in functions(work / "small.o").items():
            # The compiler may inline advance() into beat(): the longer one is the loop.
            if ("advance()" in name or name.startswith("beat(")) and "cold" not in name and len(lines) > len(result.get(compiler, [])):
                result[compiler] = lines
    return result


def latency(work):
    """Round trips between one driver and its reflectors, over each transport, beside the bare means of the transport."""
    rows = []

    def large_stack():  # what eight reflectors send of 1 MiB in a beat does not fit 8 MiB
        resource.setrlimit(resource.RLIMIT_STACK, (1 << 30, resource.getrlimit(resource.RLIMIT_STACK)[1]))

    for fan_out in FAN_OUTS:
        out = run([str(PROGRAMS / f"latency_{fan_out}"), *(["--quick"] if QUICK else [])], preexec_fn=large_stack).stdout
        rows += [json.loads(line) for line in out.splitlines()]
        print("latency", fan_out, [f"{r['transport']} {r['form']} {r['bytes']} B: {r['mean_us']} us" for r in rows if r["fan_out"] == fan_out], flush=True)
    keys = ("mean_us", "p50_us", "p99_us", "variance_us2", "jitter_us", "set_up_us")
    beside = {(r["transport"], r["fan_out"], r["bytes"]): r for r in rows if r["form"] == "raw"}
    summary = []
    for r in rows:
        if r["form"] != "cca":
            continue
        raw = beside.get((r["transport"], r["fan_out"], r["bytes"]), {})
        summary.append({k: v for k, v in r.items() if k != "form"} | {f"raw_{k}": raw[k] for k in keys if raw})
    save("latency.json", summary)
    return rows


def quantiles(counts):
    """Of how often which number of microseconds."""
    total, found = sum(counts.values()), {}
    for name, part in (("p50", 0.5), ("p99", 0.99), ("p999", 0.999)):
        seen = 0
        for us in sorted(counts):
            seen += counts[us]
            if seen >= part * total:
                found[name] = us
                break
    return {**found, "max": max(counts), "count": total}


def realtime(work):
    """Wake-ups at 1 kHz of an environment in real time, and of cyclictest on the other core; they change places in each round."""
    if os.cpu_count() < 2 or not shutil.which("cyclictest"):
        sys.exit("realtime: needs two cores and cyclictest (Debian's rt-tests; ./bootstrap installs it)")
    rounds, seconds = (2, 1) if QUICK else (6, 10)
    result = {}
    for state, hogs in (("idle", 0), ("load", os.cpu_count())):
        counts = {"cca": {}, "cyclictest": {}}
        busy = [subprocess.Popen(["sh", "-c", "while :; do :; done"]) for _ in range(hogs)]
        try:
            for n in range(rounds):
                beside = subprocess.Popen(["cyclictest", "-q", "-a", str(1 - n % 2), "-t", "1", "-p", "80", "-m", "-i", "1000", "-D", str(seconds + 1), "-h", "50000"],
                                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                own = subprocess.run([str(PROGRAMS / "bench_realtime"), "--core", str(n % 2), "--seconds", str(seconds)], text=True, capture_output=True)
                out, error = beside.communicate()
                if own.returncode != 0 or beside.returncode != 0:
                    print(f"realtime: NOT MEASURED: {own.stderr}{error}", file=sys.stderr)
                    return {"refused": (own.stderr + error).strip()}
                for us, count in json.loads(own.stdout)["us"].items():
                    counts["cca"][int(us)] = counts["cca"].get(int(us), 0) + count
                for us, count in re.findall(r"^(\d{6}) (\d{6,})$", out, re.M):
                    if int(count):
                        counts["cyclictest"][int(us)] = counts["cyclictest"].get(int(us), 0) + int(count)
                worst = int(re.search(r"Max Latencies: (\d+)", out)[1])
                counts["cyclictest"].setdefault(worst, 1)  # beyond its histogram
        finally:
            for one in busy:
                one.kill()
                one.wait()
        result[state] = {name: quantiles(c) for name, c in counts.items()}
        result[state]["p99_ratio"] = result[state]["cca"]["p99"] / max(result[state]["cyclictest"]["p99"], 1)
        print("realtime", state, result[state], flush=True)
    save("realtime.json", result)
    return result


def save(name, data):
    OUT.mkdir(parents=True, exist_ok=True)
    (OUT / name).write_text(json.dumps(data, indent=1) + "\n")


def machine():
    cpu = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    versions = [run([c, "--version"]).stdout.splitlines()[0] for c in (*COMPILERS, "valgrind")]
    commit = run(["git", "-C", str(ROOT), "rev-parse", "--short", "HEAD"]).stdout.strip()
    return {"cpu": cpu[1] if cpu else "unknown", "cores": os.cpu_count(), "load": os.getloadavg()[0], "versions": versions,
            "date": datetime.date.today().isoformat(), "commit": commit}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parts = {"trot": trot, "synthetic": synthetic, "skeletons": skeletons, "copies": copies, "random": random_graph, "skills": skills, "arm": arm, "drives": drives, "dynamics": dynamics, "pinocchio": pinocchio, "floating": floating, "derivatives": derivatives, "cold": cold, "learning": learning, "policies": policies, "modes": modes, "observed": observed, "latency": latency, "realtime": realtime, "compile": compile_times, "listing": listing}
    parser.add_argument("--only", choices=parts, action="append")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--page", action="store_true")
    parser.add_argument("--graphs", type=int, default=20)
    parser.add_argument("--pinocchio", type=pathlib.Path, help="the folder that has pinocchio/algorithm/rnea.hpp: Debian has none, so this part is measured only where it is given")
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build/bench/bench")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "build/bench/out")
    a = parser.parse_args()
    global PROGRAMS, OUT, QUICK, GRAPHS, PINOCCHIO
    PROGRAMS, OUT, QUICK, GRAPHS, PINOCCHIO = a.programs, a.out, a.quick, a.graphs, a.pinocchio
    if "pinocchio" in (a.only or []) and not a.pinocchio:
        sys.exit("measure.py: the part pinocchio needs --pinocchio FOLDER")
    if not a.pinocchio:
        del parts["pinocchio"]
        print("Pinocchio is not measured: no --pinocchio FOLDER; its figures stay as they are", flush=True)
    if a.quick:
        global TROT_FLAGS, SIZES, COMPILE_SIZES
        GRAPHS = min(GRAPHS, 3)
        TROT_FLAGS, SIZES, COMPILE_SIZES = TROT_FLAGS[:2], SIZES[:3], COMPILE_SIZES[:3]
    file = HERE / "figures.json"
    figures = json.loads(file.read_text()) if file.exists() else {}
    if not a.page:
        with tempfile.TemporaryDirectory() as work:
            for name in a.only or parts:
                part = {"machine": machine(), "data": parts[name](pathlib.Path(work))}
                # Read again: another process may have measured another part meanwhile.
                figures = json.loads(file.read_text()) if file.exists() else {}
                figures[name] = part
                file.write_text(json.dumps(figures, indent=1) + "\n")
    (ROOT / "docs" / "performance.md").write_text(page.text(figures, exponent))


if __name__ == "__main__":
    main()
