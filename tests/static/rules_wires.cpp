// Rules about wires: what is told, and that the mended graph is sound.
#include <string>
#include <tuple>
#include <utility>

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

struct two_writers : khz<cca::node<"a", source<>>,
                         cca::node<"c", source<>>,
                         cca::node<"b", sink<>>,
                         cca::wire<"a.y", "b.x">,
                         cca::wire<"c.y", "b.x">> {};
struct two_writers_mended : khz<cca::node<"a", source<>>,
                                cca::node<"c", source<>>,
                                cca::node<"b", sink<>>,
                                cca::wire<"a.y", "b.x">> {};
static_assert(tells<two_writers, two_writers_mended>(
    {"wire.two_writers", "b.x",
     "`b.x` is written by `a.y` and by `c.y`, but an input has one writer: put an arbiter in front, "
     "cca::arbiter<`x`, signal, cca::by_priority<`first`, `second`>>, and wire each to an input of "
     "it; or, to read every sample of both, give each wire cca::merged<8>"}));

struct twice_wired : khz<cca::node<"a", source<>>,
                         cca::node<"b", sink<>>,
                         cca::wire<"a.y", "b.x">,
                         cca::wire<"a.y", "b.x">> {};
struct twice_wired_mended : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<twice_wired, twice_wired_mended>(
    {"wire.two_writers", "b.x", "`b.x` is written by `a.y` twice: remove one of the two wires"}));

struct fed : cca::graph<cca::node<"a", source<>>,
                        cca::node<"b", sink<>>,
                        cca::wire<"a.y", "b.x">,
                        cca::expose<"b.x", "x">> {};

struct two_writers_inside : khz<cca::node<"g", fed>, cca::node<"a", source<>>, cca::wire<"a.y", "g.x">> {};
struct two_writers_inside_mended : khz<cca::node<"g", fed>> {};
static_assert(tells<two_writers_inside, two_writers_inside_mended>(
    {"wire.two_writers", "g.b.x",
     "`g.b.x` is written by `a.y` and by `g.a.y`, but an input has one writer: put an arbiter in front, "
     "cca::arbiter<`x`, signal, cca::by_priority<`first`, `second`>>, and wire each to an input of "
     "it; or, to read every sample of both, give each wire cca::merged<8>"}));

struct initial_too_long
    : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x", cca::initial<1, 2, 3>>> {
};
struct initial_too_long_mended
    : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x", cca::initial<1>>> {};
static_assert(tells<initial_too_long, initial_too_long_mended>(
    {"wire.bad_initial", "a.y -> b.x",
     "cca::initial of the wire `a.y` -> `b.x` gives 3 numbers, but `b.x` has 1: give one for each, or one "
     "for all"}));

struct angles3 : cca::space<cca::joint_angles, cca::axes<hip, knee, toe>> {};

struct initial_too_short : khz<cca::node<"a", source<angles3>>,
                               cca::node<"b", sink<angles3>>,
                               cca::wire<"a.y", "b.x", cca::delayed<1>, cca::initial<1, 2>>> {};
struct initial_too_short_mended : khz<cca::node<"a", source<angles3>>,
                                      cca::node<"b", sink<angles3>>,
                                      cca::wire<"a.y", "b.x", cca::delayed<1>, cca::initial<1, 2, 3>>> {};
static_assert(tells<initial_too_short, initial_too_short_mended>(
    {"wire.bad_initial", "a.y -> b.x",
     "cca::initial of the wire `a.y` -> `b.x` gives 2 numbers, but `b.x` has 3: give one for each, or one "
     "for all"}));

struct torques : cca::space<cca::joint_torques, cca::axes<hip, knee>> {};

struct domain : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<torques>>, cca::wire<"a.y", "b.x">> {
};
struct domain_mended
    : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<angles>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<domain, domain_mended>(
    {"space.mismatch", "a.y -> b.x",
     "`a.y` publishes angles (joint_angles over hip, knee) but `b.x` expects torques (joint_torques over "
     "hip, knee): the domain types differ; put a mapping between them, or wire another port"}));

struct hip_angle : cca::space<cca::joint_angles, cca::axes<hip>> {};

struct axes : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<hip_angle>>, cca::wire<"a.y", "b.x">> {
};
struct axes_mended
    : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<angles>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<axes, axes_mended>(
    {"space.mismatch", "a.y -> b.x",
     "`a.y` publishes angles (joint_angles over hip, knee) but `b.x` expects hip_angle (joint_angles over "
     "hip): the axes differ; use a splitter or a collector, or give both ends one space"}));

struct other_order : cca::space<cca::joint_angles, cca::axes<knee, hip>> {};

