// Rules about time: the message of each mistake, and that the mended graph is sound.
#include "rules_parts.hpp"

namespace {

using namespace parts;

struct no_rate : cca::graph<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">> {};
struct no_rate_mended
    : cca::graph<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">, cca::rate<500>> {
};
static_assert(tells<no_rate, no_rate_mended>({"rate.missing", "no_rate",
                                              "neither no_rate nor any of its spaces states a rate, so a "
                                              "beat has no length: add cca::rate<1000> to the graph"}));

template <auto Rate>
struct as_fast_as : cca::graph<cca::rate<Rate>, cca::node<"a", source<>>> {};
struct too_fast : as_fast_as<2'000'000'000> {};
struct fastest : as_fast_as<1'000'000'000> {};
static_assert(tells<too_fast, fastest>(
    {"rate.missing", "too_fast",
     "too_fast or one of its spaces states 2000000000 Hz, and a beat is at least a nanosecond long: state "
     "at most 1,000,000,000 Hz"}));

struct stands_still : as_fast_as<0> {};
struct inner_stands_still : khz<cca::node<"g", stands_still>> {};
struct moves : as_fast_as<1000> {};
struct inner_moves : khz<cca::node<"g", moves>> {};
static_assert(tells<stands_still, moves>(
    {"rate.missing", "stands_still",
     "`cca::rate<0>` in stands_still is no rate, which is a number of updates per second above 0, as "
     "`cca::rate<1000>`; where none is meant, leave it out"}));
static_assert(tells<inner_stands_still, inner_moves>(
    {"rate.missing", "stands_still",
     "`cca::rate<0>` in stands_still is no rate, which is a number of updates per second above 0, as "
     "`cca::rate<1000>`; where none is meant, leave it out"}));

struct two_rates : khz<cca::rate<500>, cca::node<"a", source<>>> {};
struct two_rates_mended : khz<cca::rate<1000>, cca::node<"a", source<>>> {};
static_assert(tells<two_rates, two_rates_mended>(
    {"rate.mismatch", "two_rates",
     "two_rates states two rates, 1000 Hz and 500 Hz, but all of it runs in one beat: keep one"}));

struct slow_graph : cca::graph<cca::rate<250>, cca::node<"a", source<>>> {};
struct slow_graph_mended : cca::graph<cca::rate<1000>, cca::node<"a", source<>>> {};

struct inner_rate : khz<cca::node<"g", slow_graph>> {};
struct inner_rate_mended : khz<cca::node<"g", slow_graph_mended>> {};
static_assert(tells<inner_rate, inner_rate_mended>(
    {"rate.mismatch", "g",
     "the inner graph `g` (slow_graph) states 250 Hz, but inner_rate runs at 1000 Hz: give both one rate, or "
     "let the inner one state none"}));

struct at_100 : cca::space<cca::number, cca::axes<cca::x>, cca::rate<100>> {};

struct space_rate : khz<cca::node<"a", source<at_100>, cca::timed<4>>> {};
struct space_rate_mended : khz<cca::node<"a", source<at_100>, cca::timed<10>>> {};
static_assert(tells<space_rate, space_rate_mended>(
    {"rate.mismatch", "a.y",
     "`a.y` is published every 4 beats, that is at 250 Hz, but its space is at_100 (number over x at 100 "
     "Hz): change the strategy of `a`, or the rate of the space, or let the space state none"}));

struct to_100 {
  auto process(cca::in<"x", signal>) -> cca::out<"y", at_100> { return {}; }
};

struct space_rate_derived
    : khz<cca::node<"a", source<>, cca::timed<5>>, cca::node<"b", to_100>, cca::wire<"a.y", "b.x">> {};
struct space_rate_derived_mended
    : khz<cca::node<"a", source<>, cca::timed<10>>, cca::node<"b", to_100>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<space_rate_derived, space_rate_derived_mended>(
    {"rate.mismatch", "b.y",
     "`b.y` is published every 5 beats, that is at 200 Hz, but its space is at_100 (number over x at 100 "
     "Hz): change the strategy of `b`, or the rate of the space, or let the space state none"}));

