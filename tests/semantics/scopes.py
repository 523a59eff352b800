"""What a pattern names in an architecture, so that only patterns are made which the Rules allow.

The interpreter looks patterns up for itself, by the words of the Semantics; nothing of this reaches it.
"""


def matches(words, names):
    if not words:
        return not names
    if words[0] == "**":
        return any(matches(words[1:], names[skipped:]) for skipped in range(len(names) + 1))
    return bool(names) and words[0] in ("*", names[0]) and matches(words[1:], names[1:])


class Scopes:
    def __init__(self, top):
        self.outputs, self.inputs = [], {}  # (names, node, function); names -> (node, wires)
        self.second_names, self.groups, self.places = [], [], {}
        self.walk(top, ())

    def walk(self, graph, path):
        self.places.setdefault(id(graph), []).append(path)
        if graph.group:
            self.groups.append(path)
        for name, child in graph.children:
            if hasattr(child, "children"):
                self.walk(child, path + (name,))
            else:
                self.outputs += [(path + (name, port.name), child, function) for function, port in child.outputs()]
        if path:
            self.second_names += [(path + (outer,), self.resolve(graph, path, inner)) for outer, inner in graph.exposes.items()]
        for _, b, wire in graph.wires:
            self.inputs.setdefault(self.resolve(graph, path, b), []).append(wire)

    def resolve(self, graph, path, name):
        child_name, port = name.split(".")
        child = dict(graph.children)[child_name]
        if hasattr(child, "children"):
            return self.resolve(child, path + (child_name,), child.exposes[port])
        return path + (child_name, port)

    def named(self, pattern, place):
        """Outputs as (names, node, function), inputs as (names, wires), for an observer in the graph at `place`; None: it must not be."""
        words = tuple(pattern.lstrip("/").split("."))
        graphs = [()] if pattern[0] == "/" else [place[:n] for n in range(len(place), -1, -1)]
        for graph in graphs:
            def hears(own):
                names = [own] + [second for second, first in self.second_names if first == own]
                return any(name[:len(graph)] == graph and matches(words, name[len(graph):]) for name in names)
            # A skeleton of the library may expose more than is used here.
            for group in self.groups:
                if group[:len(graph)] == graph and matches(words, group[len(graph):] + ("?",)) and "**" not in words:
                    return None
            found = [one for one in self.outputs if hears(one[0])]
            if words[-1] == "**":
                found += [(own, wires) for own, wires in self.inputs.items() if hears(own)]
            if found:
                return found
        return []


def is_queued(wire):
    return "queue" in wire.policy or "merged" in wire.policy


def may_hear(found, policy, environment):
    """Whether an observer with this policy, in this environment, may hear all of it."""
    late = policy[1] if policy[0] == "delayed" else 0
    if not found or len(found) > 12 or len({one[0] for one in found}) != len(found):
        return False
    for one in found:
        if len(one) == 3:
            if not late and (one[1].environment != environment or one[2] == "act"):
                return False
            continue
        for wire in one[1]:
            if is_queued(wire) and late:
                continue  # it hears what is taken
            if is_queued(wire) and wire.reader.environment != environment:
                return False
            delay = late + (wire.policy[1] if wire.policy[0] == "delayed" else 0)
            from_act = any(port is wire.out for port in wire.writer.ports["act"][1])
            if not delay and (wire.writer.environment != environment or from_act):
                return False
    return True
