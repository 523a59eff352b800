// A small architecture with feedback, two rates, a queue, a resource node and components that may fault, and
// two ways to spread it.
#pragma once

#include <atomic>
#include <chrono>
#include <thread>
#include <tuple>

#include <cca/deployment.hpp>

namespace deployment_test {

struct state : cca::space<cca::number, cca::axes<cca::x, cca::y>> {};
struct level : cca::space<cca::number, cca::axes<cca::x>> {};

inline std::atomic<int> idle_beats{0};  // of all devices, for another thread to read

// Counts what happens to it: on_fault and on_idle may run in any thread.
struct device {
  double command = 0;
  int faults = 0, idles = 0, senses = 0;
  auto sense(cca::beat now) -> cca::out<"measured", state> {
    ++senses;
    return Eigen::Vector2d(0.5 * command, static_cast<double>(now.index() % 7));
  }
  void act(cca::in<"command", level> u) { command = u[cca::x{}]; }
  void on_fault() { ++faults; }
  void on_idle() { ++idles, ++idle_beats; }
};

struct filter {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain));
  };
  parameters p{0.1};
  double kept = 0;
  auto process(cca::in<"x", state> x) -> cca::out<"y", level> {
    kept += p.gain * (x[cca::x{}] + x[cca::y{}] - kept);
    return kept;
  }
};

struct guard {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, most));
  };
  parameters p{1e9};
  auto process(cca::in<"x", level> x, cca::optional_in<"hint", level> hint)
      -> std::tuple<cca::out<"y", level>, cca::fault> {
    const double y = x[cca::x{}] + 0.25 * hint[cca::x{}];
    return {y, y > p.most ? cca::fault("too much") : cca::fault()};
  }
};

// Now and then.
struct thinker {
  double sum = 0;
  auto process(cca::in<"x", level> x, cca::beat now) -> cca::maybe<"y", level> {
    sum += (x[cca::x{}] - sum) * now.dt();
    if (now.index() % 20 == 0) return {};
    return sum;
  }
};

// Takes long, once, in the beat that a test names or the first one after it; never for the others.
inline std::atomic<std::int64_t> beat_that_stalls{-1};
inline std::atomic<int> stall_in_ms{0};
struct stalling {
  auto process(cca::in<"x", level> x, cca::beat now) -> cca::out<"y", level> {
    if (const std::int64_t beat = beat_that_stalls; beat >= 0 && now.index() >= beat) {
      beat_that_stalls = -1;
      std::this_thread::sleep_for(std::chrono::milliseconds(stall_in_ms));
    }
    return 2 * x[cca::x{}];
  }
};

struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"device", device>,
                                 cca::node<"filter", filter>,
                                 cca::node<"guard", guard>,
                                 cca::node<"thinker", thinker, cca::timed<5, 2>>,
                                 cca::node<"slow", stalling>,
                                 cca::wire<"device.measured", "filter.x">,
                                 cca::wire<"filter.y", "guard.x">,
                                 cca::wire<"guard.y", "device.command">,
                                 cca::wire<"filter.y", "thinker.x", cca::delayed<2>>,
                                 cca::wire<"thinker.y", "slow.x", cca::queue<4, cca::drop_oldest>>,
                                 cca::wire<"slow.y", "guard.hint", cca::delayed<3>, cca::initial<0.5>>,
                                 cca::observe<"device.measured">,
                                 cca::observe<"guard.y">,
                                 cca::observe<"slow.y">> {};

struct two : cca::deployment<architecture,
                             cca::environment<"robot", cca::nodes<"device", "filter", "guard">>,
                             cca::environment<"mind", cca::other_nodes>> {};

}  // namespace deployment_test
