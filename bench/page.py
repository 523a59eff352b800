"""Writes docs/performance.md from bench/figures.json; called by measure.py."""

import re

from calls import FAR

FORMS = ("graph", "by_hand", "classical")


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(c) for c in row) + " |" for row in rows]) + "\n"


def number(x):
    return f"{x:,.0f}" if x >= 100 else f"{x:.1f}"


def each(row, what, forms):
    return " / ".join(number(row[f][what]) for f in forms)


def three(row, what):
    return each(row, what, FORMS)


RARE = {"look_for", "fail", "advance_in_parts", "far_hypot"} | {name.split("(")[0].split("::")[-1] for name in FAR}


def short(name):
    """The last two parts of a function's name, without arguments; marks those that are called rarely (see `skills`)."""
    if "part_of_beat" in name:
        return "part_of_beat"
    if encoded := re.match(r"_ZZ?NK?", name):  # objdump can't read it: then at least its class or function
        parts, at = [], encoded.end()
        while size := re.match(r"\d+", name[at:]):
            at += size.end()
            parts.append(name[at:at + int(size[0])])
            at += int(size[0])
        parts = parts[-2:]
    else:
        plain = re.sub(r"\{[^{}]*\}", "", re.sub(r"\{[^{}]*\}", "", name)).split("(")[0]
        while re.search(r"<[^<>]*>", plain):
            plain = re.sub(r"<[^<>]*>", "", plain)
        parts = plain.split(" ")[-1].split("::")[-2:]
        parts = ["controller" if p == "loop_host" else p for p in parts]
    return "::".join(parts) + (" (rare)" if parts[-1] in RARE else "")


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

The graph is that of `examples/trot` with a robot that plays back stored angles (`bench/trot.cpp`).
It is compared with the same arithmetic in two other forms:

- by hand: one loop on Eigen vectors
- classical: virtual components, samples behind shared pointers, queues (`bench/classical.hpp`)

Each run checks that the three forms give the same bits.
Each cell reads graph / by hand / classical.
The goal is a ratio of at most 1.00 at -O2 and -O3; the largest there is {worst(True):.3f}.
For newer processors the largest is {worst(False):.3f}.
The graph tests whether the controller is running; the loop by hand does not.
In return the graph tells clang that the index of a beat is never negative (`component/beat.hpp`): the modulo of the playback then needs no sign, which saves 4 instructions.

{table(["compiler", "flags", "instructions per beat", "graph : by hand", "ns per beat", "calls left in the graph's beat", "allocations per beat", "bytes of state"], rows)}
Callgrind counts the instructions, including those of libm.
Bytes are all bytes of the form on the heap.

{measured(part)}"""


def synthetic(part):
    rows = [[r["shape"], r["nodes"], r["compiler"], three(r, "instructions"), f"**{ratio(r)}**", three(r, "ns"), calls(r),
             three(r, "allocations"), three(r, "bytes")] for r in part["data"]]
    return f"""## Chain, fan-out, mixed rates

These graphs consist of low-pass filters on samples of two axes, compiled at `-O2`:

- chain: one filter after another
- fan_out: all filters behind one source
- mixed: one filter after another, at 1000, 500, 200 and 100 Hz in turn

The loop by hand goes over an array of filters.
Each cell reads graph / by hand / classical.
A beat of more than 128 nodes is compiled in parts; the calls of these parts are listed as `part_of_beat`.

