// Rules about patterns: observe.nothing, observe.bad_policy, plan.unknown_path.
#include <array>

#include <cca/adaptive/sequencer.hpp>
#include <cca/deployment.hpp>

#include "rules_parts.hpp"

using namespace parts;

namespace {

template <cca::fixed_string Pattern, class... Policy>
struct log {
  void process(cca::observe<Pattern, Policy...>) {}
};
template <class... Items>
struct chain : khz<cca::node<"source", source<>>,
                   cca::node<"step", step<>>,
                   cca::wire<"source.y", "step.x">,
                   Items...> {};
template <cca::fixed_string Pattern, class... Policy>
struct hears : chain<cca::node<"log", log<Pattern, Policy...>>> {};

// ---- what patterns name ----

template <cca::fixed_string Pattern>
constexpr bool names = cca::well_formed<hears<Pattern>>;
template <cca::fixed_string Pattern>
constexpr bool names_nothing = cca::diagnosis<hears<Pattern>>.rule == "observe.nothing";

static_assert(names<"source.y"> && names<"*.*"> && names<"*.y"> && names<"source.*">);
static_assert(names<"**"> && names<"**.y"> && names<"**.*"> && names<"source.**"> && names<"**.source.**.y">);
static_assert(names<"/source.y"> && names<"/**">);
static_assert(names<"step.x.**">);  // an input, and nothing below it
static_assert(names<"nobody.*|step.y"> && names<"step.y|/nobody.*">);
static_assert(names_nothing<"*"> && names_nothing<"*.*.*"> && names_nothing<"source"> && names_nothing<"">);
static_assert(names_nothing<"step.x"> && names_nothing<"*.x"> && names_nothing<"source..y">);
static_assert(names_nothing<"/"> && names_nothing<"source.y.*"> && names_nothing<"log.**">);

// ---- where they are looked up ----

struct skill : cca::graph<cca::node<"core", source<>>, cca::expose<"core.y", "y">> {};
template <cca::fixed_string Pattern>
struct mind : cca::graph<cca::node<"own", source<>>, cca::node<"log", log<Pattern>>> {};
template <cca::fixed_string Pattern>
struct around : khz<cca::node<"mind", mind<Pattern>>, cca::node<"skill", skill>, cca::node<"own", source<>>> {
};

template <cca::fixed_string Pattern>
constexpr int heard = cca::detail::link_count_of<around<Pattern>>;

static_assert(heard<"own.y"> == 1);   // that of its own graph
static_assert(heard<"/own.y"> == 1);  // the outermost
static_assert(heard<"/**.own.y"> == 2);
static_assert(heard<"skill.core.y"> == 1);  // in the graph around it
static_assert(heard<"skill.y"> == 1);       // as the graph exposes it
static_assert(heard<"skill.*"> == 1);
static_assert(heard<"skill.**"> == 1);  // one output, though it has two names
static_assert(heard<"*.y"> == 1);
static_assert(heard<"/*.y"> == 2);
static_assert(heard<"/**"> == 3);
static_assert(heard<"mind.own.y"> == 1);

// ---- observe.nothing ----

static_assert(tells<hears<"suorce.*">, hears<"source.*">>(
    {"observe.nothing", "log",
     "`log` (log<suorce.*>) observes `suorce.*`, which names nothing in hears<suorce.*> or in a graph around "
     "it, so it would hear nothing; did you mean `source.*`?"}));

struct misheard : chain<cca::observe<"c.*">> {};
struct watched : chain<cca::observe<"source.*">> {};
static_assert(tells<misheard, watched>({"observe.nothing", "c.*",
                                        "cca::observe<`c.*`> in misheard names nothing, neither in misheard "
                                        "nor in a graph around it, so it would "
                                        "hear nothing: write the path of a port from the nodes of one of "
                                        "these graphs on, as in `node.port`; `*` "
                                        "stands for one name, and `**` for any number of names"}));

struct misheard_nearly : chain<cca::observe<"suorce.*">> {};
static_assert(tells<misheard_nearly, watched>(
    {"observe.nothing", "suorce.*",
     "cca::observe<`suorce.*`> in misheard_nearly names nothing, neither in misheard_nearly nor in a "
     "graph around it, so it would hear nothing; did you mean `source.*`?"}));

static_assert(tells<hears<"/source/**">, hears<"/source.**">>(
    {"observe.nothing", "log",
     "`log` (log</source/**>) observes `/source/**`, which names nothing in hears</source/**>, the "
     "outermost graph, so it would hear nothing: names are joined by dots, and a `/` may only be the "
     "first letter, as in `/dmp.status.*`"}));

// What observes inside of a component of the library names its source, too.
template <cca::fixed_string Source>
struct stale : cca::watchdog<signal, 5, cca::of<Source>> {};
template <cca::fixed_string Source>
struct guarded : chain<cca::node<"watchdog", stale<Source>>, cca::wire<"source.y", "watchdog.command">> {};
static_assert(tells<guarded<"suorce.y">, guarded<"source.y">>(
    {"observe.nothing", "watchdog.watch",
     "`watchdog.watch` (source_watch<parts::signal, 5, suorce.y, 5>) observes `suorce.y`, which names "
     "nothing in stale<suorce.y> or in a graph around it, so it would hear nothing; did you mean "
     "`source.y`?"}));

// A graph, or its scope, stands for all that is under it.
struct in_chain : khz<cca::node<"inner", chain<>>, cca::node<"log", log<"inner.*">>> {};
struct in_chain_mended : khz<cca::node<"inner", chain<>>, cca::node<"log", log<"inner.**">>> {};
static_assert(tells<in_chain, in_chain_mended>({"observe.nothing", "log",
                                                "`log` (log<inner.*>) observes `inner.*`, which names "
                                                "nothing in in_chain or in a graph around it, so it "
                                                "would hear nothing; did you mean `inner.**`?"}));
struct at_outermost : khz<cca::node<"mind", mind<"/sikll.**">>, cca::node<"skill", skill>> {};
struct at_outermost_mended : khz<cca::node<"mind", mind<"/skill.**">>, cca::node<"skill", skill>> {};
static_assert(tells<at_outermost, at_outermost_mended>(
    {"observe.nothing", "mind.log",
     "`mind.log` (log</sikll.**>) observes `/sikll.**`, which names nothing in at_outermost, the outermost "
     "graph, so it would hear nothing; did you mean `/skill.**`?"}));

// ---- observe.bad_policy ----

using two = cca::queue<2, cca::drop_oldest>;
static_assert(cca::well_formed<hears<"**", cca::latest>> && cca::well_formed<hears<"**", cca::delayed<3>>> &&
              cca::well_formed<hears<"**", two>>);
static_assert(tells<hears<"**", cca::delayed<0>>, hears<"**", cca::delayed<1>>>(
    {"observe.bad_policy", "log",
     "cca::observe<`**`> of `log` (log<**, cca::delayed<0>>) has two policies of one kind, or one with a "
     "number below 1: write cca::latest, cca::delayed<N> or cca::queue<C, F>, each as on a wire"}));
static_assert(tells<hears<"**", int>, hears<"**", cca::latest>>(
    {"observe.bad_policy", "log",
     "cca::observe<`**`> of `log` (log<**, int>) has `int`, which is no policy of an observer: write "
     "cca::latest, cca::delayed<N> or cca::queue<C, F>, each as on a wire"}));
static_assert(tells<hears<"**", cca::initial<1>>, hears<"**", cca::latest>>(
    {"observe.bad_policy", "log",
     "cca::observe<`**`> of `log` (log<**, cca::initial<1>>) has an initial value, but what it hears may "
     "be of several spaces, and begins with the zero of each: write cca::latest, cca::delayed<N> or "
     "cca::queue<C, F>, each as on a wire"}));
struct watched_late : chain<cca::observe<"**", cca::delayed<1>>> {};
struct watched_merged : chain<cca::observe<"**", cca::merged<2>>> {};
static_assert(tells<watched_merged, watched_late>(
    {"observe.bad_policy", "**",
     "cca::observe<`**`> in watched_merged is cca::merged, but what it hears may be of several spaces, and "
     "each "
     "has a queue of its own: write cca::latest, cca::delayed<N> or cca::queue<C, F>, each as on a wire"}));

// A queue that rejects is looked at as on a wire.
template <class Strategy>
struct rejecting : khz<cca::node<"source", source<>>,
                       cca::node<"log", log<"source.y", cca::queue<2, cca::reject>>, Strategy>> {};
static_assert(tells<rejecting<cca::timed<2>>, rejecting<cca::timed<1>>>(
    {"queue.overflow", "log",
     "`source.y` is published every beat but `log.source.y` is read every 2 beats, so the queue of 2 between "
     "them is full sooner or later, which cca::reject forbids: read faster, or say what is lost: "
     "cca::drop_oldest or cca::drop_newest"}));

// ---- inputs with a queue ----

template <cca::fixed_string Pattern, class... Policy>
struct beside_queue : khz<cca::node<"source", source<>>,
                          cca::node<"step", step<>, cca::timed<1>>,
                          cca::wire<"source.y", "step.x", cca::delayed<1>, two>,
                          cca::node<"log", log<Pattern, Policy...>>> {};
static_assert(cca::well_formed<beside_queue<"**">> && cca::well_formed<beside_queue<"**", cca::delayed<1>>>);
static_assert(cca::detail::counts_of<beside_queue<"**">>.taken_count == 0);  // they cost what they did
static_assert(cca::detail::counts_of<beside_queue<"step.*", cca::delayed<1>>>.taken_count == 0);
static_assert(cca::detail::counts_of<beside_queue<"step.**", cca::delayed<1>>>.taken_count == 1);

template <class Graph>
struct log_elsewhere : cca::deployment<Graph,
                                       cca::environment<"step", cca::nodes<"step">>,
                                       cca::environment<"log", cca::other_nodes>> {};
static_assert(cca::well_formed<log_elsewhere<beside_queue<"step.x.**", cca::delayed<1>>>>);
static_assert(cca::diagnosis<log_elsewhere<beside_queue<"step.x.**">>>.rule == "deployment.undelayed");

// ---- plan.unknown_path ----

struct state_of_skill {
  auto process(cca::beat) -> cca::out<"status", cca::component_status_port> { return {}; }
};
template <cca::fixed_string Path>
struct plan : cca::steps<cca::step<"wait">, cca::step<"go", cca::is<Path, 1>>> {};
template <int Axis>
struct plan_of_axis : cca::steps<cca::step<"wait">, cca::step<"go", cca::is<"reach.status", 1, Axis>>> {};
template <class Plan>
struct leader_of : cca::sequencer<"*.status.*", Plan> {};
template <class Plan>
struct led : khz<cca::node<"reach", state_of_skill>, cca::node<"leader", leader_of<Plan>>> {};
static_assert(tells<led<plan<"raech.status">>, led<plan<"reach.status">>>(
    {"plan.unknown_path", "leader",
     "`leader` (leader_of<plan<raech.status>>) asks for `raech.status`, which nobody publishes "
     "under what it observes (`*.status.*|*.status`), so it would wait for ever; did you mean "
     "`reach.status`?"}));
static_assert(tells<led<plan<"elsewhere.value">>, led<plan<"reach.status">>>(
    {"plan.unknown_path", "leader",
     "`leader` (leader_of<plan<elsewhere.value>>) asks for `elsewhere.value`, which nobody publishes "
     "under what it observes (`*.status.*|*.status`), so it would wait for ever: name one that is "
     "published there, as in `node.port`, or let it observe more"}));
static_assert(tells<led<plan_of_axis<1>>, led<plan_of_axis<0>>>(
    {"plan.unknown_path", "leader",
     "`leader` (leader_of<plan_of_axis<1>>) asks for number 1 of `reach.status`, which has 1 "
     "number: count from 0"}));

template <class... Conditions>
struct combined : cca::steps<cca::step<"wait">, cca::step<"go", Conditions...>> {};
using known = cca::above<"reach.status", 1.0>;
using unknown = cca::above<"nobody.status", 1.0>;
static_assert(cca::well_formed<led<combined<known, cca::any<known, cca::no<known>>>>>);
static_assert(!cca::well_formed<led<combined<known, unknown>>>);
static_assert(!cca::well_formed<led<combined<cca::any<cca::after<3>, cca::no<unknown>>>>>);

// The sequencer in an inner graph: its paths begin where it stands, or in a graph around it.
template <cca::fixed_string Path>
struct led_inside : khz<cca::node<"mind", led<plan<Path>>>, cca::node<"arm", state_of_skill>> {};
static_assert(cca::well_formed<led_inside<"reach.status">> &&
              cca::well_formed<led_inside<"mind.reach.status">> &&
              cca::well_formed<led_inside<"/mind.reach.status">>);
static_assert(!cca::well_formed<led_inside<"arm.status">>);  // the sequencer hears its own graph alone

}  // namespace
