#!/usr/bin/env python3
"""Sources of the synthetic graphs: chain, fan_out, mixed; of any number of nodes; as a graph, as a loop written by hand,
and in the classical way. All three do the same arithmetic on the same components (bench/components.hpp).

    generate.py chain 30 > chain_30.hpp        defines chain_30, chain_30_by_hand, chain_30_classical
    generate.py chain 1000 --only-graph        one translation unit that steps the graph, for compile-time measurements
"""
import argparse

SHAPES = ("chain", "fan_out", "mixed")
PERIODS = (1, 2, 5, 10)  # of mixed rates: node i has PERIODS[i % 4]


def graph(shape, count, own_types=False):
    """Nodes and wires. Node 0 is the source, the others are filters."""
    lines = ['cca::rate<1000>', 'cca::node<"n0", source>']
    for i in range(1, count):
        kind = f"own_filter<{i}>" if own_types else "filter"
        if shape == "mixed":
            lines.append(f'cca::node<"n{i}", {kind}, cca::timed<{PERIODS[i % 4]}>>')
        else:
            lines.append(f'cca::node<"n{i}", {kind}>')
    for i in range(1, count):
        writer = {"chain": i - 1, "fan_out": 0, "mixed": i - 1}[shape]
        policy = ", cca::latest" if shape == "mixed" else ""
        lines.append(f'cca::wire<"n{writer}.y", "n{i}.x"{policy}>')
    return ",\n    ".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("shape", choices=SHAPES)
    parser.add_argument("count", type=int)
    parser.add_argument("--only-graph", action="store_true")
    parser.add_argument("--own-types", action="store_true", help="each node has a component type of its own")
    a = parser.parse_args()
    name = f"{a.shape}_{a.count}"
    if a.only_graph:
        print('#include "components.hpp"\n\n#include <cca/cca.hpp>\n')
    else:
        print(f'#pragma once\n\n#include "components.hpp"\n\n#include <cca/cca.hpp>\n')
    print("namespace bench {\n")
    if a.own_types:
        print("template <int>\nstruct own_filter : filter {\n"
              '  auto process(cca::in<"x", plane> x) -> cca::out<"y", plane> { return filter::process(x); }\n};\n')
    print(f"struct {name} : cca::graph<\n    {graph(a.shape, a.count, a.own_types)}> {{}};\n")
    print("}  // namespace bench")
    if a.only_graph:
        print(f"\nvoid beat(cca::controller<bench::{name}>& c) {{ c.step(); }}")


if __name__ == "__main__":
    main()