{table(["shape", "nodes", "compiler", "instructions per beat", "graph : by hand", "ns per beat", "calls left", "allocations per beat", "bytes of state"], rows)}
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
    head = ["skeleton"] + [text for c in compilers for text in (f"{c}: graph / by hand", "difference", "allocations in 1000 beats")]
    return f"""## Skeletons

Instructions per beat of a graph with one skeleton, its sources and its readers, beside the same by hand (`bench/skeletons.cpp`), at `-O2`.
Each run checks that the two give the same bits.
The graph also tests whether the controller is running, and carries the origins and the freshness that the skeleton reads; the loop by hand does not.

A skeleton takes more instructions where it does more than the loop by hand:

- Every graph tests whether the controller is running and reads the index of the beat (5 instructions).
- An arbiter by priority asks each writer whether it has published something new, and passes on the origin of the one it selects (22 more in all).
- A switch tests whether its choice has published yet, and during a change finds the older of the two sources (23).
- The mean of a decimation takes the oldest origin of its samples (18).
- An interpolation reads a slower wire at its own rate.
  It finds the age of the sample by a division of the beat's index, and its result takes the older origin of two (30).
- A delay between the stages of a pipeline keeps each sample with its origin and its beat, also past a beat that a fault cuts (22 per delay).
  By hand, a stage's own state is what the next stage reads one beat later.

For a farm on threads, only the work of the loop in its own thread is counted: two rings for each worker, one for tasks and one for results.
The work of the workers and the waiting are not counted: between two beats each run waits until the workers are done, so that every beat hands out a task and takes a result.
By hand these are the same rings, of bare numbers.
The farm also passes on origin and beat with each task, and the origin with each result, and publishes how many tasks are under way and how many were dropped.

{table(head, rows)}
Calls left in the beats of all of them: {"; ".join(calls_left)}.

{measured(part)}"""


COPIED = {"filled": "fill their output in place", "returned": "return a vector", "expressions": "use Eigen expressions"}


def copies(part):
    rows = [[COPIED[r["style"]], r["compiler"], both(r, "instructions"), f"**{ratio(r)}**"] for r in part["data"]]
    return f"""## Samples of many axes

A controller of 22 nodes hands on samples of eight axes; eight of the nodes have a single axis and stand between a splitter and a collector (`bench/copies.cpp`).
It is compared with the same arithmetic by hand: a loop over the axes for each node, or Eigen vectors where the components use Eigen expressions.
Each run checks that the two give the same bits.
Flags: `-O3 -march=x86-64-v3`.
Each cell reads graph / by hand.

{table(["components", "compiler", "instructions per beat", "graph : by hand"], rows)}
{measured(part)}"""


def runs_of(numbers):
    """[1, 2, 3, 100] is "1 to 3, 100"."""
    runs = []
    for n in sorted(numbers):
        if runs and runs[-1][1] == n - 1:
            runs[-1][1] = n
        else:
            runs.append([n, n])
    return ", ".join(f"{first} to {last}" if first < last else f"{first}" for first, last in runs)


def random_table(rows):
    """Seeds from 100 on are those that nobody had looked at."""
    sets = {}
    for r in rows:
        ratio = r["graph"]["instructions"] / r["by_hand"]["instructions"]
        sets.setdefault((r["compiler"], r["flags"], r["seed"] >= 100), {})[r["seed"]] = ratio
    table_rows = []
    for (compiler, flags, _), ratios in sorted(sets.items(), key=lambda s: (s[0][0] != "g++", *s[0][1:])):
        all_of = ratios.values()
        table_rows.append([compiler, f"`{flags}`", f"**{sum(all_of) / len(all_of):.3f}**", f"**{max(all_of):.3f}**", f"{min(all_of):.3f}", runs_of(ratios)])
    return table(["compiler", "flags", "mean", "most", "least", "seeds"], table_rows)


