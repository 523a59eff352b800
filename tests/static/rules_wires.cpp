// Rules about ports that wires name: the message of each mistake, and that the mended graph is sound.
#include "rules_parts.hpp"

namespace {

using namespace parts;

struct no_node : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"c.y", "b.x">> {};
struct no_node_mended : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<no_node, no_node_mended>(
    {"wire.unknown_port", "c.y -> b.x",
     "the wire `c.y` -> `b.x` in no_node names `c.y`, but there is no node `c`; did you mean `a.y`?"}));

struct no_output : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.z", "b.x">> {};
struct no_output_mended : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<no_output, no_output_mended>({"wire.unknown_port", "a.z -> b.x",
                                                  "the wire `a.z` -> `b.x` in no_output names `a.z`, but `a` "
                                                  "(source<>) has no such output; did you mean `a.y`?"}));

struct no_input : khz<cca::node<"a", source<>>, cca::node<"bird", sink<>>, cca::wire<"a.y", "brid.x">> {};
struct no_input_mended
    : khz<cca::node<"a", source<>>, cca::node<"bird", sink<>>, cca::wire<"a.y", "bird.x">> {};
static_assert(tells<no_input, no_input_mended>({"wire.unknown_port", "a.y -> brid.x",
                                                "the wire `a.y` -> `brid.x` in no_input names `brid.x`, but "
                                                "there is no node `brid`; did you mean `bird.x`?"}));

struct no_dot : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a", "b.x">> {};
struct no_dot_mended : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<no_dot, no_dot_mended>(
    {"wire.unknown_port", "a -> b.x",
     "the wire `a` -> `b.x` in no_dot names `a`, but a port is named with its node: `node.port`"}));

struct showing : cca::graph<cca::node<"in", sink<>>,
                            cca::node<"out", source<>>,
                            cca::node<"hidden", source<>>,
                            cca::expose<"in.x", "x">,
                            cca::expose<"out.y", "y">> {};

struct inner_path : khz<cca::node<"g", showing>,
                        cca::node<"a", source<>>,
                        cca::node<"b", sink<>>,
                        cca::wire<"a.y", "g.x">,
                        cca::wire<"g.out.y", "b.x">> {};
struct inner_path_mended : khz<cca::node<"g", showing>,
                               cca::node<"a", source<>>,
                               cca::node<"b", sink<>>,
                               cca::wire<"a.y", "g.x">,
                               cca::wire<"g.y", "b.x">> {};
static_assert(tells<inner_path, inner_path_mended>(
    {"wire.unknown_port", "g.out.y -> b.x",
     "the wire `g.out.y` -> `b.x` in inner_path names `g.out.y`, but a path into an inner graph cannot be "
     "wired: showing exposes this port as `g.y`, name that"}));

struct inner_path_hidden : khz<cca::node<"g", showing>,
                               cca::node<"a", source<>>,
                               cca::node<"b", sink<>>,
                               cca::wire<"a.y", "g.x">,
                               cca::wire<"g.hidden.y", "b.x">> {};
struct inner_path_hidden_mended : khz<cca::node<"g", showing>,
                                      cca::node<"a", source<>>,
                                      cca::node<"b", sink<>>,
                                      cca::wire<"a.y", "g.x">,
                                      cca::wire<"g.y", "b.x">> {};
static_assert(tells<inner_path_hidden, inner_path_hidden_mended>(
    {"wire.unknown_port", "g.hidden.y -> b.x",
     "the wire `g.hidden.y` -> `b.x` in inner_path_hidden names `g.hidden.y`, but a path into an inner graph "
     "cannot be wired: let showing expose the port, with cca::expose<`hidden.y`, `y`>, and name `g.y` "
     "here"}));

struct not_shown : khz<cca::node<"g", showing>,
                       cca::node<"a", source<>>,
                       cca::node<"b", sink<>>,
                       cca::wire<"a.y", "g.x">,
                       cca::wire<"g.z", "b.x">> {};
struct not_shown_mended : khz<cca::node<"g", showing>,
                              cca::node<"a", source<>>,
                              cca::node<"b", sink<>>,
                              cca::wire<"a.y", "g.x">,
                              cca::wire<"g.y", "b.x">> {};
static_assert(tells<not_shown, not_shown_mended>({"wire.unknown_port", "g.z -> b.x",
                                                  "the wire `g.z` -> `b.x` in not_shown names `g.z`, but `g` "
                                                  "(showing) exposes no such output; did you mean `g.y`?"}));

