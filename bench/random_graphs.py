#!/usr/bin/env python3
"""Random graphs that nobody tuned, each from its seed, and the same arithmetic by hand: one function that copies no sample.

    random_graphs.py 17    the benchmark program of seed 17 (program.hpp says how to run it)

`measure.py --only random` counts the instructions of both forms.

A graph has 14 to 26 nodes and a robot, on samples of eight axes and of one.
Components fill their output in place, return their state or Eigen expressions, call static functions and keep arrays.
Wires are immediate, delayed or latest; some outputs have several readers, some wires close a loop, some nodes are slower.
By hand, a result is read where it was computed: a variable of the function, or the state from which the component returns it.
Only what is read one or more beats later is stored, as late as possible.
"""
import argparse
import random
import re

# A kind of component: its inputs and its output (v: eight axes, s: one), what it keeps, a static function that it calls, what it computes.
# `$x` and `$z` are inputs, `$y` is the output filled in place, `$NAME` is what it keeps. `return` says what it returns otherwise.
# 0.# is a constant of its own. EACH is the loop over the axes.
KINDS = {
    "filter_filled": ("v", "v", {"state": "vector8"}, "", "EACH { $state[i] += 0.# * ($x[i] - $state[i]); $y[i] = $state[i]; }"),
    "filter_state": ("v", "v", {"state": "vector8"}, "", "EACH $state[i] += 0.# * ($x[i] - $state[i]); return $state"),
    "filter_eigen": ("v", "v", {"state": "vector8"}, "", "$state += 0.# * ($x - $state); return $state"),
    "second_order": ("v", "v", {"s1": "vector8", "s2": "vector8"}, "", """EACH {
      const double now = 0.067 * $x[i] + $s1[i];
      $s1[i] = 0.135 * $x[i] + 1.143 * now + $s2[i];
      $s2[i] = 0.067 * $x[i] - 0.413 * now;
      $y[i] = 0.# * now;
    }"""),
    "second_order_eigen": ("v", "v", {"s1": "vector8", "s2": "vector8", "out": "vector8"}, "", """$out = 0.067 * $x + $s1;
    $s1 = 0.135 * $x + 1.143 * $out + $s2;
    $s2 = 0.067 * $x - 0.413 * $out;
    return $out"""),
    "spring": ("v", "v", {}, "", "EACH { const double e = $x[i]; $y[i] = e * (0.# + 0.# * e * e) / (1 + e * e); }"),
    "spring_eigen": ("v", "v", {}, "", "return ($x.array() * (0.# + 0.# * $x.array().square()) / (1 + $x.array().square())).matrix()"),
    "damper_eigen": ("v", "v", {}, "", "return ($x.array() * 0.# / (1 + 0.# * $x.array().abs())).matrix()"),
    "weighed": ("vv", "v", {}, "", "EACH $y[i] = 0.# * $x[i] - (1 - 0.#) * $z[i];"),
    "weighed_eigen": ("vv", "v", {}, "", "return 0.5 * $x + 0.5 * $z"),
    "difference_eigen": ("vv", "v", {}, "", "return 0.# * ($x - $z)"),
    "least": ("vv", "v", {}, "", "EACH $y[i] = std::min(std::max($x[i], -0.#), 0.# + std::abs($z[i]));"),
    "product_eigen": ("vv", "v", {}, "", "return ($x.array() * $z.array() / (1 + $z.array().square())).matrix()"),
    "change": ("v", "v", {"last": "vector8", "state": "vector8"}, "", """EACH {
      $state[i] += 0.# * (0.5 * ($x[i] - $last[i]) - $state[i]);
      $last[i] = $x[i];
      $y[i] = $state[i] + 0.25 * $x[i];
    }"""),
    "integral_eigen": ("v", "v", {"state": "vector8"}, "", "$state = ($state + 0.01 * $x).cwiseMin(0.#).cwiseMax(-0.#); return $state"),
    "friction": ("v", "v", {}, """double $F(double v) {
  const double s = v / (0.1 + std::abs(v)), d = v * v;
  const double stiction = 0.# * s / (1 + 8 * d), viscous = 0.# * v;
  return v > 0 ? 0.5 * (stiction + viscous) : 0.4 * stiction + 0.5 * viscous;
}""", "EACH $y[i] = $F($x[i]);"),
    "shaped": ("v", "v", {}, """vector8 $F(const vector8& x) {
  vector8 y;
  EACH {
    const double a = x[i] / (1 + std::abs(x[i])), b = a * a;
    y[i] = a * (1 + b * (-0.# + b * (0.# - 0.01 * b))) + 0.05 * (x[i] > 0.2 ? 1 - b : b);
  }
  return y;
}""", "return $F($x)"),
    "observed": ("vv", "v", {"state": "vector8"}, """void $F(vector8& state, const vector8& x, const vector8& z) {
  EACH {
    const double e = x[i] - state[i], g = 0.# / (1 + e * e);
    state[i] += g * e + 0.01 * (z[i] - 0.5 * state[i]) / (1 + std::abs(z[i]));
  }
}""", "$F($state, $x, $z); return $state"),
    "average": ("v", "v", {"past": "std::array<vector8, 4>", "at": "std::uint32_t"}, "", """$past[$at] = $x;
    $at = ($at + 1) % 4;
    return 0.25 * ($past[0] + $past[1] + $past[2] + $past[3])"""),
    "taps": ("v", "v", {"last": "std::array<std::array<double, 8>, 3>"}, "", """for (std::size_t i = 0; i < 8; ++i) {
      $y[static_cast<int>(i)] = 0.4 * $x[static_cast<int>(i)] + 0.3 * $last[0][i] + 0.2 * $last[1][i] + 0.1 * $last[2][i];
      $last[2][i] = $last[1][i];
      $last[1][i] = $last[0][i];
      $last[0][i] = $x[static_cast<int>(i)];
    }"""),
    "table": ("v", "v", {"state": "std::array<double, 8>"}, "", """for (std::size_t i = 0; i < 8; ++i)
      $state[i] = 0.# * $state[i] + (1 - 0.#) * $x[static_cast<int>(i)];
    EACH $y[i] = $state[static_cast<std::size_t>((i + 3) % 8)];"""),
    "axis": ("v", "s", {"state": "double"}, "", "$state += 0.# * ($x[AXIS] - $state); return $state + 0.1 * $x[OTHER]"),
    "length": ("v", "s", {}, "", "return 0.3 * $x.squaredNorm()"),
    "largest": ("v", "s", {}, "", "double most = 0; EACH most = std::max(most, std::abs($x[i])); return 0.# * most"),
    "scaled": ("vs", "v", {}, "", "EACH $y[i] = 0.# * $x[i] / (1 + std::abs($z));"),
    "scaled_eigen": ("vs", "v", {}, "", "return $x / (1 + $z * $z)"),
    "smoothed": ("s", "s", {"state": "double"}, "", "$state += 0.# * ($x - $state); return $state"),
    "spread": ("s", "v", {"state": "vector8"}, "", "EACH $state[i] += 0.01 * (i + 1) * ($x - $state[i]); return $state"),
}
SOURCE = ("", "v", {"c": "vector8", "s": "vector8"}, "", """EACH {
      const double a = 0.99998 * $c[i] - 0.0063245 * $s[i], b = 0.0063245 * $c[i] + 0.99998 * $s[i];
      const double grow = 1.5 - 0.5 * (a * a + b * b);
      $c[i] = a * grow;
      $s[i] = b * grow;
      $y[i] = 0.2 + 0.4 * $s[i];
    }""")