def random_graph(part):
    rows = part["data"]
    least, most = (f([r["by_hand"]["instructions"] for r in rows]) for f in (min, max))
    return f"""## Graphs that nobody tuned

The graphs above were looked at until they cost little; these are random (`bench/random_graphs.py`, each made from its seed).
Each has 14 to 26 components and a robot, on samples of eight axes and of one.
Some components fill their output in place, some return their state or an Eigen expression, call static functions or keep arrays; some publish one axis.
Wires are immediate, delayed by one to three beats, or latest; outputs have one or more readers, some wires close a loop, some components are slower than the beat.
The same arithmetic by hand is one function that copies no sample: a result is read where it was computed.
Each run checks that the two give the same bits.
By hand they take {number(least)} to {number(most)} instructions per beat.
The bounds, for 20 graphs, are a mean of 1.03 and none above 1.10.

Instructions, graph : by hand:

{random_table(rows)}
On g++ a beat unrolls the loops over the axes of a sample at `-O2`, too ([compilers](compilers.md#cca_beat-and-gnunoinline)); in the function by hand they stay loops there.
So its rows of `-O2` say what a program gains that is compiled with these flags; at `-O3` g++ unrolls both forms, and the row compares like with like.

The unrolled loops also show g++ that a component fills its output: it drops the zeros that the output begins with, so that an axis that a component forgets is never what memory held.
Before, these were most of what the graph took more on g++.
Seven graphs (seeds 1 to 7), mean and most:

| g++ | loops of a beat not unrolled | the same without the zeros |
|---|---|---|
| `-O2` | 1.049, 1.118 | 1.018, 1.077 |
| `-O2 -march=x86-64-v3` | 1.039, 1.123 | 1.009, 1.070 |
| `-O3 -march=x86-64-v3` | 1.040, 1.066 | 1.040, 1.063 |

At `-O3` the loops were unrolled and the zeros gone already; there a reader of the same beat had read a sample from a ring again, and rings had kept the beats of their samples ([decision 17](decisions/0017-results-stay-where-they-are-returned.md)).
What remains are origins, the places in rings and the call of the beat, which the loop by hand does not have.
Nobody had looked at the seeds from 100 on; their mean is above the bound.
The rows of clang are of commit f6ad09f7.
Three of its counts were made again, and are lower: 0.948 instead of 0.994 and 1.015 instead of 1.038 (seeds 7 and 3, `-O3 -march=x86-64-v3`), 0.960 instead of 0.975 (seed 7, `-O2`).
g++ inlines by a budget for the whole file, so both forms move with each other.
`python3 bench/measure.py --only random` measures this part.

{measured(part)}"""


def both(row, what):
    return each(row, what, ("graph", "by_hand"))


def skills(part):
    rows = [[r["compiler"], f"`{r['flags']}`", both(r, "instructions"), f"**{ratio(r)}**", calls(r), both(r, "allocations"), both(r, "bytes")]
            for r in part["data"]]
    return f"""## The Combination of Skills

The controller is that of `examples/combination_of_skills` with a robot that follows every command (`bench/skills.cpp`), from the sight of the ball through all skills.
It is compared with the same arithmetic written by hand as one loop.
Both use the library's functions for equations, kinematics and monitors.
Only the graph has samples, ports, origins, strategies and a sequencer that observes.
Each run checks that the two give the same bits.
Each cell reads graph / by hand; the goal is a ratio of at most 1.05.

{table(["compiler", "flags", "instructions per beat", "graph : by hand", "calls left in the graph's beat", "allocations per beat", "bytes of state"], rows)}
Rare calls: a sequence looks for the path of a condition once; a step of an equation is divided where it is too long for its parameters; an angle is beyond 1.6 million rad (`far_sine_and_cosine`) or more than a turn outside its range (`wrap_far_...`), a length is far from what has a square (`far_hypot`); a fault ends the run.

{measured(part)}"""


