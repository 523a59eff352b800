// Patterns between environments: they hear the same samples as in one loop.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include <cca/deployment.hpp>

#include "../core/counting.hpp"

using namespace core_test;

namespace {

struct heard {
  std::int64_t beat;
  std::string path;
  double value;
  std::int64_t origin;
  bool fresh;
  friend bool operator==(const heard&, const heard&) = default;
};
template <class Observe>
struct ear {
  void process(Observe all, cca::beat now) {
    for (const auto& one : all)
      log.push_back({now.index(), std::string(one.path), one.values[0], one.origin, one.fresh});
  }
  std::vector<heard> log;
};

// Outputs, and inputs with a delay, from the graph around and from the outermost one.
struct arm : cca::graph<cca::node<"counter", counter, cca::timed<2>>,
                        cca::node<"sum", adder>,
                        cca::node<"slow", adder, cca::timed<5>>,
                        cca::wire<"counter.y", "sum.x", cca::delayed<2>>,
                        cca::wire<"counter.y", "slow.x", cca::delayed<1>, cca::queue<3>>> {};
struct mind
    : cca::graph<cca::node<"all", ear<cca::observe<"arm.**", cca::delayed<1>>>, cca::timed<1>>,
                 cca::node<"sums", ear<cca::observe<"/**.sum.*", cca::delayed<3>>>, cca::timed<3>>,
                 cca::node<"taken", ear<cca::observe<"/**.slow.x.**", cca::delayed<2>>>>,
                 cca::node<"queue",
                           ear<cca::observe<"*.counter.y", cca::delayed<1>, cca::queue<2, cca::drop_newest>>>,
                           cca::timed<5>>> {};
struct whole : cca::graph<cca::rate<1000>,
                          cca::node<"mind", mind>,
                          cca::node<"arm", arm>,
                          cca::observe<"arm.**">,
                          cca::observe<"arm.slow.**", cca::delayed<3>>> {};
struct split : cca::deployment<whole,
                               cca::environment<"body", cca::nodes<"arm.counter">>,
                               cca::environment<"sums", cca::nodes<"arm.sum">>,
                               cca::environment<"mind", cca::other_nodes>> {};

template <class Controller>
std::vector<std::vector<heard>> told(Controller& c) {
  c.load();
  c.start();
  c.run(cca::for_beats<40>{});
  std::vector<std::vector<heard>> all{c.template get<"mind.all">().log,
                                      c.template get<"mind.sums">().log,
                                      c.template get<"mind.queue">().log,
                                      c.template get<"mind.taken">().log,
                                      {}};
  c.observed([&](const cca::observation& one) {
    all.back().push_back({c.beat_index(), std::string(one.path), one.values[0], one.origin, one.fresh});
  });
  return all;
}

}  // namespace

TEST_SUITE("scopes between environments") {
  TEST_CASE("observers get what they get in one loop") {
    cca::controller<whole> one;
    cca::deployed<split> environments;
    const auto expected = told(one);
    CHECK(told(environments) == expected);
    REQUIRE(expected.size() == 5);
    CHECK(expected[0].size() == 5 * 40);  // three outputs and two inputs
    CHECK(expected[0][3].path == "arm.sum.x");
    CHECK(expected[0][4].path == "arm.slow.x");
    CHECK(expected[1].size() == 14);
    CHECK(expected[2].size() == 8);
    CHECK(expected[3].size() == 7);  // in beats 7, 12, ..., 37: the queue is empty in beat 0
    CHECK(expected[4].size() == 7);
  }
}
