// What a plan makes room for, and how a long beat is cut. A bound that is too wide costs clang's limit of
// constexpr steps.
#include <cca/deployment.hpp>

namespace {

struct number : cca::space<cca::number, cca::axes<cca::x>> {};

struct source {
  cca::out<"y", number> process(cca::beat now) { return now.dt(); }
};
struct sink {
  void process(cca::in<"x", number> x, cca::in<"z", number>) { last = x[cca::x{}]; }
  double last = 0;
};

// Four ports, each under a name of its own.
struct apart : cca::graph<cca::node<"a", sink>,
                          cca::node<"b", sink>,
                          cca::expose<"a.x", "ax">,
                          cca::expose<"a.z", "az">,
                          cca::expose<"b.x", "bx">,
                          cca::expose<"b.z", "bz">> {};
// Two of them under one name.
struct together : cca::graph<cca::node<"a", sink>,
                             cca::node<"b", sink>,
                             cca::expose<"a.x", "x">,
                             cca::expose<"b.x", "x">,
                             cca::expose<"a.z", "az">,
                             cca::expose<"b.z", "bz">> {};

template <class Inner, cca::fixed_string Port>
struct merging : cca::graph<cca::rate<100>,
                            cca::node<"one", source>,
                            cca::node<"other", source>,
                            cca::node<"inner", Inner>,
                            cca::wire<"one.y", Port, cca::merged<4>>,
                            cca::wire<"other.y", Port, cca::merged<4>>> {};

static_assert(cca::detail::graph_size<merging<apart, "inner.ax">>.ways() == 4 + 2);
static_assert(cca::detail::graph_size<merging<together, "inner.x">>.ways() == 4 + 2 * 2);

static_assert(cca::detail::one_pattern("a.**.**.b.**").path.count() == 4);

// The parts of a deployment cut a beat where it was planned to be cut.
struct two : cca::graph<cca::rate<100>,
                        cca::node<"one", source>,
                        cca::node<"other", sink>,
                        cca::wire<"one.y", "other.x", cca::delayed<1>>,
                        cca::wire<"one.y", "other.z", cca::delayed<1>>> {};
struct split : cca::deployment<two,
                               cca::environment<"a", cca::nodes<"one">>,
                               cca::environment<"b", cca::other_nodes>> {};

}  // namespace

template <>
constexpr int cca::detail::calls_in_part<split> = 1;
static_assert(cca::detail::calls_in_part<cca::detail::part<split, 0>> == 1);
static_assert(cca::detail::calls_in_part<cca::detail::part<split, 1>> == 1);