def arm(part):
    forms = ("graph", "by_hand", "shared")
    rows = [[r["compiler"], f"`{r['flags']}`", each(r, "instructions", forms), ratio(r),
             f"**{r['graph']['instructions'] / r['shared']['instructions']:.3f}**", each(r, "allocations", forms), each(r, "bytes", forms)] for r in part["data"]]
    worst = max(r["graph"]["instructions"] / r["shared"]["instructions"] for r in part["data"])
    return f"""## The arm's torque loop

The graph is the torque loop of `examples/touch` (`bench/arm_controller.cpp`): what the flange does and feels, momentum observer, watch, leader, Cartesian impedance, gravity compensation, passivity guard and limiter.
The robot plays back a motion with its torques and the load on the flange; so does what the plan and the movement primitives ask for.
It is compared with two loops by hand, which use the library's functions for dynamics, kinematics, springs, tanks and checks:

- by hand: the same arithmetic, where each part computes what it needs from the angles
- shared: kinematics, mass matrix and gravity torques are computed once in each beat

Each run checks that the three give the same bits.
Each cell reads graph / by hand / shared.
The goal is a ratio of graph to shared of at most 1.05; the largest is {worst:.3f}.
In the graph the components know nothing of each other, but kinematics and mass matrix are [derived](components.md#computed-once) once in each beat; the gravity torques are computed twice.

{table(["compiler", "flags", "instructions per beat", "graph : by hand", "graph : shared", "allocations per beat", "bytes of state"], rows)}
{measured(part)}"""


def dynamics(part):
    rows = [[r["quantity"], r["compiler"], f"{number(r['cca']['instructions'])} / {number(r['kdl']['instructions'])}",
             f"**{r['cca']['instructions'] / r['kdl']['instructions']:.2f}**", r["allocations"]] for r in part["data"]]
    worst = max(r["cca"]["instructions"] / r["kdl"]["instructions"] for r in part["data"])
    return f"""## Dynamics of an arm

An arm of seven joints, by the library and by Orocos KDL (`bench/dynamics.cpp`).
Each computation begins with the angles; a run checks that both give the same numbers to 1e-9.
KDL is that of Debian, and its solvers are made once.
Each cell reads cca / KDL.
The dynamics are [recorded](body.md#recordings).
The goal is a ratio of at most 0.7; the largest is {worst:.2f}.

{table(["quantity", "compiler", "instructions", "ratio", "allocations in 1000 computations"], rows)}
{measured(part)}"""


def pinocchio(part):
    data = part["data"]
    rows = [[r["quantity"], r["compiler"], f"{number(r['cca'])} / {number(r['pinocchio'])}", f"**{r['cca'] / r['pinocchio']:.2f}**"] for r in data["rows"]]
    return f"""### Beside Pinocchio

The same arm by Pinocchio {data["version"]} (`bench/pinocchio_dynamics.cpp`), at `-O2 -DNDEBUG` as the rest.
Pinocchio is not in Debian: its headers are those of its repository at that version, used as templates on `double` without its compiled library, geometry and parsers, so all of it is compiled with these flags.
Its model is built from the same numbers, with its joints about an axis, and its data are made once; a run checks that both give the same numbers to 1e-9.
`python3 bench/measure.py --only pinocchio --pinocchio FOLDER` measures this part.

{table(["quantity", "compiler", "instructions: cca / Pinocchio", "ratio"], rows)}
{measured(part)}"""


def floating(part):
    sines = {r["compiler"]: r for r in part["data"] if r["quantity"] == "sines"}
    rows = [[r["quantity"], r["compiler"], f"{number(r['cca'])} / {number(r['loops'])}", f"**{r['cca'] / r['loops']:.2f}**",
             "" if r["quantity"] == "sines" else f"{number(r['cca'] - sines[r['compiler']]['cca'])} / {number(r['loops'] - sines[r['compiler']]['loops'])}",
             r["allocations"]] for r in part["data"]]
    return f"""## Dynamics of a quadruped

A quadruped of twelve joints with a free base: recorded, and by the loops over its links that larger bodies use (`bench/floating_dynamics.cpp`).
Each computation begins with the angles; a run checks that both give the same numbers to 1e-12 of the largest.
Each cell reads recorded / loops; the row "sines" is what the sines and cosines of the angles take, of the library and of the C library.

{table(["quantity", "compiler", "instructions", "ratio", "without sines", "allocations in 1000 computations"], rows)}
{measured(part)}"""


