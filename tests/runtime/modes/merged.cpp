// Merged wires and delayed queues in a set of modes: a queue that both modes have keeps its samples,
// one that the other mode lacks begins empty.
#include <doctest/doctest.h>

#include <vector>

#include <cca/modes.hpp>

namespace {

struct reading : cca::space<cca::number, cca::axes<cca::x>> {};

template <int Base>
struct counter {
  auto process(cca::beat now) -> cca::out<"y", reading> { return Base + static_cast<double>(now.index()); }
};
struct journal {
  std::vector<double> all;
  void process(cca::in<"x", reading> x) { all.push_back(x.fresh() ? x[cca::x{}] : -1); }
};

template <class... More>
struct read_by_two : cca::graph<cca::rate<1000>,
                                cca::node<"a", counter<100>, cca::timed<2>>,
                                cca::node<"b", counter<200>, cca::timed<4>>,
                                cca::node<"r", journal, cca::timed<1>>,
                                cca::wire<"a.y", "r.x", cca::merged<8>, cca::delayed<3>>,
                                More...> {};
struct only_a : read_by_two<> {};
struct both : read_by_two<cca::wire<"b.y", "r.x", cca::merged<8>>> {};
struct b_later : read_by_two<cca::wire<"b.y", "r.x", cca::merged<8>, cca::delayed<2>>> {};
struct neither : cca::graph<cca::rate<1000>,
                            cca::node<"a", counter<100>, cca::timed<2>>,
                            cca::node<"b", counter<200>, cca::timed<4>>,
                            cca::node<"r", journal, cca::timed<1>>,
                            cca::wire<"a.y", "r.x", cca::latest>> {};

struct all_of_them : cca::modes<cca::mode<"both", both>,
                                cca::mode<"only_a", only_a>,
                                cca::mode<"b_later", b_later>,
                                cca::mode<"neither", neither>> {};

std::vector<double> seen_in(cca::controller<all_of_them>& c, int beats) {
  const std::size_t before = c.get<"r">().all.size();
  for (int k = 0; k < beats; ++k) c.step();
  const auto& all = c.get<"r">().all;
  return {all.begin() + static_cast<std::ptrdiff_t>(before), all.end()};
}
using values = std::vector<double>;

}  // namespace

TEST_SUITE("merged") {
  TEST_CASE("modes with other wires into one queue share it, and what is on its way") {
    cca::controller<all_of_them> c;
    c.load();
    c.start();
    CHECK(seen_in(c, 6) == values{200, -1, -1, 100, 204, 102});  // a arrives in beats 3, 5, 7, ...
    c.switch_to<"only_a">();
    CHECK(seen_in(c, 4) == values{-1, 104, -1, 106});  // what a published in the other mode arrives
    c.switch_to<"b_later">();                          // beat 10: b publishes in beat 12, arrives in 14
    CHECK(seen_in(c, 6) == values{-1, 108, -1, 110, 212, 112});
    c.switch_to<"both">();
    CHECK(seen_in(c, 2) == values{216, 114});
  }

  TEST_CASE("a mode without the queue: it begins anew, and so does what was on its way") {
    cca::controller<all_of_them> c;
    c.load();
    c.start();
    CHECK(seen_in(c, 5) == values{200, -1, -1, 100, 204});
    c.switch_to<"neither">();
    CHECK(seen_in(c, 1) == values{-1});  // a published in beat 4
    c.switch_to<"both">();
    CHECK(seen_in(c, 5) == values{-1, -1, 208, 106, -1});
  }
}
