// A beat never calls malloc, with any strategy and any policy. core/allocations.cpp tests copies and faults.
#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>

#include <cca/cca.hpp>

namespace laws {
std::size_t allocations();
}

namespace {

struct plane : cca::space<cca::number, cca::axes<cca::x, cca::y>> {};
struct turned : cca::space<cca::orientation<plane>, cca::axes<cca::x, cca::y, cca::z>> {};

struct source {
  double n = 0;
  auto process(cca::beat now) -> cca::out<"y", plane> {
    n += now.dt();
    return Eigen::Vector2d(n, -n);
  }
};
struct seldom {
  auto process(cca::beat now) -> cca::maybe<"y", plane> {
    if (now.index() % 7 > 2) return {};
    return Eigen::Vector2d(1, static_cast<double>(now.index()));
  }
};
struct filter {
  Eigen::Vector2d s{0, 0};
  auto process(cca::in<"x", plane> x) -> cca::out<"y", plane> {
    return Eigen::Vector2d(s += 0.5 * (x.vector() - s));
  }
};
struct sum {
  Eigen::Vector2d s{0, 0};
  auto process(cca::in<"a", plane> a, cca::in<"b", plane> b, cca::optional_in<"c", plane>)
      -> cca::out<"y", plane> {
    return Eigen::Vector2d(s += a.vector() + b.vector());
  }
};
struct spin {
  auto process(cca::in<"x", plane> x) -> cca::out<"q", turned> {
    return Eigen::Vector4d(0, 0, std::sin(x[cca::x{}] / 2), std::cos(x[cca::x{}] / 2));
  }
};
struct ear {
  double total = 0;
  void process(cca::observe<"inner.**"> all) {
    for (const auto& one : all) total += one.values[0];
  }
};
struct every_other {
  template <class Inputs>
  static bool fires(cca::beat now, const Inputs& in) {
    return now.index() % 2 == 0 && in.template get<"x">().fresh();
  }
};

struct inner : cca::graph<cca::node<"f", filter>,
                          cca::node<"g", filter>,
                          cca::wire<"f.y", "g.x">,
                          cca::expose<"f.x", "x">,
                          cca::expose<"g.y", "y">> {};

// Every strategy and every policy of a wire.
struct all : cca::graph<cca::rate<1000>,
                        cca::node<"source", source>,
                        cca::node<"slow", source, cca::timed<5, 2>>,
                        cca::node<"seldom", seldom>,
                        cca::node<"inner", inner>,
                        cca::node<"restless", sum, cca::restless>,
                        cca::node<"moderate", sum, cca::moderate>,
                        cca::node<"together", sum, cca::coordinated>,
                        cca::node<"named", sum, cca::port_triggered<"b">>,
                        cca::node<"patient", sum, cca::any_of<cca::moderate, cca::timeout<15>>>,
                        cca::node<"both", sum, cca::all_of<cca::restless, cca::timed<3>>>,
                        cca::node<"always", sum, cca::full_speed>,
                        cca::node<"never", sum, cca::inactive>,
                        cca::node<"own", filter, every_other>,
                        cca::node<"oldest", filter>,
                        cca::node<"newest", filter, cca::timed<4>>,
                        cca::node<"ear", ear>,
                        cca::node<"spin", spin>,
                        cca::wire<"source.y", "inner.x">,
                        cca::wire<"source.y", "restless.a">,
                        cca::wire<"seldom.y", "restless.b">,
                        cca::wire<"slow.y", "moderate.a", cca::latest>,
                        cca::wire<"seldom.y", "moderate.b">,
                        cca::wire<"source.y", "together.a">,
                        cca::wire<"inner.y", "together.b">,
                        cca::wire<"source.y", "named.a", cca::delayed<3>>,
                        cca::wire<"seldom.y", "named.b", cca::delayed<2>>,
                        cca::wire<"slow.y", "patient.a", cca::latest>,
                        cca::wire<"seldom.y", "patient.b">,
                        cca::wire<"source.y", "both.a", cca::latest, cca::initial<1, 2>>,
                        cca::wire<"restless.y", "both.b", cca::delayed<1>, cca::initial<3>>,
                        cca::wire<"source.y", "always.a">,
                        cca::wire<"moderate.y", "always.b">,
                        cca::wire<"source.y", "never.a", cca::latest>,
                        cca::wire<"source.y", "never.b", cca::latest>,
                        cca::wire<"seldom.y", "own.x">,
                        cca::wire<"seldom.y", "oldest.x", cca::queue<3, cca::drop_oldest>>,
                        cca::wire<"source.y", "newest.x", cca::queue<3, cca::drop_newest>>,
                        cca::wire<"oldest.y", "spin.x">,
                        cca::observe<"inner.**">> {};

}  // namespace

TEST_SUITE("no allocation") {
  TEST_CASE("the counter counts") {
    const auto before = laws::allocations();
    void* volatile memory = std::malloc(10);
    std::free(memory);
    CHECK_EQ(laws::allocations() - before, 1);
  }

  TEST_CASE("a thousand beats of all strategies and policies allocate nothing") {
    cca::controller<all> c;
    c.load();
    c.start();
    const auto before = laws::allocations();
    for (int k = 0; k < 1000; ++k) c.step();
    const auto after = laws::allocations();
    CHECK_EQ(after, before);
    CHECK_NE(c.get<"restless">().s[0], 0);
    CHECK_NE(c.get<"newest">().s[0], 0);
    CHECK_NE(c.get<"ear">().total, 0);
  }

}  // TEST_SUITE