def derivatives(part):
    rows = [[r["quantity"], r["compiler"], f"{number(r['cca'])} / {number(r['loops'])}", f"**{r['cca'] / r['loops']:.2f}**", r["allocations"]] for r in part["data"]]
    return f"""## Derivatives of dynamics

The matrices of [derivatives](body.md#derivatives) of the arm of seven joints and of the quadruped of twelve, whose bases stand, and the arm's Coriolis matrix, momentum and [operational space](body.md#recordings): recorded, and by the loops that larger bodies use (`bench/dynamics_derivatives.cpp`).
Each computation begins with the angles, operational space with mass matrix and Jacobian; those of derivatives give the torques or accelerations, too.
A run checks that both give the same numbers.
Each cell reads recorded / loops.

{table(["quantity", "compiler", "instructions", "ratio", "allocations in 1000 computations"], rows)}
{measured(part)}"""


def cold(part):
    def cell(r, way):
        recorded, loops = r["ns"][way]
        return f"{number(recorded)} / {number(loops)} (**{recorded / loops:.2f}**)"

    rows = [[r["quantity"], r["body"], r["compiler"], f"{r['operations']:,}", f"{r['bytes'] / 1024:.1f}", *(cell(r, way) for way in ("warm", "code", "data"))]
            for r in part["data"]]
    return f"""## Dynamics with cold caches

A component calls a function of dynamics once in a beat; the rest of the beat takes its place in the caches.
`bench/cold_dynamics.cpp` measures the arm of seven joints and the quadruped of twelve, recorded and by the loops over the links, with the sines of the angles, as nanoseconds of a call:

- warm: one call after another
- other code: after 256 KB of instructions, more than the processor's first cache holds; the recording comes from the second
- data, too: after 8 MB of data and that code; it comes from the third

Each cell reads recorded / loops (ratio), the median of 3,000 beats, less a call that does nothing.
The recordings are sorted by size.
The library records up to 2,300 operations ([decision 40](decisions/0040-recorded-dynamics.md)); the last one is larger, and shows what the limit is for.

{table(["quantity", "body", "compiler", "operations", "KB of code", "warm, ns", "other code, ns", "data, too, ns"], rows)}
{measured(part)}"""


def learning(part):
    rows = [[r["module"], r["compiler"], number(r["resting"]), number(r["batch"]), number(r["batch"] - r["resting"])] for r in part["data"]]
    return f"""## Learning beside the loop

A beat of each adaptive module while nothing is learned, and while another thread learns a batch (`bench/learning.cpp`).
Only the instructions of the loop are counted, with a source of all inputs and a demonstration on its wire.

{table(["module", "compiler", "instructions per beat", "while a batch is learned", "difference"], rows)}
{measured(part)}"""


def policies(part):
    rows = [[r["network"], r["compiler"], f"{number(r['policy'])} / {number(r['products'])} / {number(r['by_hand'])}",
             f"**{r['policy'] / r['products']:.3f}**", f"{r['policy'] / r['by_hand']:.3f}", r["allocations"]] for r in part["data"]]
    return f"""## Learned policies

A beat of a graph with a policy of 48 observations on four wires and 12 outputs (`bench/learned_policy.cpp`), beside two forms by hand:

- products: y = W x + b for each layer, without activation, scales or limits
- by hand: the whole network on Eigen vectors; a run checks that it gives the same numbers

Each cell reads policy / products / by hand.
The goal is at most 1.1 times the products.

{table(["activation, hidden layers", "compiler", "instructions per beat", "policy : products", "policy : by hand", "allocations in 1000 beats"], rows)}
{measured(part)}"""


def drives(part):
    rows = [[r["compiler"], f"`{r['flags']}`", number(r["instructions"]), r["allocations"]] for r in part["data"]]
    return f"""## Eight drives

A whole beat of the trot with `hardware::oncilla`, eight drives and the sensor board: 8 set-points, 13 answers, five buses, the whole safety chain.
In `bench/drives.cpp` each drive reaches its commanded position at once.
The instructions of these buses and drives are subtracted.

{table(["compiler", "flags", "instructions per beat", "allocations in 1000 beats"], rows)}
{measured(part)}"""


