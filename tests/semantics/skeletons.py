"""Skeletons among the nodes of a random architecture: they are put behind it, from a source of chance of their own, with probes
that read them. A skeleton that is a component is a leaf without a habit: the interpreter knows its function by its name
(skeletons.hpp). One that is a graph is a group of leaves, as docs/skeletons.md says; its stages and workers are probes.
"""
import random

KINDS = ("pipeline", "pipeline_over", "farm", "by_priority", "by_freshness", "switch", "blend", "blend_of", "hold", "freeze",
         "decimate", "averaged", "interpolate", "splitter", "collector")
PARTS = {"num2": ("num1", 2), "num3": ("num1", 3), "ang2": ("ang1", 2)}  # a farm's whole: what its workers take, and how many
AXES = {"num1": ["a0"], "num2": ["a0", "a1"], "num3": ["a0", "a1", "a2"], "ang1": ["a1"], "ang2": ["a0", "a2"]}


class Group:
    """Leaves that are one graph of the library's: its name in C++ is made of `skeleton`."""

    def __init__(self, skeleton, leaves, exposes):
        self.skeleton, self.leaves, self.exposes = skeleton, leaves, exposes


class Skeletons:
    """Adds to `made`, an architecture that is still flat."""

    def __init__(self, made, Leaf, Port, Wire):
        self.made, self.Leaf, self.Port, self.Wire = made, Leaf, Port, Wire
        self.rng = random.Random(made.seed + 1000003)
        self.groups = []
        self.group_in = None  # the environment of a graph whose leaves stay together
        self.outputs = [(leaf, port) for leaf in made.nodes for half, port in leaf.outputs() if half != "act"]
        for i in range(self.rng.choice([0, 1, 1, 2, 2, 3, 3]) if len(made.nodes) < 24 else 0):
            self.add(self.rng.choice(KINDS), i)
        for i in range(3, self.rng.choice([4, 5]) if made.threads else 3):
            self.add("farm_on_threads", i)

    def leaf(self, name, number, skeleton=None):
        leaf = self.Leaf(name, number)
        leaf.skeleton = skeleton
        self.made.place_somewhere(leaf)
        if self.group_in is not None:
            leaf.environment = self.group_in
        self.made.nodes.append(leaf)
        return leaf

    def stay_together(self, together):
        self.group_in = self.made.rng.randrange(self.made.environments) if together and self.made.environments > 1 else None

    def give(self, leaf, name, space, kind="out", rate=None):
        port = self.Port(name, kind, space)
        port.rate = rate
        leaf.ports["process"][1].append(port)
        return port

    def take(self, leaf, name, writer, policy=("latest",), rate=None, stated=True, kind="in"):
        port = self.Port(name, kind, writer[1].space)
        port.rate = rate
        leaf.ports["process"][0].append(port)
        over = self.made.over(writer[0], leaf, policy)
        stated = stated or over != policy
        wire = self.Wire(*writer, leaf, port, over)
        wire.stated = stated
        self.made.wires.append(wire)

    def policy(self):
        return self.rng.choice([("latest",)] * 5 + [("delayed", self.rng.choice([1, 2, 3])), ("queue", self.rng.choice([1, 3]), "drop_oldest")])

    def writers(self, spaces, rate=None):
        return [(leaf, port) for leaf, port in self.outputs if port.space in spaces and (rate is None or port.rate in (None, rate))]

    def own(self, space, rate=None):
        """A writer of this space; where there is none, a probe that makes one."""
        known = self.writers([space], rate)
        if known and self.rng.randrange(100) < 85:
            return self.rng.choice(known)
        leaf = self.leaf(f"f{len(self.made.nodes)}", 500 + len(self.made.nodes))
        leaf.strategy = ("timed", self.rng.choice([1, 1, 2, 3]), 0)
        leaf.publishes = 50
        port = self.give(leaf, "y0", space, self.rng.choice(["out", "maybe"]))
        self.outputs.append((leaf, port))
        return leaf, port

    def sources(self, leaf, space, count):
        for i in range(count):
            self.take(leaf, f"w{i}", self.own(space), self.policy())

    def worker(self, leaf, into, space):
        leaf.strategy = ("port_triggered", (into,))
        leaf.publishes = self.rng.choice([60, 90])

    def add(self, kind, i):
        rng, name, number = self.rng, f"k{i}", 400 + 10 * i
        space = rng.choice(["num1", "num1", "num2", "num3", "ang1", "ang2"])
        self.made.count(f"of skeletons: {kind}")
        told = []
        if kind in ("pipeline", "pipeline_over"):
            told = [self.pipeline(kind, name, number, space)]
        elif kind in ("farm", "farm_on_threads"):
            told = [getattr(self, kind)(name, number, rng.choice(list(PARTS)), rng.choice(list(PARTS)))]
        else:
            leaf = self.leaf(name, number)
            told = getattr(self, kind)(leaf, space)
            told = [(leaf, port) for port in told]
        self.outputs += told
        reader = self.leaf(f"r{i}", number + 9)
        for j, one in enumerate(told[:4]):
            self.take(reader, f"x{j}", one, rng.choice([("latest",), ("latest",), ("delayed", 1)]))
        reader.strategy = rng.choice([("default",), ("default",), ("restless",), ("moderate",), ("timed", 2, 1), ("full_speed",)])
        self.outputs.append((reader, self.give(reader, "y0", rng.choice(["num1", "num2", "ang1"]))))

    # ---- graphs ----

    def pipeline(self, kind, name, number, space):
        count = self.rng.choice([2, 2, 3, 4])
        between = self.rng.choice([("delayed", 1), ("delayed", 2), ("queue", 2, "drop_newest")]) if kind == "pipeline_over" else ("latest",)
        writer, leaves = self.own(space), []
        self.stay_together(between[0] != "delayed")
        for j in range(count):
            stage = self.leaf(f"stage{j}", number + j)
            self.take(stage, "x0", writer, between if j else self.policy(), stated=between[0] != "latest" if j else True)
            self.worker(stage, "x0", space)
            space = self.rng.choice(["num1", "num2", "ang1"])
            writer = stage, self.give(stage, "y0", space, self.rng.choice(["out", "out", "maybe"]))
            leaves.append(stage)
        self.stay_together(False)
        self.groups.append(Group((kind, between), leaves, {"stage0.x0": "input", f"stage{count - 1}.y0": "output"}))
        return writer

    def farm(self, name, number, whole, result):
        one, count = PARTS[whole]
        if PARTS[result][1] != count:
            result = whole
        given = PARTS[result][0]
        self.stay_together(True)
        split = self.leaf("split", number, ("share_out", count))
        self.take(split, "input", self.own(whole), self.policy())
        leaves, sign = [split], (number + 1, self.rng.choice(["out", "out", "maybe"]))
        parts = [self.give(split, f"part{j}", one) for j in range(count)]
        join = None
        ends = []
        for j in range(count):
            worker = self.leaf(f"worker{j}", sign[0])  # of one type: they have one number
            self.take(worker, "x0", (split, parts[j]), stated=False)
            worker.strategy, worker.publishes = ("port_triggered", ("x0",)), 70
            ends.append((worker, self.give(worker, "y0", given, sign[1])))
            leaves.append(worker)
        join = self.leaf("join", number, ("gather", count))
        join.strategy = ("moderate",)
        for j, end in enumerate(ends):
            self.take(join, f"part{j}", end, stated=False)
        leaves.append(join)
        self.stay_together(False)
        output = join, self.give(join, "output", result)
        self.groups.append(Group(("farm", whole, result), leaves, {"split.input": "input", "join.output": "output"}))
        return output

    def farm_on_threads(self, name, number, whole, result):
        """Settled after each beat: a result comes one beat after its task."""
        count = PARTS[whole][1]
        if PARTS[result][1] != count:
            result = whole
        crew = self.leaf("crew", number, ("on_threads", count))
        crew.strategy = ("full_speed",)
        self.take(crew, "input", self.own(whole), self.policy())
        output = crew, self.give(crew, "output", result, "maybe")
        self.give(crew, "waiting", "num1")
        self.give(crew, "dropped", "num1")
        self.groups.append(Group(("farm_on_threads", whole, result), [crew], {"crew.input": "input", "crew.output": "output"}))
        return output

    # ---- components: each gives its outputs ----

    def by_priority(self, leaf, space):
        count = self.rng.choice([2, 2, 3])
        leaf.skeleton = ("by_priority", count, self.rng.choice([0, 0, 1, 4]) * self.made.period)
        self.sources(leaf, space, count)
        return [self.give(leaf, "y", space), self.give(leaf, "writer", "pick1")]

    def by_freshness(self, leaf, space):
        count = self.rng.choice([2, 2, 3])
        leaf.skeleton = ("by_freshness", count)
        self.sources(leaf, space, count)
        return [self.give(leaf, "y", space), self.give(leaf, "writer", "pick1")]

    def switch(self, leaf, space):
        count = self.rng.choice([2, 3])
        leaf.skeleton = ("switch", count, self.rng.choice([0, 3, 7, 20]) * self.made.period)
        self.sources(leaf, space, count)
        self.take(leaf, "choice", self.own("pick1"), self.policy())
        return [self.give(leaf, "y", space), self.give(leaf, "settled", "pick1")]

    def blend(self, leaf, space):
        leaf.skeleton = ("blend", self.rng.choice([-6, -1, 0]), self.rng.choice([1, 4, 7]))
        self.sources(leaf, space, 2)
        self.take(leaf, "weight", self.own("num1"), self.policy())
        return [self.give(leaf, "y", space)]

    def blend_of(self, leaf, space):
        leaf.skeleton = ("blend_of", 3)
        self.sources(leaf, space, 3)
        self.take(leaf, "weight", self.own("num3"), self.policy())
        return [self.give(leaf, "y", space)]

    def hold(self, leaf, space):
        leaf.skeleton = ("hold",)
        leaf.strategy = ("timed", self.rng.choice([1, 1, 2, 3]), 0)
        self.take(leaf, "input", self.own(space), self.policy())
        leaf.ports["process"][0].append(self.Port("freeze", "optional_in", "pick1"))
        return [self.give(leaf, "output", space)]

    def freeze(self, leaf, space):
        leaf.skeleton = ("hold",)
        self.take(leaf, "input", self.own(space), self.policy())
        self.take(leaf, "freeze", self.own("pick1"), self.policy(), kind="optional_in")
        return [self.give(leaf, "output", space)]

    def ratio(self):
        """Of two rates, in beats: the faster one, and how many of it there are to one of the slower."""
        pairs = [(fast, n) for fast in (1, 2) for n in (2, 3, 5) if self.made.base % (fast * n) == 0]
        return self.rng.choice(pairs or [(1, self.made.base)])

    def decimate(self, leaf, space, how="picked"):
        fast, n = self.ratio()
        into, to = self.made.base // fast, self.made.base // fast // n
        leaf.skeleton = ("decimate", n, how)
        self.take(leaf, "input", self.own(space, into), self.policy(), into)
        return [self.give(leaf, "output", space, "maybe", to)]

    def averaged(self, leaf, space):
        return self.decimate(leaf, space, "averaged")

    def interpolate(self, leaf, space):
        fast, n = self.ratio()
        into, to = self.made.base // fast // n, self.made.base // fast
        leaf.skeleton = ("interpolate", n)
        leaf.strategy = ("timed", fast, 0)
        self.take(leaf, "input", self.own(space, into), self.policy(), into)
        return [self.give(leaf, "output", space, "out", to)]

    def splitter(self, leaf, space):
        space = self.rng.choice(["num2", "num3", "ang2"])
        leaf.skeleton = ("splitter",)
        self.take(leaf, "whole", self.own(space), self.policy())
        return [self.give(leaf, axis, f"{space}_{axis}") for axis in AXES[space]]

    def collector(self, leaf, space):
        space = self.rng.choice(["num2", "num3", "ang2"])
        leaf.skeleton = ("collector",)
        leaf.strategy = self.rng.choice([("moderate",), ("default",)])
        for axis in AXES[space]:
            self.take(leaf, axis, self.own(f"{space}_{axis}"), self.policy())
        return [self.give(leaf, "whole", space)]