struct unstated
    : khz<cca::node<"a", source<>>, cca::node<"b", sink<>, cca::timed<10>>, cca::wire<"a.y", "b.x">> {};
struct unstated_mended : khz<cca::node<"a", source<>>,
                             cca::node<"b", sink<>, cca::timed<10>>,
                             cca::wire<"a.y", "b.x", cca::latest>> {};
static_assert(tells<unstated, unstated_mended>(
    {"rate.unstated", "a.y -> b.x",
     "`a.y` is published every beat but `b.x` is read every 10 beats, and the wire does not say what happens "
     "between them: write cca::wire<`a.y`, `b.x`, cca::latest>, or cca::queue or cca::delayed instead"}));

struct unstated_phase : khz<cca::node<"a", source<>, cca::timed<4, 3>>,
                            cca::node<"b", sink<>, cca::timed<4>>,
                            cca::wire<"a.y", "b.x">> {};
struct unstated_phase_mended : khz<cca::node<"a", source<>, cca::timed<4, 4>>,
                                   cca::node<"b", sink<>, cca::timed<4>>,
                                   cca::wire<"a.y", "b.x">> {};
static_assert(tells<unstated_phase, unstated_phase_mended>(
    {"rate.unstated", "a.y -> b.x",
     "`a.y` is published every 4 beats from beat 3 but `b.x` is read every 4 beats, and the wire does not "
     "say what happens between them: write cca::wire<`a.y`, `b.x`, cca::latest>, or cca::queue or "
     "cca::delayed instead"}));

struct overflow : khz<cca::node<"a", source<>>,
                      cca::node<"b", sink<>, cca::timed<3>>,
                      cca::wire<"a.y", "b.x", cca::queue<8, cca::reject>>> {};
struct overflow_mended : khz<cca::node<"a", source<>, cca::timed<3, 1>>,
                             cca::node<"b", sink<>, cca::timed<3>>,
                             cca::wire<"a.y", "b.x", cca::queue<8, cca::reject>>> {};
static_assert(tells<overflow, overflow_mended>(
    {"queue.overflow", "a.y -> b.x",
     "`a.y` is published every beat but `b.x` is read every 3 beats, so the queue of 8 between them is full "
     "sooner or later, which cca::reject forbids: read faster, or say what is lost: cca::drop_oldest or "
     "cca::drop_newest"}));

struct overflow_never_read : khz<cca::node<"a", source<>>,
                                 cca::node<"b", sink<>, cca::inactive>,
                                 cca::wire<"a.y", "b.x", cca::queue<8, cca::reject>>> {};
struct overflow_never_read_mended : khz<cca::node<"a", source<>>,
                                        cca::node<"b", sink<>, cca::inactive>,
                                        cca::wire<"a.y", "b.x", cca::queue<8, cca::drop_newest>>> {};
static_assert(tells<overflow_never_read, overflow_never_read_mended>(
    {"queue.overflow", "a.y -> b.x",
     "`a.y` is published every beat but `b.x` is never read, so the queue of 8 between them is full sooner "
     "or later, which cca::reject forbids: read faster, or say what is lost: cca::drop_oldest or "
     "cca::drop_newest"}));

struct late_reader {  // fires first when the delayed sample is there
  void process(cca::in<"x", signal>, cca::in<"late", signal>) {}
};
template <int Room>
struct overflow_at_first : khz<cca::node<"a", source<>>,
                               cca::node<"b", late_reader, cca::port_triggered<"late">>,
                               cca::wire<"a.y", "b.late", cca::delayed<10>>,
                               cca::wire<"a.y", "b.x", cca::queue<Room, cca::reject>>> {};
static_assert(tells<overflow_at_first<10>, overflow_at_first<11>>(
    {"queue.overflow", "a.y -> b.x",
     "`a.y` is published every beat but `b.x` is read every beat from beat 10, so the queue of 10 between "
     "them is full sooner or later, which cca::reject forbids: read sooner, or say what is lost: "
     "cca::drop_oldest or cca::drop_newest"}));

