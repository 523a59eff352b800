// After a fault dt() is the time since a component last fired, whatever mode comes next.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include <cca/modes.hpp>
#include <cca/runtime/modes/mode_controller.hpp>

#include "../core/counting.hpp"

using namespace core_test;

namespace {

struct failing {
  auto process(cca::beat now) -> cca::fault {
    return now.index() == fails_in ? cca::fault("as planned") : cca::fault();
  }
  std::int64_t fails_in = -1;
};
struct timekeeper {
  auto process(cca::beat now) -> cca::out<"y", reading> {
    beats.push_back(now.index());
    told.push_back(std::llround(now.dt() * 1e9 / static_cast<double>(now.period())));
    return 1;
  }
  bool is_right() const {
    for (std::size_t i = 1; i < beats.size(); ++i)
      if (told[i] != beats[i] - beats[i - 1]) return false;
    return true;
  }
  std::vector<std::int64_t> beats{}, told{};
};

// In `safe` nothing faults, so there no firing is missed; one clock is another one.
struct risky : cca::graph<cca::rate<1000>,
                          cca::node<"fails", failing>,
                          cca::node<"steady", timekeeper, cca::timed<3>>,
                          cca::node<"other", timekeeper, cca::timed<2>>> {};
struct safe : cca::graph<cca::rate<1000>,
                         cca::node<"steady", timekeeper, cca::timed<3>>,
                         cca::node<"other", timekeeper, cca::timed<5, 1>>> {};
struct both : cca::modes<cca::mode<"risky", risky>, cca::mode<"safe", safe>> {};

}  // namespace

TEST_SUITE("faults in modes") {
  TEST_CASE("a firing that a fault kept from a component counts in no mode") {
    for (std::int64_t fault = 0; fault < 8; ++fault)
      for (std::int64_t change = fault + 1; change < fault + 8; ++change) {
        CAPTURE(fault);
        CAPTURE(change);
        auto c = started<both>();
        c.get<"fails">().fails_in = fault;
        while (c.beat_index() < 30) {
          if (c.state() == cca::state::faulted) c.resume();
          if (c.beat_index() == change) c.switch_to<"safe">();
          if (c.beat_index() == change + 6) c.switch_to<"risky">();
          c.step();
        }
        CHECK(c.get<"steady">().is_right());
        CHECK(c.get<"other">().is_right());
      }
  }
}
