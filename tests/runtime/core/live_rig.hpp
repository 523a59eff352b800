// What the tests of cca::live_access share: a component whose values show whether they are whole, and a
// thread beside a run.
#pragma once

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/runtime/live/live_access.hpp>

#include "../running.hpp"

namespace live_test {

using namespace std::chrono_literals;

struct pair : cca::space<cca::number, cca::axes<cca::x, cca::y>> {};

// Both coordinates are equal, whoever looks; so are the parameters `slope` and `same` where a test sets both.
struct source {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0, 100>, slope),
                             (bool, locked),
                             (cca::bounded<double, 0, 100>, same));
  };
  parameters p{1, false, 1};
  auto process(cca::beat) -> cca::out<"y", pair> {
    value += p.slope;
    broken += p.slope != p.same;
    return Eigen::Vector2d(value, value);
  }
  std::string_view refusal_of(const parameters& to) const {
    return p.locked && to.locked ? "slope: it is locked" : "";
  }
  void on_start() { ++starts; }
  void on_stop() { ++stops; }
  double value = 0;
  int broken = 0, starts = 0, stops = 0;
};

using test::refusal;

inline void wait_until(auto holds) {
  bool has_come = holds();
  for (int i = 0; i < 10000 && !has_come; ++i) {
    std::this_thread::sleep_for(1ms);
    has_come = holds();
  }
  CHECK(has_come);
}

// The first number of the newest sample. `newest` is empty where the writer was faster than each attempt to
// read.
template <class Live>
double newest_in(const Live& live, const char* path) {
  double number = 0;
  wait_until([&] {
    const auto seen = live.newest(path);
    if (seen) number = seen->values[0];
    return seen.has_value();
  });
  return number;
}
// A request, until it has been taken.
inline void insist(auto& live, auto request) {
  wait_until(request);
  wait_until([&] { return live.is_taken(); });
}

// The loops in this thread, `other` in another one; it ends the run.
template <class Controller, class Pace, class F>
void beside(Controller& c, cca::live_access<Controller>& live, Pace pace, F other) {
  std::thread window([&] {
    other();
    live.end_run();
  });
  c.run(cca::without_end{}, pace, live);
  window.join();
}

template <class Controller>
Controller started() {
  Controller c;
  c.load();
  c.start();
  return c;
}

// Threads that keep the cores busy.
class busy_cores {
public:
  explicit busy_cores(int count) {
    for (int i = 0; i < count; ++i)
      all.emplace_back([this] {
        while (!is_over.load(std::memory_order_relaxed)) {}
      });
  }
  ~busy_cores() {
    is_over = true;
    for (auto& each : all) each.join();
  }

private:
  std::atomic<bool> is_over{false};
  std::vector<std::thread> all;
};

}  // namespace live_test