// A queue that several wires fill. Each beat of a period counts: two of four may bring three samples.
template <class Second, class Reader, int Room, class... Delay>
struct merged_overflow : khz<cca::node<"a", source<>, cca::timed<2>>,
                             cca::node<"c", source<>, Second>,
                             cca::node<"b", sink<>, Reader>,
                             cca::wire<"a.y", "b.x", cca::merged<Room, cca::reject>>,
                             cca::wire<"c.y", "b.x", cca::merged<Room, cca::reject>, Delay...>> {};
static_assert(tells<merged_overflow<cca::timed<1>, cca::restless, 8>,
                    merged_overflow<cca::timed<2>, cca::restless, 8>>(
    {"queue.overflow", "a.y -> b.x",
     "`b.x` is read at beats known only at run time, but samples come from `a.y` (published every 2 beats) "
     "and from `c.y` (published every beat), so the queue of 8 is full sooner or later, which cca::reject "
     "forbids: read faster, or say what is lost: cca::drop_oldest or cca::drop_newest"}));
static_assert(!cca::well_formed<merged_overflow<cca::timed<2>, cca::restless, 1>>);  // both in one beat
static_assert(cca::well_formed<merged_overflow<cca::timed<2>, cca::restless, 2>>);
static_assert(cca::well_formed<merged_overflow<cca::timed<2, 1>, cca::restless, 1>>);
static_assert(!cca::well_formed<merged_overflow<cca::timed<2, 1>, cca::restless, 1, cca::delayed<1>>>);
static_assert(cca::well_formed<merged_overflow<cca::timed<2, 1>, cca::restless, 1, cca::delayed<2>>>);
static_assert(!cca::well_formed<merged_overflow<cca::timed<2>, cca::timed<2>, 100>>);
static_assert(!cca::well_formed<merged_overflow<cca::inactive, cca::inactive, 100>>);
static_assert(
    !cca::well_formed<merged_overflow<cca::timed<4>, cca::timed<2, 9>, 5>>);  // until it is first read
static_assert(cca::well_formed<merged_overflow<cca::timed<4>, cca::timed<1, 8>, 8>>);

static_assert(tells<merged_overflow<cca::timed<2>, cca::timed<2>, 16>,
                    merged_overflow<cca::timed<4, 1>, cca::timed<1>, 16>>(
    {"queue.overflow", "a.y -> b.x",
     "`b.x` is read every 2 beats, but samples come from `a.y` (published every 2 beats) and from `c.y` "
     "(published every 2 beats), so the queue of 16 is full sooner or later, which cca::reject forbids: "
     "read faster, or say what is lost: cca::drop_oldest or cca::drop_newest"}));

// A delayed sample fills the queue when it arrives.
template <int Room, int Delay>
struct delayed_overflow : khz<cca::node<"a", source<>>,
                              cca::node<"b", late_reader, cca::port_triggered<"late">>,
                              cca::wire<"a.y", "b.late", cca::delayed<10>>,
                              cca::wire<"a.y", "b.x", cca::queue<Room, cca::reject>, cca::delayed<Delay>>> {};
static_assert(!cca::well_formed<delayed_overflow<7, 3>>);
static_assert(cca::well_formed<delayed_overflow<8, 3>>);
static_assert(cca::well_formed<delayed_overflow<1, 10>>);

// What waits when it is first read waits as long ever after.
template <int Room, int Beats>
struct age_at_first : khz<cca::node<"a", source<>>,
                          cca::node<"b", late_reader, cca::port_triggered<"late">>,
                          cca::wire<"a.y", "b.late", cca::delayed<10>>,
                          cca::wire<"a.y", "b.x", cca::queue<Room, cca::drop_oldest>>,
                          cca::require<cca::latency<"a.y", "b.x">, cca::beats<Beats>>> {};
static_assert(cca::well_formed<age_at_first<20, 10>> &&
              cca::diagnosis<age_at_first<20, 9>>.rule == "latency.exceeded");
static_assert(cca::well_formed<age_at_first<4, 3>> &&
              cca::diagnosis<age_at_first<4, 2>>.rule == "latency.exceeded");

