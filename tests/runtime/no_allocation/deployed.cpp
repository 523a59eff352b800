// A beat of an environment allocates nothing, at any pace and over any transport. Each environment counts
// the allocations of its own thread between two of its beats, with sending, receiving and waiting. The
// threads of a transport run no beats, so they are not counted.
#include <doctest/doctest.h>

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include <cca/deployment.hpp>

#include "../../laws/process.hpp"
#include "../dds/over_dds.hpp"

namespace laws {
std::size_t allocations_of_this_thread();
}

namespace {

struct plane : cca::space<cca::number, cca::axes<cca::x, cca::y>> {};

// Fires once in each beat of its environment. So between its first firing and its last the thread does all
// that belongs to a beat, many times.
struct tally {
  std::vector<std::size_t> spoils;  // allocates in the beat that a test names
  std::int64_t spoilt = -1, fired = 0;
  std::size_t before = 0, newest = 0;
  auto process(cca::beat now) -> cca::out<"y", plane> {
    newest = laws::allocations_of_this_thread();
    if (fired++ == 0) before = newest;
    if (now.index() == spoilt) spoils.resize(1000);
    return Eigen::Vector2d(static_cast<double>(now.index()), 1);
  }
  // What its thread allocated, in many beats.
  std::string said() const {
    return (fired < 100 ? "only " + std::to_string(fired) + " beats, " : "") +
           std::to_string(newest - before);
  }
};

struct seldom {
  auto process(cca::in<"x", plane> x, cca::beat now) -> cca::maybe<"y", plane> {
    if (now.index() % 7 > 2) return {};
    return Eigen::Vector2d(x[cca::y{}], x[cca::x{}]);
  }
};
struct sum {
  Eigen::Vector2d s{0, 0};
  auto process(cca::in<"a", plane> a, cca::optional_in<"b", plane> b) -> cca::out<"y", plane> {
    return Eigen::Vector2d(s += a.vector() + b.vector());
  }
};
struct ear {
  double total = 0;
  void process(cca::observe<"near.*", cca::delayed<2>> all) {
    for (const auto& one : all) total += one.values[0];
  }
};
// Others wait for it, in a fast run.
struct watch {
  auto process(cca::in<"x", plane> x) -> cca::fault {
    return x[cca::x{}] < -1 ? cca::fault("below") : cca::fault();
  }
};
struct body {
  auto sense(cca::beat) -> cca::out<"is", plane> { return Eigen::Vector2d(0, 0); }
  void act(cca::in<"command", plane>) {}
  void on_fault() {}
};

struct spread_out : cca::graph<cca::rate<1000>,
                               cca::node<"body", body>,
                               cca::node<"near_tally", tally>,
                               cca::node<"near", sum>,
                               cca::node<"watch", watch>,
                               cca::node<"far_tally", tally>,
                               cca::node<"seldom", seldom>,
                               cca::node<"queued", sum>,
                               cca::node<"slow", sum, cca::timed<4>>,
                               cca::node<"ear", ear>,
                               cca::wire<"body.is", "near.a">,
                               cca::wire<"queued.y", "near.b", cca::delayed<3>>,
                               cca::wire<"near.y", "body.command">,
                               cca::wire<"near_tally.y", "watch.x">,
                               cca::wire<"near.y", "seldom.x", cca::delayed<1>>,
                               cca::wire<"seldom.y", "queued.a", cca::queue<3, cca::drop_oldest>>,
                               cca::wire<"far_tally.y", "slow.a", cca::latest>,
                               cca::wire<"near_tally.y", "slow.b", cca::delayed<2>>> {};
struct two_tallies
    : cca::deployment<spread_out,
                      cca::environment<"near", cca::nodes<"body", "near_tally", "near", "watch">>,
                      cca::environment<"far", cca::other_nodes>,
                      cca::tolerate<1000000>> {};

constexpr int beats = 400;

template <class Deployed, class Pace>
std::string tallied(Deployed& d, const std::vector<std::string>& environments, Pace pace) {
  d.load();
  d.start();
  d.run(cca::for_beats<beats>{}, pace);
  std::ostringstream all;
  all << cca::to_string(d.state());
  for (const std::string& one : environments)
    all << ", " << one << " "
        << (one == "near" ? d.template get<"near_tally">().said() : d.template get<"far_tally">().said());
  return all.str();
}

template <class Pace, class Open>
void check_processes(Pace pace, Open open) {
  const auto part = [&](const char* name) {
    cca::deployed<two_tallies> d(cca::only{name}, open());
    return tallied(d, {name}, pace);
  };
  process far([&] { return part("far"); });
  process near([&] { return part("near"); });
  CHECK_EQ(near.said(), "started, near 0");
  CHECK_EQ(far.said(), "started, far 0");
}
}  // namespace

TEST_SUITE("no allocation") {
  TEST_CASE("an environment's beat: the counter counts in its own thread") {
    cca::deployed<two_tallies> d;
    d.get<"far_tally">().spoilt = 200;
    CHECK_EQ(tallied(d, {"near", "far"}, cca::as_fast_as_possible{}), "started, near 0, far 1");
  }
  TEST_CASE("beats of environments in threads") {
    cca::deployed<two_tallies> fast, timely;
    CHECK_EQ(tallied(fast, {"near", "far"}, cca::as_fast_as_possible{}), "started, near 0, far 0");
    CHECK_EQ(tallied(timely, {"near", "far"}, cca::at_speed(0.5)), "started, near 0, far 0");
  }
  TEST_CASE("beats of environments over shared memory") {
    int number = 0;
    const std::string begin = "/cca_no_allocation_" + std::to_string(::getpid()) + "_";
    std::string name;
    const auto next = [&] { name = begin + std::to_string(number++); };
    next();
    check_processes(cca::as_fast_as_possible{}, [&] { return cca::shared_memory(name); });
    next();
    check_processes(cca::at_speed(0.5), [&] { return cca::shared_memory(name); });
  }
  TEST_CASE("beats of environments over DDS") {
    // In a fast run the threads of the environments send and receive themselves, and Cyclone allocates.
    const std::string name = over_dds::other_name();
    check_processes(cca::at_speed(0.5), [&] { return over_dds::transport(name); });
  }
}