# ---- as code ----


def skeleton_cpp(skeleton, leaf):
    """Of a leaf."""
    kind, rest = skeleton[0], skeleton[1:]
    inputs, outputs = leaf.ports["process"]

    def named(ports):
        return ", ".join(f'"{port.name}"' for port in ports)

    space = outputs[0].space
    if kind in ("by_priority", "by_freshness"):
        made = f'cca::arbiter<"y", {space}, cca::{kind}<{named(inputs)}>>'
        return f"with_patience<{made}, {rest[1]}>" if kind == "by_priority" else made
    if kind == "switch":
        return f'lasting<cca::switch_between<"y", {space}, {named(inputs[:-1])}>, {rest[1]}>'
    if kind == "blend":
        return f'between<cca::blend<"y", {space}, num1, {named(inputs[:-1])}>, {rest[0]}, {rest[1]}>'
    if kind == "blend_of":
        return f'cca::blend<"y", {space}, num3, {named(inputs[:-1])}>'
    if kind == "hold":
        return f"cca::hold<{space}>"
    if kind in ("decimate", "interpolate"):
        how = f", cca::{rest[1]}" if kind == "decimate" else ""
        return f"cca::{kind}<at<{space}, {inputs[0].rate}>, at<{space}, {outputs[0].rate}>{how}>"
    if kind == "splitter":
        return f'cca::splitter<"whole", {inputs[0].space}>'
    return f'cca::collector<"whole", {space}>'


def group_cpp(group, leaf_cpp):
    kind, leaves = group.skeleton[0], group.leaves
    if kind == "farm":
        return f"cca::farm<{leaf_cpp(leaves[1])}, {group.skeleton[1]}, {group.skeleton[2]}>"
    if kind == "farm_on_threads":
        whole, result = group.skeleton[1:]
        return f"cca::farm_on_threads<apprentice<{PARTS[whole][0]}, {PARTS[result][0]}>, {whole}, {result}>"
    stages = ", ".join(leaf_cpp(leaf) for leaf in leaves)
    if kind == "pipeline":
        return f"cca::pipeline<{stages}>"
    between = group.skeleton[1]
    policy = f"cca::delayed<{between[1]}>" if between[0] == "delayed" else f"cca::queue<{between[1]}, cca::{between[2]}>"
    return f"cca::pipeline_over<{policy}, {stages}>"
