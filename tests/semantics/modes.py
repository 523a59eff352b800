"""A random set of modes: variants of one architecture, in one loop or spread over environments.

All nodes and the nested form are made once. Each mode lacks some components, and has other wires, policies, strategies and initial
values. A component that is not the same in all modes is `unsteady`: what it did before a switch matters. Its strategy is one for
which docs/modes.md says beyond doubt when it fires.
"""
import copy
import random

from architecture import DIMENSIONS, Architecture, Graph, Node, Wire
from outside import BEATS, add_look, may_be_seen
from scopes import Scopes, is_queued, may_hear

NAMES = ("a", "b", "c")


class Base(Architecture):
    """What all modes have, flat, and the nested form."""

    most_nodes = 9

    def __init__(self, seed, is_spread, over_dds):
        self.seed, self.threads, self.free, self.looks, self.features = seed, False, None, [], {}
        self.environments = 2 + seed % 2 if is_spread else 1
        self.in_processes = is_spread and (over_dds or seed % 4 == 1)
        self.rng = random.Random(seed)
        self.base = self.rng.choice([1000, 300, 12])
        self.period, self.states_rate = 1000000000 // self.base, True
        self.make_nodes()
        self.make_wires()
        self.make_strategies()
        if self.chance(50):
            self.make_watchers()
        self.make_habits()
        self.make_buffers()
        for wire in self.wires:
            wire.stated = True
            wire.policy = tuple("drop_oldest" if word == "reject" else word for word in wire.policy)
            if "merged" not in wire.policy and self.chance(20):
                wire.initial = self.initial(wire)
        self.types, self.where, self.groups = [], {}, []
        order = list(self.nodes)
        self.rng.shuffle(order)
        self.top = self.make_graph(order, 0, [])

    def run_freely(self):
        pass

    def initial(self, wire):
        return [self.rng.randrange(-32, 33) / 8 for _ in range(DIMENSIONS[wire.out.space])]


class Mode(Architecture):
    """One of the modes, as an architecture of its own."""

    def __init__(self, base, name):
        self.seed, self.name, self.base_of, self.rng = base.seed, name, base, base.rng
        self.environments, self.in_processes, self.period, self.free = base.environments, base.in_processes, base.period, None
        self.components, self.features, self.looks = base.components, {}, []
        self.present, self.wires, self.types, self.where, self.groups = [], [], [], {}, []

    # ---- components and wires ----

    def choose(self, dropped):
        """False: an input can't be wired without a component that is lacking; then that one comes back."""
        base, rng = self.base_of, self.rng
        self.present = [node for node in base.nodes if node not in dropped]
        self.wires = []
        for node in self.present:
            for _, into in node.inputs():
                wires = [wire for wire in base.wires if wire.into is into]
                if not self.wire(node, into, wires, dropped):
                    for wire in wires:
                        dropped.discard(wire.writer)
                    return False
        return True

    def wire(self, node, into, wires, dropped):
        rng = self.rng
        lacking = any(wire.writer in dropped for wire in wires)
        if not wires:  # an optional one that is not wired may be wired here
            return not (rng.randrange(100) < 30 and self.rewire(node, into)) or True
        if not lacking and (self.name == "a" or rng.randrange(100) < 75):
            self.wires += [copy.copy(wire) for wire in wires]
            return True
        if into.kind == "optional_in" and rng.randrange(2):
            return True
        if not lacking and len(wires) == 1 and rng.randrange(2):
            return self.add(wires[0].writer, wires[0].out, node, into)
        return self.rewire(node, into)

    def rewire(self, node, into):
        fitting = [(writer, out) for writer in self.present if not writer.hears for _, out in writer.outputs() if out.space == into.space]
        if not fitting:
            return False
        return self.add(*self.rng.choice(fitting), node, into)

    def add(self, writer, out, reader, into):
        rng = self.rng
        policy = () if self.may_be_undelayed(writer, out, reader, into) and rng.randrange(100) < 60 else ("delayed", rng.choice([1, 1, 2, 3, 6]))
        if rng.randrange(100) < 35:
            policy += ("queue", rng.choice([1, 2, 4, 8]), rng.choice(["drop_oldest", "drop_newest"]))
        wire = Wire(writer, out, reader, into, policy or ("latest",))
        if rng.randrange(100) < 20:
            wire.initial = self.base_of.initial(wire)
        self.wires.append(wire)
        return True

    # ---- nested ----

    def nest(self, strategies):
        """The nested form of all, without what this mode lacks. Nodes are copies, for their strategies."""
        self.copies = {}
        for node in self.present:
            own = self.copies[node] = copy.copy(node)
            own.strategy = strategies[node]
        self.nodes = list(self.copies.values())
        self.top = self.clone(self.base_of.top, [])
        for wire in self.wires:
            wire.writer, wire.reader = self.copies[wire.writer], self.copies[wire.reader]
            self.place(wire)
        self.top.rate = self.base_of.base

    def clone(self, graph, around):
        own = Graph(f"{self.name}_{graph.name}")
        own.cloned = graph
        self.types.append(own)
        for name, child in graph.children:
            if isinstance(child, Graph):
                if any(node in self.copies for node in self.base_of.nodes_of(child)):
                    own.children.append((name, self.clone(child, around + [(own, name)])))
                    if name in graph.stoppable:
                        own.stoppable.add(name)
            elif child in self.copies:
                own.children.append((name, self.copies[child]))
                self.where[self.copies[child]] = around + [(own, name)]
        return own

    def parts(self):
        return [(path, self.base_of.rests.get(path)) for path, _ in Architecture.parts(self)]


