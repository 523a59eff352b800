"""Skeletons among the nodes of a random architecture: they are put after it, from a source of chance of their own, with probes
that read them. A skeleton that is a component is a node without a habit: the interpreter knows its function by its name
(skeletons.hpp). One that is a graph is a group of nodes, as docs/skeletons.md says; its stages and workers are probes.
"""
import random

KINDS = ("pipeline", "pipeline_over", "farm", "by_priority", "by_freshness", "switch", "blend", "blend_of", "hold", "freeze",
         "decimate", "averaged", "interpolate", "splitter", "collector")
PARTS = {"num2": ("num1", 2), "num3": ("num1", 3), "ang2": ("ang1", 2)}  # a farm's whole: what its workers take, and how many
AXES = {"num1": ["a0"], "num2": ["a0", "a1"], "num3": ["a0", "a1", "a2"], "ang1": ["a1"], "ang2": ["a0", "a2"]}


class Group:
    """Leaves that are one graph of the library's: its name in C++ is made of `skeleton`."""

    def __init__(self, skeleton, nodes, exposes):
        self.skeleton, self.nodes, self.exposes = skeleton, nodes, exposes


class Skeletons:
    """Adds to `made`, an architecture that is still flat."""

    def __init__(self, made, Node, Port, Wire):
        self.made, self.Node, self.Port, self.Wire = made, Node, Port, Wire
        self.rng = random.Random(made.seed + 1000003)
        self.groups = []
        self.group_in = None  # the environment of a graph whose nodes stay together
        self.outputs = [(node, port) for node in made.nodes for function, port in node.outputs() if function != "act"]
        for i in range(self.rng.choice([0, 1, 1, 2, 2, 3, 3]) if len(made.nodes) < 24 else 0):
            self.add(self.rng.choice(KINDS), i)
        for i in range(3, self.rng.choice([4, 5]) if made.threads else 3):
            self.add("farm_on_threads", i)

    def node(self, name, number, skeleton=None):
        node = self.Node(name, number)
        node.skeleton = skeleton
        self.made.place_somewhere(node)
        if self.group_in is not None:
            node.environment = self.group_in
        self.made.nodes.append(node)
        return node

    def stay_together(self, together):
        self.group_in = self.made.rng.randrange(self.made.environments) if together and self.made.environments > 1 else None
        if self.group_in is not None and self.group_in == self.made.free:
            self.group_in = (self.group_in + 1) % self.made.environments

    def give(self, node, name, space, kind="out", rate=None):
        port = self.Port(name, kind, space)
        port.rate = rate
        node.ports["process"][1].append(port)
        return port

    def take(self, node, name, writer, policy=("latest",), rate=None, stated=True, kind="in"):
        port = self.Port(name, kind, writer[1].space)
        port.rate = rate
        node.ports["process"][0].append(port)
        over = self.made.over(writer[0], node, policy)
        stated = stated or over != policy
        wire = self.Wire(*writer, node, port, over)
        wire.stated = stated
        self.made.wires.append(wire)

    def policy(self):
        return self.rng.choice([("latest",)] * 5 + [("delayed", self.rng.choice([1, 2, 3])), ("queue", self.rng.choice([1, 3]), "drop_oldest")])

    def writers(self, spaces, rate=None):
        return [(node, port) for node, port in self.outputs if port.space in spaces and (rate is None or port.rate in (None, rate))]

    def own(self, space, rate=None):
        """A writer of this space; where there is none, a probe that makes one."""
        known = self.writers([space], rate)
        if known and self.rng.randrange(100) < 85:
            return self.rng.choice(known)
        node = self.node(f"f{len(self.made.nodes)}", 500 + len(self.made.nodes))
        node.strategy = ("timed", self.rng.choice([1, 1, 2, 3]), 0)
        node.publishes = 50
        port = self.give(node, "y0", space, self.rng.choice(["out", "maybe"]))
        self.outputs.append((node, port))
        return node, port

    def sources(self, node, space, count):
        for i in range(count):
            self.take(node, f"w{i}", self.own(space), self.policy())

    def worker(self, node, into, space):
        node.strategy = ("port_triggered", (into,))
        node.publishes = self.rng.choice([60, 90])

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
            node = self.node(name, number)
            told = getattr(self, kind)(node, space)
            told = [(node, port) for port in told]
        self.outputs += told
        reader = self.node(f"r{i}", number + 9)
        for j, one in enumerate(told[:4]):
            self.take(reader, f"x{j}", one, rng.choice([("latest",), ("latest",), ("delayed", 1)]))
        reader.strategy = rng.choice([("default",), ("default",), ("restless",), ("moderate",), ("timed", 2, 1), ("full_speed",)])
        self.outputs.append((reader, self.give(reader, "y0", rng.choice(["num1", "num2", "ang1"]))))

    # ---- graphs ----

    def pipeline(self, kind, name, number, space):
        count = self.rng.choice([2, 2, 3, 4])
        between = self.rng.choice([("delayed", 1), ("delayed", 2), ("queue", 2, "drop_newest")]) if kind == "pipeline_over" else ("latest",)
        writer, nodes = self.own(space), []
        self.stay_together(between[0] != "delayed")
        for j in range(count):
            stage = self.node(f"stage{j}", number + j)
            self.take(stage, "x0", writer, between if j else self.policy(), stated=between[0] != "latest" if j else True)
            self.worker(stage, "x0", space)
            space = self.rng.choice(["num1", "num2", "ang1"])
            writer = stage, self.give(stage, "y0", space, self.rng.choice(["out", "out", "maybe"]))
            nodes.append(stage)
        self.stay_together(False)
        self.groups.append(Group((kind, between), nodes, {"stage0.x0": "input", f"stage{count - 1}.y0": "output"}))
        return writer

    def farm(self, name, number, whole, result):
        one, count = PARTS[whole]
        if PARTS[result][1] != count:
            result = whole
        given = PARTS[result][0]
        between = random.Random(self.made.seed * 31 + number).choice([None, None, ("delayed", 1), ("delayed", 2), ("queue", 2, "drop_oldest")])
        if between:
            self.made.count("of skeletons: farm with inner wires")
        self.stay_together(not between or between[0] != "delayed")
        inner, stated = between or ("latest",), bool(between)
        split = self.node("split", number, ("share_out", count))
        self.take(split, "input", self.own(whole), self.policy())
        nodes, sign = [split], (number + 1, self.rng.choice(["out", "out", "maybe"]))
        parts = [self.give(split, f"part{j}", one) for j in range(count)]
        join = None
        ends = []
        for j in range(count):
            worker = self.node(f"worker{j}", sign[0])  # of one type: they have one number
            self.take(worker, "x0", (split, parts[j]), inner, stated=stated)
            worker.strategy, worker.publishes = ("port_triggered", ("x0",)), 70
            ends.append((worker, self.give(worker, "y0", given, sign[1])))
            nodes.append(worker)
        join = self.node("join", number, ("gather", count))
        join.strategy = ("moderate",)
        for j, end in enumerate(ends):
            self.take(join, f"part{j}", end, inner, stated=stated)
        nodes.append(join)
        self.stay_together(False)
        output = join, self.give(join, "output", result)
        self.groups.append(Group(("farm", whole, result, between), nodes, {"split.input": "input", "join.output": "output"}))
        return output

    def farm_on_threads(self, name, number, whole, result):
        """Settled after each beat: a result comes one beat after its task."""
        count = PARTS[whole][1]
        if PARTS[result][1] != count:
            result = whole
        crew = self.node("crew", number, ("on_threads", count))
        crew.strategy = ("full_speed",)
        self.take(crew, "input", self.own(whole), self.policy())
        output = crew, self.give(crew, "output", result, "maybe")
        self.give(crew, "waiting", "num1")
        self.give(crew, "dropped", "num1")
        self.groups.append(Group(("farm_on_threads", whole, result), [crew], {"crew.input": "input", "crew.output": "output"}))
        return output

    # ---- components: each gives its outputs ----

    def by_priority(self, node, space):
        count = self.rng.choice([2, 2, 3])
        node.skeleton = ("by_priority", count, self.rng.choice([0, 0, 1, 4]) * self.made.period)
        self.sources(node, space, count)
        return [self.give(node, "y", space), self.give(node, "writer", "pick1")]

    def by_freshness(self, node, space):
        count = self.rng.choice([2, 2, 3])
        node.skeleton = ("by_freshness", count)
        self.sources(node, space, count)
        return [self.give(node, "y", space), self.give(node, "writer", "pick1")]

    def switch(self, node, space):
        count = self.rng.choice([2, 3])
        node.skeleton = ("switch", count, self.rng.choice([0, 3, 7, 20]) * self.made.period)
        self.sources(node, space, count)
        self.take(node, "choice", self.own("pick1"), self.policy())
        return [self.give(node, "y", space), self.give(node, "settled", "pick1")]

    def blend(self, node, space):
        node.skeleton = ("blend", self.rng.choice([-6, -1, 0]), self.rng.choice([1, 4, 7]))
        self.sources(node, space, 2)
        self.take(node, "weight", self.own("num1"), self.policy())
        return [self.give(node, "y", space)]

    def blend_of(self, node, space):
        node.skeleton = ("blend_of", 3)
        self.sources(node, space, 3)
        self.take(node, "weight", self.own("num3"), self.policy())
        return [self.give(node, "y", space)]

    def hold(self, node, space):
        node.skeleton = ("hold",)
        node.strategy = ("timed", self.rng.choice([1, 1, 2, 3]), 0)
        self.take(node, "input", self.own(space), self.policy())
        node.ports["process"][0].append(self.Port("freeze", "optional_in", "pick1"))
        return [self.give(node, "output", space)]

    def freeze(self, node, space):
        node.skeleton = ("hold",)
        self.take(node, "input", self.own(space), self.policy())
        self.take(node, "freeze", self.own("pick1"), self.policy(), kind="optional_in")
        return [self.give(node, "output", space)]

    def ratio(self):
        """Of two rates, in beats: the faster one, and how many of it there are to one of the slower."""
        pairs = [(fast, n) for fast in (1, 2) for n in (2, 3, 5) if self.made.base % (fast * n) == 0]
        return self.rng.choice(pairs or [(1, self.made.base)])

    def decimate(self, node, space, how="picked"):
        fast, n = self.ratio()
        into, to = self.made.base // fast, self.made.base // fast // n
        node.skeleton = ("decimate", n, how)
        self.take(node, "input", self.own(space, into), self.policy(), into)
        return [self.give(node, "output", space, "maybe", to)]

    def averaged(self, node, space):
        return self.decimate(node, space, "averaged")

    def interpolate(self, node, space):
        fast, n = self.ratio()
        into, to = self.made.base // fast // n, self.made.base // fast
        node.skeleton = ("interpolate", n)
        node.strategy = ("timed", fast, 0)
        self.take(node, "input", self.own(space, into), self.policy(), into)
        return [self.give(node, "output", space, "out", to)]

    def splitter(self, node, space):
        space = self.rng.choice(["num2", "num3", "ang2"])
        node.skeleton = ("splitter",)
        self.take(node, "whole", self.own(space), self.policy())
        return [self.give(node, axis, f"{space}_{axis}") for axis in AXES[space]]

    def collector(self, node, space):
        space = self.rng.choice(["num2", "num3", "ang2"])
        node.skeleton = ("collector",)
        node.strategy = self.rng.choice([("moderate",), ("default",)])
        for axis in AXES[space]:
            self.take(node, axis, self.own(f"{space}_{axis}"), self.policy())
        return [self.give(node, "whole", space)]


# ---- as code ----


def skeleton_cpp(skeleton, node):
    """Of a node."""
    kind, rest = skeleton[0], skeleton[1:]
    inputs, outputs = node.ports["process"]

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


def inner_wires(between):
    """The option of a skeleton that sets the policy of its inner wires; nothing where none is stated."""
    if not between or between[0] == "latest":
        return ""
    policy = f"cca::delayed<{between[1]}>" if between[0] == "delayed" else f"cca::queue<{between[1]}, cca::{between[2]}>"
    return f", cca::inner_wires<{policy}>"


def group_cpp(group, node_cpp):
    kind, nodes = group.skeleton[0], group.nodes
    if kind == "farm":
        whole, result, between = group.skeleton[1:]
        return f"cca::farm<{node_cpp(nodes[1])}, {whole}, {result}{inner_wires(between)}>"
    if kind == "farm_on_threads":
        whole, result = group.skeleton[1:]
        return f"cca::farm_on_threads<apprentice<{PARTS[whole][0]}, {PARTS[result][0]}>, {whole}, {result}>"
    stages = ", ".join(node_cpp(node) for node in nodes)
    return f"cca::pipeline<{stages}{inner_wires(group.skeleton[1])}>"
