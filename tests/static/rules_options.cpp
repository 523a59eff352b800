// Rules about options of wires, and several wires at one input: the message of each mistake, and that the
// mended graph is sound.
#include "rules_parts.hpp"

namespace {

using namespace parts;

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

}  // namespace