LAST = ("v", "v", {}, "", "EACH $y[i] = 0.9 * $x[i] / (1 + std::abs($x[i]));")
INITIAL = {"vector8": "vector8::Zero()", "double": "0", "std::uint32_t": "0", "std::array<vector8, 4>": "zeros<4>()"}
FIRST = {"c": "vector8::LinSpaced(8, 0.1, 0.8)", "s": "vector8::Constant(0.6)"}  # of a source
EACH = "for (int i = 0; i < 8; ++i)"
ROBOT_STYLES = ("filled", "eigen")


class Component:
    """A type of component, with constants of its own."""

    def __init__(self, number, kind, rng):
        self.number, self.kind = number, kind
        self.inputs, self.output, self.kept, static, body = SOURCE if kind == "source" else LAST if kind == "last" else KINDS[kind]
        axis, other = rng.sample(range(8), 2)
        self.axes = {"AXIS": axis, "OTHER": other}

        def own(text):
            text = re.sub(r"0\.#", lambda _: f"0.{rng.randint(1, 6)}{rng.randint(1, 9)}", text)
            return text.replace("EACH", EACH)

        self.static, body = own(static), own(body)
        body, _, returned = body.rpartition("return ")
        self.body, self.returned = (body, returned) if "$y" not in returned else (returned, "")
        self.is_member = rng.random() < 0.4  # the static function: of the class, or of the file
        # By hand, what is computed: a copy of the state is the state.
        copied = " $y[i] = $state[i]; }"
        self.by_hand = (self.body.replace(copied, " }"), "$state") if self.body.endswith(copied) else (self.body, self.returned)
        self.keeps_result = re.fullmatch(r"\$(\w+)", self.by_hand[1]) is not None

    def first(self, name, kind):
        return FIRST[name] if self.kind == "source" else INITIAL.get(kind, "")

    def function(self):
        return f"function_{self.number}"


