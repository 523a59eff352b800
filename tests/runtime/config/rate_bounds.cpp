// Bounds that follow from the rate of a node: a file that breaks one is refused whole, with its line.
#include <string>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/config.hpp>

#include "../../laws/temporary_file.hpp"

namespace {

struct level : cca::space<cca::number, cca::axes<cca::x>> {};
struct filter {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (cca::bounded<double, 0, 1000>, rate), (double, gain));
    std::string check_at(double step) const {
      return rate * step <= 1 ? "" : "`rate` is too fast for this node";
    }
  };
  parameters p{10.0, 1.0};
  auto process(cca::in<"x", level> x) -> cca::out<"y", level> { return (p.gain * x.vector()).eval(); }
};
struct source {
  auto process() -> cca::out<"y", level> { return 1.0; }
};
struct filtered : cca::graph<cca::rate<1000>,
                             cca::node<"source", source>,
                             cca::node<"fast", filter>,
                             cca::node<"slow", filter, cca::timed<100>>,
                             cca::wire<"source.y", "fast.x">,
                             cca::wire<"source.y", "slow.x", cca::latest>> {};

std::string refusal(cca::controller<filtered>& c, const std::string& text) {
  const laws::temporary_file file("rate.toml", text);
  std::string words;
  try {
    c.load(file.path);
  } catch (const cca::refused& refused) { words = refused.what(); }
  return words;
}

}  // namespace

TEST_CASE("a file with parameters that are too fast for their node is refused whole") {
  cca::controller<filtered> c;
  const std::string words = refusal(c, "[fast]\nrate = 500.0\ngain = 3.0\n\n[slow]\nrate = 20.0\n");
  CHECK(words.ends_with(".toml:5: slow: `rate` is too fast for this node"));
  CHECK(c.get<"fast">().p.gain == 1.0);  // nothing was set
  CHECK(c.get<"slow">().p.rate == 10.0);
  CHECK(refusal(c, "[fast]\nrate = 500.0\n\n[slow]\nrate = 9.0\n") == "");
  CHECK(c.get<"fast">().p.rate == 500.0);
  CHECK_THROWS_AS(c.set<"slow">({20.0, 1.0}), cca::refused);
  CHECK_NOTHROW(c.set<"fast">({900.0, 1.0}));
}

TEST_CASE("so is a parameter that is set by its path") {
  cca::controller<filtered> c;
  CHECK_THROWS_WITH_AS(c.set("slow.rate", 20.0),
                       "cca::controller: set: slow: `rate` is too fast for this node", cca::refused);
  CHECK(c.get<"slow">().p.rate == 10.0);
  CHECK_NOTHROW(c.set("fast.rate", 900.0));
}
