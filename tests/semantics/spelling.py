"""An architecture in both spellings: as text, flat, for the interpreter, and as graph types for the compiler.

The text is made from the nested form: what `expose` does is worked out here by names.
"""
import random

from architecture import DIMENSIONS, Graph, Node
from outside import around_cpp
from skeletons import group_cpp, skeleton_cpp


# ---- as text ----


def flat(made):
    """Paths of nodes in order of declaration, and wires between paths of ports, worked out from the nested form."""
    nodes, wires = [], []

    def resolve(graph, path, name):
        child_name, port = name.split(".")
        child = dict(graph.children)[child_name]
        if isinstance(child, Graph):
            return resolve(child, path + child_name + ".", child.exposes[port])
        return path + name

    def walk(graph, path):
        for name, child in graph.children:
            if isinstance(child, Graph):
                walk(child, path + name + ".")
            else:
                nodes.append((path + name, child))
        for a, b, wire in graph.wires:
            wires.append((resolve(graph, path, a), resolve(graph, path, b), wire))

    walk(made.top, "")
    return nodes, wires


def exposed(made):
    """Second names of ports, as graphs expose them: (path, path of the port)."""
    names = []

    def resolve(graph, path, name):
        child_name, port = name.split(".")
        child = dict(graph.children)[child_name]
        if isinstance(child, Graph):
            return resolve(child, path + child_name + ".", child.exposes[port])
        return path + name

    def walk(graph, path):
        names.extend((path + outer, resolve(graph, path, inner)) for outer, inner in graph.exposes.items() if path)
        for name, child in graph.children:
            if isinstance(child, Graph):
                walk(child, path + name + ".")

    walk(made.top, "")
    return names



def watched(made):
    """What graphs observe for programs: path of the graph, pattern, policy."""
    found = []

    def walk(graph, path):
        found.extend((path, *one) for one in graph.observes)
        for name, child in graph.children:
            if isinstance(child, Graph):
                walk(child, f"{path}.{name}" if path else name)

    walk(made.top, "")
    return found


def words(strategy):
    kind, rest = strategy[0], strategy[1:]
    if kind in ("any_of", "all_of"):
        return f"{kind} {len(rest[0])} " + " ".join(words(part) for part in rest[0])
    if kind == "port_triggered":
        return f"{kind} {len(rest[0])} " + " ".join(rest[0])
    if kind == "stoppable":
        return f"{kind} {words(rest[0])}"
    return " ".join([kind, *map(str, rest)])


def text(made):
    lines = [f"architecture {made.seed}", f"period {made.period}"]
    if hasattr(made, "modes"):
        for mode in made.modes:
            for feature, n in mode.features.items():
                made.count(feature, n)
    lines += [f"feature {n} {name}" for name, n in sorted(made.features.items()) if n]
    if hasattr(made, "modes"):
        for k, name in made.switches:
            lines.append(f"switch {k} {name}")
        lines += ["look " + " ".join(map(str, made.looks))] if made.looks else []
        for mode in made.modes:
            lines += [f"mode {mode.name}", *text_of_graph(mode)]
    else:
        lines += text_of_graph(made)
    return "\n".join(lines) + "\n"


def text_of_graph(made):
    nodes, wires = flat(made)
    lines = []
    if made.environments > 1:
        lines += [f"feature {n} {name}" for name, n in crossings(made).items() if n]
    lines += [f"exposed {name} {port}" for name, port in exposed(made)]
    for path, node in nodes:
        lines.append(f"{'resource' if node.resource else 'component'} {path} {words(node.strategy)}")
        lines.append("skeleton " + " ".join(map(str, node.skeleton)) if node.skeleton else
                     f"habit {node.number} {node.publishes} {node.origin} {node.fault_at}")
        for function in node.functions:
            lines.append(function)
            lines += [f"{'optional' if port.kind == 'optional_in' else 'in'} {port.name} {DIMENSIONS[port.space]}" for port in node.ports[function][0]]
            lines += ["observe " + " ".join(map(str, (node.hears,) + node.hears_policy))] if node.hears else []
            lines += [f"{port.kind} {port.name} {DIMENSIONS[port.space]}" for port in node.ports[function][1]]
            lines += ["fault"] if node.fault_function == function else []
    parts = made.parts()
    lines += [f"part {path} {rests[0]} {rests[1]}" if rests else f"part {path} -1 -1" for path, rests in parts]
    for path, node in nodes:
        around = path.rpartition(".")[0]
        for spelled, kind in node.asks:
            asked = spelled[1:] if spelled[0] == "/" else f"{around}.{spelled}" if around else spelled
            lines.append(f"asks {path} {asked} {kind} {salt(spelled, kind)}")
        lines += [f"switches {path} {name} {salt(name, '')}" for name in node.switches]
    lines += [" ".join(map(str, ("watch", path or "-", pattern) + policy)) for path, pattern, policy in watched(made)]
    lines += ["look " + " ".join(map(str, made.looks))] if made.looks else []
    for a, b, wire in wires:
        line = f"wire {a} {b} " + " ".join(map(str, wire.policy))
        if wire.initial:
            line += " initial " + " ".join(map(str, wire.initial))
        lines.append(line)
    return lines


