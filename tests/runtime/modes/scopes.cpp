// Patterns in modes: each mode looks them up in its own graph.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include <cca/modes.hpp>
#include <cca/runtime/modes/mode_controller.hpp>

#include "../core/counting.hpp"

using namespace core_test;

namespace {

struct ear {
  void process(cca::observe<"/**.sum.**"> all) {
    for (const auto& one : all)
      log.push_back(std::string(one.path) + " " + std::to_string(static_cast<int>(one.values[0])));
  }
  std::vector<std::string> log;
};
struct listener : cca::graph<cca::node<"ear", ear, cca::timed<1>>> {};
template <class Inner>
struct one_mode : cca::graph<cca::rate<1000>,
                             cca::node<"counter", counter>,
                             cca::node<"sum", Inner>,
                             cca::node<"mind", listener>,
                             cca::wire<"counter.y", "sum.x", cca::delayed<1>>> {};
struct twice : cca::graph<cca::rate<1000>,
                          cca::node<"counter", counter>,
                          cca::node<"sum", adder>,
                          cca::node<"sums", cca::graph<cca::node<"sum", adder>, cca::expose<"sum.x", "x">>>,
                          cca::node<"mind", listener>,
                          cca::wire<"counter.y", "sum.x", cca::delayed<1>>,
                          cca::wire<"counter.y", "sums.x">> {};
struct both : cca::modes<cca::mode<"one", one_mode<adder>>, cca::mode<"twice", twice>> {};

}  // namespace

TEST_SUITE("scopes in modes") {
  TEST_CASE("an observer hears what the pattern names in the active mode") {
    auto c = started<both>();
    c.run(cca::for_beats<2>{});
    using lines = std::vector<std::string>;
    CHECK_EQ(c.get<"mind.ear">().log, lines{"sum.y 0", "sum.x 0", "sum.y 1", "sum.x 1"});
    c.get<"mind.ear">().log.clear();
    c.switch_to<"twice">();
    c.step();
    CHECK_EQ(c.get<"mind.ear">().log, lines{"sum.y 3", "sums.sum.y 3", "sum.x 2", "sums.sum.x 3"});
  }
}
