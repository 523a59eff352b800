// Rules about strategies: the message of each mistake, and that the mended graph is sound.
#include <cca/deployment.hpp>

#include "rules_parts.hpp"

namespace {

using namespace parts;

struct trigger : khz<cca::node<"a", source<>>,
                     cca::node<"b", sink<>, cca::port_triggered<"xx">>,
                     cca::wire<"a.y", "b.x">> {};
struct trigger_mended : khz<cca::node<"a", source<>>,
                            cca::node<"b", sink<>, cca::port_triggered<"x">>,
                            cca::wire<"a.y", "b.x">> {};
static_assert(tells<trigger, trigger_mended>(
    {"strategy.unknown_port", "b",
     "`b` (sink<>) is cca::port_triggered by `xx`, but it has no such input; did you mean `x`?"}));

struct trigger_within
    : khz<cca::node<"a", source<>>,
          cca::node<"b",
                    sink<>,
                    cca::any_of<cca::timed<3>, cca::all_of<cca::timed<5>, cca::port_triggered<"x", "y">>>>,
          cca::wire<"a.y", "b.x">> {};
struct trigger_within_mended
    : khz<cca::node<"a", source<>>,
          cca::node<"b",
                    sink<>,
                    cca::any_of<cca::timed<3>, cca::all_of<cca::timed<5>, cca::port_triggered<"x">>>>,
          cca::wire<"a.y", "b.x">> {};
static_assert(tells<trigger_within, trigger_within_mended>(
    {"strategy.unknown_port", "b",
     "`b` (sink<>) is cca::port_triggered by `y`, but it has no such input; did you mean `x`?"}));

struct trigger_none : khz<cca::node<"a", source<>, cca::port_triggered<"x">>> {};
struct trigger_none_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<trigger_none, trigger_none_mended>(
    {"strategy.unknown_port", "a",
     "`a` (source<>) is cca::port_triggered by `x`, but it has no such input: it has no inputs at all"}));

struct resource_waits : khz<cca::node<"r", robot<signal>, cca::restless>,
                            cca::node<"a", source<>>,
                            cca::wire<"a.y", "r.command">> {};
struct resource_waits_mended : khz<cca::node<"r", robot<signal>, cca::timed<1>>,
                                   cca::node<"a", source<>>,
                                   cca::wire<"a.y", "r.command">> {};
static_assert(tells<resource_waits, resource_waits_mended>(
    {"strategy.misplaced", "r",
     "`r` (robot<parts::signal>) is a resource node, which runs at fixed beats: it may be cca::timed, "
     "cca::full_speed or cca::inactive"}));

struct inner : cca::graph<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">> {};

struct graph_fires : khz<cca::node<"g", inner, cca::timed<2>>> {};
struct graph_fires_mended : khz<cca::node<"g", inner>> {};
static_assert(tells<graph_fires, graph_fires_mended>(
    {"strategy.misplaced", "g",
     "`g` (inner) is a graph, and a strategy stands on components: give it to the nodes inside"}));

template <class... Strategy>
struct around_inner : khz<cca::node<"g", inner, Strategy...>> {};
static_assert(tells<around_inner<cca::stoppable<cca::timed<2>>>, around_inner<cca::stoppable<>>>(
    {"strategy.misplaced", "g",
     "`g` (inner) is a graph, which is cca::stoppable<> without a strategy: give the strategy to the "
     "nodes inside"}));

struct body
    : cca::graph<cca::node<"a", source<>>, cca::node<"r", robot<signal>>, cca::wire<"a.y", "r.command">> {};
template <class... Strategy>
struct around_body : khz<cca::node<"g", body, Strategy...>> {};
static_assert(tells<around_body<cca::stoppable<>>, around_body<>>(
    {"strategy.misplaced", "g.r",
     "`g.r` (robot<parts::signal>) is a resource node, which stops only with its controller, but the "
     "graph around it is cca::stoppable<>: move the resource node out of that graph"}));

