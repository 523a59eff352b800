// Modes with a free-running environment. Some of its components are in all modes, some come and go; they read
// and are read with and without delay, through queues, and may ask for a mode.
#pragma once

#include <cstdint>
#include <string>

#include "cycle_time.hpp"
#include "modes_rig.hpp"

namespace free_modes {

using namespace modes_test;
using free_cycles::cycle_hangs, free_cycles::cycle_in_us, free_cycles::cycles_of, free_cycles::take_time;

// Takes its time.
struct eyes : noting<1> {
  auto process(cca::in<"x", number> x, cca::beat now) -> cca::out<"y", number> {
    take_time();
    return noting<1>::process(x, now);
  }
};
struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"robot", robot>,
                         cca::node<"asks", orders<1, "stand", "fall">>,
                         cca::node<"see", eyes, cca::full_speed>,
                         cca::node<"aim", seldom<2>, cca::full_speed>,
                         cca::node<"wish", orders<3, "stand", "fall">, cca::full_speed>,
                         cca::node<"quick", noting<4>>,
                         cca::node<"log", noting<5>, cca::timed<3>>,
                         cca::node<"old", noting<6>>,
                         cca::node<"slow", pair, cca::any_of<cca::moderate, cca::timeout<7>>>,
                         cca::wire<"robot.y", "asks.x">,
                         cca::wire<"robot.y", "see.x">,
                         cca::wire<"see.y", "aim.x", cca::delayed<1>>,
                         cca::wire<"robot.y", "wish.x", cca::delayed<1>>,
                         cca::wire<"see.y", "quick.x">,
                         cca::wire<"quick.y", "robot.x">,
                         cca::wire<"aim.y", "log.x", cca::queue<4>>,
                         cca::wire<"aim.y", "old.x", cca::delayed<3>>,
                         cca::wire<"wish.y", "slow.a">,
                         cca::wire<"robot.y", "slow.b", cca::delayed<2>>,
                         cca::observe<"see.y">,
                         cca::observe<"aim.y">> {};

struct stand : cca::graph<cca::rate<1000>,
                          cca::node<"robot", robot>,
                          cca::node<"see", eyes, cca::full_speed>,
                          cca::node<"also_asks", orders<2, "walk", "fall">>,
                          cca::node<"look", seldom<7>, cca::stoppable<cca::full_speed>>,
                          cca::node<"quick", noting<4>>,
                          cca::node<"log", noting<5>, cca::timed<3>>,
                          cca::node<"old", noting<6>>,
                          cca::wire<"robot.y", "see.x">,
                          cca::wire<"quick.y", "also_asks.x", cca::delayed<1>>,
                          cca::wire<"also_asks.y", "look.x", cca::queue<3>>,
                          cca::wire<"look.y", "quick.x">,
                          cca::wire<"quick.y", "robot.x">,
                          cca::wire<"look.y", "log.x", cca::queue<4>>,
                          cca::wire<"see.y", "old.x", cca::delayed<2>>,
                          cca::observe<"see.y">> {};

// The eyes are shut.
struct fall : cca::graph<cca::rate<1000>,
                         cca::node<"robot", robot>,
                         cca::node<"asks", orders<1, "stand", "fall">>,
                         cca::node<"also_asks", orders<2, "walk", "fall">>,
                         cca::node<"aim", seldom<2>, cca::full_speed>,
                         cca::node<"far", noting<8>, cca::full_speed>,
                         cca::node<"quick", noting<4>>,
                         cca::node<"log", noting<5>, cca::timed<3>>,
                         cca::wire<"robot.y", "asks.x">,
                         cca::wire<"asks.y", "also_asks.x", cca::delayed<1>>,
                         cca::wire<"also_asks.y", "aim.x", cca::delayed<2>>,
                         cca::wire<"aim.y", "far.x">,
                         cca::wire<"aim.y", "quick.x", cca::delayed<1>>,
                         cca::wire<"quick.y", "robot.x">,
                         cca::wire<"aim.y", "log.x", cca::merged<6>>,
                         cca::wire<"far.y", "log.x", cca::merged<6>, cca::delayed<2>>> {};
// Nothing runs freely.
struct rest : cca::graph<cca::rate<1000>,
                         cca::node<"robot", robot>,
                         cca::node<"also_asks", orders<2, "walk", "fall">>,
                         cca::node<"quick", noting<4>>,
                         cca::wire<"robot.y", "quick.x">,
                         cca::wire<"quick.y", "robot.x", cca::delayed<1>>,
                         cca::wire<"robot.y", "also_asks.x", cca::delayed<1>>> {};

struct sees : cca::modes<cca::mode<"walk", walk>,
                         cca::mode<"stand", stand>,
                         cca::mode<"fall", fall>,
                         cca::mode<"rest", rest>> {};
inline constexpr const char* names[] = {"walk", "stand", "fall", "rest"};

template <class... Options>
struct spread
    : cca::deployment<
          sees,
          cca::environment<"robot", cca::nodes<"robot", "asks", "quick">>,
          cca::environment<"eyes", cca::nodes<"see", "aim", "wish", "look", "far">, cca::free_running>,
          cca::environment<"mind", cca::other_nodes>,
          Options...> {};
// Two that run freely, with a wire between them.
struct two_free
    : cca::deployment<sees,
                      cca::environment<"robot", cca::nodes<"robot", "asks", "quick", "log">>,
                      cca::environment<"eyes", cca::nodes<"see", "look">, cca::free_running>,
                      cca::environment<"mind", cca::other_nodes>,
                      cca::environment<"aims", cca::nodes<"aim", "wish", "far">, cca::free_running>> {};

template <class C>
void quiet(C& c) {
  const auto hush = [](auto get) {
    try {
      get().asks = false;
    } catch (const cca::refused&) {}  // another process has it
  };
  hush([&]() -> auto& { return c.template get<"asks">(); });
  hush([&]() -> auto& { return c.template get<"also_asks">(); });
  hush([&]() -> auto& { return c.template get<"wish">(); });
}

// ---- a robot that turns its head: in each mode another component aims ----

inline constexpr std::int64_t beats_of_mode = 7;

// The next beat is the first of the other mode.
template <cca::fixed_string Other>
struct turns {
  auto process(cca::beat now) -> cca::switch_to<Other> { return now.index() % beats_of_mode == 3; }
};
// Its results show all that it has seen.
struct counting : journal {
  double sum = 0;
  auto process(cca::in<"x", number> x, cca::beat now) -> cca::out<"y", number> {
    note(now, x[cca::x{}], x.origin(), x.fresh());
    return sum += 1 + 0.25 * x[cca::x{}];
  }
};
// In a free-running environment it asks for the other mode, too, if a test wants that.
template <cca::fixed_string Other>
struct aiming : counting {
  std::size_t asks_every = 1'000'000'000;
  auto process(cca::in<"x", number> x, cca::beat now)
      -> std::tuple<cca::out<"y", number>, cca::switch_to<Other>> {
    return {counting::process(x, now), all.size() % asks_every == 0};
  }
};
struct slow_eyes : counting {
  auto process(cca::in<"x", number> x, cca::beat now) -> cca::out<"y", number> {
    take_time();
    return counting::process(x, now);
  }
};
// Counts what it reads, and of that what comes from cycles that began before the mode.
struct reader {
  struct counts {
    std::int64_t fresh = 0, old = 0;
  };
  counts eyes, aim, queue;
  std::int64_t mode_began = 0;