def salt(path, kind):
    """As `salt_of` in probe.hpp."""
    number = int(kind == "starts")
    for letter in path:
        number = (number * 31 + ord(letter)) % 100003
    return number


def crossings(made):
    across = [wire for wire in made.wires if wire.writer.environment != wire.reader.environment]
    return {"queues between environments": sum("queue" in wire.policy for wire in across),
            "merged wires between environments": sum("merged" in wire.policy for wire in across),
            "environments": len({node.environment for node in made.nodes}),
            "wires between environments": len(across),
            "wires between environments, longer than a beat": sum(wire.delayed() and wire.policy[1] > 1 for wire in across)}


# ---- as code ----


def strategy_cpp(strategy):
    kind, rest = strategy[0], strategy[1:]
    if kind in ("any_of", "all_of"):
        return f"cca::{kind}<{', '.join(strategy_cpp(part) for part in rest[0])}>"
    if kind == "stoppable":
        return f"cca::stoppable<{strategy_cpp(rest[0])}>"
    if kind == "port_triggered":
        return "cca::port_triggered<" + ", ".join(f'"{name}"' for name in rest[0]) + ">"
    if kind == "timed":
        return f"cca::timed<{rest[0]}>" if rest[1] == 0 else f"cca::timed<{rest[0]}, {rest[1]}>"
    if kind == "timeout":
        return f"cca::timeout<{rest[0]}>"
    if kind == "user":
        name, port, n, m = rest
        arguments = {"on_beats": f"{n}, {m}", "patient": f"{n}", "above": f'"{port}", {n}', "older": f'"{port}", {n}', "fresh_on_odd": f'"{port}"',
                     "every_nth": f'"{port}", {n}', "while_waiting": f'"{port}", {n}'}
        return f"{name}<{arguments[name]}>"
    return f"cca::{kind}"


def policies_cpp(policy):
    options = []
    if policy and policy[0] == "delayed":
        options.append(f"cca::delayed<{policy[1]}>")
        policy = policy[2:]
    if policy and policy[0] in ("queue", "merged"):
        options.append(f"cca::{policy[0]}<{policy[1]}, cca::{policy[2]}>")
    return options


def function_cpp(node, function):
    if function not in node.functions:
        return "void, void"
    inputs, outputs = ([port.cpp() for port in ports] for ports in node.ports[function])
    if node.hears:
        inputs.append(f'cca::observe<{", ".join([f"{chr(34)}{node.hears}{chr(34)}"] + policies_cpp(node.hears_policy))}>')
    outputs += [f'cca::{kind}<"{path}">' for path, kind in node.asks]
    outputs += [f'cca::switch_to<"{name}">' for name in node.switches]
    if node.fault_function == function:
        outputs.insert(0 if node.fault_first else len(outputs), "cca::fault")
    return f"reads<{', '.join(inputs)}>, tells<{', '.join(outputs)}>"


def node_cpp(node):
    if node.skeleton:
        return skeleton_cpp(node.skeleton, node)
    habit = f"habit{{{node.number}, {node.publishes}, {node.origin}, {node.fault_at}}}"
    if not node.resource:
        return f"probe<{habit}, {function_cpp(node, 'process')}>"
    return f"device<{habit}, {function_cpp(node, 'sense')}, {function_cpp(node, 'act')}>"


def graph_cpp(graph, rng):
    nodes, others = [], []
    for name, child in graph.children:
        kind = node_cpp(child) if isinstance(child, Node) else group_cpp(child.group, node_cpp) if child.group else child.name
        strategy = ""
        if isinstance(child, Node) and child.strategy != ("default",):
            strategy = ", " + strategy_cpp(child.strategy)
        if name in graph.stoppable:
            strategy = ", cca::stoppable<>"
        nodes.append(f'cca::node<"{name}", {kind}{strategy}>')
    for a, b, wire in graph.wires:
        options = policies_cpp(wire.policy)
        rng.shuffle(options)
        if wire.policy == ("latest",) and wire.stated:
            options.append("cca::latest")
        if wire.initial:
            same = len(set(wire.initial)) == 1
            options.append("cca::initial<" + ", ".join(map(str, wire.initial[:1] if same else wire.initial)) + ">")
        others.append(", ".join([f'cca::wire<"{a}"', f'"{b}"'] + options) + ">")
    others += [f'cca::expose<"{inner}", "{outer}">' for outer, inner in graph.exposes.items()]
    others += [f'cca::observe<{", ".join([f"{chr(34)}{pattern}{chr(34)}"] + policies_cpp(policy))}>' for pattern, policy in graph.observes]
    if graph.rate:
        others.append(f"cca::rate<{graph.rate}>")
    rng.shuffle(others)  # only nodes have an order that means something
    items = nodes
    for other in others:
        items.insert(rng.randrange(len(items) + 1), other)
    return f"struct {graph.name} : cca::graph<\n    " + ",\n    ".join(items) + "> {};\n"


