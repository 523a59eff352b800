// The parts of examples/deployed: an architecture with other items, and the record of all samples.
#include <array>
#include <limits>
#include <type_traits>

#include <doctest/doctest.h>

#include <cca/cca.hpp>

#include "../../../examples/deployed/recorder.hpp"
#include "../../../examples/deployed/with_items.hpp"

namespace {

struct number : cca::space<cca::number, cca::axes<cca::x>> {};
struct source {
  auto process(cca::beat now) -> cca::out<"y", number> { return static_cast<double>(now.index()); }
};
struct middle {
  auto process(cca::in<"x", number> is) -> cca::out<"y", number> { return 2 * is[cca::x{}]; }
};

struct near : cca::graph<cca::rate<1000>,
                         cca::node<"source", source>,
                         cca::node<"middle", middle, cca::timed<1>>,
                         cca::wire<"source.y", "middle.x">> {};
struct distant : deployed::with_items<near,
                                      cca::wire<"source.y", "middle.x", cca::delayed<3>>,
                                      cca::node<"recorder", deployed::recorder, cca::timed<1>>> {};

static_assert(std::is_same_v<distant::cca_items,
                             cca::detail::list<cca::rate<1000>,
                                               cca::node<"source", source>,
                                               cca::node<"middle", middle, cca::timed<1>>,
                                               cca::wire<"source.y", "middle.x", cca::delayed<3>>,
                                               cca::node<"recorder", deployed::recorder, cca::timed<1>>>>);

cca::controller<distant> played(std::int64_t beats) {
  cca::controller<distant> c;
  c.get<"recorder">().seen.reserve(beats);
  c.load();
  c.start();
  c.run(cca::for_some_beats{beats});
  return c;
}

// A beat in which one output published this number, or nothing.
void note(deployed::record& into, double value, std::int64_t origin, bool fresh) {
  const std::array values{value};
  const std::array all{cca::observation{"far.y", values, origin, fresh}};
  into.note({all.data(), all.size()});
}

}  // namespace

TEST_SUITE("deployed example") {
  TEST_CASE("a record has every sample of every output") {
    const auto one = played(50), other = played(50);
    const auto& seen = one.get<"recorder">().seen;
    CHECK_EQ(seen.beats(), 50);
    const auto all = seen.compare(other.get<"recorder">().seen, 50);
    CHECK_EQ(all.compared, 2 * 49);  // in its first beat it hears nothing
    CHECK_EQ(all.different, 0);
    CHECK_FALSE(all.first.has_value());
  }

  TEST_CASE("the first difference has an output and a beat: a number, an origin, a sample too much") {
    const auto differs = [](double value, std::int64_t origin, bool fresh) {
      deployed::record one, other;
      for (auto* r : {&one, &other}) {
        r->reserve(10);
        for (int beat = 0; beat < 5; ++beat) note(*r, beat, beat, true);
      }
      note(one, 5, 5, true);
      note(other, value, origin, fresh);
      const auto all = one.compare(other, 6);
      CHECK_EQ(all.compared, 6);
      if (all.first) {
        CHECK_EQ(all.first->output, "far.y");
        CHECK_EQ(all.first->beat, 4);  // heard one beat later
      }
      CHECK_EQ(one.compare(other, 5).different, 0);
      return all.different;
    };
    CHECK_EQ(differs(5, 5, true), 0);
    CHECK_EQ(differs(5 + 4 * std::numeric_limits<double>::epsilon(), 5, true), 1);
    CHECK_EQ(differs(5, 4, true), 1);
    CHECK_EQ(differs(5, 5, false), 1);
  }

  TEST_CASE("records of unequal length or outputs differ") {
    deployed::record one, other;
    one.reserve(2);
    other.reserve(2);
    note(one, 1, 1, true);
    CHECK_EQ(one.compare(other, 1).different, 1);
  }
}
