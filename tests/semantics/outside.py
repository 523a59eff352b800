"""What somebody outside does with an architecture while it runs, between two beats: looks at what its graphs observe, and stops and
starts parts. Its own dice: the rest of an architecture does not depend on it.
"""
import random

from scopes import Scopes

BEATS = 200


def add_looks(made):
    """Graphs observe scopes, each with the policies of a wire; a program looks at them before some beats."""
    rng = random.Random(f"{made.seed} looks")
    if rng.randrange(100) >= 40:
        return
    scopes = Scopes(made.top)
    for graph in made.types:
        for _ in range(rng.choice([1, 1, 2, 3]) if graph is made.top else rng.choice([0, 0, 0, 0, 1])):
            add_look(made, rng, scopes, graph)
    if any(graph.observes for graph in made.types):
        n = rng.choice([3, 7, 20])
        made.looks = sorted(k for k in range(1, BEATS) if rng.randrange(n) == 0) or [BEATS // 2]


def add_look(made, rng, scopes, graph):
    policies = [(), (), ("latest",), ("delayed", 1), ("delayed", rng.choice([2, 3, 5]))]
    for _ in range(20):
        pattern = made.pattern(scopes, scopes.places[id(graph)][0], rng)
        policy = rng.choice(policies)
        if rng.randrange(100) < 45:
            queue = ("queue", rng.choice([1, 2, 4, 9]), rng.choice(["drop_oldest", "drop_newest"]))
            policy = policy + queue if policy[:1] == ("delayed",) else queue
        found = [scopes.named(pattern, place) for place in scopes.places[id(graph)]]
        if not all(one and may_be_seen(one, policy) for one in found):
            continue
        graph.observes.append((pattern, policy))
        made.count("observed by a graph: " + ("queue, delayed" if len(policy) > 3 else policy[0] if policy else "no policy"))
        made.count("observed by a graph: several outputs with a policy", policy[:1] not in ((), ("latest",)) and any(len(one) > 1 for one in found))
        made.count("observed by a graph: inputs", any(len(port) == 2 for one in found for port in one))
        return


def may_be_seen(found, policy):
    """Whether a graph may observe all of it with this policy: what waits in a queue is seen where it waits, and at once."""
    if len(found) > 12 or len({one[0] for one in found}) != len(found):
        return False
    return not any("queue" in wire.policy or "merged" in wire.policy for one in found if len(one) == 2 for wire in one[1])


def rests_of_spread(made, path, inside):
    """The beats before which somebody outside stops a part of an architecture that is spread, and starts it again, or None."""
    rng = random.Random(f"{made.seed} {path} asked from outside")
    if rng.randrange(100) >= 60:
        return None
    first = rng.randrange(1, 90)
    return first, first + rng.randrange(1, 60)


# ---- as code ----


def around_cpp(made, crews, parts, inside, switches=()):
    """The struct that does it; empty: nobody does anything. `inside`: of each part the environments that have its nodes."""
    changes = sorted((k, kind, path) for path, rests in parts if rests for k, kind in zip(rests, ("stop", "start")))
    if not crews and not changes and not made.looks and not switches:
        return ""

    def spelled(k, kind, path):
        return f'c.template {kind}<"{path}">()' if k % 2 else f'c.{kind}("{path}")'

    # By cca::live_access, which takes one request at a time; others of the same beat are asked of the deployment itself.
    ordered = {}
    for change in changes:
        k, _, path = change
        if made.environments > 1 and not made.in_processes and len(inside[path]) > 1 and k not in dict(switches):
            ordered.setdefault(k, change)

    lines = ["struct around : in_the_loop {"]
    if made.environments > 1:
        acts = sorted({k for k, _, _ in changes} | {k for k, _ in switches} | set(made.looks))
        at_rest = sorted({k for k, _, _ in changes} | set(made.looks)) if made.in_processes else []
        lines.append(f"  static constexpr int at_rest[] = {{{', '.join(map(str, at_rest + ['beats']))}}};")
        lines.append(f"  static constexpr int acts[] = {{{', '.join(map(str, acts))}, beats}};")
        if ordered or (switches and not made.in_processes):
            lines += ["  static constexpr bool gives_orders = true;", "  static void order(auto& live, int k) {"]
            lines += [f'    if (k == {k}) insist(live.{kind}("{path}"));' for k, kind, path in ordered.values()]
            lines += [f'    if (k == {k}) insist(live.switch_to("{mode}"));' for k, mode in switches]
            lines.append("  }")
    lines += ["  template <class Controller>",
              "  static void before([[maybe_unused]] Controller& c, [[maybe_unused]] int k, [[maybe_unused]] bool by_orders = false) {"]
    if made.looks:
        lines += [f"    constexpr int looks[] = {{{', '.join(map(str, made.looks))}}};", "    look_if_it_is_time(c, k, looks);"]
    for k, kind, path in changes:
        unless = "!by_orders && " if ordered.get(k) == (k, kind, path) else ""
        lines.append(f"    if ({unless}k == {k}) where_it_is([&] {{ {spelled(k, kind, path)}; }});")
    for number, (k, mode) in enumerate(switches):  # of processes one asks, each time another one
        spelled_mode = f'c.template switch_to<"{mode}">()' if k % 2 else f'c.switch_to("{mode}")'
        unless = "" if made.environments == 1 else f"is_here({number % 2}) && " if made.in_processes else "!by_orders && "
        lines.append(f"    if ({unless}k == {k} && c.state() != cca::state::faulted) {spelled_mode};")
    lines.append("  }")
    if crews:
        waits = " ".join(f'c.template get<"{path}">().wait();' for path in crews)
        lines += ["  template <class Controller>", f"  static void settle(Controller& c) {{ {waits} }}"]
    return "\n".join(lines + ["};"])
