"""docs/performance.md from bench/figures.json: called by measure.py."""

import re

FORMS = ("graph", "by_hand", "classical")


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(c) for c in row) + " |" for row in rows]) + "\n"


def number(x):
    return f"{x:,.0f}" if x >= 100 else f"{x:.1f}"


def three(row, what):
    return " / ".join(number(row[f][what]) for f in FORMS)


def short(name):
    """`sin`; what is seldom done: a sequence's search for a path, a fault."""
    seldom = re.search(r"cca::(sequence|controller)<.*::(look_for|fail)\b", name)
    if "part_of_beat" in name:
        return "part_of_beat"
    return f"{seldom[1]}::{seldom[2]} (seldom)" if seldom else name.split("(")[0]


def calls(row):
    count = {}
    for name, n in row["graph"]["calls"].items():
        count[short(name)] = count.get(short(name), 0) + n
    return ", ".join(f"{n} {name}" for name, n in sorted(count.items())) or "none"


def ratio(row):
    return f"{row['graph']['instructions'] / row['by_hand']['instructions']:.3f}"


def measured(part):
    m = part["machine"]
    return (f"Measured on {m['date']} at commit {m['commit']}: {m['cpu']}, {m['cores']} cores, load {m['load']:.1f} at the start; "
            f"{'; '.join(m['versions'])}.\n")


def trot(part):
    rows = [[r["compiler"], f"`{r['flags']}`", three(r, "instructions"), f"**{ratio(r)}**", three(r, "ns"), calls(r),
             three(r, "allocations"), three(r, "bytes")] for r in part["data"]]
    def worst(plain):
        return max(r["graph"]["instructions"] / r["by_hand"]["instructions"] for r in part["data"] if plain != ("march" in str(r["flags"])))
    return f"""## The trot's controller

The graph of `examples/trot` with a robot that plays stored angles back (`bench/trot.cpp`), beside the same arithmetic written
by hand as one loop on Eigen vectors, and beside the classical way: virtual components, samples behind shared pointers, queues
(`bench/classical.hpp`). The three give the same results to the last bit, which each run checks. Each figure reads
graph / by hand / classical. The goal is at most 1.00 at -O2 and -O3: the largest there is {worst(True):.3f}; for newer processors it is
{worst(False):.3f}. The graph has the question whether the controller runs, the loop by hand has not; in return the graph tells clang that
a beat's number is never negative (`component/beat.hpp`), so that the modulo of the playback needs no sign: 4 instructions.

{table(["compiler", "flags", "instructions a beat", "graph : by hand", "ns a beat", "calls left in the graph's beat", "allocations a beat", "bytes of state"], rows)}
Instructions are counted by callgrind, libm's included. Bytes are those on the heap with all that the form allocates.
{measured(part)}"""


def synthetic(part):
    rows = [[r["shape"], r["nodes"], r["compiler"], three(r, "instructions"), f"**{ratio(r)}**", three(r, "ns"), calls(r),
             three(r, "allocations"), three(r, "bytes")] for r in part["data"]]
    return f"""## Chain, fan-out, mixed rates

Low-pass filters on samples of two axes, `-O2`: one after another, all behind one source, and one after another at 1000, 500,
200 and 100 Hz in turn. By hand: a loop over an array of filters. Graph / by hand / classical. A beat of more than 128 nodes is
compiled in parts: these calls are listed as `part_of_beat`.

{table(["shape", "nodes", "compiler", "instructions a beat", "graph : by hand", "ns a beat", "calls left", "allocations a beat", "bytes of state"], rows)}
{measured(part)}"""


def skeletons(part):
    rows, calls_left = [], []
    compilers = list(dict.fromkeys(r["compiler"] for r in part["data"]))
    for name in dict.fromkeys(r["skeleton"] for r in part["data"] if "skeleton" in r):
        row = [name]
        for compiler in compilers:
            one = next(r for r in part["data"] if r.get("skeleton") == name and r["compiler"] == compiler)
            graph, hand = one["graph"]["instructions"], one["by_hand"]["instructions"]
            row += [f"{number(graph)} / {number(hand)}", f"{graph - hand:+.1f}", one["allocations"]]
        rows.append(row)
    for r in part["data"]:
        if "calls" in r:
            calls_left.append(f"{r['compiler']}: " + (", ".join(f"{n} {short(c)}" for c, n in sorted(r["calls"].items())) or "none"))
    head = ["skeleton"] + [text for c in compilers for text in (f"{c}: graph / by hand", "more by", "allocations of 1000 beats")]
    return f"""## Skeletons

Instructions a beat of a graph of one skeleton, its sources and what it feeds, beside the same by hand (`bench/skeletons.cpp`), `-O2`.
The two give the same results to the last bit, which each run checks. The graph has the question whether the controller runs, and the
origins and freshness that the skeleton looks at, where the loop by hand has not.

What a skeleton takes more is what it does more. In each beat of a graph: is the controller running, and which beat is it (5 instructions).
An arbiter by priority asks each writer whether it has said something new, and hands on the origin of the one it hears (22 more in all); a switch
asks whether its choice has spoken yet, and while it hands over which source is the older (23); the mean of a decimation has the oldest origin of its samples (18);
an interpolation reads a slower wire at its own rate, so it finds the sample's age by a division of the beat's number, and its result has the older origin of two (30);
a delay between the stages of a pipeline keeps each sample with its origin and its beat, where by hand a stage's own state is what the next one reads a beat later (15 a delay).

Of a farm on threads what is counted is what the loop does in its own thread: two rings a worker, one of tasks and one of results. What the workers do is not, nor waiting:
between two beats each run waits, uncounted, until they are done, so that every beat hands out a task and takes a result. By hand these are the same rings of bare numbers. The farm
hands over with each task its origin and its beat as well, takes with each result its origin, and publishes how many tasks are under way and how many were lost.

{table(head, rows)}
Calls left in the beats of all of them: {"; ".join(calls_left)}.

{measured(part)}"""