// ---- what stops and starts ----

struct finishing {
  auto process(cca::beat) -> cca::done { return {}; }
};
template <class Strategy>
struct finished : khz<cca::node<"a", finishing, Strategy>> {};
static_assert(tells<finished<cca::timed<2>>, finished<cca::stoppable<cca::timed<2>>>>(
    {"strategy.not_stoppable", "a",
     "`a` (finishing) returns cca::done, by which it stops itself, but its strategy does not let it be "
     "stopped: write cca::stoppable<...> around the strategy, for example cca::stoppable<cca::restless>"}));

struct finishing_robot {
  auto sense() -> cca::done { return {}; }
};
struct finished_robot : khz<cca::node<"r", finishing_robot>> {};
static_assert(tells<finished_robot, finished<cca::stoppable<>>>(
    {"strategy.not_stoppable", "r",
     "`r` (finishing_robot) returns cca::done, by which it stops itself, but a resource node stops only "
     "with its controller: leave the cca::done out"}));

template <cca::fixed_string Path>
struct orders {
  auto process(cca::beat) -> cca::stops<Path> { return true; }
};
template <cca::fixed_string Path, class... Strategy>
struct ordered : khz<cca::node<"o", orders<Path>>, cca::node<"inner", inner, Strategy...>> {};
static_assert(tells<ordered<"iner", cca::stoppable<>>, ordered<"inner", cca::stoppable<>>>(
    {"part.unknown_path", "o",
     "`o` (orders<iner>) stops or starts `iner`, but there is no node of this path in its graph, nor in "
     "the graphs around it; did you mean `inner`?"}));
static_assert(tells<ordered<"inner">, ordered<"inner", cca::stoppable<>>>(
    {"part.unknown_path", "o",
     "`o` (orders<inner>) stops or starts `inner`, but its node does not let it be stopped: write "
     "cca::stoppable<> as the strategy of the graph"}));
static_assert(tells<ordered<"elsewhere">, ordered<"inner", cca::stoppable<>>>(
    {"part.unknown_path", "o",
     "`o` (orders<elsewhere>) stops or starts `elsewhere`, but there is no node of this path in its "
     "graph, nor in the graphs around it: name a node that has cca::stoppable<...>"}));
template <class Strategy>
struct orders_of_one : khz<cca::node<"o", orders<"a">>, cca::node<"a", source<>, Strategy>> {};
static_assert(tells<orders_of_one<cca::timed<2>>, orders_of_one<cca::stoppable<cca::timed<2>>>>(
    {"part.unknown_path", "o",
     "`o` (orders<a>) stops or starts `a`, but its node does not let it be stopped: write "
     "cca::stoppable<...> around its strategy"}));

struct no_strategy : khz<cca::node<"a", source<>, signal>> {};
struct no_strategy_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<no_strategy, no_strategy_mended>(
    {"strategy.no_fires", "a",
     "`a` (source<>) has the strategy `signal`, which cannot say when it fires: use one like cca::timed<10> "
     "or cca::moderate, or give it `template <class Inputs> static bool fires(cca::beat, const Inputs&)` "
     "(not "
     "static if it has a state) and a constructor without arguments"}));

struct fires_by_beat_only {
  static bool fires(cca::beat) { return true; }
};
struct fires_at_once {
  static bool fires(cca::beat, const auto&) { return true; }
};

struct no_template_strategy
    : khz<cca::node<"a", source<>>, cca::node<"b", sink<>, fires_by_beat_only>, cca::wire<"a.y", "b.x">> {};
struct no_template_strategy_mended
    : khz<cca::node<"a", source<>>, cca::node<"b", sink<>, fires_at_once>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<no_template_strategy, no_template_strategy_mended>(
    {"strategy.no_fires", "b",
     "`b` (sink<>) has the strategy `fires_by_beat_only`, which cannot say when it fires: use one like "
     "cca::timed<10> or cca::moderate, or give it `template <class Inputs> static bool fires(cca::beat, "
     "const Inputs&)` (not static if it has a state) and a constructor without arguments"}));