TRANSPORTS = {
    "loop": ("Within one loop", "by hand: the same copies in a function"),
    "threads": ("Between threads", "a bare atomic ping-pong: a number and the message on the same cache line"),
    "shared_memory": ("Between processes over shared memory", "the same ping-pong in shared memory"),
    "dds": ("Between processes over Cyclone DDS", "Cyclone DDS by its C functions, reliable, with a waitset"),
    "tcp": ("Over TCP", "a connection for each reflector, without delay"),
}
BOUNDS = {"threads": 1.5, "shared_memory": 1.2, "dds": 1.05}


def time(x):
    return f"{x:,.0f}" if x >= 100 else f"{x:.3g}"


def size(n):
    return f"{n} B" if n < 1024 else f"{n // 1024} KiB" if n < 1 << 20 else f"{n >> 20} MiB"


def latency(part):
    rows, blocks = part["data"], []
    keys = ("p50_us", "p99_us", "variance_us2", "jitter_us", "set_up_us")
    for transport, (title, raw_is) in TRANSPORTS.items():
        mine = {(r["fan_out"], r["bytes"], r["form"]): r for r in rows if r["transport"] == transport}
        if not mine:
            continue
        lines = []
        for fan_out, n in dict.fromkeys((f, b) for f, b, _ in mine):
            both = [mine[fan_out, n, form] for form in ("cca", "raw") if (fan_out, n, form) in mine]
            ratio_of = f"{both[0]['mean_us'] / both[1]['mean_us']:.2f}" if len(both) == 2 else ""
            lines.append([fan_out, size(n), " / ".join(time(r["mean_us"]) for r in both), ratio_of,
                          *(" / ".join(time(r[key]) for r in both) for key in keys)])
        small = [(b, r) for (f, b, form), r in mine.items() if form == "cca" and b <= 1024 and f == 1]
        note = ""
        if small and transport == "loop":
            note = f"The goal for one reflector and up to 1 KiB is 0.05 us; the longest is {time(max(r['mean_us'] for _, r in small))} us.\n"
        elif small and transport in BOUNDS:
            worst = max(r["mean_us"] / mine[1, b, "raw"]["mean_us"] for b, r in small)
            note = f"The goal for one reflector and up to 1 KiB is {BOUNDS[transport]} times raw; the largest ratio is {worst:.2f}.\n"
        head = ["reflectors", "message", "mean [us]", "ratio", "p50 [us]", "p99 [us]", "variance [us^2]", "jitter [us]", "set-up [us]"]
        forms = "Each cell reads cca / raw.\n" if any(form == "cca" for _, _, form in mine) else "Raw only: for comparison.\n"
        blocks.append(f"### {title}\n\nRaw is {raw_is}.\n{forms}{note}\n{table(head, lines)}")
    return f"""## Round trips

A driver publishes a message, each reflector publishes what it read, and the driver reads what comes back (`bench/latency`; section 5.1.3 of the source document).
`cmake --build --preset bench --target latency` measures this part and writes `build/bench/out/latency.json`.

How to read the figures:

- Between environments the architecture is the same for all transports; only the deployment differs.
  All its wires are `delayed<1>`: what the driver publishes in an even beat is reflected in the odd one after it, and read in the next even one.
  So a round trip is two beats of a fast run: the environments wait for each other, and each way is one hand-over.
  Raw does the same number of hand-overs: one there, one back.
- The time goes from one reading of the clock by the driver to the next, two beats later: it publishes, two messages cross, it checks the first and the last number of each.
  With several reflectors it ends when the last one has answered.
- In both forms a reader takes the whole message into memory of its own, and a writer puts it from there.
  The environments also hand over the time of origin and the beat, and look for faults in each other.
- Within one loop no wire needs a delay: the driver is a resource node, and a round trip is one beat, from its `sense` to its `act`.
  A reading of the clock takes longer than that: 200 round trips are timed together, and p50 and p99 are those of such means.
- All forms are measured in turn, up to 15 rounds each, all anew; a figure is the median of the rounds.
  Jitter is the mean difference between two round trips that follow each other; set-up goes from nothing to the first message that came back.
- If there are fewer cores than driver and reflectors, they take turns on them: then the figures are those of the system's scheduler, and so are raw's, which gives way after 64 looks.
  With a core each, driver and reflectors are pinned.
- What a hand-over costs depends on where the two cores are: 0.06 us a way between the two threads of one core, 0.35 us between cores.
  What the environments do beside it stays the same, so the ratios are worst where it is cheapest.
  The figures below are of the first kind; between cores, where a raw round trip of 8 B took 0.53 us, all ratios up to 1 KiB were 0.85 to 0.87 (commit 9707165, one short run).
- Samples are values, so a beat keeps them on the stack: what eight reflectors send of 1 MiB does not fit the usual 8 MiB.
  The programs run with a stack of 1 GiB (`ulimit -s`); with 16 reflectors 1 MiB is left out, because that takes 9 GB to compile.

{"".join(block + chr(10) for block in blocks)}{measured(part)}"""


