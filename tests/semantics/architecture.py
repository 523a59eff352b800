"""A random well-formed architecture.

It is made flat first: nodes, then wires that close no loop without delay, then strategies, rates and policies that the
Rules allow. Then it is cut into nested graphs, some of which are used twice. It may also be spread over environments; then the
wires between them are delayed.
"""
import random

from outside import add_looks, rests_of_spread
from scopes import Scopes, is_queued, may_hear
from skeletons import AXES, Group, Skeletons

DIMENSIONS = {"num1": 1, "num2": 2, "num3": 3, "ang1": 1, "ang2": 2, "pick1": 1}
DIMENSIONS.update({f"{space}_{axis}": 1 for space, axes in AXES.items() for axis in axes})  # one axis of a space
BASE_RATES = [1000, 1200, 600, 300, 100, 12, 7]


class Port:
    def __init__(self, name, kind, space):
        self.name, self.kind, self.space = name, kind, space
        self.rate = None   # stated by its space
        self.alias = False  # the same space under another name

    def cpp(self):
        space = f"also_{self.space}" if self.alias and not self.rate else self.space
        if self.rate:
            space = f"at<{self.space}, {self.rate}>"
        return f'cca::{self.kind}<"{self.name}", {space}>'


class Node:
    """A component, or a resource node. Its strategy is a tuple of the words that the text has."""

    def __init__(self, name, number):
        self.name, self.number = name, number
        self.resource = False
        self.ports = {"sense": ([], []), "process": ([], []), "act": ([], [])}  # inputs, outputs
        self.functions = ["process"]
        self.strategy = ("default",)
        self.publishes, self.origin, self.fault_at = 100, 0, -1
        self.fault_function, self.fault_first = None, False
        self.hears, self.hears_policy = None, ("latest",)  # the pattern of an observer
        self.skeleton = None  # of the library's: its kind, and what its function depends on
        self.root = None    # the node from whose samples alone it makes its own, each as it comes
        self.environment = 0
        self.rests = None   # the beats before which somebody stops it and starts it again
        self.switches = []  # modes that it asks for by its results
        self.asks = []      # parts that it stops or starts by its results: the path as it is spelled, and which of the two

    def inputs(self):
        return [(function, port) for function in self.functions for port in self.ports[function][0]]

    def outputs(self):
        return [(function, port) for function in self.functions for port in self.ports[function][1]]


class Wire:
    def __init__(self, writer, out, reader, into, policy):
        self.writer, self.out, self.reader, self.into, self.policy = writer, out, reader, into, policy
        self.initial = None
        self.stated = True

    def delayed(self):
        return self.policy[0] == "delayed"


class Graph:
    """A type. Children are (name, Node or Graph); wires (from, to, Wire); exposes {outer: inner}."""

    def __init__(self, name):
        self.name = name
        self.children, self.wires, self.exposes = [], [], {}
        self.rate = None
        self.group = None  # a skeleton of the library's, which has what this graph shows
        self.stoppable = set()  # the names of inner graphs that stop and start as a whole
        self.observes = []  # patterns with policies, for programs

    def expose(self, inner):
        if self.group:
            self.exposes[self.group.exposes[inner]] = inner
            return self.group.exposes[inner]
        for outer, known in self.exposes.items():
            if known == inner:
                return outer
        outer = f"p{len(self.exposes)}"
        self.exposes[outer] = inner
        return outer