def key(wire):
    return wire.writer.name, wire.out.name, wire.into.name, wire.policy, tuple(wire.initial or ())


class SetOfModes:
    """Its modes, and what somebody outside does: `switches` are (beat, name)."""

    def __init__(self, seed, is_spread=False, over_dds=False):
        self.base = base = Base(seed, is_spread, over_dds)
        self.seed, self.rng, self.environments, self.in_processes, self.period = seed, base.rng, base.environments, base.in_processes, base.period
        self.features, self.looks = base.features, []
        self.modes = [Mode(base, name) for name in NAMES[:2 if self.rng.randrange(100) < 80 else 3]]
        self.choose_nodes()
        self.find_steady()
        self.choose_strategies()
        self.choose_parts()
        for mode in self.modes:
            mode.nest({node: self.strategies[mode.name, node] for node in mode.present})
        self.let_switch()
        self.add_observers()
        self.add_looks()
        self.count("sets of modes")

    def count(self, feature, by=1):
        self.features[feature] = self.features.get(feature, 0) + by

    def choose_nodes(self):
        rng = self.rng
        for mode in self.modes:
            dropped = {node for node in self.base.components if rng.randrange(100) < 22}
            while not mode.choose(dropped):
                pass
            self.count("components that a mode lacks", len(dropped))
        self.forget({node for node in self.base.components if all(node not in mode.present for mode in self.modes)})

    def forget(self, nodes):
        """What no mode has: no environment may name it."""
        def prune(graph):
            for _, child in graph.children:
                if isinstance(child, Graph):
                    prune(child)
            graph.children = [(name, child) for name, child in graph.children if child not in nodes and not (isinstance(child, Graph) and not child.children)]

        if nodes:
            prune(self.base.top)
            self.base.nodes = [node for node in self.base.nodes if node not in nodes]

    # ---- which components are the same in all modes ----

    def find_steady(self):
        self.other_devices = {}
        for node in self.base.nodes:
            if node.resource and self.rng.randrange(100) < 25:
                self.other_devices[node] = [self.base.timed() for _ in self.modes]
        steady = {node for node in self.base.nodes if all(node in mode.present for mode in self.modes) and node not in self.other_devices}
        for node in list(steady):
            if len({tuple(sorted(map(key, mode.wires_to(node)))) for mode in self.modes}) > 1:
                steady.discard(node)
        for grown in iter(lambda: [node for node in steady if any(wire.writer not in steady for wire in self.modes[0].wires_to(node))], []):
            steady.difference_update(grown)
        self.steady = steady
        self.count("components that are the same in all modes", len(steady))

    # ---- strategies ----

    def choose_strategies(self):
        rng = self.rng
        self.strategies = {}
        for node in self.base.nodes:
            having = [mode for mode in self.modes if node in mode.present]
            inner = node.strategy[1] if node.strategy[0] == "stoppable" else node.strategy
            last = None
            for number, mode in enumerate(having):
                if node in self.steady:
                    chosen = inner
                elif node.resource:
                    chosen = self.other_devices.get(node, [inner] * 3)[number]
                elif last and rng.randrange(2) and self.is_sound(mode, node, last):
                    chosen = last
                else:
                    chosen = self.strategy(mode, node)
                if node.strategy[0] == "stoppable" and chosen == ("default",):
                    chosen = ("restless",) if mode.wires_to(node) else ("timed", 1, 0)
                last = chosen
                self.strategies[mode.name, node] = ("stoppable", chosen) if node.strategy[0] == "stoppable" else chosen

    def strategy(self, mode, node):
        rng, base = self.rng, self.base
        wires = mode.wires_to(node)
        names = sorted({wire.into.name for wire in wires})
        while True:
            roll = rng.randrange(100)
            if roll < 25:
                chosen = base.timed()
            elif roll < 32:
                chosen = ("full_speed",)
            elif roll < 38 or not names:
                chosen = base.user(names) if rng.randrange(2) else base.timed()
            elif roll < 48:
                chosen = base.user(names)
            elif roll < 60:
                chosen = ("any_of", rng.choice([(base.user(names), base.timed()), (base.user(names), base.event(names)), (base.event(names), base.user(names))]))
            elif roll < 66:
                chosen = ("any_of", (base.user(names), ("timeout", rng.randrange(2, 8))))
            elif roll < 70:
                chosen = ("all_of", (base.user(names), base.event(names)))
            else:
                chosen = rng.choice([("default",), base.event(names), base.event(names)])
            if self.is_sound(mode, node, chosen):
                return chosen

    def is_sound(self, mode, node, strategy):
        """The Rules allow it, and nothing depends on which clocks a compiler knows."""
        wires = mode.wires_to(node)
        names = {wire.into.name for wire in wires}
        kind = strategy[0]
        if kind in ("any_of", "all_of"):  # a user's among them: it is asked in each beat, whatever is known of the others
            parts = strategy[1]
            looked = [name for part in parts for name in (part[1] if part[0] == "port_triggered" else part[2:3] if part[0] == "user" else ())]
            return any(part[0] == "user" for part in parts) and set(looked) <= names | {"-"} and (
                bool(names) or all(part[0] in ("user", "timed", "timeout") for part in parts))
        if kind == "user":
            return strategy[2] == "-" or strategy[2] in names
        if kind == "default" and not node.inputs():
            return True
        if kind in ("timed", "full_speed"):
            return True
        if kind not in ("default", "restless", "moderate", "port_triggered") or not names:
            return False
        looked = [wire for wire in wires if kind != "port_triggered" or wire.into.name in strategy[1]]
        if kind == "port_triggered" and not set(strategy[1]) <= names:
            return False
        unknown = all(wire.out.kind == "maybe" or self.is_unknown(mode, wire.writer) for wire in looked)
        return unknown or (len(looked) == 1 and "queue" not in looked[0].policy)

    def is_unknown(self, mode, node):
        """Its clock, whatever a compiler can find out: its strategy is in every beat that of a user."""
        strategy = self.strategies.get((mode.name, node), ("timed",))
        inner = strategy[1] if strategy[0] == "stoppable" else strategy
        return inner[0] == "user"

    # ---- parts, and who asks for them and for modes ----

    def choose_parts(self):
        rng, base = self.rng, self.base
        base.rests = {}
        everywhere = [node for node in base.nodes if all(node in mode.present for mode in self.modes)]
        paths = []

        def walk(graph, path):
            for name, child in graph.children:
                inside = [child] if isinstance(child, Node) else base.nodes_of(child)
                if isinstance(child, Graph) and rng.randrange(100) < 35 and not any(node.resource for node in inside):
                    graph.stoppable.add(name)
                    self.count("inner graphs of modes that may be stopped")
                is_part = name in graph.stoppable or (isinstance(child, Node) and child.strategy[0] == "stoppable")
                if is_part and any(node in everywhere for node in inside):
                    paths.append(path + name)
                    places = {node.environment for node in inside}
                    if rng.randrange(100) < 60 and not (self.in_processes and len(places) > 1):
                        first = rng.randrange(1, 90)
                        base.rests[path + name] = first, first + rng.randrange(1, 60)
                if isinstance(child, Graph):
                    walk(child, path + name + ".")

        walk(base.top, "")
        for node in base.components:
            if paths and not node.hears and rng.randrange(100) < 12:
                path = "/" + rng.choice(paths)
                node.asks += [(path, kind) for kind in rng.choice([("stops", "starts"), ("starts", "stops")])]
                self.count("components of modes that ask for parts")
        names = [mode.name for mode in self.modes]
        for node in rng.sample(base.components, min(len(base.components), rng.choice([0, 1, 1, 2]))):
            node.switches = rng.choice([names, names[::-1], [rng.choice(names)]])
            self.count("components that ask for modes")

    def let_switch(self):
        rng = self.rng
        self.switches, k = [], 0
        while True:
            k += rng.choice([1, 2, 3, 7, 13, 40])
            if k >= BEATS or len(self.switches) > 16:
                break
            if any(k in rests for rests in self.base.rests.values()):
                continue
            self.switches.append((k, rng.choice(self.modes).name))

    # ---- observers and looks ----

    def add_observers(self):
        rng = self.rng
        if rng.randrange(100) >= 40:
            return
        observer = Node("o", 200)
        observer.environment = rng.randrange(self.environments)
        scopes = {mode.name: Scopes(mode.top) for mode in self.modes}
        for _ in range(30):
            first = rng.choice(self.modes)
            pattern = self.base.pattern(scopes[first.name], (), rng)
            policy = rng.choice([("latest",), ("latest",), ("delayed", 1), ("delayed", 3)])
            if rng.randrange(100) < 25:
                queue = ("queue", rng.choice([1, 2, 4]), rng.choice(["drop_oldest", "drop_newest"]))
                policy = queue if policy[0] == "latest" else policy + queue
            named = {mode.name: scopes[mode.name].named(pattern, ()) for mode in self.modes}
            if any(is_queued(wire) for found in named.values() for port in found or [] if len(port) == 2 for wire in port[1]):
                continue  # what waits in a queue that other modes lack
            having = [mode for mode in self.modes if named[mode.name] and may_hear(named[mode.name], policy, observer.environment)]
            if first not in having:
                continue
            observer.hears, observer.hears_policy = pattern, policy
            at = rng.randrange(len(self.base.top.children) + 1)
            for mode in having:
                own = copy.copy(observer)
                own.strategy = rng.choice([("full_speed",), self.base.timed(), ("restless",)])
                mode.top.children.insert(min(at, len(mode.top.children)), ("o", own))
                mode.nodes.append(own)
            self.base.top.children.append(("o", observer))
            self.base.nodes.append(observer)
            self.count("observers in modes")
            return

    def add_looks(self):
        rng = self.rng
        if rng.randrange(100) >= 50:
            return
        for mode in self.modes:
            scopes = Scopes(mode.top)
            add_look(mode, rng, scopes, mode.top)
            for other in self.modes:
                for pattern, policy in mode.top.observes if other is not mode else []:
                    found = Scopes(other.top).named(pattern, ())
                    if found and may_be_seen(found, policy) and (pattern, policy) not in other.top.observes and rng.randrange(100) < 70:
                        other.top.observes.append((pattern, policy))
        if all(not mode.top.observes for mode in self.modes):
            return
        n = rng.choice([3, 7, 20])
        self.looks = sorted(k for k in range(1, BEATS) if rng.randrange(n) == 0) or [BEATS // 2]
        self.count("modes that programs look at")