struct order
    : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<other_order>>, cca::wire<"a.y", "b.x">> {};
struct order_mended
    : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<angles>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<order, order_mended>(
    {"space.mismatch", "a.y -> b.x",
     "`a.y` publishes angles (joint_angles over hip, knee) but `b.x` expects other_order (joint_angles over "
     "knee, hip): the axes are in another order; give both ends one space"}));

struct hip_frame {};
struct world_frame {};
struct foot_in_hip : cca::space<cca::cartesian_position<hip_frame>, cca::axes<cca::x, cca::z>> {};
struct foot_in_world : cca::space<cca::cartesian_position<world_frame>, cca::axes<cca::x, cca::z>> {};
struct same_foot : cca::space<cca::cartesian_position<hip_frame>, cca::axes<cca::x, cca::z>> {};

struct frame
    : khz<cca::node<"a", source<foot_in_hip>>, cca::node<"b", sink<foot_in_world>>, cca::wire<"a.y", "b.x">> {
};
struct frame_mended
    : khz<cca::node<"a", source<foot_in_hip>>, cca::node<"b", sink<same_foot>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<frame, frame_mended>(
    {"space.mismatch", "a.y -> b.x",
     "`a.y` publishes foot_in_hip (cartesian_position<hip_frame> over x, z) but `b.x` expects foot_in_world "
     "(cartesian_position<world_frame> over x, z): the frames differ; put a transformation between them"}));

struct fast : cca::space<cca::number, cca::axes<cca::x>, cca::rate<1000>> {};
struct slow : cca::space<cca::number, cca::axes<cca::x>, cca::rate<62.5>> {};

struct rate : khz<cca::node<"a", source<fast>>, cca::node<"b", sink<slow>>, cca::wire<"a.y", "b.x">> {};
struct rate_mended : khz<cca::node<"a", source<fast>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<rate, rate_mended>(
    {"space.mismatch", "a.y -> b.x",
     "`a.y` publishes fast (number over x at 1000 Hz) but `b.x` expects slow (number over x at 62.5 Hz): the "
     "rates differ; give both spaces one rate, or let one of them state none"}));

namespace elsewhere {
struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct angles : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
}  // namespace elsewhere

struct same_names
    : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<elsewhere::angles>>, cca::wire<"a.y", "b.x">> {
};
struct same_names_mended
    : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<angles>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<same_names, same_names_mended>(
    {"space.mismatch", "a.y -> b.x",
     "`a.y` publishes angles (joint_angles over hip, knee) but `b.x` expects angles (joint_angles over hip, "
     "knee): their domain types, axes or frames have the same names but are different types; use those of "
     "one namespace"}));

struct inner_space : khz<cca::node<"g", showing>,
                         cca::node<"b", sink<angles>>,
                         cca::node<"a", source<>>,
                         cca::wire<"a.y", "g.x">,
                         cca::wire<"g.y", "b.x">> {};
struct inner_space_mended : khz<cca::node<"g", showing>,
                                cca::node<"b", sink<>>,
                                cca::node<"a", source<>>,
                                cca::wire<"a.y", "g.x">,
                                cca::wire<"g.y", "b.x">> {};
static_assert(tells<inner_space, inner_space_mended>(
    {"space.mismatch", "g.y -> b.x",
     "`g.out.y` (exposed as `g.y`) publishes signal (number over x) but `b.x` expects angles (joint_angles "
     "over hip, knee): the domain types differ; put a mapping between them, or wire another port"}));

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

struct toe_angle : cca::space<cca::joint_angles, cca::axes<hip, toe>> {};

struct no_limits : khz<cca::node<"a", source<toe_angle>>,
                       cca::node<"l", cca::limiter<toe_angle>>,
                       cca::node<"r", robot<toe_angle>>,
                       cca::wire<"a.y", "l.command">,
                       cca::wire<"l.safe", "r.command">> {};
struct no_limits_mended : khz<cca::node<"a", source<angles>>,
                              cca::node<"l", cca::limiter<angles>>,
                              cca::node<"r", robot<>>,
                              cca::wire<"a.y", "l.command">,
                              cca::wire<"l.safe", "r.command">> {};
static_assert(tells<no_limits, no_limits_mended>(
    {"space.missing_limits", "l.command",
     "`l.command` takes commands of toe_angle, but its axis `toe` states no limits of angle to keep them "
     "within: add `static constexpr auto limits = cca::limits{cca::angle{lower, upper}};` to it"}));