class Node:
    def __init__(self, name, component):
        self.name, self.component = name, component
        self.sources = []  # (node, policy): now, delay of so many beats, latest
        self.period = 1

    def output(self):
        return self.component.output if self.component else "v"


class Graph:
    def __init__(self, seed):
        self.rng = random.Random(seed)
        self.nodes = []
        while not 14 <= len(self.nodes) <= 26:
            self.make()

    def make(self):
        rng = self.rng
        self.components, self.nodes = [], []
        self.robot_style = rng.choice(ROBOT_STYLES)
        robot = Node("robot", None)
        self.readable = {"v": [robot], "s": []}  # what the next node can read now
        self.unread = [robot]
        count = rng.randint(14, 26)
        kinds = rng.sample(sorted(KINDS), rng.randint(8, 16))
        for _ in range(rng.randint(1, 2)):
            self.add(self.component("source"), [])
        waiting = []  # inputs that read a node that comes later, over a delay
        while len(self.nodes) + len(self.unread) // 2 < count:
            kind = rng.choice(kinds)
            if any(not self.readable[i] for i in KINDS[kind][0]):
                continue
            again = [c for c in self.components if c.kind == kind]
            component = rng.choice(again) if again and rng.random() < 0.3 else self.component(kind)
            sources = []
            for i in component.inputs:
                if rng.random() < 0.12 and sources:
                    sources.append(None)
                    continue
                fresh = [n for n in self.unread if n in self.readable[i]]
                source = rng.choice(fresh) if fresh and rng.random() < 0.7 else rng.choice(self.readable[i])
                sources.append((source, rng.randint(1, 3) if rng.random() < 0.15 else 0))
            node = self.add(component, sources)
            waiting += [(node, i) for i, s in enumerate(sources) if s is None]
            if rng.random() < 0.1:
                node.period = rng.choice((2, 5, 10))
        while len(self.unread) > 1:  # brought together for the command
            one, other = self.unread[:2]
            kind = "weighed" if rng.random() < 0.5 else "weighed_eigen"
            if one.output() == other.output() == "s":
                kind, chosen = "spread", [(one, 0)]
            elif "s" in (one.output(), other.output()):
                kind, chosen = "scaled", [(one, 0), (other, 0)] if one.output() == "v" else [(other, 0), (one, 0)]
            else:
                chosen = [(one, 0), (other, 0)]
            self.add(self.component(kind), chosen)
        self.add(self.component("last"), [(self.nodes[-1], 0)])
        for node, i in waiting:
            later = [n for n in self.nodes if n.component.output == node.component.inputs[i] and n.period == 1 and self.nodes.index(n) >= self.nodes.index(node)]
            node.sources[i] = (rng.choice(later), rng.randint(1, 3)) if later else (self.nodes[0] if node.component.inputs[i] == "v" else self.readable["s"][0], 1)
        for node in self.nodes:  # a slower end needs no delay
            node.sources = [(s, 0 if s.period > 1 or node.period > 1 and s is not node else d) for s, d in node.sources]

    def component(self, kind):
        self.components.append(Component(len(self.components), kind, self.rng))
        return self.components[-1]

    def add(self, component, sources):
        node = Node(f"n{len(self.nodes)}", component)
        node.sources = sources
        self.nodes.append(node)
        self.unread = [n for n in self.unread if n not in [s[0] for s in sources if s]] + [node]
        self.readable[component.output].append(node)
        return node


