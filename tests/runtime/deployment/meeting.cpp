// How environments begin a run, with the record of one that is elsewhere as it may have come: late.
#include <doctest/doctest.h>

#include <memory>

#include <cca/deployment.hpp>

namespace {

struct number : cca::space<cca::number, cca::axes<cca::x>> {};
struct source {
  cca::out<"y", number> process(cca::beat now) { return now.dt(); }
};
struct sink {
  void process(cca::in<"x", number>) {}
};
struct two : cca::graph<cca::rate<100>,
                        cca::node<"one", source>,
                        cca::node<"other", sink>,
                        cca::wire<"one.y", "other.x", cca::delayed<1>>> {};
struct split : cca::deployment<two,
                               cca::environment<"here", cca::nodes<"one">>,
                               cca::environment<"there", cca::other_nodes>> {};

struct rig {
  std::unique_ptr<cca::detail::exchange<split>> shared = std::make_unique<cca::detail::exchange<split>>();
  cca::detail::environments_here<split> here{true, false};
  cca::detail::meeting<split> together{*shared, here, nullptr};

  // At most 50 ms. `stops`: how often it was stopped here.
  cca::detail::terms_of_run agree(std::int64_t stops) {
    cca::detail::idle_beats idle(10'000'000, 0);
    cca::detail::terms_of_run wanted;
    wanted.stops = stops;
    return together.agree(wanted, 10, 50'000'000, idle, [] {}, [] { return true; });
  }
};

TEST_SUITE("meeting") {
  TEST_CASE("a stop of the others ends what waits for them") {
    rig r;
    r.shared->environments[1].stopped = 1;
    CHECK(r.agree(0).is_stopped);
  }
  TEST_CASE("a stop that both have called is over, although the news of the other's start has not come") {
    rig r;
    r.shared->environments[1].stopped = 1;
    CHECK_THROWS_AS(r.agree(1), cca::refused);  // waits for it, for 50 ms
    r.shared->environments[1].stopped = 2;
    CHECK(r.agree(1).is_stopped);
  }
}

}  // namespace
