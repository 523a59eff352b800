#!/usr/bin/env python3
"""Generates the sources of the synthetic graphs: chain, fan_out and mixed (rates), with any number of nodes.

    generate.py chain 30                 a benchmark program: graph, loop by hand, classical
    generate.py chain 1000 --only-graph  one translation unit that steps the graph, to measure compile time
"""
import argparse

SHAPES = ("chain", "fan_out", "mixed")
PERIODS = (1, 2, 5, 10)  # mixed rates: node i has the period PERIODS[i % 4]


def writer_of(shape, i):
    return 0 if shape == "fan_out" else i - 1


def graph(shape, count, own_types):
    """Nodes and wires. Node 0 is the source, the others are filters."""
    items = ["cca::rate<1000>", 'cca::node<"n0", source>']
    for i in range(1, count):
        kind = f"own_filter<{i}>" if own_types else "filter"
        strategy = f", cca::timed<{PERIODS[i % 4]}>" if shape == "mixed" else ""
        items.append(f'cca::node<"n{i}", {kind}{strategy}>')
    for i in range(1, count):
        policy = ", cca::latest" if shape == "mixed" else ""
        items.append(f'cca::wire<"n{writer_of(shape, i)}.y", "n{i}.x"{policy}>')
    return ",\n    ".join(items)


OWN_TYPES = """template <int>
struct own_filter : filter {
  auto process(cca::in<"x", plane> x) -> cca::out<"y", plane> { return filter::process(x); }
};
"""

BY_HAND = {
    "chain": """    Eigen::Vector2d x = ramp;
    for (auto& f : filters) x = f.state += f.gain * (x - f.state);""",
    "fan_out": """    for (auto& f : filters) f.state += f.gain * (ramp - f.state);""",
    # A filter publishes its state, so the next one reads it there.
    "mixed": """    const bool due[4] = {true, k % 2 == 0, k % 5 == 0, k % 10 == 0};
    const Eigen::Vector2d* x = &ramp;
    for (std::size_t i = 0; i < filters.size(); ++i) {
      auto& f = filters[i];
      if (due[(i + 1) % 4]) f.state += f.gain * (*x - f.state);
      x = &f.state;
    }""",
}

PROGRAM = """#include <array>

#include "classical.hpp"
#include "components.hpp"
#include "program.hpp"

namespace bench {{

constexpr int nodes = {count};

{own}struct {name} : cca::graph<
    {graph}> {{}};

struct look_at_last {{
  Eigen::Vector2d operator()(const auto& controller) const {{ return controller.template get<"n{last}">().state; }}
}};
using graph = as_graph<{name}, look_at_last>;

struct by_hand {{
  static constexpr const char* name = "by_hand";
  struct low_pass {{
    double gain = 0.25;
    Eigen::Vector2d state{{0, 0}};
  }};
  Eigen::Vector2d ramp{{0, 1}};
  std::array<low_pass, nodes - 1> filters;
  long k = 0;

  void step() {{
    constexpr double dt = 1'000'000 / 1e9;
    ramp[0] += dt;
    ramp[1] -= dt;
{loop}
    ++k;
  }}
  Eigen::Vector2d result() const {{ return filters.back().state; }}
}};

struct in_classical_way {{
  static constexpr const char* name = "classical";
  source first;
  std::array<filter, nodes - 1> filters;
  classical::architecture loop{{1'000'000}};

  in_classical_way() {{
    using namespace classical;
    loop.add<&source::process>("n0", first, std::make_unique<every>(1));
    for (int i = 1; i < nodes; ++i) {{
      constexpr int periods[] = {{1, 2, 5, 10}};
      std::unique_ptr<strategy> when = std::make_unique<when_fresh>();
      if ({is_mixed}) when = std::make_unique<every>(periods[i % 4]);
      loop.add<&filter::process>("n" + std::to_string(i), filters[static_cast<std::size_t>(i - 1)], std::move(when));
      loop.connect("n" + std::to_string({writer}) + ".y", "n" + std::to_string(i) + ".x");
    }}
  }}
  in_classical_way(const in_classical_way&) = delete;
  void step() {{ loop.step(); }}
  Eigen::Vector2d result() const {{ return filters.back().state; }}
}};

}}  // namespace bench

int main(int argc, char** argv) {{ return bench::program<bench::graph, bench::by_hand, bench::in_classical_way>(argc, argv); }}
"""

ONLY_GRAPH = """#include "components.hpp"

#include <cca/cca.hpp>

namespace bench {{

{own}struct {name} : cca::graph<
    {graph}> {{}};

}}  // namespace bench

void beat(cca::controller<bench::{name}>& c) {{ c.step(); }}
"""


def source(shape, count, only_graph=False, own_types=False):
    return (ONLY_GRAPH if only_graph else PROGRAM).format(
        name=f"{shape}_{count}", count=count, last=count - 1, graph=graph(shape, count, own_types), loop=BY_HAND[shape],
        own=OWN_TYPES + "\n" if own_types else "", is_mixed="true" if shape == "mixed" else "false",
        writer="0" if shape == "fan_out" else "i - 1")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("shape", choices=SHAPES)
    parser.add_argument("count", type=int)
    parser.add_argument("--only-graph", action="store_true")
    parser.add_argument("--own-types", action="store_true", help="each node has its own component type")
    a = parser.parse_args()
    print(source(a.shape, a.count, a.only_graph, a.own_types))