struct loop
    : khz<cca::node<"a", step<>>, cca::node<"b", step<>>, cca::wire<"a.y", "b.x">, cca::wire<"b.y", "a.x">> {
};
struct loop_mended : khz<cca::node<"a", step<>>,
                         cca::node<"b", step<>>,
                         cca::wire<"a.y", "b.x">,
                         cca::wire<"b.y", "a.x", cca::delayed<1>>> {};
static_assert(tells<loop, loop_mended>(
    {"graph.algebraic_loop", "b.y -> a.x",
     "`a.y` -> `b.x`, `b.y` -> `a.x` are a loop without delay, so none of their components can come first; "
     "say where it may be a beat late: cca::wire<`b.y`, `a.x`, cca::delayed<1>>"}));

struct loop_of_three : khz<cca::node<"z", source<>>,
                           cca::node<"a", merge<>>,
                           cca::node<"b", step<>>,
                           cca::node<"c", step<>>,
                           cca::node<"d", sink<>>,
                           cca::wire<"z.y", "a.a">,
                           cca::wire<"a.y", "b.x">,
                           cca::wire<"b.y", "c.x">,
                           cca::wire<"c.y", "a.b", cca::queue<2, cca::drop_oldest>>,
                           cca::wire<"c.y", "d.x">> {};
struct loop_of_three_mended : khz<cca::node<"z", source<>>,
                                  cca::node<"a", merge<>>,
                                  cca::node<"b", step<>>,
                                  cca::node<"c", step<>>,
                                  cca::node<"d", sink<>>,
                                  cca::wire<"z.y", "a.a">,
                                  cca::wire<"a.y", "b.x">,
                                  cca::wire<"b.y", "c.x">,
                                  cca::wire<"c.y", "a.b", cca::delayed<2>>,
                                  cca::wire<"c.y", "d.x">> {};
static_assert(tells<loop_of_three, loop_of_three_mended>(
    {"graph.algebraic_loop", "c.y -> a.b",
     "`a.y` -> `b.x`, `b.y` -> `c.x`, `c.y` -> `a.b` are a loop without delay, so none of their components "
     "can come first; say where it may be a beat late: cca::wire<`c.y`, `a.b`, cca::delayed<1>>"}));

struct loop_of_one : khz<cca::node<"a", step<>>, cca::wire<"a.y", "a.x">> {};
struct loop_of_one_mended : khz<cca::node<"a", step<>>, cca::wire<"a.y", "a.x", cca::delayed<1>>> {};
static_assert(tells<loop_of_one, loop_of_one_mended>(
    {"graph.algebraic_loop", "a.y -> a.x",
     "`a.y` -> `a.x` is a loop without delay, so its component would have to come before itself; say where "
     "it may be a beat late: cca::wire<`a.y`, `a.x`, cca::delayed<1>>"}));

struct eye {
  auto sense(cca::in<"x", signal>) -> cca::out<"y", signal> { return {}; }
};

struct backwards
    : khz<cca::node<"e", eye>, cca::node<"a", step<>>, cca::wire<"e.y", "a.x">, cca::wire<"a.y", "e.x">> {};
struct backwards_mended : khz<cca::node<"e", eye>,
                              cca::node<"a", step<>>,
                              cca::wire<"e.y", "a.x">,
                              cca::wire<"a.y", "e.x", cca::delayed<1>>> {};
static_assert(tells<backwards, backwards_mended>(
    {"graph.algebraic_loop", "a.y -> e.x",
     "`a.y` -> `e.x` leads back within a beat, which is: every sense, then every component, then every act; "
     "say where it may be a beat late: cca::wire<`a.y`, `e.x`, cca::delayed<1>>"}));

struct filter : cca::graph<cca::node<"a", step<>>,
                           cca::node<"b", step<>>,
                           cca::wire<"a.y", "b.x">,
                           cca::expose<"a.x", "in">,
                           cca::expose<"b.y", "out">> {};

