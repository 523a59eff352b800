// Rules about names and items of a graph: the message of each mistake, and that the mended one is sound.
#include "rules_parts.hpp"

namespace {

using namespace parts;

struct twice : khz<cca::node<"a", source<>>, cca::node<"a", step<>>, cca::wire<"a.y", "a.x">> {};
struct twice_mended : khz<cca::node<"a", source<>>, cca::node<"b", step<>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<twice, twice_mended>({"node.duplicate_name", "a",
                                          "two nodes of twice are named `a` (source<>, step<>), so a path to "
                                          "them has two meanings: give one of them another name"}));

struct twice_outside : khz<cca::node<"a", source<>>,
                           cca::node<"b", source<>>,
                           cca::expose<"a.y", "y">,
                           cca::expose<"b.y", "y">> {};
struct twice_outside_mended : khz<cca::node<"a", source<>>,
                                  cca::node<"b", source<>>,
                                  cca::expose<"a.y", "y">,
                                  cca::expose<"b.y", "z">> {};
static_assert(tells<twice_outside, twice_outside_mended>(
    {"node.duplicate_name", "b.y",
     "two outputs are exposed as `y` by twice_outside: give one of them another name"}));

struct twice_inside : khz<cca::node<"g", twice>> {};
struct twice_inside_mended : khz<cca::node<"g", twice_mended>> {};
static_assert(tells<twice_inside, twice_inside_mended>(
    {"node.duplicate_name", "g.a",
     "two nodes of twice are named `a` (source<>, step<>), so a path to them has two meanings: give one of "
     "them another name"}));

struct nothing {};

struct no_item : khz<cca::node<"a", source<>>, source<>> {};
struct no_item_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<no_item, no_item_mended>(
    {"graph.unknown_item", "no_item",
     "`source<>` in no_item is no item of a graph, so it would be ignored: write cca::node<`name`, type> for "
     "a component or graph; the others are cca::wire, cca::expose, cca::observe, cca::rate and "
     "cca::require<cca::latency<...>, cca::beats<N>>"}));

struct no_bound : khz<cca::node<"a", source<>>,
                      cca::node<"b", sink<>>,
                      cca::wire<"a.y", "b.x">,
                      cca::require<cca::latency<"a.y", "b.x">, cca::rate<2>>> {};
struct no_bound_mended : khz<cca::node<"a", source<>>,
                             cca::node<"b", sink<>>,
                             cca::wire<"a.y", "b.x">,
                             cca::require<cca::latency<"a.y", "b.x">, cca::beats<2>>> {};
static_assert(tells<no_bound, no_bound_mended>(
    {"graph.unknown_item", "no_bound",
     "`require<latency<a.y, b.x>, rate<2>>` in no_bound is no item of a graph, so it would be ignored: write "
     "cca::node<`name`, type> for a component or graph; the others are cca::wire, cca::expose, cca::observe, "
     "cca::rate and cca::require<cca::latency<...>, cca::beats<N>>"}));

struct dotted_node : khz<cca::node<"a.b", source<>>> {};
struct dotted_node_mended : khz<cca::node<"a_b", source<>>> {};
static_assert(
    tells<dotted_node, dotted_node_mended>({"node.bad_name", "a.b",
                                            "a node of dotted_node is named `a.b`, but dots join names to "
                                            "paths, and `*` stands for any name: use neither in a name"}));

struct nameless_node : khz<cca::node<"", source<>>> {};
struct nameless_node_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<nameless_node, nameless_node_mended>(
    {"node.bad_name", "nameless_node",
     "a node of nameless_node has no name, so no wire could name it: give it one"}));

struct with_dotted_port {
  void process(cca::optional_in<"x.1", signal>, cca::beat) {}
};

struct dotted_port : khz<cca::node<"a", with_dotted_port>> {};
struct dotted_port_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<dotted_port, dotted_port_mended>(
    {"node.bad_name", "a",
     "a port of `a` (with_dotted_port) is named `x.1`, but dots join names to paths, and `*` stands for any "
     "name: use neither in a name"}));

struct starred_expose : khz<cca::node<"a", source<>>, cca::expose<"a.y", "all.*">> {};
struct starred_expose_mended : khz<cca::node<"a", source<>>, cca::expose<"a.y", "all">> {};
static_assert(tells<starred_expose, starred_expose_mended>(
    {"node.bad_name", "a.y",
     "a port that starred_expose exposes is named `all.*`, but dots join names to paths, and `*` stands for "
     "any name: use neither in a name"}));

struct nameless_expose : khz<cca::node<"a", source<>>, cca::expose<"a.y", "">> {};
struct nameless_expose_mended : khz<cca::node<"a", source<>>, cca::expose<"a.y", "y">> {};
static_assert(tells<nameless_expose, nameless_expose_mended>(
    {"node.bad_name", "a.y",
     "a port that nameless_expose exposes has no name, so no wire could name it: give it one"}));

// A component, and not even that, in place of a graph.
static_assert(!cca::well_formed<nothing> && !cca::well_formed<int>);
static_assert(told{
    "graph.unknown_item", "nothing",
    "`nothing` is no graph: a controller runs a struct derived from cca::graph<...>; put a "
    "component into one as cca::node<`name`, nothing>; if another error names nothing, mend that "
    "first: a comma may be missing between two items of the graph, or a value (a lambda, an object) stands "
    "where a type should"}
                  .by(cca::diagnosis<nothing>));

}  // namespace