def realtime(part):
    data = part["data"]
    if "refused" in data:
        return f"""## Wake-ups in real time

**Not measured: the system refused.**

```text
{data["refused"]}
```

{measured(part)}"""
    rows = [[state, *(f"{data[state]['cca'][q]} / {data[state]['cyclictest'][q]}" for q in ("p50", "p99", "p999", "max")),
             f"**{data[state]['p99_ratio']:.2f}**", f"{data[state]['cca']['count']:,}"] for state in data]
    return f"""## Wake-ups in real time

An environment with `cca::realtime<80, cca::on_core<N>>` makes wall-clock runs at 1 kHz (`bench/realtime.cpp`), and cyclictest of the same priority and period on the other core, in one run.
They change places in each round.
Under load, each core also has a process that computes without end.
`cmake --build --preset bench --target realtime` measures this part as root, or with the rights that [real time](real_time.md) needs, and writes `build/bench/out/realtime.json`.

A wake-up is the time from when a beat should begin until its thread is awake, in whole microseconds; each cell reads cca / cyclictest.
The maxima are those of the machine, virtual or not: compare them only with each other.
The goal is a p99 of at most 1.2 times that of cyclictest.

{table(["machine", "p50 [us]", "p99 [us]", "p99.9 [us]", "max [us]", "p99 : cyclictest", "beats"], rows)}
{measured(part)}"""


def modes(part):
    columns = ("trot", "trot_mode", "stand", "stand_mode")
    rows = [[r["compiler"], *(number(r[what]) for what in columns), f"**{number(r['switch'])}**"] for r in part["data"]]
    return f"""## Modes

The trot of the examples with a mode `stand` beside it, `-O3`, instructions (`bench/modes.cpp`).
The bound of a switch is a beat.

{table(["compiler", "beat of the trot, alone", "in the set", "beat of `stand`, alone", "in the set", "a switch"], rows)}
{measured(part)}"""