struct shows_nothing : khz<cca::node<"a", source<>>, cca::expose<"a.z", "z">> {};
struct shows_nothing_mended : khz<cca::node<"a", source<>>, cca::expose<"a.y", "z">> {};
static_assert(
    tells<shows_nothing, shows_nothing_mended>({"wire.unknown_port", "a.z -> z",
                                                "cca::expose<`a.z`, `z`> in shows_nothing names `a.z`, but "
                                                "`a` (source<>) has no such port; did you mean `a.y`?"}));

struct shows_inner_path : khz<cca::node<"g", showing>,
                              cca::node<"a", source<>>,
                              cca::wire<"a.y", "g.x">,
                              cca::expose<"g.hidden.y", "z">> {};
struct shows_inner_path_mended : khz<cca::node<"g", showing>,
                                     cca::node<"a", source<>>,
                                     cca::wire<"a.y", "g.x">,
                                     cca::expose<"g.y", "z">> {};
static_assert(tells<shows_inner_path, shows_inner_path_mended>(
    {"wire.unknown_port", "g.hidden.y -> z",
     "cca::expose<`g.hidden.y`, `z`> in shows_inner_path names `g.hidden.y`, but a path into an inner graph "
     "cannot be wired: let showing expose the port, with cca::expose<`hidden.y`, `y`>, and name `g.y` "
     "here"}));

struct bound_of_nothing : khz<cca::node<"a", source<>>,
                              cca::node<"b", sink<>>,
                              cca::wire<"a.y", "b.x">,
                              cca::require<cca::latency<"a.y", "b.z">, cca::beats<1>>> {};
struct bound_of_nothing_mended : khz<cca::node<"a", source<>>,
                                     cca::node<"b", sink<>>,
                                     cca::wire<"a.y", "b.x">,
                                     cca::require<cca::latency<"a.y", "b.x">, cca::beats<1>>> {};
static_assert(tells<bound_of_nothing, bound_of_nothing_mended>(
    {"wire.unknown_port", "a.y -> b.z",
     "cca::latency<`a.y`, `b.z`> in bound_of_nothing names `b.z`, but `b` (sink<>) has no such input; did "
     "you mean `b.x`?"}));

struct into_source : khz<cca::node<"a", source<>>, cca::node<"b", source<>>, cca::wire<"a.y", "b.command">> {
};
struct into_source_mended : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<into_source, into_source_mended>(
    {"wire.unknown_port", "a.y -> b.command",
     "the wire `a.y` -> `b.command` in into_source names `b.command`, but `b` (source<>) has no such input: "
     "it has no inputs at all"}));

struct two_far : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.foot">> {};
static_assert(tells<two_far, no_node_mended>({"wire.unknown_port", "a.y -> b.foot",
                                              "the wire `a.y` -> `b.foot` in two_far names `b.foot`, but "
                                              "`b` (sink<>) has no such input; it has `x`"}));

template <cca::fixed_string... Inputs>
struct board {
  void process(cca::optional_in<Inputs, signal>...) {}
};
template <cca::fixed_string Input>
struct to_board : khz<cca::node<"a", source<>>,
                      cca::node<"b", board<"i1", "i2", "i3", "i4", "i5", "i6", "i7", "i8", "i9">>,
                      cca::wire<"a.y", Input>> {};
static_assert(tells<to_board<"b.foot">, to_board<"b.i9">>(
    {"wire.unknown_port", "a.y -> b.foot",
     "the wire `a.y` -> `b.foot` in to_board<b.foot> names `b.foot`, but `b` (board<i1, i2, i3, i4, i5, "
     "i6, i7, i8, i9>) has no such input; it has `i1`, `i2`, `i3`, `i4`, `i5`, `i6`, `i7`, `i8` and "
     "others"}));

struct log {
  void process(cca::observe<"**">) {}
};

template <class... Wire>
struct logged : khz<cca::node<"a", source<>>, cca::node<"b", log>, Wire...> {};
static_assert(tells<logged<cca::wire<"a.y", "b.x">>, logged<>>(
    {"wire.unknown_port", "a.y -> b.x",
     "the wire `a.y` -> `b.x` in logged<wire<a.y, b.x>> names `b.x`, but `b` (log) has no such input: "
     "what it observes comes without a wire"}));

struct reversed : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"b.x", "a.y">> {};
struct reversed_mended : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<reversed, reversed_mended>(
    {"wire.direction", "b.x -> a.y",
     "a wire leads from an output to an input, but in `b.x` -> `a.y` in reversed `b.x` is an input and `a.y` "
     "an output: turn it round, cca::wire<`a.y`, `b.x`>"}));