// ---- never ----

struct deaf : khz<cca::node<"b", listener<>>> {};
struct deaf_mended : khz<cca::node<"b", listener<>, cca::any_of<cca::restless, cca::timeout<9>>>> {};
static_assert(tells<deaf, deaf_mended>({"strategy.never_fires", "b",
                                        "`b` (listener<>) fires only when a sample arrives, but no input "
                                        "that it waits for is wired: wire one, or make it cca::timed"}));

struct deaf_trigger : khz<cca::node<"a", source<>>,
                          cca::node<"b", listener<>, cca::port_triggered<"z">>,
                          cca::wire<"a.y", "b.x">> {};
struct deaf_trigger_mended
    : khz<cca::node<"a", source<>>,
          cca::node<"b", listener<>, cca::any_of<cca::port_triggered<"z">, cca::port_triggered<"x">>>,
          cca::wire<"a.y", "b.x">> {};
static_assert(tells<deaf_trigger, deaf_trigger_mended>(
    {"strategy.never_fires", "b",
     "`b` (listener<>) fires only when a sample arrives, but no input that it waits for is wired: wire one, "
     "or make it cca::timed"}));

struct exclusive : khz<cca::node<"a", source<>, cca::all_of<cca::timed<2>, cca::timed<4, 1>>>> {};
struct exclusive_mended : khz<cca::node<"a", source<>, cca::all_of<cca::timed<2>, cca::timed<3, 1>>>> {};
static_assert(
    tells<exclusive, exclusive_mended>({"strategy.never_fires", "a",
                                        "`a` (source<>) never fires: the clocks under its cca::all_of have "
                                        "no beat in common; change a period or a phase"}));

struct exclusive_within
    : khz<cca::
              node<"a", source<>, cca::any_of<cca::all_of<cca::timed<2>, cca::timed<2, 1>>, cca::timed<3>>>> {
};
struct exclusive_within_mended : khz<cca::node<"a", source<>, cca::any_of<cca::timed<2>, cca::timed<3>>>> {};
static_assert(tells<exclusive_within, exclusive_within_mended>(
    {"strategy.never_fires", "a",
     "`a` (source<>) has all_of<timed<2>, timed<2, 1>> in its strategy, which never fires: its clocks have "
     "no beat in common; change a period or a phase, or remove it"}));

struct exclusive_and_waiting
    : khz<cca::node<"a", source<>>,
          cca::node<"b", sink<>, cca::all_of<cca::restless, cca::all_of<cca::timed<2>, cca::timed<4, 3>>>>,
          cca::wire<"a.y", "b.x", cca::latest>> {};
static_assert(cca::diagnosis<exclusive_and_waiting>.message ==
              "strategy.never_fires: `b` (sink<>) has all_of<timed<2>, timed<4, 3>> in its strategy, which "
              "never fires: its clocks have no beat in common; change a period or a phase, or remove it");

// A user's strategies without add_name: the name of the type stands in the message.
struct nameless {
  template <class Inputs>
  static constexpr bool fires(cca::beat, const Inputs&) {
    return true;
  }
};
struct mistaken : nameless {
  static constexpr std::string_view mistake = "asks for a beat that never comes: ask for another";
};
struct never_satisfied : nameless {
  static constexpr bool excludes_itself = true;
};
struct waiting_in_vain : nameless {
  static constexpr bool waits_in_vain(const cca::detail::arrivals&) { return true; }
};
template <class Strategy>
struct fired_by : khz<cca::node<"a", source<>, Strategy>> {};
template <class Strategy>
constexpr bool says(std::string_view end) {
  const std::string_view whole = cca::diagnosis<fired_by<Strategy>>.message,
                         begin = "strategy.never_fires: `a` (source<>) ";
  return whole.starts_with(begin) && whole.substr(begin.size()) == end;
}
static_assert(cca::well_formed<fired_by<nameless>> &&
              cca::well_formed<fired_by<cca::any_of<nameless, cca::timed<3>>>>);