def observed(part):
    names = {"plain": "as it is", "recordable": "recordable, not recorded", "traceable": "traceable, not traced",
             "both": "both, neither recorded nor traced", "recorded": "recordable, recorded", "open": "recordable, an open door", "traced": "traceable, traced",
             "both_recorded": "both, recorded"}
    rows = [[name, *(f"{number(r[what])} ({100 * (r[what] / r['plain'] - 1):+.1f} %)" for r in part["data"])] for what, name in names.items()]
    return f"""## Recordings, doors and traces

Instructions of a beat of the trot's controller, `-O2` (`bench/observed.cpp`); those of other threads don't count.
A traced beat also reads the clock for each firing, of which only the call is counted here.
The bound of a recording and of an open door is 5 %.

{table(["graph", *(r["compiler"] for r in part["data"])], rows)}
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

One file with a graph and a function that makes one beat of it, at `-O2`, with samples of two axes.
Seconds are processor time (user and system), the least of several runs.
The speed of a shared machine changes by the minute, so each run also compiles Eigen alone; "times Eigen" is the figure that holds on other machines.
clang counts the instantiations in the whole file, including those of Eigen and the standard library.
The goals: 1,000 nodes in 15 s and 700 MB; 100 nodes at most 1.2 s above Eigen alone.

{bases}
{table(["graph", "compiler", "nodes", "s", "s above Eigen", "times Eigen", "MB", "classes instantiated", "functions instantiated"], rows)}
Growth exponent of the seconds above Eigen (1: linear):

{table(["graph", "compiler", "nodes", "exponent"], growth)}
Components of one type that are wired in the same way are compiled once.
"a type each" is the other extreme: no two components share anything.
A beat of more than 128 functions is compiled in parts of 64, each a function that is called once.
As one function, 1,000 nodes of mixed rates took g++ 106 s.

{measured(part)}"""


def listing(part):
    blocks = "\n".join(f"{compiler}:\n\n```asm\n" + "\n".join(lines) + "\n```\n" for compiler, lines in part["data"].items())
    return f"""## The loop of a small graph

A source and three low-pass filters in a row, at `-O2`: the whole beat, with the test whether the controller is running.
No sample, port or origin is left.

{blocks}"""


def text(figures, exponent):
    parts = ["""# Performance

<!-- Generated by bench/measure.py from bench/figures.json: edit those, not this page. -->

One command measures everything: `cmake --workflow --preset bench`.
It builds the benchmarks and runs `bench/measure.py`, which takes an hour on a machine that does nothing else.
It needs g++, clang++-19, valgrind, objdump, Google Benchmark and cyclictest; `./bootstrap` installs them.
Round trips are also compared with Cyclone DDS, if it is installed.
Counts do not depend on how busy the machine is; times do, and each time is the median of five.
`tests/runtime/no_allocation` and the test `performance: calls` check that a beat allocates nothing and calls nothing.
"""]
    if "trot" in figures:
        parts.append(trot(figures["trot"]))
    if "synthetic" in figures:
        parts.append(synthetic(figures["synthetic"]))
    if "skeletons" in figures:
        parts.append(skeletons(figures["skeletons"]))
    if "copies" in figures:
        parts.append(copies(figures["copies"]))
    if "random" in figures:
        parts.append(random_graph(figures["random"]))
    if "skills" in figures:
        parts.append(skills(figures["skills"]))
    if "arm" in figures:
        parts.append(arm(figures["arm"]))
    if "drives" in figures:
        parts.append(drives(figures["drives"]))
    if "dynamics" in figures:
        parts.append(dynamics(figures["dynamics"]))
    if "pinocchio" in figures:
        parts.append(pinocchio(figures["pinocchio"]))
    if "floating" in figures:
        parts.append(floating(figures["floating"]))
    if "derivatives" in figures:
        parts.append(derivatives(figures["derivatives"]))
    if "cold" in figures:
        parts.append(cold(figures["cold"]))
    if "learning" in figures:
        parts.append(learning(figures["learning"]))
    if "policies" in figures:
        parts.append(policies(figures["policies"]))
    if "modes" in figures:
        parts.append(modes(figures["modes"]))
    if "observed" in figures:
        parts.append(observed(figures["observed"]))
    if "latency" in figures:
        parts.append(latency(figures["latency"]))
    if "realtime" in figures:
        parts.append(realtime(figures["realtime"]))
    if "compile" in figures:
        parts.append(compiling(figures["compile"], exponent))
    if "listing" in figures:
        parts.append(listing(figures["listing"]))
    return "\n".join(parts)
