// Beats in a wall-clock run, on a clock that the tests move: overruns are counted and never caught up.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "counting.hpp"

using namespace core_test;

namespace {

constexpr std::int64_t ms = 1'000'000;

// Time passes where a beat takes it, and where the pace sleeps.
struct fake_clock {
  static inline std::int64_t time = 0, wakes_late = 0;
  static std::int64_t now() { return time; }
  static void sleep_until(std::int64_t t) { time = std::max(time, t + wakes_late); }
};
using pace = cca::clocked_pace<fake_clock>;

struct busy {  // takes `usual`, in some beats longer
  std::vector<std::int64_t> began{};
  std::int64_t usual = ms / 10, stall_at = -1, stall = 0;
  void process(cca::beat now) {
    began.push_back(fake_clock::time);
    fake_clock::time += now.index() == stall_at ? stall : usual;
  }
};
struct one : cca::graph<cca::rate<1000>, cca::node<"busy", busy>> {};

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-10, 10}, cca::velocity{-4, 4}};
};
struct angles : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};
struct jump {
  auto process(cca::beat now) -> cca::out<"q", angles> { return now.index() < 10 ? 0.0 : 5.0; }
};
struct axle {
  struct moved {
    std::int64_t time;
    double to;
  };
  std::vector<moved> all{};
  void act(cca::in<"q", angles> q) { all.push_back({fake_clock::time, q.vector()[0]}); }
};
struct limited : cca::graph<cca::node<"jump", jump>,
                            cca::node<"limits", cca::limiter<angles>>,
                            cca::node<"axle", axle>,
                            cca::node<"busy", busy, cca::timed<1>>,
                            cca::wire<"jump.q", "limits.command">,
                            cca::wire<"limits.safe", "axle.q">> {};

struct brake {
  int braked = 0;
  void act(cca::optional_in<"x", angles>) {}
  void on_fault() { ++braked; }
};
struct with_brake : cca::graph<cca::rate<1000>, cca::node<"busy", busy>, cca::node<"brake", brake>> {};

void reset() { fake_clock::time = 5000 * ms, fake_clock::wakes_late = 0; }

}  // namespace

