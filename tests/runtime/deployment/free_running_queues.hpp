// Queues and merged wires to and from free-running environments, with and without delay.
#pragma once

#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

#include <cca/deployment.hpp>

#include "cycle_time.hpp"

namespace free_queues {

struct number : cca::space<cca::number, cca::axes<cca::x>> {};

using free_cycles::cycle_in_us, free_cycles::cycles_of, free_cycles::take_time;

// Counts from 1 on.
struct counter {
  double y = 0;
  auto process(cca::beat) -> cca::out<"y", number> { return ++y; }
};
struct robot {
  double command = 0, n = 0;
  int faults = 0;
  auto sense(cca::beat) -> cca::out<"y", number> { return 1000 * ++n + 0.001 * command; }
  void act(cca::in<"command", number> to) { command = to[cca::x{}]; }
  void on_fault() { ++faults; }
};
// Counts its cycles, and now and then something rare.
struct eyes {
  double cycles = 0, sum = 0;
  auto process(cca::in<"x", number> x) -> std::tuple<cca::out<"y", number>, cca::maybe<"rare", number>> {
    sum = 0.5 * sum + x[cca::x{}];
    ++cycles;
    take_time();
    return {cycles, static_cast<int>(cycles) % 3 == 1 ? cca::maybe<"rare", number>(sum)
                                                      : cca::maybe<"rare", number>()};
  }
};
// Between the eyes and the logbook in the order of a beat.
struct echo {
  auto process(cca::in<"x", number> x) -> cca::out<"y", number> { return -x[cca::x{}]; }
};
// What it shows depends on each sample that it has seen, in their order, and on what was lost.
struct logbook {
  double hash = 0, seen = 0, last = 0;
  std::int64_t lost = 0;
  std::vector<double> all{};
  auto process(cca::in<"x", number> x) -> cca::out<"y", number> {
    if (x.fresh()) {
      last = x[cca::x{}];
      if (all.size() < 5000) all.push_back(last);
      ++seen;
    }
    lost = x.dropped();
    hash = std::fmod(
        1.37 * hash + x[cca::x{}] + 1e-3 * static_cast<double>(lost) + 1e-9 * static_cast<double>(x.origin()),
        1e6);
    return hash;
  }
};
// Its cycles take as long as those of the eyes.
struct pauses {
  void process(cca::beat) { take_time(); }
};
// Sees what waits for another component.
struct witness {
  double hash = 0;
  void process(cca::observe<"merged.x.**"> all) {
    for (const auto& one : all) hash = std::fmod(1.21 * hash + one.values[0] + (one.fresh ? 0.5 : 0), 1e6);
  }
};
// Hears what others take from their queues, wherever these are.
template <class Heard>
struct hears {
  double hash = 0;
  auto process(Heard all, cca::beat) -> cca::out<"y", number> {
    for (const auto& one : all)
      hash = std::fmod(
          1.19 * hash + one.values[0] + (one.fresh ? 0.5 : 0) + 1e-9 * static_cast<double>(one.origin), 1e6);
    return hash;
  }
};
using from_all = cca::observe<"eyes.x.**|inside.x.**|merged.x.**|late.x.**", cca::delayed<2>>;
using from_beats = cca::observe<"merged.x.**|mind.x.**", cca::delayed<1>>;
struct alarm {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, most));
  };
  parameters p{1e9};
  auto process(cca::in<"x", number> x) -> std::tuple<cca::out<"y", number>, cca::fault> {
    return {x[cca::x{}], x[cca::x{}] > p.most ? cca::fault("enough") : cca::fault()};
  }
};

struct architecture
    : cca::graph<cca::rate<1000>,
                 cca::node<"robot", robot>,
                 cca::node<"first", counter>,
                 cca::node<"witness", witness, cca::timed<1>>,
                 cca::node<"merged", logbook, cca::timed<2>>,
                 cca::node<"eyes", eyes, cca::full_speed>,
                 cca::node<"echo", echo>,
                 cca::node<"counts", logbook, cca::full_speed>,
                 cca::node<"pauses", pauses, cca::full_speed>,
                 cca::node<"alarm", alarm>,
                 cca::node<"mind", logbook>,
                 cca::node<"newest", logbook, cca::timed<3, 1>>,
                 cca::node<"late", logbook, cca::timed<2, 1>>,
                 cca::node<"rare", logbook, cca::timed<2>>,
                 cca::node<"inside", logbook, cca::full_speed>,
                 cca::node<"hears", hears<from_all>, cca::timed<1>>,
                 cca::node<"hears_freely", hears<from_beats>, cca::full_speed>,
                 cca::wire<"robot.y", "eyes.x", cca::queue<4>>,
                 // One after another in a beat: the counter, the eyes, their echo, and who counts the
                 // counter. That one may be done before the echo begins.
                 cca::wire<"first.y", "merged.x", cca::merged<6>>,
                 cca::wire<"echo.y", "merged.x", cca::merged<6>>,
                 cca::wire<"counts.y", "merged.x", cca::merged<6>>,
                 cca::wire<"eyes.y", "merged.x", cca::merged<6>>,
                 cca::wire<"robot.y", "merged.x", cca::merged<6>, cca::delayed<2>>,
                 cca::wire<"eyes.y", "echo.x">,
                 cca::wire<"eyes.y", "alarm.x">,
                 cca::wire<"alarm.y", "mind.x", cca::queue<3>, cca::delayed<1>>,
                 cca::wire<"eyes.y", "newest.x", cca::queue<5, cca::drop_newest>>,
                 cca::wire<"eyes.y", "late.x", cca::queue<3>, cca::delayed<3>>,
                 cca::wire<"eyes.rare", "rare.x", cca::queue<6>>,
                 cca::wire<"first.y", "inside.x", cca::merged<7, cca::drop_newest>>,
                 cca::wire<"robot.y", "inside.x", cca::merged<7, cca::drop_newest>>,
                 cca::wire<"eyes.y", "inside.x", cca::merged<7, cca::drop_newest>>,
                 cca::wire<"mind.y", "inside.x", cca::merged<7, cca::drop_newest>, cca::delayed<1>>,
                 cca::wire<"first.y", "counts.x", cca::queue<4, cca::drop_newest>>,
                 cca::wire<"merged.y", "robot.command", cca::delayed<1>>> {};

template <class... Options>
struct spread
    : cca::deployment<
          architecture,
          cca::environment<"robot", cca::nodes<"robot", "first", "merged", "witness", "echo", "alarm">>,
          cca::environment<"eyes", cca::nodes<"eyes", "inside">, cca::free_running>,
          cca::environment<"counts", cca::nodes<"counts", "pauses", "hears_freely">, cca::free_running>,
          cca::environment<"mind", cca::other_nodes>,
          Options...> {};

}  // namespace free_queues
