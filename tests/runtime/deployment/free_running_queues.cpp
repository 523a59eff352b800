// Queues to and from free-running environments without delay: in a fast run they have the bits of one
// loop, in a wall-clock run they lose what their policy says, and count it.
#include <doctest/doctest.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "free_running_queues.hpp"
#include "same_story.hpp"

using namespace free_queues;

namespace {

template <class Played>
std::string told(const Played& c) {
  std::ostringstream text;
  text << std::hexfloat << c.beat_index() << ' ' << cca::to_string(c.state()) << ' ' << c.fault().reason()
       << ' ' << c.fault_path() << ' ' << c.template get<"robot">().command << ' '
       << c.template get<"witness">().hash << ' ' << c.template get<"hears">().hash << ' '
       << c.template get<"hears_freely">().hash;
  const auto tell = [&](const char* name, const logbook& one) {
    text << '\n' << name << ' ' << one.hash << ' ' << one.seen << ' ' << one.last << ' ' << one.lost;
  };
  tell("merged", c.template get<"merged">());
  tell("mind", c.template get<"mind">());
  tell("newest", c.template get<"newest">());
  tell("late", c.template get<"late">());
  tell("rare", c.template get<"rare">());
  tell("inside", c.template get<"inside">());
  tell("counts", c.template get<"counts">());
  for (const char* input : {"merged.x", "newest.x", "late.x", "rare.x", "inside.x", "eyes.x"})
    text << '\n' << input << ' ' << c.dropped(input);
  return text.str();
}
template <class Deployment, class F>
void check_same(F plays) {
  same_story::check<architecture, Deployment>(plays, [](const auto& c) { return told(c); });
}

struct two_free
    : cca::deployment<architecture,
                      cca::environment<"robot", cca::nodes<"robot">>,
                      cca::environment<"inside",
                                       cca::nodes<"inside", "counts", "pauses", "hears_freely">,
                                       cca::free_running>,
                      cca::environment<"eyes", cca::nodes<"eyes">, cca::free_running>,
                      cca::environment<"mind", cca::nodes<"mind", "merged", "witness", "first", "echo">>,
                      cca::environment<"rest", cca::other_nodes>> {};

// From its fortieth cycle on it publishes more than is read.
struct flood {
  double cycles = 0;
  auto process(cca::in<"x", number> x) -> cca::maybe<"y", number> {
    ++cycles;
    if (static_cast<int>(cycles) % 50 < 40) return {};
    return cycles + x[cca::x{}];
  }
};
struct flooded_graph : cca::graph<cca::rate<1000>,
                                  cca::node<"robot", robot>,
                                  cca::node<"early", logbook>,
                                  cca::node<"flood", flood, cca::full_speed>,
                                  cca::node<"between", logbook>,
                                  cca::node<"other", logbook, cca::timed<12>>,
                                  cca::node<"mind", logbook, cca::timed<3>>,
                                  cca::node<"behind", logbook, cca::full_speed>,
                                  cca::wire<"robot.y", "early.x", cca::delayed<1>>,
                                  cca::wire<"robot.y", "flood.x">,
                                  cca::wire<"flood.y", "between.x">,
                                  cca::wire<"robot.y", "other.x", cca::delayed<1>>,
                                  cca::wire<"flood.y", "mind.x", cca::merged<4, cca::reject>>,
                                  cca::wire<"other.y", "mind.x", cca::merged<4, cca::reject>>,
                                  cca::wire<"between.y", "behind.x">,
                                  cca::wire<"between.y", "robot.command">> {};
struct flooded_apart
    : cca::deployment<flooded_graph,
                      cca::environment<"robot", cca::nodes<"robot", "between">>,
                      cca::environment<"early", cca::nodes<"early">>,
                      cca::environment<"flood", cca::nodes<"flood", "behind">, cca::free_running>,
                      cca::environment<"mind", cca::other_nodes>> {};

// Whose cycles take twenty beats. It notes what it sees, and what had been lost by then.
struct notes {
  std::vector<double> seen{}, lost{};
  void process(cca::in<"x", number> x) {
    if (x.fresh()) {  // its first cycle may begin before the first sample has come
      seen.push_back(x[cca::x{}]);
      lost.push_back(static_cast<double>(x.dropped()));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
};
struct slowly_read : cca::graph<cca::rate<1000>,
                                cca::node<"beats", counter>,
                                cca::node<"cycles", counter, cca::full_speed>,
                                cca::node<"a", notes, cca::full_speed>,
                                cca::node<"b", notes, cca::full_speed>,
                                cca::node<"c", notes, cca::full_speed>,
                                cca::wire<"beats.y", "a.x", cca::queue<4, cca::drop_newest>>,
                                cca::wire<"beats.y", "b.x", cca::queue<4>>,
                                cca::wire<"cycles.y", "c.x", cca::queue<4, cca::drop_newest>>> {};
struct slow_apart : cca::deployment<slowly_read,
                                    cca::environment<"robot", cca::nodes<"beats">>,
                                    cca::environment<"fast", cca::nodes<"cycles">, cca::free_running>,
                                    cca::environment<"a", cca::nodes<"a">, cca::free_running>,
                                    cca::environment<"b", cca::nodes<"b">, cca::free_running>,
                                    cca::environment<"c", cca::nodes<"c">, cca::free_running>> {};

}  // namespace

TEST_SUITE("deployed free-running queues") {
  TEST_CASE("in a fast run all is as in one loop") {
    const auto plays = [](auto& c, auto tell) {
      c.load();
      c.start();
      for (int i = 0; i < 12; ++i) {
        c.step();
        tell();
      }
      c.run(cca::for_beats<50>{});
      tell();
      for (int i = 0; i < 20; ++i) c.run(cca::for_some_beats{i % 4});
      tell();
      int beats = 0;
      c.run(cca::without_end{}, cca::as_fast_as_possible{}, [&](auto&) {
        tell();
        return ++beats < 10;
      });
    };
    check_same<spread<>>(plays);
    check_same<two_free>(plays);
    const cycles_of slow(300);  // the others are done long before
    check_same<spread<>>(plays);
  }

  TEST_CASE("in a fast run a fault ends the beat where it ends the one loop") {
    const auto plays = [](auto& c, auto tell) {
      c.load();
      c.template set<"alarm">({57});
      c.start();
      c.run(cca::for_beats<300>{});
      tell();
      REQUIRE_EQ(c.fault_path(), "alarm");
      for (int i = 0; i < 5; ++i) {  // in each beat
        c.resume();
        c.run(cca::for_beats<30>{});
        tell();
      }
      c.template set<"alarm">({1e9});
      c.resume();
      for (int i = 0; i < 10; ++i) {
        c.step();
        tell();
      }
    };
    check_same<spread<>>(plays);
    check_same<two_free>(plays);
  }

  TEST_CASE("a queue that rejects what it can't hold ends the beat of all, behind who has published it") {
    const auto plays = [](auto& c, auto tell) {
      c.load();
      c.start();
      for (int i = 0; i < 4; ++i) {
        c.run(cca::for_beats<300>{});
        tell();
        REQUIRE_EQ(c.fault_path(), "mind");
        c.resume();
      }
    };
    std::vector<std::string> of_one, of_apart;
    const auto play = [&](auto& c, auto& pages) {
      plays(c, [&] {
        std::ostringstream text;
        text << std::hexfloat << c.beat_index() << ' ' << c.fault().reason() << ' ' << c.fault_path() << ' '
             << c.dropped() << ' ' << c.template get<"robot">().command << ' '
             << c.template get<"robot">().faults << ' ' << c.template get<"flood">().cycles;
        text << ' ' << c.template get<"early">().hash << ' ' << c.template get<"between">().hash << ' '
             << c.template get<"other">().hash << ' ' << c.template get<"mind">().hash << ' '
             << c.template get<"behind">().hash;
        pages.push_back(text.str());
      });
    };
    cca::controller<flooded_graph> one;
    cca::deployed<flooded_apart> apart;
    play(one, of_one);
    play(apart, of_apart);
    REQUIRE_EQ(of_one.size(), of_apart.size());
    for (std::size_t i = 0; i < of_one.size(); ++i) CHECK_EQ(of_one[i], of_apart[i]);
  }

  TEST_CASE("in a wall-clock run a slow cycle loses what its policy says: the newest, or the oldest") {
    cca::deployed<slow_apart> d;
    d.load();
    d.start();
    d.run(cca::for_beats<400>{}, cca::at_wall_clock());
    // Where the queue was full before a cycle, the first that came after it begins is the last of the four.
    const auto keeps_the_first = [](const notes& one) {
      REQUIRE_GT(one.seen.size(), 8);
      for (std::size_t i = 3; i + 4 < one.seen.size(); ++i) {
        CAPTURE(i);
        if (one.lost[i] > one.lost[i - 1] && one.lost[i + 1] > one.lost[i])
          CHECK_EQ(one.seen[i + 4], static_cast<double>(i + 5) + one.lost[i]);
      }
    };
    keeps_the_first(d.get<"a">());
    keeps_the_first(d.get<"c">());
    const auto& b = d.get<"b">();
    REQUIRE_GT(b.seen.size(), 8);
    for (std::size_t i = 0; i < b.seen.size(); ++i)
      CHECK_EQ(b.seen[i], static_cast<double>(i + 1) + b.lost[i]);
  }

  TEST_CASE("in a wall-clock run each sample of each cycle is taken, waits, or is counted as lost") {
    for (const std::int64_t us : {0, 100, 2'500}) {
      const cycles_of these(us);
      cca::deployed<spread<cca::tolerate<100000>>> d;
      d.load();
      d.start();
      for (int i = 0; i < 3; ++i) d.run(cca::for_beats<100>{}, cca::at_wall_clock());
      const auto& eyes = d.get<"eyes">();
      CAPTURE(us);
      CAPTURE(eyes.cycles);
      REQUIRE_EQ(d.state(), cca::state::started);
      CHECK_GT(eyes.cycles, 50);
      // What the last cycles published has not arrived yet.
      const auto& newest = d.get<"newest">();
      const double arrived = newest.seen + static_cast<double>(d.dropped<"newest.x">());
      CHECK_LE(arrived, eyes.cycles);
      CHECK_GE(arrived + 5, newest.last);
      const auto& late = d.get<"late">();
      CHECK_LE(late.seen + static_cast<double>(d.dropped<"late.x">()), eyes.cycles);
      CHECK_GE(late.seen + static_cast<double>(d.dropped<"late.x">()) + 3, late.last);
      const auto is_rising = [](const logbook& one) {
        for (std::size_t i = 1; i < one.all.size(); ++i)
          if (one.all[i] <= one.all[i - 1]) return false;
        return true;
      };
      CHECK(is_rising(newest));
      CHECK(is_rising(late));
      // The oldest are lost: those before the one that is seen. Or the newest: some of those.
      CHECK_EQ(late.last - late.seen, static_cast<double>(late.lost));
      CHECK_LE(newest.last - newest.seen, static_cast<double>(newest.lost));
      if (us == 0) CHECK_GT(late.lost, 1000);
      // To a free-running environment: the counter counts beats.
      const auto& counts = d.get<"counts">();
      CHECK(is_rising(counts));
      CHECK_GT(counts.seen, 50);
      CHECK_LE(counts.seen + static_cast<double>(d.dropped<"counts.x">()), 301);
      CHECK_LE(counts.last - counts.seen, static_cast<double>(counts.lost));
    }
  }
}