def both(row, what):
    return " / ".join(number(row[f][what]) for f in ("graph", "by_hand"))


def skills(part):
    rows = [[r["compiler"], f"`{r['flags']}`", both(r, "instructions"), f"**{ratio(r)}**", calls(r), both(r, "allocations"), both(r, "bytes")]
            for r in part["data"]]
    return f"""## The Combination of Skills

The controller of `examples/combination_of_skills` with a robot that does what it is told (`bench/skills.cpp`), from the sight of the
ball through all skills, beside the same arithmetic written by hand as one loop: equations, kinematics and monitors are the same functions
of the library in both, samples, ports, origins, strategies and the sequencer's listening are the graph's alone. The two give the same results to
the last bit, which each run checks. Graph / by hand; the goal is a ratio of at most 1.05.

{table(["compiler", "flags", "instructions a beat", "graph : by hand", "calls left in the graph's beat", "allocations a beat", "bytes of state"], rows)}
Seldom: a sequence looks for the path of a condition once; a fault ends the run.
{measured(part)}"""


def drives(part):
    rows = [[r["compiler"], f"`{r['flags']}`", number(r["instructions"]), r["allocations"]] for r in part["data"]]
    return f"""## Eight drives

A whole beat of the trot with `hardware::oncilla`, eight drives and the sensor board: 8 set-points, 13 answers, five buses, the whole safety chain.
`bench/drives.cpp` has buses that cost nothing, behind which drives are at once where they are told to be; what these do is taken off.

{table(["compiler", "flags", "instructions a beat", "allocations in 1000 beats"], rows)}
{measured(part)}"""


def compiling(part, exponent):
    data = part["data"]
    bases = table(["file that only includes", "compiler", "s", "MB"],
                  [[b["includes"], b["compiler"], f"{b['seconds']:.2f}", f"{b['megabytes']:.0f}"] for b in data["bases"]])
    rows, growth = [], []
    keys = dict.fromkeys((r["shape"], r["compiler"]) for r in data["rows"])
    for shape, compiler in keys:
        mine = [r for r in data["rows"] if (r["shape"], r["compiler"]) == (shape, compiler)]
        for r in mine:
            rows.append([shape, compiler, r["nodes"], f"{r['seconds']:.1f}", f"{r['seconds'] - r['eigen']:.1f}",
                         f"{r['seconds'] / r['eigen']:.1f}", f"{r['megabytes']:.0f}",
                         r.get("classes", ""), r.get("functions", "")])
        growth.append([shape, compiler, f"{mine[-2]['nodes']} to {mine[-1]['nodes']}", f"{exponent(mine):.2f}"])
    return f"""## Compiling

One file with a graph and a function that makes a beat of it, `-O2`, samples of two axes. Seconds are those of the processor,
user and system, the least of some runs. How fast a shared machine is changes by the minute, so Eigen alone is compiled in between each time:
"times Eigen" is what holds elsewhere. Instantiations are counted by clang in the whole file, Eigen and the standard library included.
The goals: 1,000 nodes in 15 s and 700 MB; 100 nodes at most 1 s above Eigen alone.

{bases}
{table(["graph", "compiler", "nodes", "s", "s above Eigen", "times Eigen", "MB", "classes instantiated", "functions instantiated"], rows)}
Growth exponent of what is above Eigen (1: linear):

{table(["graph", "compiler", "nodes", "exponent"], growth)}
Components of one type that are wired alike are compiled once (`include/cca/graph/layout.hpp`); "a type each" is the other
extreme, where no two components share anything. A beat of more than 128 functions is compiled in parts of 64
(`include/cca/graph/parts.hpp`), each a call and a function of its own: in one, 1,000 nodes of mixed rates took g++ 106 s.
{measured(part)}"""


def listing(part):
    blocks = "\n".join(f"{compiler}:\n\n```asm\n" + "\n".join(lines) + "\n```\n" for compiler, lines in part["data"].items())
    return f"""## The loop of a small graph

A source and three low-pass filters in a row, `-O2`: all that a beat is, with the question whether the controller runs. No
sample, port or origin is left.

{blocks}"""


def text(figures, exponent):
    parts = ["""# Performance

<!-- Made by bench/measure.py from bench/figures.json: change those, not this page. -->

All figures come from one command, `cmake --workflow --preset bench`, which builds the benchmarks and runs `bench/measure.py`: half
an hour on a machine that does nothing else. It needs g++, clang++-19, valgrind, objdump and Google Benchmark, all of which `bootstrap` installs. Counts are the
same on a busy machine; times are medians of five and are not. `tests/runtime/no_allocation` and the test `performance: calls` keep
watch that a beat allocates nothing and calls nothing but libm.
"""]
    if "trot" in figures:
        parts.append(trot(figures["trot"]))
    if "synthetic" in figures:
        parts.append(synthetic(figures["synthetic"]))
    if "skeletons" in figures:
        parts.append(skeletons(figures["skeletons"]))
    if "skills" in figures:
        parts.append(skills(figures["skills"]))
    if "drives" in figures:
        parts.append(drives(figures["drives"]))
    if "compile" in figures:
        parts.append(compiling(figures["compile"], exponent))
    if "listing" in figures:
        parts.append(listing(figures["listing"]))
    return "\n".join(parts)
