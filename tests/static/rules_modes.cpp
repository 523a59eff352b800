// Rules about sets of modes, alone and deployed: the message of each mistake, and that the mended one is
// sound.
#include <utility>

#include <cca/deployment.hpp>
#include <cca/modes.hpp>

#include "rules_parts.hpp"

namespace {

using namespace parts;

struct walk : khz<cca::node<"a", source<>>> {};
struct rest : khz<cca::node<"b", source<>>> {};
struct fall : khz<cca::node<"c", source<>>> {};
struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"rest", rest>> {};

// ---- modes.bad_mode ----

struct alone : cca::modes<cca::mode<"walk", walk>> {};
static_assert(tells<alone, legs>(
    {"modes.bad_mode", "alone",
     "alone has 1 mode, so there is nothing to switch to: write two or more, cca::mode<`name`, graph>, or "
     "run the graph by itself in a cca::controller"}));
template <std::size_t>
using one_more = cca::mode<"walk", walk>;
template <std::size_t... I>
cca::modes<one_more<I>...> as_many(std::index_sequence<I...>);
struct crowd : decltype(as_many(std::make_index_sequence<65>())){};
static_assert(tells<crowd, legs>({"modes.bad_mode", "crowd",
                                  "crowd has 65 modes, but it may have at most 64: make it smaller"}));
struct with_graph : cca::modes<cca::mode<"walk", walk>, rest> {};
static_assert(tells<with_graph, legs>(
    {"modes.bad_mode", "with_graph",
     "`rest` in with_graph is no mode, so it would be ignored: write cca::mode<`name`, graph>"}));
struct deployed_walk : cca::deployment<walk, cca::environment<"all", cca::other_nodes>> {};
struct with_deployment : cca::modes<cca::mode<"walk", deployed_walk>, cca::mode<"rest", rest>> {};
static_assert(tells<with_deployment, legs>(
    {"modes.bad_mode", "with_deployment",
     "mode `walk` of with_deployment is a deployment, whose environments would be ignored: give its "
     "architecture instead, walk"}));
struct with_set : cca::modes<cca::mode<"legs", legs>, cca::mode<"fall", fall>> {};
struct with_all : cca::modes<cca::mode<"walk", walk>, cca::mode<"rest", rest>, cca::mode<"fall", fall>> {};
static_assert(tells<with_set, with_all>(
    {"modes.bad_mode", "with_set",
     "mode `legs` of with_set is a set of modes, legs, but one set holds all modes: list its modes in "
     "with_set instead of it"}));
struct same_name : cca::modes<cca::mode<"walk", walk>, cca::mode<"walk", rest>> {};
static_assert(tells<same_name, legs>(
    {"modes.bad_mode", "same_name",
     "two modes of same_name are named `walk`, so to switch to it has two meanings: give one another name"}));
struct unnamed : cca::modes<cca::mode<"", walk>, cca::mode<"rest", rest>> {};
static_assert(
    tells<unnamed, legs>({"modes.bad_mode", "unnamed",
                          "a mode of unnamed has no name, so nothing could switch to it: give it one"}));
struct dotted : cca::modes<cca::mode<"legs.walk", walk>, cca::mode<"rest", rest>> {};
static_assert(tells<dotted, legs>(
    {"modes.bad_mode", "dotted",
     "a mode of dotted is named `legs.walk`, but dots join names to paths, and `*` stands for any name: "
     "use neither in a name"}));

// The first mistake of a deployment of a mistaken set is that of the set.
struct deployed_set : cca::deployment<with_set, cca::environment<"one", cca::other_nodes>> {};
static_assert(cca::diagnosis<deployed_set>.message == cca::diagnosis<with_set>.message);

// ---- a set of modes as a node ----

struct with_legs : khz<cca::node<"legs", legs>> {};
struct with_walk : khz<cca::node<"legs", walk>> {};
static_assert(tells<with_legs, with_walk>(
    {"component.no_process", "legs",
     "`legs` (legs) is a set of modes, which is no node: a mode holds the whole architecture, so put the "
     "other nodes of with_legs into its modes, and give the set to a controller or a deployment"}));

// ---- a mistake in one mode ----

template <class First, class Second>
struct either : cca::modes<cca::mode<"first", First>, cca::mode<"second", Second>> {};

struct unwired : khz<cca::node<"a", source<>>, cca::node<"s", step<>>> {};
struct wired : khz<cca::node<"a", source<>>, cca::node<"s", step<>>, cca::wire<"a.y", "s.x">> {};
static_assert(tells<either<rest, unwired>, either<rest, wired>>(
    {"wire.unconnected_input", "s.x",
     "`s.x` is not connected: in unwired, wire an output of signal (number over x) to `s.x`, or expose "
     "it, or make it a cca::optional_in"}));

// ---- what the modes of a set share: the beat, the robot, the types, the commands ----

struct slow : cca::graph<cca::rate<500>, cca::node<"b", source<>>> {};
static_assert(tells<either<walk, slow>, either<walk, rest>>(
    {"modes.two_rates", "either<walk, slow>",
     "mode `first` of either<walk, slow> runs at 1000 Hz but mode `second` at 500 Hz: all modes share the "
     "beat, so give both graphs the same cca::rate<...>, and what is slower a cca::timed<N>"}));

struct other_walk : khz<cca::node<"a", source<angles>>> {};
static_assert(tells<either<walk, other_walk>, either<walk, walk>>(
    {"modes.two_types", "a",
     "`a` is source<> in mode `first` but source<parts::angles> in mode `second`: modes share what is at "
     "a path, its state and its parameters, so give one of them another name"}));

struct measuring {
  auto sense() -> cca::out<"measured", signal> { return {}; }
};
struct measuring_at_times {
  auto sense() -> cca::maybe<"measured", signal> { return {}; }
};
template <class Leg>
struct body : cca::graph<cca::node<"leg", Leg>, cca::expose<"leg.measured", "measured">> {};
template <class Leg>
struct watching
    : khz<cca::node<"robot", body<Leg>>, cca::node<"s", sink<>>, cca::wire<"robot.measured", "s.x">> {};
static_assert(tells<either<watching<measuring>, watching<measuring_at_times>>,
                    either<watching<measuring>, watching<measuring>>>(
    {"modes.two_types", "robot.leg",
     "`robot.leg` is measuring in mode `first` but measuring_at_times in mode `second`: the modes of a "
     "set run on one robot, so give it one type in all of them"}));
static_assert(tells<either<watching<measuring>, walk>, either<watching<measuring>, watching<measuring>>>(
    {"modes.missing_robot", "robot.leg",
     "the resource node `robot.leg` (measuring) is in mode `first` but not in mode `second`, so after a "
     "switch nothing would command it or go on stopping it: put it into every mode, under the same path"}));

template <cca::fixed_string Limits, class... Policy>
struct moving : khz<cca::node<"a", source<angles>>,
                    cca::node<"l", cca::limiter<angles>>,
                    cca::node<"m", cca::limiter<angles>>,
                    cca::node<"r", robot<>>,
                    cca::wire<"a.y", "l.command">,
                    cca::wire<"a.y", "m.command">,
                    cca::wire<Limits, "r.command", Policy...>> {};
static_assert(tells<either<moving<"l.safe">, moving<"m.safe">>, either<moving<"l.safe">, moving<"l.safe">>>(
    {"modes.command_jumps", "r.command",
     "`r.command` gets its commands from `l.safe` in mode `first` but from `m.safe` in mode `second`, so "
     "at a switch they could jump: put one cca::limiter in front of it that both modes have, of the same "
     "path and type; it goes on from its last command, at most at the rates of the axes"}));
static_assert(tells<either<moving<"l.safe">, moving<"l.safe", cca::delayed<20>>>,
                    either<moving<"l.safe", cca::delayed<20>>, moving<"l.safe", cca::delayed<20>>>>(
    {"modes.command_jumps", "r.command",
     "`r.command` gets its commands from `l.safe` in mode `first` and in mode `second`, but by wires of "
     "different delay or queue, so at a switch they could jump: give both wires the same policy"}));

struct patient_robot {
  void act(cca::optional_in<"command", angles>) {}
};
template <class... Wire>
struct driven : khz<cca::node<"a", source<angles>>,
                    cca::node<"l", cca::limiter<angles>>,
                    cca::node<"r", patient_robot>,
                    cca::wire<"a.y", "l.command">,
                    Wire...> {};
struct driven_by_limiter : driven<cca::wire<"l.safe", "r.command">> {};
static_assert(tells<either<driven_by_limiter, driven<>>, either<driven_by_limiter, driven_by_limiter>>(
    {"modes.command_jumps", "r.command",
     "`r.command` gets its commands from `l.safe` in mode `first` but from nothing in mode `second`, so "
     "at a switch they could jump: put one cca::limiter in front of it that both modes have, of the same "
     "path and type; it goes on from its last command, at most at the rates of the axes"}));

// ---- what components ask of modes ----

template <cca::fixed_string Mode>
struct falling {
  auto process(cca::beat) -> cca::switch_to<Mode> { return true; }
};
template <cca::fixed_string Mode>
struct leading : khz<cca::node<"f", falling<Mode>>> {};
static_assert(tells<either<leading<"secnod">, rest>, either<leading<"second">, rest>>(
    {"modes.unknown_mode", "f",
     "`f` (falling<secnod>) returns a cca::switch_to<`secnod`>, but either<leading<secnod>, rest> has no "
     "such mode; did you mean `second`?"}));

static_assert(tells<either<leading<"elsewhere">, rest>, either<leading<"second">, rest>>(
    {"modes.unknown_mode", "f",
     "`f` (falling<elsewhere>) returns a cca::switch_to<`elsewhere`>, but either<leading<elsewhere>, "
     "rest> has no such mode: ask for one of its modes, or add a mode of this name"}));

struct orders {
  auto process(cca::beat) -> cca::stops<"a"> { return true; }
};
template <class... Strategy>
struct ordered : khz<cca::node<"o", orders>, cca::node<"a", source<>, Strategy...>> {};
static_assert(tells<either<ordered<cca::stoppable<>>, walk>,
                    either<ordered<cca::stoppable<>>, khz<cca::node<"a", source<>, cca::stoppable<>>>>>(
    {"part.unknown_path", "o",
     "`o` (orders) stops or starts `a`, but not every mode that has this node lets it be stopped: give it "
     "cca::stoppable<...> in all of them"}));

// ---- deployments of modes ----

template <class... Options>
struct crossing : khz<cca::node<"a", source<>>, cca::node<"s", sink<>>, cca::wire<"a.y", "s.x", Options...>> {
};
template <class Mode>
struct both : either<walk, Mode> {};
template <cca::fixed_string Name, cca::fixed_string... Paths>
using some = cca::environment<Name, cca::nodes<Paths...>>;
template <class Mode, class... Environments>
struct deployed : cca::deployment<both<Mode>, Environments...> {};

struct delayed : crossing<cca::delayed<1>> {};
struct misspelt : cca::deployment<both<delayed>, some<"here", "aa">, some<"there", "s">> {};
struct placed : cca::deployment<both<delayed>, some<"here", "a">, some<"there", "s">> {};
static_assert(tells<misspelt, placed>(
    {"deployment.unknown_node", "aa",
     "environment `here` names `aa`, but no mode of misspelt has such a node; did you mean `a`?"}));
// The names of all modes count: `thinker` is only in the second one.
struct thinking : khz<cca::node<"thinker", source<>>> {};
struct misspelt_in_second
    : cca::deployment<either<delayed, thinking>, some<"here", "a", "thinkr">, some<"there", "s">> {};
struct placed_in_second
    : cca::deployment<either<delayed, thinking>, some<"here", "a", "thinker">, some<"there", "s">> {};
static_assert(tells<misspelt_in_second, placed_in_second>(
    {"deployment.unknown_node", "thinkr",
     "environment `here` names `thinkr`, but no mode of misspelt_in_second has such a node; did you mean "
     "`thinker`?"}));
struct unplaced : cca::deployment<either<delayed, rest>, some<"here", "a">, some<"there", "s">> {};
struct all_placed : cca::deployment<either<delayed, rest>, some<"here", "a">, some<"there", "s", "b">> {};
static_assert(tells<unplaced, all_placed>(
    {"deployment.unplaced", "b",
     "`b` (source<>) of mode `second` runs in no environment of unplaced: add its path to the "
     "cca::nodes<...> of one of them, or give one cca::other_nodes"}));
struct twice : cca::deployment<both<delayed>, some<"here", "a", "s">, some<"there", "s">> {};
static_assert(tells<twice, placed>(
    {"deployment.placed_twice", "s",
     "`s` (sink<>) of mode `second` runs in environment `here` and in environment `there`: a component "
     "runs in one environment; remove it from one of the two (the path of an inner graph names all its "
     "components)"}));
struct undelayed : cca::deployment<both<crossing<>>, some<"here", "a">, some<"there", "s">> {};
static_assert(tells<undelayed, placed>(
    {"deployment.undelayed", "a.y -> s.x",
     "`a.y` of mode `second` is published in environment `here` and read in environment `there`, so it "
     "takes at least a beat to get there: write cca::wire<`a.y`, `s.x`, cca::delayed<1>>, or a greater "
     "delay, or place both in one environment"}));

template <class... Strategy>
struct logged : khz<cca::node<"a", source<>>, cca::node<"s", sink<>, Strategy...>, cca::wire<"a.y", "s.x">> {
};
template <class... Strategy>
struct beside : cca::deployment<both<logged<Strategy...>>,
                                some<"here", "a">,
                                cca::environment<"log", cca::other_nodes, cca::free_running>> {};
static_assert(tells<beside<>, beside<cca::full_speed>>(
    {"deployment.free_running", "s",
     "`s` (sink<>) of mode `second` runs in environment `log`, whose cycles begin without pause, but its "
     "strategy is restless: write cca::node<`s`, sink<>, cca::full_speed>, or place it in another "
     "environment"}));

}  // namespace