  auto process(cca::in<"eyes", number> seen,
               cca::in<"aim", number> aimed,
               cca::in<"queue", number> all,
               cca::beat now) -> cca::out<"y", number> {
    if (now.index() % beats_of_mode == 4) mode_began = now.index();
    // The first cycle of the mode may read what was published in the beat before.
    const std::int64_t first = (mode_began - 1) * 1'000'000;
    const auto count = [&](counts& of, const auto& in) {
      of.fresh += in.fresh();
      of.old += in.fresh() && in.origin() < first;
    };
    count(eyes, seen);
    count(aim, aimed);
    count(queue, all);
    return seen[cca::x{}] + 0.5 * aimed[cca::x{}] + 0.125 * all[cca::x{}];
  }
};

// `sees`, `aimed` and `both` have a clock in a fast run. In a wall-clock run they fire by what arrives:
// `sees` by what is in both modes, `aimed` by what is in one.
struct left : cca::graph<cca::rate<1000>,
                         cca::node<"robot", robot>,
                         cca::node<"turns_right", turns<"right">>,
                         cca::node<"eyes", slow_eyes, cca::full_speed>,
                         cca::node<"aims_left", aiming<"right">, cca::full_speed>,
                         cca::node<"reader", reader, cca::timed<1>>,
                         cca::node<"sees", noting<21>>,
                         cca::node<"aimed", noting<22>>,
                         cca::node<"both", pair, cca::moderate>,
                         cca::wire<"eyes.y", "sees.x">,
                         cca::wire<"aims_left.y", "aimed.x", cca::delayed<1>>,
                         cca::wire<"sees.y", "both.a">,
                         cca::wire<"aimed.y", "both.b">,
                         cca::wire<"robot.y", "eyes.x">,
                         cca::wire<"eyes.y", "aims_left.x">,
                         cca::wire<"eyes.y", "reader.eyes">,
                         cca::wire<"aims_left.y", "reader.aim", cca::delayed<1>>,
                         cca::wire<"aims_left.y", "reader.queue", cca::queue<256>>,
                         cca::wire<"reader.y", "robot.x">> {};
struct right : cca::graph<cca::rate<1000>,
                          cca::node<"robot", robot>,
                          cca::node<"turns_left", turns<"left">>,
                          cca::node<"eyes", slow_eyes, cca::full_speed>,
                          cca::node<"aims_right", aiming<"left">, cca::full_speed>,
                          cca::node<"reader", reader, cca::timed<1>>,
                          cca::node<"sees", noting<21>>,
                          cca::node<"aimed", noting<22>>,
                          cca::node<"both", pair, cca::moderate>,
                          cca::node<"counts", noting<23>>,
                          cca::wire<"eyes.y", "sees.x">,
                          cca::wire<"aims_right.y", "aimed.x">,
                          cca::wire<"sees.y", "both.a", cca::delayed<1>>,
                          cca::wire<"aimed.y", "both.b">,
                          cca::wire<"aims_right.y", "counts.x", cca::delayed<2>>,
                          cca::wire<"robot.y", "eyes.x">,
                          cca::wire<"eyes.y", "aims_right.x", cca::delayed<1>>,
                          cca::wire<"eyes.y", "reader.eyes">,
                          cca::wire<"aims_right.y", "reader.aim">,
                          cca::wire<"aims_right.y", "reader.queue", cca::merged<256>, cca::delayed<1>>,
                          cca::wire<"reader.y", "robot.x">> {};
struct both_sides : cca::modes<cca::mode<"left", left>, cca::mode<"right", right>> {};

// All but the eyes is in the environment that gives the beat, so nothing can be late.
template <class... Options>
struct turning
    : cca::deployment<
          both_sides,
          cca::environment<"robot", cca::other_nodes>,
          cca::environment<"eyes", cca::nodes<"eyes", "aims_left", "aims_right">, cca::free_running>,
          Options...> {};

// What fires by what arrives is in another environment.
struct turning_apart
    : cca::deployment<
          both_sides,
          cca::environment<"robot", cca::other_nodes>,
          cca::environment<"eyes", cca::nodes<"eyes", "aims_left", "aims_right">, cca::free_running>,
          cca::environment<"mind", cca::nodes<"sees", "aimed", "both", "counts">>,
          cca::tolerate<100>> {};

// What has come from cycles that began before the mode: of the eyes, which both modes have, it counts; of
// what only one mode has nothing comes. In cycles of many beats.
inline std::string complaint_about(const reader& r) {
  const auto text = [](const char* name, const reader::counts& of) {
    return std::string(name) + " " + std::to_string(of.old) + " of " + std::to_string(of.fresh) + "; ";
  };
  if (r.eyes.old > 0 && r.aim.old == 0 && r.queue.old == 0 && r.aim.fresh > 0 && r.queue.fresh > 0) return "";
  return text("eyes", r.eyes) + text("aim", r.aim) + text("queue", r.queue);
}

// Of one that fires by what arrives: how often it did, and how often without a sample.
struct firings {
  std::size_t all = 0, without = 0;
  explicit firings(const journal& j) {
    for (const seen& one : j.all)
      if (one.beat >= 0) ++all, without += !one.fresh || one.origin < 0;
  }
};

template <class Played>
std::string complaint_about_firings(const Played& d) {
  std::string text;
  const auto look = [&](const char* name, const journal& j, std::size_t least) {
    const firings of(j);
    if (of.without > 0 || of.all < least)
      text += std::string(name) + " fired " + std::to_string(of.all) + " times, " +
              std::to_string(of.without) + " without a sample; ";
  };
  look("sees", d.template get<"sees">(), 5);
  look("aimed", d.template get<"aimed">(), 3);
  look("counts", d.template get<"counts">(), 0);
  return text;
}

template <class F>
void for_each_journal(auto& c, F f) {
  const auto tell = [&](const char* name, auto get) {
    try {
      f(name, get());
    } catch (const cca::refused&) {}  // another process has it
  };
#define CCA_TELL(path) tell(path, [&]() -> const journal& { return c.template get<path>(); })
  CCA_TELL("robot");
  CCA_TELL("asks");
  CCA_TELL("quick");
  CCA_TELL("see");
  CCA_TELL("aim");
  CCA_TELL("wish");
  CCA_TELL("look");
  CCA_TELL("far");
  CCA_TELL("log");
  CCA_TELL("old");
  CCA_TELL("slow");
  CCA_TELL("also_asks");
#undef CCA_TELL
}

}  // namespace free_modes