struct no_limits_of_torque : khz<cca::node<"a", source<torques>>,
                                 cca::node<"r", robot<torques>>,
                                 cca::node<"u", cca::unlimited<torques>>,
                                 cca::wire<"a.y", "u.command">,
                                 cca::wire<"u.safe", "r.command">> {};
struct no_limits_of_torque_mended : khz<cca::node<"a", source<angles>>,
                                        cca::node<"u", cca::unlimited<angles>>,
                                        cca::node<"r", robot<>>,
                                        cca::wire<"a.y", "u.command">,
                                        cca::wire<"u.safe", "r.command">> {};
static_assert(tells<no_limits_of_torque, no_limits_of_torque_mended>(
    {"space.missing_limits", "r.command",
     "`r.command` takes commands of torques, but its axis `hip` states no limits of torque to keep them "
     "within: add `static constexpr auto limits = cca::limits{cca::torque{lower, upper}};` to it"}));

struct unlimited
    : khz<cca::node<"a", source<angles>>, cca::node<"r", robot<>>, cca::wire<"a.y", "r.command">> {};
struct unlimited_mended : khz<cca::node<"a", source<angles>>,
                              cca::node<"u", cca::unlimited<angles>>,
                              cca::node<"r", robot<>>,
                              cca::wire<"a.y", "u.command">,
                              cca::wire<"u.safe", "r.command">> {};
static_assert(tells<unlimited, unlimited_mended>(
    {"robot.unlimited_command", "a.y -> r.command",
     "`a.y` reaches the actuator `r.command` without passing a limiter: put a cca::limiter<angles> between "
     "them (its input is `command`, its output `safe`), or a cca::unlimited where that is meant"}));

struct unlimited_behind : khz<cca::node<"a", source<angles>>,
                              cca::node<"l", cca::limiter<angles>>,
                              cca::node<"s", step<angles>>,
                              cca::node<"r", robot<>>,
                              cca::wire<"a.y", "l.command">,
                              cca::wire<"l.safe", "s.x">,
                              cca::wire<"s.y", "r.command">> {};
struct unlimited_behind_mended : khz<cca::node<"a", source<angles>>,
                                     cca::node<"l", cca::limiter<angles>>,
                                     cca::node<"s", cca::splitter<"angles", angles>>,
                                     cca::node<"c", cca::collector<"angles", angles>>,
                                     cca::node<"r", robot<>>,
                                     cca::wire<"a.y", "l.command">,
                                     cca::wire<"l.safe", "s.angles">,
                                     cca::wire<"s.hip", "c.hip">,
                                     cca::wire<"s.knee", "c.knee">,
                                     cca::wire<"c.angles", "r.command">> {};
static_assert(tells<unlimited_behind, unlimited_behind_mended>(
    {"robot.unlimited_command", "s.y -> r.command",
     "`s.y` reaches the actuator `r.command` without passing a limiter: put a cca::limiter<angles> between "
     "them (its input is `command`, its output `safe`), or a cca::unlimited where that is meant"}));

struct unlimited_measured : khz<cca::node<"r", robot<>>, cca::wire<"r.measured", "r.command">> {};
struct unlimited_measured_mended : khz<cca::node<"r", robot<>>,
                                       cca::node<"l", cca::limiter<angles>>,
                                       cca::wire<"r.measured", "l.command">,
                                       cca::wire<"l.safe", "r.command">> {};
static_assert(tells<unlimited_measured, unlimited_measured_mended>(
    {"robot.unlimited_command", "r.measured -> r.command",
     "`r.measured` reaches the actuator `r.command` without passing a limiter: put a cca::limiter<angles> "
     "between them (its input is `command`, its output `safe`), or a cca::unlimited where that is meant"}));

struct limited_later : khz<cca::node<"a", source<angles>, cca::timed<10, 9>>,
                           cca::node<"l", cca::limiter<angles>>,
                           cca::node<"r", robot<>>,
                           cca::wire<"a.y", "l.command">,
                           cca::wire<"l.safe", "r.command", cca::latest, cca::initial<0.5, 0.5>>> {};
struct limited_later_mended : khz<cca::node<"a", source<angles>, cca::timed<10, 9>>,
                                  cca::node<"l", cca::limiter<angles>>,
                                  cca::node<"r", robot<>>,
                                  cca::wire<"a.y", "l.command">,
                                  cca::wire<"l.safe", "r.command", cca::latest, cca::initial<0.5, -0.5>>> {};
static_assert(tells<limited_later, limited_later_mended>(
    {"robot.unlimited_command", "l.safe -> r.command",
     "`r.command` may be read before a first command has passed a limiter, and would then hold the "
     "cca::initial of its wire, which lies outside of the limits of `knee`, on its way to the actuator: give "
     "the wire a cca::initial<...> within them"}));