SPACE = {"v": "joints", "s": "level"}
TYPE = {"v": "vector8", "s": "double"}


def filled(text, names):
    return re.sub(r"\$(\w+)", lambda m: names[m[1]], text)


def static_function(component):
    return f"{'  ' if component.is_member else ''}static {filled(component.static, {'F': component.function()})}\n" if component.static else ""


def as_component(c):
    """The type of a component of the graph."""
    names = {"F": c.function(), "y": "y.vector()"} | {name: name for name in c.kept}
    parameters = []
    for port, kind in zip("xz", c.inputs):
        parameters.append(f'cca::in<"{port}", {SPACE[kind]}> {port}')
        names[port] = f"{port}.vector()" if kind == "v" else f"{port}[cca::x{{}}]"
    out = f'cca::out<"y", {SPACE[c.output]}>'
    text = filled(c.body, names)
    text = re.sub(r"x\.vector\(\)\[(AXIS|OTHER)\]", lambda m: f"x[q{c.axes[m[1]]}{{}}]", text)
    returned = re.sub(r"x\.vector\(\)\[(AXIS|OTHER)\]", lambda m: f"x[q{c.axes[m[1]]}{{}}]", filled(c.returned, names))
    kept = "".join(f"  {kind} {name}{{{c.first(name, kind)}}};\n" for name, kind in c.kept.items())
    static = static_function(c)
    lines = [text] if text.strip() else []
    if c.returned:
        lines.append(f"return {returned};")
    else:
        lines = [f"{out} y;", *lines, "return y;"]
    body = "\n    ".join(lines)
    return ("" if c.is_member else static) + f"""struct component_{c.number} {{
{kept}{static if c.is_member else ""}  auto process({', '.join(parameters) or 'cca::beat'}) -> {out} {{
    {body}
  }}
}};
"""


def as_graph(g):
    items = ["cca::rate<1000>", 'cca::node<"robot", robot>']
    for n in g.nodes:
        explicit = n.component.inputs and (n.period > 1 or any(d > 0 or s.period > 1 for s, d in n.sources))
        items.append(f'cca::node<"{n.name}", component_{n.component.number}{f", cca::timed<{n.period}>" if explicit else ""}>')
    for n in g.nodes:
        for port, (s, delay) in zip("xz", n.sources):
            policy = f", cca::delayed<{delay}>" if delay else ", cca::latest" if s.period != n.period else ""
            items.append(f'cca::wire<"{s.name}.y", "{n.name}.{port}"{policy}>')
    items.append(f'cca::wire<"{g.nodes[-1].name}.y", "robot.x">')
    return ",\n    ".join(items)