class Architecture:
    most_nodes = 21

    def __init__(self, seed, threads=False, is_spread=False, over_dds=False):
        self.seed, self.threads = seed, threads
        self.in_processes = is_spread and (over_dds or seed % 4 == 1)
        self.looks = []  # before these beats a program looks at what graphs observe
        self.environments = 2 + seed % 3 if is_spread else 1
        self.free = None  # an environment that runs freely
        self.rng = random.Random(seed)
        self.features = {}
        self.base = self.rng.choice(BASE_RATES)
        self.period = 1000000000 // self.base
        self.make_nodes()
        self.make_wires()
        self.make_strategies()
        self.make_watchers()
        self.make_rates()
        self.make_policies()
        self.make_habits()
        self.make_buffers()
        self.groups = Skeletons(self, Node, Port, Wire).groups
        self.nest()

    def chance(self, percent):
        return self.rng.randrange(100) < percent

    def place_somewhere(self, node):
        """In an environment, most often in the same as its neighbours in the order."""
        if self.environments > 1:
            self.here = self.rng.randrange(self.environments) if self.chance(40) else getattr(self, "here", 0)
            node.environment = self.here
            if node.environment == self.free:  # its components are chosen
                node.environment = (self.free + 1) % self.environments

    def over(self, writer, reader, policy):
        """The policy of a wire, which between two environments is delayed."""
        if writer.environment == reader.environment or policy[0] == "delayed":
            return policy
        return ("delayed", self.rng.choice([1, 1, 1, 2, 3, 5]))

    def count(self, feature, by=1):
        self.features[feature] = self.features.get(feature, 0) + by

    # ---- nodes and their outputs ----

    def make_nodes(self):
        rng = self.rng
        n = min(3 + int(rng.expovariate(1 / 6)), self.most_nodes)
        resources = rng.choice([0, 0, 1, 1, 2, 3]) if n > 3 else rng.choice([0, 0, 1])
        self.nodes = [Node(f"c{i}", i) for i in range(n)]
        for node in self.nodes:
            self.place_somewhere(node)
        if self.environments > 1 and len({node.environment for node in self.nodes}) == 1:
            self.nodes[-1].environment = 1 - min(1, self.nodes[0].environment)
        for node in rng.sample(self.nodes, min(resources, n - 2)):
            node.resource = True
            node.functions = rng.choice([["sense", "act"], ["sense", "act"], ["sense"], ["act"]])
        self.components = [node for node in self.nodes if not node.resource]
        rng.shuffle(self.components)  # an order in which wires without delay may go
        for node in self.nodes:
            for function in node.functions:
                if function == "act":
                    continue
                for i in range(rng.choice([1, 1, 1, 1, 2, 2, 3]) if function == "sense" or self.chance(90) else 0):
                    kind = "maybe" if self.chance(25) else "out"
                    node.ports[function][1].append(Port(f"y{i}", kind, self.any_space()))

    def any_space(self):
        return self.rng.choice(["num1", "num1", "num1", "num2", "num2", "num3", "ang1", "ang2"])

    # ---- wires ----

    def make_wires(self):
        rng = self.rng
        self.wires = []
        everywhere = [(node, port) for node in self.nodes for _, port in node.outputs()]
        before = [(node, port) for node in self.nodes if node.resource for _, port in node.outputs()]
        for node in self.components:
            if not (self.chance(18) or (not before and self.chance(60))):
                at_hand = [one for one in before if one[0].environment == node.environment]
                if at_hand and self.chance(22):
                    self.make_join(node, at_hand)
                else:
                    for i in range(rng.choice([1, 1, 1, 2, 2, 3])):
                        self.make_input(node, "process", f"x{i}", at_hand if self.environments > 1 and at_hand and self.chance(50) else before, everywhere)
            node.root = self.root_of(node) if self.chance(60) else None
            before += [(node, port) for _, port in node.outputs()]
        for node in self.nodes:
            if "act" in node.functions:
                for i in range(rng.choice([1, 1, 2, 3])):
                    numbers = [(w, p) for w, p in before if p.space[0] == "n"]
                    self.make_input(node, "act", f"u{i}", numbers, [(w, p) for w, p in everywhere if p.space[0] == "n"], "num1")
        # A resource node's sense may hear another one's, its act another one's act: in the order of declaration or against it.
        devices = [node for node in self.nodes if node.resource]
        rng.shuffle(devices)
        for a, b in zip(devices, devices[1:]):
            if "sense" in a.functions and "sense" in b.functions and a.ports["sense"][1] and self.chance(40):
                out = rng.choice(a.ports["sense"][1])
                port = Port("s0", "in", out.space)
                b.ports["sense"][0].append(port)
                self.wires.append(Wire(a, out, b, port, self.over(a, b, ("latest",))))
                self.count("wires from sense to sense")
            if "act" in a.functions and "act" in b.functions and self.chance(40):
                out, port = Port("v0", "out", "num1"), Port("w0", "in", "num1")
                a.ports["act"][1].append(out)
                b.ports["act"][0].append(port)
                self.wires.append(Wire(a, out, b, port, self.over(a, b, ("latest",))))
                self.count("wires from act to act")

    def make_input(self, node, function, name, before, everywhere, spare="num1"):
        rng = self.rng
        kind = "optional_in" if self.chance(20) else "in"
        if kind == "optional_in" and self.chance(40) or not everywhere:
            node.ports[function][0].append(Port(name, "optional_in", spare if function == "act" else self.any_space()))
            return
        roll = rng.randrange(100)
        if roll < 22 or not before:
            policy = ("delayed", rng.choice([1, 1, 1, 2, 3, 5]))
            if function == "process" and self.chance(30) and node.outputs():
                writer, out = node, node.outputs()[0][1]  # its own loop
            else:
                writer, out = rng.choice(everywhere)
        else:
            writer, out = rng.choice(before)
            policy = ("queue", rng.choice([1, 2, 2, 3, 4, 8]), rng.choice(["drop_oldest", "drop_newest", "reject"])) if roll < 40 else ("latest",)
        port = Port(name, kind, out.space)
        node.ports[function][0].append(port)
        self.wires.append(Wire(writer, out, node, port, self.over(writer, node, policy)))

    def make_join(self, node, before):
        """Inputs that stem from one node's samples, so that they can share an origin."""
        start = self.rng.choice(before)[0]
        start = start.root or start
        alike = [(w, p) for w, p in before if (w.root or w) is start]
        for i in range(self.rng.choice([1, 2, 2, 3])):
            writer, out = self.rng.choice(alike)
            policy = ("queue", self.rng.choice([1, 2, 4]), "drop_oldest") if self.chance(20) else ("latest",)
            port = Port(f"x{i}", "in", out.space)
            node.ports["process"][0].append(port)
            self.wires.append(Wire(writer, out, node, port, policy))

    def wires_to(self, node):
        return [wire for wire in self.wires if wire.reader is node]

    def root_of(self, node):
        wires = self.wires_to(node)
        roots = {id(wire.writer.root or wire.writer) for wire in wires}
        if not wires or len(roots) != 1 or any(wire.delayed() for wire in wires):
            return None
        return wires[0].writer.root or wires[0].writer

    # ---- strategies ----

    def timed(self):
        n = self.rng.choice([1, 1, 2, 2, 3, 4, 5, 6, 10])
        phase = self.rng.choice([0, 0, 0, self.rng.randrange(n), self.rng.randrange(n), n + 1, -1])
        return ("timed", n, phase)

    def user(self, names):
        choice = self.rng.randrange(5) if names else self.rng.randrange(2)
        name = self.rng.choice(names) if names else "-"
        if choice == 0:
            n = self.rng.choice([2, 3, 4, 5])
            return ("user", "on_beats", "-", n, self.rng.randrange(n))
        if choice == 1:
            return ("user", "patient", "-", self.rng.choice([0, 1, 3, 5]) * self.period // 1000 + 1, 0)
        if choice == 2:
            return ("user", "above", name, self.rng.choice([-16, -4, 0, 4, 8]), 0)
        if choice == 3:
            return ("user", "older", name, self.rng.choice([-1, 0, 1, 2]) * min(self.period, 300000000), 0)
        return ("user", "fresh_on_odd", name, 0, 0)

    def event(self, names):
        choice = self.rng.randrange(3)
        if choice == 2:
            chosen = self.rng.sample(names, self.rng.randrange(1, len(names) + 1))
            return ("port_triggered", tuple(chosen))
        return ("restless", "moderate")[choice],

    def make_strategies(self):
        for node in self.nodes:
            names = [wire.into.name for wire in self.wires_to(node)]
            if node.resource:
                node.strategy = self.rng.choice([("default",)] * 5 + [("full_speed",), self.timed(), self.timed(), ("inactive",) if self.chance(20) else ("default",)])
            elif names:
                node.strategy = self.with_inputs(node, names)
            else:
                plain = [self.timed(), self.timed(), self.timed(), ("full_speed",), ("timeout", self.rng.randrange(1, 6)),
                         self.user([]), ("any_of", (self.timed(), self.timed()))]
                if not node.inputs():
                    plain += [("default",)] * 4
                if self.chance(4):
                    plain = [("inactive",)]
                node.strategy = self.rng.choice(plain)
        self.wake()
        self.let_rest()
        self.run_freely()

    def run_freely(self):
        """One environment may run freely: its components fire in every beat, and its wires may have no delay."""
        rng = random.Random(f"{self.seed} runs freely")
        used = sorted({node.environment for node in self.nodes})
        if len(used) < 2 or rng.randrange(2):
            return
        self.free = rng.choice(used)
        self.count("free-running environments")
        for node in self.nodes:
            if node.environment == self.free:
                node.strategy, node.rests, node.root = ("full_speed",), None, None
                if not node.resource and rng.randrange(100) < 20:
                    node.strategy = ("stoppable", node.strategy)
                    self.count("components of free-running environments that may be stopped")
        for wire in self.wires:
            if self.crosses_freely(wire) and wire.delayed() and rng.randrange(2):
                wire.policy = ("latest",)
                self.count("wires without delay to or from a free-running environment")

    def crosses_freely(self, wire):
        """It may do without delay: it leads forwards in a beat, to or from the environment that runs freely."""
        a, b = wire.writer, wire.reader
        order = {id(node): place for place, node in enumerate(self.components)}
        senses, acts = wire.out in a.ports.get("sense", ([], []))[1], wire.into in b.ports.get("act", ([], []))[0]
        in_order = (senses or id(a) in order) and (acts or id(b) in order) and (senses or acts or order[id(a)] < order[id(b)])
        return in_order and a.environment != b.environment and self.free in (a.environment, b.environment)

    def queue_freely(self):
        """Queues and merged wires to and from it may do without delay as well."""
        rng = random.Random(f"{self.seed} queues freely")
        for wire in self.wires:
            if self.free is None or wire.policy[0] != "delayed" or len(wire.policy) == 2 or not self.crosses_freely(wire):
                continue
            same = [one for one in self.wires if one.into is wire.into and one.out is wire.out and one is not wire and one.policy[0] != "delayed"]
            if rng.randrange(100) < 70 and not same:
                wire.policy = wire.policy[2:]
                self.count(f"{wire.policy[0]} wires without delay to or from a free-running environment")

    def let_rest(self):
        """Some can be stopped. In one loop somebody stops them for a while, in environments nobody does."""
        rng = random.Random(f"{self.seed} rests")
        for node in self.nodes:
            if node.resource or node.root or node.strategy[0] in ("default", "inactive") or rng.randrange(100) >= 9:
                continue
            node.strategy = ("stoppable", node.strategy)
            if self.environments == 1 and rng.randrange(100) < 80:
                first = rng.randrange(1, 60)
                node.rests = first, first + rng.randrange(1, 40)

    def with_inputs(self, node, names):
        rng = self.rng
        if node.root and (self.chance(50) or len(names) == 1):
            return rng.choice([("default",), self.event(names)])
        if self.root_of(node) and (node.root or self.chance(60)):
            return rng.choice([("coordinated",)] * 4 + [("any_of", (("coordinated",), ("timeout", rng.randrange(3, 9))))])
        roll = rng.randrange(100)
        if roll < 16:
            return ("default",)
        if roll < 22:
            return ("restless",)
        if roll < 38:
            return ("moderate",)
        if roll < 46:
            return ("port_triggered", tuple(rng.sample(names, rng.randrange(1, len(names) + 1))))
        if roll < 60:
            return self.timed()
        if roll < 63:
            return ("full_speed",)
        if roll < 65:
            return ("inactive",)
        if roll < 76:
            parts = rng.choice([(self.event(names), ("timeout", rng.randrange(1, 9))), (self.event(names), self.timed()),
                                (self.timed(), self.timed()), (self.user(names), ("inactive",)), (self.event(names), self.event(names)),
                                (("all_of", (self.event(names), self.timed())), ("timeout", 7))])
            return ("any_of", parts)
        if roll < 87:
            parts = rng.choice([(self.event(names), ("timeout", rng.randrange(1, 9))), (self.event(names), self.timed()),
                                (("timed", 2, 1), ("timed", 3, 2)), (self.event(names), self.user(names)), (self.event(names), self.event(names)),
                                (("any_of", (self.event(names), self.timed())), ("timeout", 2))])
            return ("all_of", parts)
        return self.user(names)

    def wake(self):
        """What all_of or coordinated stands on must be able to fire, or the strategy never does: nothing asleep feeds it."""
        needy = [node for node in self.nodes if self.mentions(node.strategy, ("all_of", "coordinated"))]
        feeding = set(map(id, needy))
        grown = True
        while grown:
            grown = False
            for wire in self.wires:
                if id(wire.reader) in feeding and id(wire.writer) not in feeding:
                    feeding.add(id(wire.writer))
                    grown = True
        for node in self.nodes:
            if id(node) in feeding and node.strategy == ("inactive",):
                node.strategy = ("timed", 2, 0)

    def mentions(self, strategy, words):
        return strategy[0] in words or any(isinstance(part, tuple) and part and isinstance(part[0], tuple)
                                           and any(self.mentions(one, words) for one in part) for part in strategy[1:])

    # ---- observation: readers of other nodes' outputs, and of whole scopes ----

    def make_watchers(self):
        mode = self.seed % 3
        if mode == 2:
            return  # nobody looks: samples that nobody keeps
        outputs = [(node, port) for node in self.nodes for function, port in node.outputs() if function != "act"]
        if mode == 1:
            outputs = [one for one in outputs if self.chance(35)]
        for first in range(0, min(len(outputs), 24), 6):
            watcher = Node(f"w{first // 6}", 100 + first)
            watcher.strategy = self.rng.choice([("full_speed",), ("full_speed",), ("timed", 1, 0)])
            self.place_somewhere(watcher)
            for i, (node, out) in enumerate(outputs[first:first + 6]):
                port = Port(f"x{i}", "in", out.space)
                watcher.ports["process"][0].append(port)
                self.wires.append(Wire(node, out, watcher, port, self.over(node, watcher, ("latest",))))
            self.nodes.insert(self.rng.randrange(len(self.nodes) + 1), watcher)

    # ---- rates, only where the Rules let them ----

    def clock(self, node, seen=()):
        """(period, phase) in beats where it is beyond doubt, None elsewhere."""
        strategy = node.strategy
        if strategy[0] == "timed":
            return strategy[1], strategy[2] % strategy[1]
        if strategy[0] == "full_speed" or (strategy[0] == "default" and (node.resource or not node.inputs())):
            return 1, 0
        if strategy[0] in ("default", "restless", "moderate") and node not in seen:
            wires = self.wires_to(node)
            if any(wire.policy != ("latest",) or wire.out.kind == "maybe" for wire in wires):
                return None
            clocks = {self.clock(wire.writer, seen + (node,)) for wire in wires}
            return clocks.pop() if len(clocks) == 1 else None
        return None

    def make_rates(self):
        rng = self.rng
        self.states_rate = True
        for node in self.nodes:
            for function, port in node.outputs():
                n = self.clock(node)
                if node.strategy[0] in ("timed", "full_speed", "default") and n and port.kind == "out" and self.base % n[0] == 0 and self.chance(35):
                    port.rate = self.base // n[0]
                    if port.rate == self.base and function != "act":
                        self.states_rate = self.states_rate and self.chance(50)
        for wire in self.wires:
            if wire.out.rate:
                wire.into.rate = wire.out.rate if self.chance(50) else None
            elif self.base % 2 == 0 and self.chance(6):
                wire.into.rate = self.base // 2  # of two rates only one is stated: it doesn't count
            wire.into.alias = self.chance(25)
        self.count("rated ports", sum(port.rate is not None for node in self.nodes for _, port in node.inputs() + node.outputs()))
        self.count("rate from the spaces", not self.states_rate)

    # ---- policies that may be left out, and queues that may be full ----

    def make_policies(self):
        for wire in self.wires:
            a, b = self.clock(wire.writer), self.clock(wire.reader)
            unknown = wire.out.kind == "maybe" or wire.writer.strategy[0] == "user" or wire.reader.strategy[0] == "user"
            if wire.policy == ("latest",) and (unknown or (a is not None and a == b)) and self.chance(60):
                wire.stated = False
                self.count("policies left out")
            if wire.policy[0] == "queue" and wire.policy[2] == "reject":
                dynamic = wire.out.kind == "maybe" or "user" in (wire.writer.strategy[0], wire.reader.strategy[0])
                proven = self.exact(wire.writer) and self.exact(wire.reader) and b[0] <= a[0]
                if proven:
                    wire.policy = ("queue", max(2, wire.policy[1]), "reject")
                elif not dynamic:
                    wire.policy = wire.policy[:2] + (self.rng.choice(["drop_oldest", "drop_newest"]),)
            if self.chance(20):
                wire.initial = [self.rng.randrange(-32, 33) / 8 for _ in range(DIMENSIONS[wire.out.space])]
                if self.chance(30):
                    wire.initial = wire.initial[:1] * len(wire.initial)

    def exact(self, node):
        return node.strategy[0] in ("timed", "full_speed") or (node.strategy[0] == "default" and (node.resource or not node.inputs()))

    def make_habits(self):
        for node in self.nodes:
            if any(port.kind == "maybe" for _, port in node.outputs()):
                node.publishes = self.rng.choice([10, 30, 60, 60, 90])
            if node.outputs() and self.chance(12) and not node.root:
                node.origin = self.rng.choice([1, 2])
            if self.chance(2):
                node.fault_at = self.rng.choice([0, 3, 60, 140, 180])
                node.fault_function = self.rng.choice(node.functions)
                node.fault_first = self.chance(30)
            elif self.chance(3):
                node.fault_function = self.rng.choice(node.functions)  # it may, but never does

    # ---- queues that are delayed, several wires at one input, strategies that look at queues ----

    def make_buffers(self):
        """Its own dice: the rest of an architecture does not depend on it."""
        rng = random.Random(f"{self.seed} buffers")
        for wire in list(self.wires):
            kind = wire.policy[0]
            if kind == "delayed" and rng.randrange(100) < 35:
                wire.policy += ("queue", rng.choice([1, 2, 3, 5, 8, 20]), self.when_full(rng, wire))
            elif kind == "queue" and rng.randrange(100) < 25:
                wire.policy = ("delayed", rng.choice([1, 2, 3, 6])) + wire.policy
            if "queue" in wire.policy and rng.randrange(100) < 40:
                self.merge(rng, wire)
        for node in self.nodes:
            self.look_at_queues(rng, node)
        self.queue_freely()

    def when_full(self, rng, *wires):
        """`reject` only where no clock proves that the queue overflows."""
        known = any(wire.out.kind != "maybe" and wire.writer.strategy[0] != "user" for wire in wires)
        return rng.choice(["drop_oldest", "drop_oldest", "drop_newest", "drop_newest"] + ([] if known else ["reject"]))

    def merge(self, rng, wire):
        """Further writers at the end of a wire that has a queue."""
        reader, into = wire.reader, wire.into
        at = wire.policy.index("queue")
        others = []
        for _ in range(rng.choice([1, 1, 2, 3])):
            fitting = [(node, port) for node in self.nodes if not node.skeleton and not node.hears for _, port in node.outputs()
                       if port.space == wire.out.space and not (port.rate and into.rate and port.rate != into.rate)]
            if not fitting:
                break
            writer, out = rng.choice(fitting)
            delay = () if self.may_be_undelayed(writer, out, reader, into) and rng.randrange(100) < 60 else ("delayed", rng.choice([1, 1, 2, 3, 6]))
            if all((one.out, one.policy[:one.policy.index("merged")]) != (out, delay) for one in others) and (out, delay) != (wire.out, wire.policy[:at]):
                others.append(Wire(writer, out, reader, into, delay + ("merged",)))
        full = self.when_full(rng, wire, *others)
        queue = ("merged", wire.policy[at + 1], full)
        wire.policy = wire.policy[:at] + queue
        for one in others:
            one.policy = one.policy[:-1] + queue
            if wire.initial and rng.randrange(100) < 30:
                one.initial = wire.initial
            self.wires.insert(rng.randrange(len(self.wires) + 1), one)
        if rng.randrange(2) and others:  # whichever wire states it
            others[0].initial, wire.initial = wire.initial, others[0].initial

    def may_be_undelayed(self, writer, out, reader, into):
        """A wire without delay leads forwards in a beat."""
        if writer.environment != reader.environment:
            return False
        from_sense = any(port is out for port in writer.ports["sense"][1])
        if any(port is into for port in reader.ports["process"][0]):
            if from_sense:
                return True
            place = {id(node): i for i, node in enumerate(self.components)}
            return any(port is out for port in writer.ports["process"][1]) and place.get(id(writer), 99) < place.get(id(reader), -1)
        return any(port is into for port in reader.ports["act"][0]) and not any(port is out for port in writer.ports["act"][1])

    def look_at_queues(self, rng, node):
        """Some strategies ask how many samples wait, or count those that arrive."""
        names = sorted({wire.into.name for wire in self.wires_to(node)})
        merged = sorted({wire.into.name for wire in self.wires_to(node) if "merged" in wire.policy})
        inner = node.strategy[1] if node.strategy[0] == "stoppable" else node.strategy
        if node.resource or node.root or node.skeleton or not names or inner[0] not in ("user", "any_of", "restless", "moderate", "default") or rng.randrange(100) >= (75 if merged else 40):
            return
        if any(port.rate for _, port in node.outputs()) or any("reject" in wire.policy for wire in self.wires_to(node)):
            return
        name = rng.choice(merged or names)
        own = ("user", "every_nth", name, rng.choice([1, 2, 3, 4]), 0) if rng.randrange(3) else ("user", "while_waiting", name, rng.choice([1, 2, 3]), 0)
        if inner[0] != "user" and rng.randrange(100) < 60:
            beside = self.timed_by(rng) if inner[0] == "default" or rng.randrange(2) else inner
            own = (rng.choice(["any_of", "any_of", "all_of"]), rng.choice([(own, beside), (beside, own), (beside, own)]))
        node.strategy = ("stoppable", own) if node.strategy[0] == "stoppable" else own
        for wire in self.wires_to(node):
            if wire.policy == ("latest",):
                wire.stated = True  # the clock that it was left out for is no longer known, or was not

    def timed_by(self, rng):
        n = rng.choice([2, 3, 5])
        return ("timed", n, rng.randrange(n))

    # ---- nesting ----

    def nest(self):
        rng = self.rng
        grouped = [node for group in self.groups for node in group.nodes]
        order = [node for node in self.nodes if node not in grouped] + self.groups
        rng.shuffle(order)
        self.types = []
        self.where = {}  # node -> the graphs around it, outermost first, with their names in them
        self.top = self.make_graph(order, 0, [])
        for wire in self.wires:
            self.place(wire)
        if self.states_rate:
            self.top.rate = self.base
        for inner in self.types:
            if inner is not self.top and self.states_rate and self.chance(15):
                inner.rate = self.base
        self.use_twice()
        self.add_observers(self.top, 0)
        self.let_parts_rest()
        add_looks(self)

    def let_parts_rest(self):
        """Some inner graphs can be stopped as a whole, and some components stop and start parts by their results."""
        rng = random.Random(f"{self.seed} parts")
        if self.threads:
            return
        for graph in self.types:
            for name, child in graph.children:
                if isinstance(child, Graph) and rng.randrange(100) < 45 and not any(
                        node.resource or node.skeleton for node in self.nodes_of(child)):
                    graph.stoppable.add(name)
                    self.count("inner graphs that may be stopped")
                    self.count("inner graphs that may be stopped, partly in a free-running environment",
                               any(node.environment == self.free for node in self.nodes_of(child)))
        for graph in self.types:
            paths = ["/" + path for path, _ in self.parts()] + sorted(graph.stoppable)
            for _, node in graph.children:
                if isinstance(node, Node) and not node.resource and not node.skeleton and not node.hears and paths and rng.randrange(100) < 12:
                    for path in rng.sample(paths, min(len(paths), rng.choice([1, 1, 2]))):
                        node.asks += [(path, kind) for kind in rng.choice([("stops", "starts"), ("starts", "stops"), ("stops", "starts")])]
                    self.count("components that ask for parts")

    def parts(self):
        """The paths of all parts, each with the beats before which somebody stops it and starts it again, or None."""
        found = []

        def walk(graph, path):
            for name, child in graph.children:
                if isinstance(child, Node):
                    if child.strategy[0] == "stoppable":
                        spread = self.environments > 1
                        found.append((path + name, rests_of_spread(self, path + name, {child.environment}) if spread else child.rests))
                    continue
                if name in graph.stoppable:
                    rng = random.Random(f"{self.seed} {path}{name} rests")
                    first = rng.randrange(1, 80)
                    rests = (first, first + rng.randrange(1, 50)) if self.environments == 1 and rng.randrange(100) < 70 else None
                    if self.environments > 1:
                        rests = rests_of_spread(self, path + name, {node.environment for node in self.nodes_of(child)})
                    found.append((path + name, rests))
                walk(child, path + name + ".")

        walk(self.top, "")
        return found

    def make_graph(self, order, depth, around):
        graph = Graph("top" if depth == 0 else f"g{len(self.types)}")
        self.types.append(graph)
        i = 0
        while i < len(order):
            take = self.rng.randrange(1, max(2, len(order) // (depth + 1)) + 1) if depth < 3 and self.chance(30 if depth == 0 else 25) else 0
            if take and (depth or take < len(order)):
                name = f"s{len(self.types)}"
                graph.children.append((name, self.make_graph(order[i:i + take], depth + 1, around + [(graph, name)])))
                i += take
            elif isinstance(order[i], Group):
                inner, name = Graph(""), f"z{len(self.where)}"
                inner.group = order[i]
                graph.children.append((name, inner))
                for node in inner.group.nodes:
                    inner.children.append((node.name, node))
                    self.where[node] = around + [(graph, name), (inner, node.name)]
                i += 1
            else:
                graph.children.append((order[i].name, order[i]))
                self.where[order[i]] = around + [(graph, order[i].name)]
                i += 1
        return graph

    def place(self, wire):
        """Into the innermost graph that holds both ends, which the graphs between expose."""
        a, b = self.where[wire.writer], self.where[wire.reader]
        shared = 0
        while shared + 1 < min(len(a), len(b)) and a[shared + 1][0] is b[shared + 1][0]:
            shared += 1
        ends = []
        for path, port in ((a, wire.out.name), (b, wire.into.name)):
            name = f"{path[-1][1]}.{port}"
            for graph, _ in reversed(path[shared + 1:]):
                outer = graph.expose(name)
                name = f"{path[[g for g, _ in path].index(graph) - 1][1]}.{outer}"
                self.count("exposes")
            ends.append(name)
        a[shared][0].wires.append((ends[0], ends[1], wire))

    def use_twice(self):
        """The same graph type as another node, fed by the same writers."""
        for name, child in list(self.top.children):
            if isinstance(child, Graph) and self.chance(30) and len(self.nodes_of(child)) < 9:
                twin = name + "b"
                at = self.rng.randrange(len(self.top.children) + 1)
                self.top.children.insert(at, (twin, child))
                for a, b, wire in list(self.top.wires):
                    if b.startswith(name + "."):
                        self.top.wires.append((a, twin + b[len(name):], wire))
                self.count("graphs used twice")

    def nodes_of(self, graph):
        found = []
        for _, child in graph.children:
            found += self.nodes_of(child) if isinstance(child, Graph) else [child]
        return found

    def add_observers(self, graph, depth):
        for _, child in list(graph.children):
            if isinstance(child, Graph) and depth < 3 and not child.group:
                self.add_observers(child, depth + 1)
        if not self.chance(18) or any(name.startswith("o") for name, _ in graph.children):
            return
        scopes = Scopes(self.top)
        places = scopes.places[id(graph)]
        observer = Node("o", 200 + depth)
        self.place_somewhere(observer)
        for _ in range(30):
            pattern = self.pattern(scopes, places[0])
            policy = self.rng.choice([("latest",), ("latest",), ("latest",), ("delayed", 1), ("delayed", 3)])
            if self.chance(20):
                queue = ("queue", self.rng.choice([1, 2, 4]), self.rng.choice(["drop_oldest", "drop_newest"]))
                policy = queue if policy[0] == "latest" else policy + queue
            found = [scopes.named(pattern, place) for place in places]
            if not all(one and may_hear(one, policy, observer.environment) for one in found):
                continue
            observer.hears, observer.hears_policy = pattern, policy
            observer.strategy = self.rng.choice([("full_speed",), self.timed(), ("restless",)])
            graph.children.insert(self.rng.randrange(len(graph.children) + 1), ("o", observer))
            self.count_observer(observer, found, places)
            return

    def pattern(self, scopes, place, rng=None):
        """A path of some output, or of an input with a queue, seen from a graph around, with some of its names left open."""
        rng = rng or self.rng
        queued = [path for path, wires in scopes.inputs.items() if is_queued(wires[0])]
        of_input = bool(queued) and rng.randrange(100) < 30
        path = rng.choice(queued) if of_input else rng.choice(scopes.outputs)[0]
        around = [n for n in range(len(place) + 1) if place[:n] == path[:n] and n < len(path) - 1]
        names = list(path[rng.choice(around):])
        absolute = len(names) == len(path) and rng.randrange(100) < 40
        for i in range(len(names)):
            if rng.randrange(100) < 30:
                names[i] = "*"
        if rng.randrange(100) < 50:
            first = rng.randrange(len(names))
            last = rng.randrange(first, len(names)) + 1
            names[first:last] = ["**"]
        if rng.randrange(100) < 25:
            names[rng.randrange(1, len(names) + 1):] = ["**"]
        elif of_input:  # only a `**` at the end names inputs
            names[-1] = "**"
        return ("/" if absolute else "") + ".".join(names)

    def count_observer(self, observer, found, places):
        self.count("observers")
        for feature, is_so in (
                ("observers that hear inputs", any(len(one) == 2 for some in found for one in some)),
                ("observers with a queue", "queue" in observer.hears_policy),
                ("patterns from the outermost graph", observer.hears[0] == "/"),
                ("patterns found in a graph around", observer.hears[0] != "/" and any(
                    one[0][:len(place)] != place for some, place in zip(found, places) for one in some)),
                ("patterns with **", "**" in observer.hears),
                ("observers across environments", any(
                    node.environment != observer.environment
                    for some in found for one in some
                    for node in ([one[1]] if len(one) == 3 else [wire.writer for wire in one[1]])))):
            if is_so:
                self.count(feature)