// Never read, and so no matter.
struct limited_at_once : khz<cca::node<"a", source<angles>>,
                             cca::node<"l", cca::limiter<angles>>,
                             cca::node<"r", robot<>>,
                             cca::wire<"a.y", "l.command">,
                             cca::wire<"l.safe", "r.command", cca::initial<0.5, 0.5>>> {};
static_assert(cca::well_formed<limited_at_once>);

struct no_option
    : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x", cca::timed<2>>> {};
struct no_option_mended : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<no_option, no_option_mended>(
    {"wire.bad_option", "a.y -> b.x",
     "the wire `a.y` -> `b.x` has the option `timed<2>`, which is no option of a wire: it may have a policy "
     "(cca::latest, cca::delayed<N>, cca::queue<C, F>, cca::merged<C, F>) and a cca::initial<...>"}));

struct two_policies : khz<cca::node<"a", source<>>,
                          cca::node<"b", sink<>>,
                          cca::wire<"a.y", "b.x", cca::delayed<1>, cca::latest>> {};
struct two_policies_mended
    : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x", cca::delayed<1>>> {};
static_assert(tells<two_policies, two_policies_mended>(
    {"wire.bad_option", "a.y -> b.x",
     "the wire `a.y` -> `b.x` has two policies or two initial values: leave one of each (only a "
     "cca::delayed may stand beside a cca::queue or a cca::merged)"}));

struct two_initials : khz<cca::node<"a", source<>>,
                          cca::node<"b", sink<>>,
                          cca::wire<"a.y", "b.x", cca::initial<1>, cca::initial<2>>> {};
struct two_initials_mended : khz<cca::node<"a", source<>>,
                                 cca::node<"b", sink<>>,
                                 cca::wire<"a.y", "b.x", cca::latest, cca::initial<2>>> {};
static_assert(tells<two_initials, two_initials_mended>(
    {"wire.bad_option", "a.y -> b.x",
     "the wire `a.y` -> `b.x` has two policies or two initial values: leave one of each (only a "
     "cca::delayed may stand beside a cca::queue or a cca::merged)"}));

struct lossless_queue : khz<cca::node<"a", source<>>,
                            cca::node<"b", sink<>>,
                            cca::wire<"a.y", "b.x", cca::queue<2, cca::latest>>> {};
struct lossless_queue_mended : khz<cca::node<"a", source<>>,
                                   cca::node<"b", sink<>>,
                                   cca::wire<"a.y", "b.x", cca::queue<2, cca::reject>>> {};
static_assert(tells<lossless_queue, lossless_queue_mended>(
    {"wire.bad_option", "a.y -> b.x",
     "the wire `a.y` -> `b.x` has a queue with `latest`, which does not say what a full queue loses: write "
     "cca::drop_oldest, cca::drop_newest or cca::reject"}));

template <class Policy>
struct with_policy : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x", Policy>> {
};
static_assert(tells<with_policy<cca::delayed<0>>, with_policy<cca::delayed<1>>>(
    {"wire.bad_option", "a.y -> b.x",
     "the wire `a.y` -> `b.x` has a delay of 0: write at least 1, or cca::latest instead"}));
static_assert(
    tells<with_policy<cca::queue<0, cca::drop_oldest>>, with_policy<cca::queue<1, cca::drop_oldest>>>(
        {"wire.bad_option", "a.y -> b.x",
         "the wire `a.y` -> `b.x` has a queue of 0: write at least 1, or cca::latest instead"}));
static_assert(cca::diagnosis<with_policy<cca::delayed<-1>>>.rule == "wire.bad_option");
static_assert(tells<with_policy<cca::merged<0>>, with_policy<cca::merged<1>>>(
    {"wire.bad_option", "a.y -> b.x",
     "the wire `a.y` -> `b.x` has a queue of 0: write at least 1, or cca::latest instead"}));

// Which policies go together, in any order.
template <class... Policies>
struct with_policies
    : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x", Policies...>> {};
static_assert(cca::well_formed<with_policies<cca::delayed<2>, cca::queue<3>>>);
static_assert(cca::well_formed<with_policies<cca::queue<3, cca::drop_newest>, cca::delayed<2>>>);
static_assert(cca::well_formed<with_policies<cca::merged<3>, cca::initial<1>, cca::delayed<2>>>);
template <class... Policies>
inline constexpr bool is_bad_option =
    cca::diagnosis<with_policies<Policies...>>.rule == std::string_view("wire.bad_option");