ROBOT = {
    "filled": ("""    cca::out<"y", joints> y;
    for (int i = 0; i < 8; ++i) y.vector()[i] = 0.002 * (counts[i] - 50);
    return y;""", """    for (int i = 0; i < 8; ++i) {
      speed[i] += 0.05 * (x.vector()[i] - 0.5 * speed[i]);
      counts[i] += 0.5 * speed[i];
    }""", "    vector8 robot_y;\n    for (int i = 0; i < 8; ++i) robot_y[i] = 0.002 * (counts[i] - 50);"),
    "eigen": ("    return 0.002 * (counts.array() - 50).matrix();", """    speed += 0.05 * (x.vector() - 0.5 * speed);
    counts += 0.5 * speed;""", "    const vector8 robot_y = 0.002 * (counts.array() - 50).matrix();"),
}


def in_order(nodes):
    """As they run in a beat: after what they read without a delay, unless that wire closes a loop to a node further down."""
    found = []

    def depends(node, on, seen):
        if node is on:
            return True
        seen.add(node)
        return any(s.component and not delay and s not in seen and depends(s, on, seen) for s, delay in node.sources)

    def visit(node):
        if node in found:
            return
        for s, delay in node.sources:
            if s.component and not delay and not (nodes.index(s) >= nodes.index(node) and depends(s, node, set())):
                visit(s)
        found.append(node)

    for node in nodes:
        visit(node)
    return found


class Hand:
    """The members and the lines of the loop by hand."""

    def __init__(self, g):
        self.g = g
        self.members = ["vector8 counts = vector8::Constant(50), speed = vector8::Zero();"]
        self.nodes = in_order(g.nodes)
        self.order = {n.name: i for i, n in enumerate(self.nodes)} | {"robot": -1}
        self.results = {"robot": "robot_y"} | {n.name: f"{n.name}_{n.component.by_hand[1][1:]}" if n.component.keeps_result else f"{n.name}_y" for n in g.nodes}
        self.outlives_beat = {n.name: n.component.keeps_result for n in g.nodes}  # what it returns
        self.lines, self.end = [ROBOT[g.robot_style][2].strip()], []
        for name in self.order:
            self.keep(name)
        for n in self.nodes:
            self.compute(n)
        self.lines.append(ROBOT[g.robot_style][1].replace("x.vector()", self.results[g.nodes[-1].name]).strip())

    def still_holds(self, reader, source):
        """What a delay of one beat asks for: it runs first, and the result of the beat before is still there."""
        return self.order[reader] <= self.order[source]

    def keep(self, name):
        """What later beats read of a result."""
        writer = next((n for n in self.g.nodes if n.name == name), None)
        kind = TYPE[writer.output()] if writer else "vector8"
        readers = [(n, delay) for n in self.g.nodes for s, delay in n.sources if s.name == name]
        delays = [(delay, self.still_holds(n.name, name)) for n, delay in readers if delay]
        is_read_first = any(not delay and self.still_holds(n.name, name) for n, delay in readers)  # by a slower one, in a loop
        if writer and not writer.component.keeps_result and (writer.period > 1 or is_read_first or (1, True) in delays):
            self.outlives_beat[name] = True
            self.members.append(f"{kind} {self.results[name]}{{{INITIAL[kind]}}};")
        most = max((delay for delay, still in delays if not (still and delay == 1)), default=0)
        if most == 1:
            self.members.append(f"{kind} {name}_before{{{INITIAL[kind]}}};")
            self.end.append(f"{name}_before = {self.results[name]};")
        elif most > 1:
            size = 2 if most == 2 else 4
            self.members.append(f"std::array<{kind}, {size}> {name}_earlier{{{'zeros<' + str(size) + '>()' if kind == 'vector8' else ''}}};")
            self.end.append(f"{name}_earlier[k % {size}] = {self.results[name]};")
        writer_or_robot = writer or self
        writer_or_robot.depth = 0 if most < 2 else 2 if most == 2 else 4

    def value(self, reader, source, delay):
        if not delay or (delay == 1 and self.still_holds(reader.name, source.name)):
            return self.results[source.name]
        depth = source.depth if source.component else self.depth
        return f"{source.name}_earlier[(k - {delay}) % {depth}]" if depth else f"{source.name}_before"

    def compute(self, n):
        c = n.component
        names = {"F": c.function(), "y": self.results[n.name]} | {name: f"{n.name}_{name}" for name in c.kept}
        lines = []
        for port, (s, delay), kind in zip("xz", n.sources, c.inputs):
            names[port] = self.value(n, s, delay)
            if "%" in names[port]:
                lines.append(f"const {TYPE[kind]}& {n.name}_{port} = {names[port]};")
                names[port] = f"{n.name}_{port}"
        self.members += [f"{kind} {n.name}_{name}{{{c.first(name, kind)}}};" for name, kind in c.kept.items()]
        text, returned = (re.sub(r"\bmost\b", f"{n.name}_most", filled(part, names)) for part in c.by_hand)
        for what, axis in c.axes.items():
            text, returned = text.replace(f"[{what}]", f"[{axis}]"), returned.replace(f"[{what}]", f"[{axis}]")
        kind = "" if self.outlives_beat[n.name] else TYPE[c.output] + " "
        if kind and not returned:
            lines.append(f"{kind}{names['y']};")
        if text.strip():
            lines.append(text.strip())
        if returned and not c.keeps_result:
            lines.append(f"{'const ' if kind else ''}{kind}{names['y']} = {returned};")
        if n.period > 1:
            lines = [f"if (k % {n.period} == 0) {{", *("  " + line for line in lines), "}"]
        self.lines += lines