template <class... Delay>
struct around_filter : khz<cca::node<"inner", filter>,
                           cca::node<"outer", step<>>,
                           cca::wire<"inner.out", "outer.x">,
                           cca::wire<"outer.y", "inner.in", Delay...>> {};
static_assert(tells<around_filter<>, around_filter<cca::delayed<1>>>(
    {"graph.algebraic_loop", "outer.y -> inner.a.x",
     "`inner.a.y` -> `inner.b.x`, `inner.b.y` -> `outer.x`, `outer.y` -> `inner.a.x` are a loop without "
     "delay, so none of their components can come first; say where it may be a beat late: "
     "cca::wire<`outer.y`, `inner.in`, cca::delayed<1>>"}));

struct watcher {
  auto process(cca::observe<"a.*">) -> cca::out<"y", signal> { return {}; }
};
struct late_watcher {
  auto process(cca::observe<"a.*", cca::delayed<1>>) -> cca::out<"y", signal> { return {}; }
};

struct observed_loop : khz<cca::node<"o", watcher>, cca::node<"a", step<>>, cca::wire<"o.y", "a.x">> {};
struct observed_loop_mended
    : khz<cca::node<"o", late_watcher>, cca::node<"a", step<>>, cca::wire<"o.y", "a.x">> {};
static_assert(tells<observed_loop, observed_loop_mended>(
    {"graph.algebraic_loop", "o",
     "`o` observes `a.*`, and so `a.y`, which depends on what it publishes itself, so neither can come "
     "first; let it observe a beat later: cca::observe<`a.*`, cca::delayed<1>>"}));

struct old : khz<cca::node<"a", source<>>,
                 cca::node<"b", sink<>>,
                 cca::wire<"a.y", "b.x", cca::delayed<3>>,
                 cca::require<cca::latency<"a.y", "b.x">, cca::beats<2>>> {};
struct old_mended : khz<cca::node<"a", source<>>,
                        cca::node<"b", sink<>>,
                        cca::wire<"a.y", "b.x", cca::delayed<2>>,
                        cca::require<cca::latency<"a.y", "b.x">, cca::beats<2>>> {};
static_assert(tells<old, old_mended>(
    {"latency.exceeded", "a.y -> b.x",
     "a sample of `a.y` can be 3 beats old when `b.x` is read, but old requires at most 2: shorten a delay "
     "or a queue on the way, or run the components on it more often"}));

template <int Beats>
struct old_by_one : khz<cca::node<"a", source<>>,
                        cca::node<"b", sink<>>,
                        cca::wire<"a.y", "b.x", cca::delayed<1>>,
                        cca::require<cca::latency<"a.y", "b.x">, cca::beats<Beats>>> {};
static_assert(tells<old_by_one<0>, old_by_one<1>>(
    {"latency.exceeded", "a.y -> b.x",
     "a sample of `a.y` can be 1 beat old when `b.x` is read, but old_by_one<0> requires at most 0: "
     "shorten a delay or a queue on the way, or run the components on it more often"}));

struct perhaps {
  auto process(cca::in<"x", signal>) -> cca::maybe<"y", signal> { return {}; }
};

struct of_any_age : khz<cca::node<"a", source<>>,
                        cca::node<"p", perhaps>,
                        cca::node<"b", sink<>>,
                        cca::wire<"a.y", "p.x">,
                        cca::wire<"p.y", "b.x">,
                        cca::require<cca::latency<"a.y", "b.x">, cca::beats<9>>> {};
struct of_any_age_mended : khz<cca::node<"a", source<>>,
                               cca::node<"p", step<>>,
                               cca::node<"b", sink<>>,
                               cca::wire<"a.y", "p.x">,
                               cca::wire<"p.y", "b.x">,
                               cca::require<cca::latency<"a.y", "b.x">, cca::beats<0>>> {};
static_assert(tells<of_any_age, of_any_age_mended>(
    {"latency.exceeded", "a.y -> b.x",
     "a sample of `a.y` can be of any age when `b.x` is read, but of_any_age requires at most 9: a clock on "
     "the way is known only at run time; make those components cca::timed"}));

}  // namespace