struct from_input : khz<cca::node<"a", source<>>,
                        cca::node<"b", sink<>>,
                        cca::node<"c", sink<>>,
                        cca::wire<"a.y", "b.x">,
                        cca::wire<"b.x", "c.x">> {};
struct from_input_mended : khz<cca::node<"a", source<>>,
                               cca::node<"b", sink<>>,
                               cca::node<"c", sink<>>,
                               cca::wire<"a.y", "b.x">,
                               cca::wire<"a.y", "c.x">> {};
static_assert(tells<from_input, from_input_mended>(
    {"wire.direction", "b.x -> c.x",
     "a wire leads from an output to an input, but in `b.x` -> `c.x` in from_input `b.x` is an input: name "
     "an output there; did you mean `a.y`?"}));

template <cca::fixed_string Output>
struct far_from : khz<cca::node<"source", source<>>,
                      cca::node<"b", sink<>>,
                      cca::node<"c", sink<>>,
                      cca::wire<"source.y", "b.x">,
                      cca::wire<Output, "c.x">> {};
static_assert(tells<far_from<"b.x">, far_from<"source.y">>(
    {"wire.direction", "b.x -> c.x",
     "a wire leads from an output to an input, but in `b.x` -> `c.x` in far_from<b.x> `b.x` is an input: "
     "name an output there"}));

struct to_output : khz<cca::node<"a", source<>>,
                       cca::node<"b", sink<>>,
                       cca::node<"c", source<>>,
                       cca::wire<"a.y", "b.x">,
                       cca::wire<"a.y", "c.y">> {};
struct to_output_mended : khz<cca::node<"a", source<>>,
                              cca::node<"b", sink<>>,
                              cca::node<"c", source<>>,
                              cca::wire<"a.y", "b.x">> {};
static_assert(tells<to_output, to_output_mended>(
    {"wire.direction", "a.y -> c.y",
     "a wire leads from an output to an input, but in `a.y` -> `c.y` in to_output `c.y` is an output: name "
     "an input there; did you mean `b.x`?"}));

struct unconnected : khz<cca::node<"a", source<>>, cca::node<"m", merge<>>, cca::wire<"a.y", "m.a">> {};
struct unconnected_mended : khz<cca::node<"a", source<>>,
                                cca::node<"m", merge<>>,
                                cca::wire<"a.y", "m.a">,
                                cca::expose<"m.b", "b">> {};
static_assert(tells<unconnected, unconnected_mended>(
    {"wire.unconnected_input", "m.b",
     "`m.b` is not connected: in unconnected, wire an output of signal (number over x) to `m.b`, or expose "
     "it, or make it a cca::optional_in"}));

struct unconnected_shown : khz<cca::node<"g", showing>> {};
struct unconnected_shown_mended
    : khz<cca::node<"g", showing>, cca::node<"a", source<>>, cca::wire<"a.y", "g.x">> {};
static_assert(tells<unconnected_shown, unconnected_shown_mended>(
    {"wire.unconnected_input", "g.in.x",
     "`g.in.x` is not connected: in unconnected_shown, wire an output of signal (number over x) to `g.x`, or "
     "expose it, or make it a cca::optional_in"}));

struct deeper : cca::graph<cca::node<"g", showing>, cca::expose<"g.x", "z">> {};

struct unconnected_deep : khz<cca::node<"h", deeper>> {};
struct unconnected_deep_mended
    : khz<cca::node<"h", deeper>, cca::node<"a", source<>>, cca::wire<"a.y", "h.z">> {};
static_assert(tells<unconnected_deep, unconnected_deep_mended>(
    {"wire.unconnected_input", "h.g.in.x",
     "`h.g.in.x` is not connected: in unconnected_deep, wire an output of signal (number over x) to `h.z`, "
     "or expose it, or make it a cca::optional_in"}));

struct unfinished : cca::graph<cca::node<"g", showing>, cca::node<"b", sink<>>, cca::wire<"g.y", "b.x">> {};

struct unconnected_inside : khz<cca::node<"h", unfinished>> {};
struct unconnected_inside_mended : khz<cca::node<"g", showing>, cca::expose<"g.x", "x">> {};
static_assert(tells<unconnected_inside, unconnected_inside_mended>(
    {"wire.unconnected_input", "h.g.in.x",
     "`h.g.in.x` is not connected: in unfinished, wire an output of signal (number over x) to `g.x`, or "
     "expose it, or make it a cca::optional_in"}));

}  // namespace