PROGRAM = """// Made by bench/random_graphs.py from seed {seed}.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "program.hpp"

namespace bench {{

struct q0 : cca::dimension<"q0"> {{}};
struct q1 : cca::dimension<"q1"> {{}};
struct q2 : cca::dimension<"q2"> {{}};
struct q3 : cca::dimension<"q3"> {{}};
struct q4 : cca::dimension<"q4"> {{}};
struct q5 : cca::dimension<"q5"> {{}};
struct q6 : cca::dimension<"q6"> {{}};
struct q7 : cca::dimension<"q7"> {{}};
struct joints : cca::space<cca::number, cca::axes<q0, q1, q2, q3, q4, q5, q6, q7>> {{}};
struct level : cca::space<cca::number, cca::axes<cca::x>> {{}};
using vector8 = joints::vector_type;

template <std::size_t Count>
std::array<vector8, Count> zeros() {{
  std::array<vector8, Count> all;
  for (vector8& one : all) one.setZero();
  return all;
}}

namespace of_graph {{

{components}
struct robot {{
  vector8 counts = vector8::Constant(50), speed = vector8::Zero();
  auto sense() -> cca::out<"y", joints> {{
{sense}
  }}
  void act(cca::in<"x", joints> x) {{
{act}
  }}
}};

struct random_{seed} : cca::graph<
    {graph}> {{}};

}}  // namespace of_graph

struct look_at_robot {{
  vector8 operator()(const auto& controller) const {{ return controller.template get<"robot">().counts; }}
}};
using graph = as_graph<of_graph::random_{seed}, look_at_robot>;

namespace of_hand {{

{functions}
struct by_hand {{
  static constexpr const char* name = "by_hand";
  std::uint64_t k = 0;
  {members}

{member_functions}  void step() {{
    {lines}
    ++k;
  }}
  vector8 result() const {{ return counts; }}
}};

}}  // namespace of_hand
}}  // namespace bench

int main(int argc, char** argv) {{ return bench::program<bench::graph, bench::of_hand::by_hand>(argc, argv); }}
"""


def source(seed):
    g = Graph(seed)
    used = [c for c in g.components if any(n.component is c for n in g.nodes)]
    hand = Hand(g)
    return PROGRAM.format(
        seed=seed, components="\n".join(as_component(c) for c in used), sense=ROBOT[g.robot_style][0], act=ROBOT[g.robot_style][1], graph=as_graph(g),
        functions="".join(static_function(c) for c in used if not c.is_member), member_functions="".join(static_function(c) for c in used if c.is_member),
        members="\n  ".join(hand.members), lines="\n    ".join(hand.lines + hand.end))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("seed", type=int)
    print(source(parser.parse_args().seed))