static_assert(is_bad_option<cca::queue<3>, cca::queue<3>>);
static_assert(is_bad_option<cca::queue<3>, cca::merged<3>>);
static_assert(is_bad_option<cca::merged<3>, cca::latest>);
static_assert(is_bad_option<cca::latest, cca::queue<3>>);
static_assert(is_bad_option<cca::delayed<1>, cca::delayed<1>>);
static_assert(is_bad_option<cca::delayed<1>, cca::queue<3>, cca::delayed<1>>);
static_assert(is_bad_option<cca::queue<3>, cca::delayed<1>, cca::queue<3>>);
static_assert(is_bad_option<cca::delayed<0>, cca::queue<3>>);
static_assert(is_bad_option<cca::delayed<1>, cca::queue<0>>);

// Several wires at one input.
template <class A, class C, class... Delay>
struct merging : khz<cca::node<"a", source<>>,
                     cca::node<"c", source<>>,
                     cca::node<"b", sink<>>,
                     cca::wire<"a.y", "b.x", A>,
                     cca::wire<"c.y", "b.x", C, Delay...>> {};
static_assert(cca::well_formed<merging<cca::merged<4>, cca::merged<4>, cca::delayed<2>>>);
static_assert(tells<merging<cca::merged<4>, cca::merged<5>>, merging<cca::merged<4>, cca::merged<4>>>(
    {"wire.two_writers", "b.x",
     "`b.x` is written by `a.y` and by `c.y`, one by cca::merged<4, cca::drop_oldest> and one by "
     "cca::merged<5, cca::drop_oldest>, but wires that are merged at an input lead into one queue: give each "
     "of them the same cca::merged<C, F> (a cca::delayed<N> beside it may differ)"}));
static_assert(tells<merging<cca::queue<4>, cca::merged<4, cca::reject>>,
                    merging<cca::merged<4>, cca::merged<4>>>(
    {"wire.two_writers", "b.x",
     "`b.x` is written by `a.y` and by `c.y`, one not merged and one by cca::merged<4, cca::reject>, but "
     "wires that are merged at an input lead into one queue: give each of them the same cca::merged<C, F> "
     "(a cca::delayed<N> beside it may differ)"}));
static_assert(cca::diagnosis<merging<cca::merged<4>, cca::merged<4, cca::drop_newest>>>.rule ==
              std::string_view("wire.two_writers"));

struct merged_twice : khz<cca::node<"a", source<>>,
                          cca::node<"b", sink<>>,
                          cca::wire<"a.y", "b.x", cca::merged<4>>,
                          cca::wire<"a.y", "b.x", cca::merged<4>>> {};
struct merged_twice_mended : khz<cca::node<"a", source<>>,
                                 cca::node<"b", sink<>>,
                                 cca::wire<"a.y", "b.x", cca::merged<4>>,
                                 cca::wire<"a.y", "b.x", cca::merged<4>, cca::delayed<3>>> {};
static_assert(tells<merged_twice, merged_twice_mended>(
    {"wire.two_writers", "b.x", "`b.x` is written by `a.y` twice: remove one of the two wires"}));

template <class... Initial>
struct merged_initials : khz<cca::node<"a", source<>>,
                             cca::node<"c", source<>>,
                             cca::node<"b", sink<>>,
                             cca::wire<"a.y", "b.x", cca::merged<4>, cca::initial<1>>,
                             cca::wire<"c.y", "b.x", cca::merged<4>, Initial...>> {};
static_assert(tells<merged_initials<cca::initial<2>>, merged_initials<>>(
    {"wire.bad_initial", "c.y -> b.x",
     "`b.x` gets an initial value from two of the wires that are merged there, and they differ: leave the "
     "cca::initial of one of them"}));
static_assert(cca::well_formed<merged_initials<cca::initial<1>>>);

// Every command that is merged passes a limiter.
template <cca::fixed_string Second>
struct merged_commands : khz<cca::node<"a", source<angles>>,
                             cca::node<"c", source<angles>>,
                             cca::node<"l", cca::limiter<angles>>,
                             cca::node<"r", robot<>>,
                             cca::node<"s", sink<angles>>,
                             cca::wire<"c.y", "s.x">,
                             cca::wire<"a.y", "l.command">,
                             cca::wire<"l.safe", "r.command", cca::merged<2>>,
                             cca::wire<Second, "r.command", cca::merged<2>, cca::delayed<1>>> {};
static_assert(cca::diagnosis<merged_commands<"c.y">>.rule == std::string_view("robot.unlimited_command"));
static_assert(cca::diagnosis<merged_commands<"c.y">>.where == std::string_view("c.y -> r.command"));
static_assert(cca::well_formed<merged_commands<"l.safe">>);

}  // namespace
