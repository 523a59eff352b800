// Rules about deployments: the message of each mistake, and that the mended one is sound.
#include <cca/deployment.hpp>

#include "rules_parts.hpp"

namespace {

using namespace parts;

struct chain : khz<cca::node<"a", source<>>,
                   cca::node<"b", step<>>,
                   cca::node<"c", sink<>>,
                   cca::wire<"a.y", "b.x", cca::delayed<1>>,
                   cca::wire<"b.y", "c.x", cca::delayed<2>>> {};

template <cca::fixed_string Name, cca::fixed_string... Paths>
using some = cca::environment<Name, cca::nodes<Paths...>>;
template <cca::fixed_string Name>
using rest = cca::environment<Name, cca::other_nodes>;

struct mended : cca::deployment<chain, some<"one", "a">, rest<"two">> {};
struct mended_too : cca::deployment<chain, cca::tolerate<0>, rest<"two">, some<"one", "a", "b", "a">> {};
static_assert(cca::well_formed<mended_too>);
static_assert(cca::detail::environments_of<mended>::tolerated == 3);
static_assert(cca::detail::environments_of<mended_too>::tolerated == 0);

// ---- deployment.unknown_node, unplaced, placed_twice ----

struct misspelt : cca::deployment<chain, some<"one", "aa">, rest<"two">> {};
static_assert(
    tells<misspelt, mended>({"deployment.unknown_node", "aa",
                             "environment `one` names `aa`, but chain has no such node; did you mean `a`?"}));
struct misnamed : cca::deployment<chain, some<"one", "a.y.z.w">, rest<"two">> {};
static_assert(tells<misnamed, mended>({"deployment.unknown_node", "a.y.z.w",
                                       "environment `one` names `a.y.z.w`, but chain has no such node: write "
                                       "the path of a component or of an inner graph, as in `skills.gait`"}));

struct forgotten : cca::deployment<chain, some<"one", "a">> {};
static_assert(
    tells<forgotten, mended>({"deployment.unplaced", "b",
                              "`b` (step<>) runs in no environment of forgotten: add its path to the "
                              "cca::nodes<...> of this environment, or give one cca::other_nodes"}));
struct forgotten_of_two : cca::deployment<chain, some<"one", "a">, some<"two", "b">> {};
static_assert(
    tells<forgotten_of_two, mended>({"deployment.unplaced", "c",
                                     "`c` (sink<>) runs in no environment of forgotten_of_two: add its path "
                                     "to the cca::nodes<...> of one of them, or give one cca::other_nodes"}));

struct twice : cca::deployment<chain, some<"one", "a">, some<"two", "a", "b", "c">> {};
static_assert(
    tells<twice, mended>({"deployment.placed_twice", "a",
                          "`a` (source<>) runs in environment `one` and in environment `two`: a component "
                          "runs in one environment; remove it from one of the two (the path of an inner "
                          "graph names all its components)"}));
struct others_twice : cca::deployment<chain, rest<"one">, rest<"two">> {};
static_assert(
    tells<others_twice, mended>({"deployment.placed_twice", "two",
                                 "cca::other_nodes stands in environment `one` and in environment `two`, so "
                                 "these components would run twice: keep it in one of them, and name the "
                                 "nodes of the other"}));

template <cca::fixed_string... Placed>
struct logging : cca::deployment<khz<cca::node<"a", source<>>, cca::node<"log", chain>>,
                                 some<"one", "a", "log.a">,
                                 some<"two", Placed...>> {};
static_assert(tells<logging<"log">, logging<"log.b", "log.c">>(
    {"deployment.placed_twice", "log.a",
     "`log.a` (source<>) runs in environment `one` and in environment `two`: a component runs in one "
     "environment; remove it from one of the two (the path of an inner graph names all its components)"}));

// ---- deployment.free_running ----

template <class... Strategy>
struct free_chain
    : khz<cca::node<"a", source<>>, cca::node<"b", sink<>, Strategy...>, cca::wire<"a.y", "b.x">> {};
using in_step = some<"one", "a">;
using without_step = cca::environment<"two", cca::other_nodes, cca::free_running>;
struct free_and_full : cca::deployment<free_chain<cca::full_speed>, in_step, without_step> {};
struct free_and_restless : cca::deployment<free_chain<>, in_step, without_step> {};
static_assert(tells<free_and_restless, free_and_full>(
    {"deployment.free_running", "b",
     "`b` (sink<>) runs in environment `two`, whose cycles begin without pause, but its strategy is "
     "restless: write cca::node<`b`, sink<>, cca::full_speed>, or place it in another environment"}));
template <class Strategy>
struct free_and_stoppable : cca::deployment<free_chain<cca::stoppable<Strategy>>, in_step, without_step> {};
static_assert(tells<free_and_stoppable<cca::restless>, free_and_stoppable<cca::full_speed>>(
    {"deployment.free_running", "b",
     "`b` (sink<>) runs in environment `two`, whose cycles begin without pause, but its strategy is "
     "restless: write cca::node<`b`, sink<>, cca::stoppable<cca::full_speed>>, or place it in another "
     "environment"}));
struct free_first : cca::deployment<free_chain<cca::full_speed>, without_step, in_step> {};
static_assert(tells<free_first, free_and_full>(
    {"deployment.free_running", "two",
     "environment `two` is the first of free_first, which gives the beat, but a cca::free_running one has "
     "none: put the environment of the robot before it"}));

// ---- deployment.undelayed ----

template <class... Options>
struct undelayed_chain
    : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x", Options...>> {};
template <class... Options>
struct undelayed : cca::deployment<undelayed_chain<Options...>, some<"one", "a">, rest<"two">> {};
static_assert(tells<undelayed<cca::latest>, undelayed<cca::delayed<1>>>(
    {"deployment.undelayed", "a.y -> b.x",
     "`a.y` is published in environment `one` and read in environment `two`, so it takes at least a beat to "
     "get there: write cca::wire<`a.y`, `b.x`, cca::delayed<1>>, or a greater delay, or place both in one "
     "environment"}));
static_assert(tells<undelayed<cca::queue<2, cca::drop_oldest>>,
                    undelayed<cca::queue<2, cca::drop_oldest>, cca::delayed<1>>>(
    {"deployment.undelayed", "a.y -> b.x",
     "`a.y` is published in environment `one` and read in environment `two`, so it takes at least a beat to "
     "get there: write cca::wire<`a.y`, `b.x`, cca::delayed<1>, cca::queue<2, cca::drop_oldest>>, or a "
     "greater "
     "delay, or place both in one environment"}));

// All in `two` is full_speed, so it can run freely.
struct waits_for_beats : cca::deployment<free_chain<cca::full_speed>, in_step, rest<"two">> {};
static_assert(tells<waits_for_beats, free_and_full>(
    {"deployment.undelayed", "a.y -> b.x",
     "`a.y` is published in environment `one` and read in environment `two`, so it takes at least a beat to "
     "get there: write cca::wire<`a.y`, `b.x`, cca::delayed<1>>, or a greater delay, or place both in one "
     "environment, or give environment `two` cca::free_running, because all that it runs is "
     "cca::full_speed: then its wires need no delay"}));

// Wires that are merged: each that crosses is delayed.
template <class... Delay>
struct undelayed_merge : khz<cca::node<"a", source<>>,
                             cca::node<"c", source<>>,
                             cca::node<"b", sink<>>,
                             cca::wire<"c.y", "b.x", cca::merged<2, cca::drop_newest>>,
                             cca::wire<"a.y", "b.x", cca::merged<2, cca::drop_newest>, Delay...>> {};
template <class... Delay>
struct merging : cca::deployment<undelayed_merge<Delay...>, some<"one", "a">, rest<"two">> {};
static_assert(tells<merging<>, merging<cca::delayed<1>>>(
    {"deployment.undelayed", "a.y -> b.x",
     "`a.y` is published in environment `one` and read in environment `two`, so it takes at least a beat to "
     "get there: write cca::wire<`a.y`, `b.x`, cca::delayed<1>, cca::merged<2, cca::drop_newest>>, or a "
     "greater delay, or place both in one environment"}));

template <class... Policy>
struct hearing {
  void process(cca::observe<"a.*", Policy...>) {}
};
template <class... Policy>
struct heard : khz<cca::node<"a", source<>>, cca::node<"b", hearing<Policy...>>> {};
template <class... Policy>
struct hears : cca::deployment<heard<Policy...>, some<"one", "a">, rest<"two">> {};
static_assert(tells<hears<>, hears<cca::delayed<2>>>(
    {"deployment.undelayed", "b",
     "`b` (hearing<>) observes `a.*`: `a.y` is published in environment `one` and read in environment `two`, "
     "so it takes at least a beat to get there: write cca::observe<`a.*`, cca::delayed<1>>, or a greater "
     "delay, or place both in one environment"}));

// What waits in a queue is not sent to another environment: an observer there needs a delay, and hears the
// samples that are taken from the queue.
template <class... Policy>
struct hearing_input {
  void process(cca::observe<"a.x.**", Policy...>) {}
};
template <class... Policy>
struct waiting : khz<cca::node<"s", source<>>,
                     cca::node<"a", sink<>, cca::timed<1>>,
                     cca::wire<"s.y", "a.x", cca::delayed<1>, cca::queue<4>>,
                     cca::node<"b", hearing_input<Policy...>>> {};
template <class... Policy>
struct hears_waiting : cca::deployment<waiting<Policy...>, some<"one", "a">, rest<"two">> {};
static_assert(tells<hears_waiting<>, hears_waiting<cca::delayed<1>>>(
    {"deployment.undelayed", "b",
     "`b` (hearing_input<>) observes `a.x.**`, and so the input `a.x` in environment `one`, but what "
     "waits in its queue now is known only there: write cca::observe<`a.x.**`, cca::delayed<1>>, or a "
     "greater delay, to hear what is taken from the queue, or place both in one environment"}));

// `cca::observe` as an item of a graph is for `observed`, between two beats: it needs no delay.
struct watched : cca::deployment<khz<cca::node<"a", source<>>, cca::node<"b", source<>>, cca::observe<"**">>,
                                 some<"one", "a">,
                                 rest<"two">> {};
static_assert(cca::well_formed<watched>);

template <class... Options>
struct pair : cca::graph<cca::node<"a", source<>>,
                         cca::node<"b", step<>>,
                         cca::wire<"a.y", "b.x", Options...>,
                         cca::expose<"b.y", "y">> {};
template <class Outside, class... Inside>
struct nested
    : khz<cca::node<"g", pair<Inside...>>, cca::node<"c", sink<>>, cca::wire<"g.y", "c.x", Outside>> {};
template <class Outside, class... Inside>
struct cut_inside : cca::deployment<nested<Outside, Inside...>, some<"one", "g.a">, rest<"two">> {};
static_assert(tells<cut_inside<cca::latest>, cut_inside<cca::latest, cca::delayed<1>>>(
    {"deployment.undelayed", "g.a.y -> g.b.x",
     "`g.a.y` is published in environment `one` and read in environment `two`, so it takes at least a beat "
     "to "
     "get there: write cca::wire<`a.y`, `b.x`, cca::delayed<1>> in pair<>, or a greater delay, or place both "
     "in one environment"}));
template <class Outside>
struct cut_outside : cca::deployment<nested<Outside>, some<"one", "g">, rest<"two">> {};
static_assert(tells<cut_outside<cca::latest>, cut_outside<cca::delayed<1>>>(
    {"deployment.undelayed", "g.y -> c.x",
     "`g.b.y` is published in environment `one` and read in environment `two`, so it takes at least a beat "
     "to "
     "get there: write cca::wire<`g.y`, `c.x`, cca::delayed<1>>, or a greater delay, or place both in one "
     "environment"}));

// The wires inside a skeleton are not the user's: an option of it sets their policies.
using pair_of_angles = cca::array_of<angles, 2>;
template <class... Wires>
struct crew : cca::farm<step<angles>, pair_of_angles, pair_of_angles, Wires...> {};
struct undelayed_crew : crew<> {};
struct delayed_crew : crew<cca::inner_wires<cca::delayed<1>>> {};
template <class Crew>
struct crossed_crew
    : cca::deployment<
          khz<cca::node<"a", source<pair_of_angles>>, cca::node<"f", Crew>, cca::wire<"a.y", "f.input">>,
          rest<"one">,
          some<"two", "f.worker1">> {};
static_assert(tells<crossed_crew<undelayed_crew>, crossed_crew<delayed_crew>>(
    {"deployment.undelayed", "f.split.part1 -> f.worker1.x",
     "`f.split.part1` is published in environment `one` and read in environment `two`, so it takes at "
     "least a beat to get there: add cca::inner_wires<cca::delayed<1>> to the arguments of the skeleton "
     "`f` (undelayed_crew), or place its parts in one environment"}));
struct undelayed_queues : crew<cca::inner_wires<cca::queue<2>>> {};
struct delayed_queues : crew<cca::inner_wires<cca::delayed<1>, cca::queue<2>>> {};
static_assert(tells<crossed_crew<undelayed_queues>, crossed_crew<delayed_queues>>(
    {"deployment.undelayed", "f.split.part1 -> f.worker1.x",
     "`f.split.part1` is published in environment `one` and read in environment `two`, so it takes at "
     "least a beat to get there: add cca::delayed<1> to the cca::inner_wires<...> of the skeleton `f` "
     "(undelayed_queues), or place its parts in one environment"}));

// ---- deployment.bad_environment ----

struct no_item : cca::deployment<chain, some<"one", "a">, sink<>, rest<"two">> {};
static_assert(tells<no_item, mended>(
    {"deployment.bad_environment", "no_item",
     "`sink<>` in no_item is no item of a deployment, so it would be ignored: write cca::environment<`name`, "
     "cca::nodes<`a`, `b.c`>>, or cca::tolerate<N>"}));
struct no_nodes : cca::deployment<chain, cca::environment<"one", sink<>>, rest<"two">> {};
static_assert(tells<no_nodes, mended>(
    {"deployment.bad_environment", "one",
     "environment `one` has `sink<>` in place of its nodes: write cca::nodes<`a`, `b.c`>, with the paths of "
     "components or inner graphs, or cca::other_nodes"}));
struct no_option : cca::deployment<chain, cca::environment<"two", cca::other_nodes, cca::timed<2>>> {};
static_assert(tells<no_option, mended>(
    {"deployment.bad_environment", "two",
     "environment `two` has the option `timed<2>`, but its options are cca::realtime<Priority, "
     "cca::on_core<N>>, cca::realtime_if_allowed and cca::free_running: write one of them, or none (all "
     "nodes "
     "go into one cca::nodes<...>)"}));
template <class... Options>
struct with_options : cca::deployment<chain, cca::environment<"two", cca::other_nodes, Options...>> {};
static_assert(cca::well_formed<with_options<cca::realtime<80>>>);
static_assert(cca::well_formed<with_options<cca::realtime_if_allowed<80, cca::on_core<1>>>>);
static_assert(cca::diagnosis<with_options<cca::realtime<80, cca::on_core<1>, cca::on_core<2>>>>.rule ==
              "deployment.bad_environment");
static_assert(cca::diagnosis<with_options<cca::realtime<80, int>>>.rule == "deployment.bad_environment");
static_assert(tells<with_options<cca::realtime<80>, cca::realtime_if_allowed<80>>, mended>(
    {"deployment.bad_environment", "two",
     "environment `two` has two options of one kind, but one says how its thread runs: leave one of them"}));
struct unnamed : cca::deployment<chain, some<"", "a">, rest<"two">> {};
static_assert(
    tells<unnamed, mended>({"deployment.bad_environment", "unnamed",
                            "an environment of unnamed has no name, so no message could name it: give it "
                            "one"}));
struct dotted : cca::deployment<chain, some<"one.a", "a">, rest<"two">> {};
static_assert(tells<dotted, mended>(
    {"deployment.bad_environment", "one.a",
     "an environment of dotted is named `one.a`, but dots join names to paths, and `*` stands for any name: "
     "use neither in a name"}));
struct same_name : cca::deployment<chain, some<"one", "a">, rest<"one">> {};
static_assert(tells<same_name, mended>(
    {"deployment.bad_environment", "one",
     "two environments of same_name are named `one`, so a message about one of them has two meanings: give "
     "one another name"}));
struct without_nodes : cca::deployment<chain, some<"one">, rest<"two">> {};
static_assert(tells<without_nodes, mended>(
    {"deployment.bad_environment", "one",
     "environment `one` of without_nodes has no component, so it has nothing to run: add the path of a node "
     "to its cca::nodes<...>, or remove it"}));
struct without_others : cca::deployment<chain, some<"one", "a", "b", "c">, rest<"two">> {};
static_assert(tells<without_others, mended>(
    {"deployment.bad_environment", "two",
     "environment `two` of without_others has no component, so it has nothing to run: the other environments "
     "name every node; remove a path there, or this environment"}));
struct without_environment : cca::deployment<chain> {};
static_assert(tells<without_environment, mended>(
    {"deployment.bad_environment", "without_environment",
     "without_environment has no environment: write cca::environment<`name`, cca::nodes<`a`, `b.c`>> after "
     "the architecture, and one with cca::other_nodes"}));
struct tolerates_twice : cca::deployment<chain, rest<"one">, cca::tolerate<1>, cca::tolerate<2>> {};
static_assert(tells<tolerates_twice, mended>(
    {"deployment.bad_environment", "tolerates_twice",
     "tolerates_twice states cca::tolerate more than once: leave one of them"}));
struct tolerates_less_than_none : cca::deployment<chain, rest<"one">, cca::tolerate<-1>> {};
static_assert(tells<tolerates_less_than_none, mended>(
    {"deployment.bad_environment", "tolerates_less_than_none",
     "cca::tolerate<-1> in tolerates_less_than_none is no number of late beats: write 0 or more"}));
struct of_deployment : cca::deployment<mended, rest<"one">> {};
static_assert(tells<of_deployment, mended>({"deployment.bad_environment", "of_deployment",
                                            "of_deployment is a deployment of the deployment mended, whose "
                                            "environments would be ignored: deploy its "
                                            "architecture instead, chain"}));
struct with_deployment : khz<cca::node<"g", mended>> {};
struct with_architecture : khz<cca::node<"g", chain>> {};
static_assert(tells<with_deployment, with_architecture>(
    {"deployment.bad_environment", "g",
     "`g` is the deployment mended, but inside of a graph its environments would be ignored: make it a node "
     "of the architecture, chain, and deploy the graph around it"}));

// Mistakes in the architecture come first, and name it as if it were not deployed.
struct loose : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>> {};
struct wired : khz<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">> {};
struct of_loose : cca::deployment<loose, some<"one", "d">, int> {};
struct of_wired : cca::deployment<wired, rest<"one">> {};
static_assert(tells<of_loose, of_wired>({"wire.unconnected_input", "b.x",
                                         cca::diagnosis<loose>.message.substr(24)}));
static_assert(cca::diagnosis<of_loose>.message == cca::diagnosis<loose>.message);

struct of_component : cca::deployment<sink<>, rest<"one">> {};
static_assert(!cca::Deployment<of_component> && !cca::well_formed<of_component>);
static_assert(tells<of_component, mended>(
    {"graph.unknown_item", "of_component",
     "`sink<>` in of_component is no graph: the first argument of cca::deployment is the architecture, a "
     "struct derived from cca::graph<...> or, of several modes, from cca::modes<...>, and the environments "
     "follow"}));

// A deployment without a name of its own.
static_assert(
    cca::diagnosis<cca::deployment<chain, rest<"one">, int>>.message ==
    "deployment.bad_environment: `int` in the deployment is no item of a deployment, so it would be ignored: "
    "write cca::environment<`name`, cca::nodes<`a`, `b.c`>>, or cca::tolerate<N>");

}  // namespace