def placed(made, rng):
    """Of each environment the paths that it names: of components, or of an inner graph that lies in it wholly."""
    named = {e: [] for e in range(made.environments)}

    def walk(graph, path):
        for name, child in graph.children:
            if isinstance(child, Node):
                named[child.environment].append(path + name)
                continue
            inside = {node.environment for node in made.nodes_of(child)}
            if len(inside) == 1 and rng.randrange(2):
                named[inside.pop()].append(path + name)
            else:
                walk(child, path + name + ".")

    walk(made.top, "")
    return [(e, paths) for e, paths in named.items() if paths]


def deployment_cpp(made, rng, what="top"):
    environments = placed(made, rng)
    rng.shuffle(environments)
    rest = rng.randrange(2 * len(environments))  # half of them name all nodes
    items = []
    if environments[0][0] == made.free:  # the first gives the beat
        environments.append(environments.pop(0))
    for e, (which, paths) in enumerate(environments):
        nodes = "cca::other_nodes" if e == rest else "cca::nodes<" + ", ".join(f'"{path}"' for path in paths) + ">"
        items.append(f'cca::environment<"e{e}", {nodes}' + (", cca::free_running>" if which == made.free else ">"))
    return f"struct spread : cca::deployment<{what},\n    " + ",\n    ".join(items) + "> {};\n"


def code_of_modes(made, over_dds):
    rng = random.Random(made.seed)
    lines = [f"namespace architecture_{made.seed} {{", "using namespace semantics;\n"]
    for mode in made.modes:
        lines += [graph_cpp(graph, rng) for graph in reversed(mode.types)]
    modes = ", ".join(f'cca::mode<"{mode.name}", {mode.name}_top>' for mode in made.modes)
    lines.append(f"struct moves : cca::modes<{modes}> {{}};\n")
    if made.environments > 1:
        lines.append(deployment_cpp(made.base, rng, "moves"))
    lines.append(f'constexpr char text[] = R"({text(made)})";')
    paths = dict.fromkeys(path for mode in made.modes for path, _ in mode.parts())
    nodes = [one for mode in made.modes for one in flat(mode)[0]]
    inside = {path: {node.environment for at, node in nodes if at == path or at.startswith(path + ".")} for path in paths}
    around = around_cpp(made, [], sorted(made.base.rests.items()), inside, made.switches)
    lines += [around] if around else []
    outside = "around" if around else "nothing_outside" if made.environments > 1 else "in_the_loop"
    forms = ", moves" if made.seed % 4 == 0 else ", void, true" if made.seed % 4 == 1 else ""
    run = f"run_over_dds<spread, {outside}>" if over_dds else f"run_deployed<spread, {outside}{forms}>" if made.environments > 1 else f"run<moves, {outside}>"
    lines.append(f"const registered here{{{made.seed}, text, &{run}}};\n\n}}  // namespace architecture_{made.seed}\n")
    return "\n".join(lines)


def code(made, over_dds=False):
    if hasattr(made, "modes"):
        return code_of_modes(made, over_dds)
    rng = random.Random(made.seed)
    lines = [f"namespace architecture_{made.seed} {{", "using namespace semantics;\n"]
    lines += [graph_cpp(graph, rng) for graph in reversed(made.types)]  # inner ones first
    if made.environments > 1:
        lines.append(deployment_cpp(made, rng))
    lines.append(f'constexpr char text[] = R"({text(made)})";')
    closed = f"}}  // namespace architecture_{made.seed}\n"
    top = f"architecture_{made.seed}::{'spread' if made.environments > 1 else 'top'}"
    as_long = []  # cut into parts, as graphs of very many functions are
    if made.seed % 3 == 0:
        as_long.append(f"template <>\nconstexpr int cca::detail::calls_in_part<{top}> = {1 + made.seed % 4};")
    if as_long:
        lines += [f"\n{closed}", *as_long, f"namespace architecture_{made.seed} {{"]
    nodes = flat(made)[0]
    crews = [path for path, node in nodes if node.skeleton and node.skeleton[0] == "on_threads"]
    inside = {path: {node.environment for at, node in nodes if at == path or at.startswith(path + ".")} for path, _ in made.parts()}
    around = around_cpp(made, crews, made.parts(), inside)
    lines += [around] if around else []
    outside = "around" if around else "nothing_outside"
    forms = ", top" if made.seed % 4 == 0 else ", void, true" if made.seed % 4 == 1 else ""
    run = f"run_over_dds<spread, {outside}>" if over_dds else f"run_deployed<spread, {outside}{forms}>" if made.environments > 1 else f"run<top{', around' if around else ''}>"
    lines.append(f"const registered here{{{made.seed}, text, &{run}}};\n\n{closed}")
    return "\n".join(lines)