static_assert(says<mistaken>("asks for a beat that never comes: ask for another") &&
              says<cca::any_of<nameless, mistaken>>("asks for a beat that never comes: ask for another"));
static_assert(says<waiting_in_vain>(
    "fires only when a sample arrives, but no input that it waits for is wired: wire one, or make it "
    "cca::timed"));
static_assert(says<cca::all_of<nameless, cca::timed<2>, cca::timed<2, 1>>>(
    "never fires: the clocks under its cca::all_of have no beat in common; change a period or a phase"));
static_assert(says<cca::any_of<nameless, cca::all_of<cca::timed<2>, nameless, cca::timed<2, 1>>>>(
    "has all_of<timed<2>, nameless, timed<2, 1>> in its strategy, which never fires: its clocks have no beat "
    "in common; change a period or a phase, or remove it"));
// No all_of is at fault here, and no clock.
static_assert(
    says<never_satisfied>("never fires: no beat can satisfy never_satisfied; choose another "
                          "strategy"));
static_assert(says<cca::any_of<cca::timed<3>, never_satisfied>>(
    "has never_satisfied in its strategy, which no beat can satisfy: remove it"));
static_assert(says<cca::all_of<cca::timed<3>, never_satisfied>>(
    "has never_satisfied in its strategy, which no beat can satisfy: remove it"));

static_assert(tells<fired_by<cca::free_running>, fired_by<cca::full_speed>>(
    {"strategy.no_fires", "a",
     "`a` (source<>) has the strategy `free_running`, which cannot say when it fires: it is an option of "
     "an environment; the nodes in that are cca::full_speed"}));
static_assert(tells<fired_by<cca::timed<0>>, fired_by<cca::timed<1>>>(
    {"strategy.never_fires", "a",
     "`a` (source<>) counts beats by a number below 1: in cca::timed<N> and cca::timeout<N> it is at "
     "least 1"}));
static_assert(tells<fired_by<cca::any_of<cca::timed<4>, cca::timeout<0>>>,
                    fired_by<cca::any_of<cca::timed<4>, cca::timeout<1>>>>(
    {"strategy.never_fires", "a",
     "`a` (source<>) counts beats by a number below 1: in cca::timed<N> and cca::timeout<N> it is at "
     "least 1"}));

// What is observed has no origin in common with anything.
struct hearing {
  void process(cca::observe<"a.*">) {}
};
template <class... Strategy>
struct heard : khz<cca::node<"a", source<>>, cca::node<"b", hearing, Strategy...>> {};
static_assert(tells<heard<cca::coordinated>, heard<>>(
    {"strategy.never_fires", "b",
     "`b` (hearing) fires only when a sample arrives, but no input that it waits for is wired: wire one, "
     "or make it cca::timed"}));

struct apart : khz<cca::node<"a", source<>, cca::timed<2, 0>>,
                   cca::node<"c", source<>, cca::timed<2, 1>>,
                   cca::node<"m", merge<>, cca::coordinated>,
                   cca::wire<"a.y", "m.a">,
                   cca::wire<"c.y", "m.b">> {};
struct apart_mended : khz<cca::node<"a", source<>, cca::timed<2>>,
                          cca::node<"c", source<>, cca::timed<4>>,
                          cca::node<"m", merge<>, cca::coordinated>,
                          cca::wire<"a.y", "m.a">,
                          cca::wire<"c.y", "m.b">> {};
static_assert(tells<apart, apart_mended>(
    {"strategy.coordination", "m",
     "`m` (merge<>) is cca::coordinated, but `m.a` (from `a.y`, every 2 beats) and `m.b` (from `c.y`, every "
     "2 beats from beat 1) never hold samples of one time of origin, so it would never fire: feed them from "
     "one source at one rate, with equal delays, or make it cca::moderate"}));

}  // namespace