TEST_SUITE("pace") {
  TEST_CASE("without overruns each beat begins at its whole period") {
    reset();
    auto c = started<one>();
    c.run(cca::for_beats<5>{}, pace(1));
    CHECK_EQ(c.get<"busy">().began,
             std::vector<std::int64_t>{5000 * ms, 5001 * ms, 5002 * ms, 5003 * ms, 5004 * ms});
    CHECK_EQ(c.overruns(), 0);
    CHECK_EQ(c.lost_periods(), 0);
  }

  TEST_CASE("after a stall the next beat begins at the next whole period, and nothing is caught up") {
    reset();
    auto c = started<one>();
    c.get<"busy">().stall_at = 2;
    c.get<"busy">().stall = 100 * ms + ms / 4;
    c.run(cca::for_beats<6>{}, pace(1));
    CHECK_EQ(c.get<"busy">().began,
             std::vector<std::int64_t>{5000 * ms, 5001 * ms, 5002 * ms, 5103 * ms, 5104 * ms, 5105 * ms});
    CHECK_EQ(c.overruns(), 1);
    CHECK_EQ(c.lost_periods(), 100);
  }

  TEST_CASE("beats that always take too long begin at every second period") {
    reset();
    auto c = started<one>();
    c.get<"busy">().usual = 3 * ms / 2;
    std::vector<std::int64_t> counted;
    c.run(cca::for_beats<4>{}, pace(1), [&](auto& running) { counted.push_back(running.overruns()); });
    CHECK_EQ(c.get<"busy">().began, std::vector<std::int64_t>{5000 * ms, 5002 * ms, 5004 * ms, 5006 * ms});
    CHECK_EQ(c.overruns(), 3);
    CHECK_EQ(counted, std::vector<std::int64_t>{0, 1, 2, 3});
    c.stop();
    c.start();
    CHECK_EQ(c.overruns(), 0);
  }

  TEST_CASE("a beat that wakes late does not shift those after it") {
    reset();
    fake_clock::wakes_late = ms / 2;
    auto c = started<one>();
    c.run(cca::for_beats<3>{}, pace(1));
    CHECK_EQ(c.get<"busy">().began,
             std::vector<std::int64_t>{5000 * ms + ms / 2, 5001 * ms + ms / 2, 5002 * ms + ms / 2});
    CHECK_EQ(c.overruns(), 0);
  }

  TEST_CASE("at another speed the same holds") {
    reset();
    auto c = started<one>();
    c.get<"busy">().stall_at = 1;
    c.get<"busy">().stall = 9 * ms;
    c.run(cca::for_beats<4>{}, pace(0.25));  // a period of 4 ms
    CHECK_EQ(c.get<"busy">().began, std::vector<std::int64_t>{5000 * ms, 5004 * ms, 5016 * ms, 5020 * ms});
    CHECK_EQ(c.overruns(), 1);
    CHECK_EQ(c.lost_periods(), 2);
  }

  TEST_CASE("many short runs are as fast as one long run") {
    reset();
    auto c = started<one>();
    for (int i = 0; i < 4; ++i) c.run(cca::for_beats<1>{}, pace(1));
    CHECK_EQ(c.get<"busy">().began, std::vector<std::int64_t>{5000 * ms, 5001 * ms, 5002 * ms, 5003 * ms});
    fake_clock::time += 50 * ms;  // a pause between two runs is no overrun
    c.run(cca::for_beats<1>{}, pace(1));
    CHECK_EQ(c.get<"busy">().began.back(), 5053 * ms + ms / 10);
    CHECK_EQ(c.overruns(), 0);
  }

  TEST_CASE("whatever stalls, a limiter lets no more through than the time that has passed") {
    for (const std::int64_t stall : {ms / 2, 2 * ms, 40 * ms + 1, 300 * ms}) {
      for (const double speed : {1.0, 0.5}) {
        reset();
        auto c = started<limited>();
        c.get<"busy">().stall_at = 40;
        c.get<"busy">().stall = stall;
        for (int i = 0; i < 5; ++i) c.run(cca::for_beats<40>{}, pace(speed));
        const auto& all = c.get<"axle">().all;
        REQUIRE_EQ(all.size(), 200);
        for (std::size_t i = 0; i < all.size(); ++i)
          for (std::size_t j = i + 1; j < all.size(); ++j) {
            const double passed = static_cast<double>(all[j].time - all[i].time) * 1e-9 * speed;
            // A beat is one period long, and its command may go out at any time in it.
            if (!(std::abs(all[j].to - all[i].to) <= 4 * (passed + 1e-3) + 1e-9)) {
              CAPTURE(i);
              CAPTURE(j);
              FAIL("more than 4 rad/s of real time");
            }
          }
      }
    }
  }

  TEST_CASE("so many overruns in a row are a fault, in which every resource node brakes") {
    reset();
    auto c = started<with_brake>();
    c.get<"busy">().usual = 2 * ms + 1;
    CHECK_EQ(c.run(cca::for_beats<10>{}, pace(1).fault_after(3)), cca::state::faulted);
    CHECK_EQ(c.beat_index(), 3);
    CHECK_EQ(c.overruns(), 3);
    CHECK_EQ(c.get<"brake">().braked, 1);
    CHECK_EQ(std::string(c.fault().reason()), "overruns in a row: the beats take longer than their period");
    CHECK_EQ(c.fault_path(), "");
    c.resume();
    c.get<"busy">().usual = ms / 2;
    CHECK_EQ(c.run(cca::for_beats<10>{}, pace(1).fault_after(3)), cca::state::started);
    CHECK_EQ(words_of([] { cca::at_wall_clock().fault_after(0); }),
             "cca::at_wall_clock().fault_after: 0 is no number of overruns, expected 1 or more");
  }

  TEST_CASE("overruns that are not in a row are no fault") {
    reset();
    auto c = started<with_brake>();
    for (int i = 0; i < 5; ++i) {
      c.get<"busy">().stall_at = c.beat_index() + 1;
      c.get<"busy">().stall = 5 * ms;
      CHECK_EQ(c.run(cca::for_beats<4>{}, pace(1).fault_after(2)), cca::state::started);
    }
    CHECK_EQ(c.overruns(), 5);
  }
}
