// One graph per skeleton, with a ramp and low-pass filters, and the same by hand. `end` adds up what it gets.
#pragma once

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include <cca/cca.hpp>
#include <cca/skeleton/farm_on_threads.hpp>

#include "components.hpp"

namespace bench {

template <int Hz>
struct plane_at : cca::space<cca::number, cca::axes<cca::x, cca::y>, cca::rate<Hz>> {};
struct q0 : cca::dimension<"q0"> {};
struct q1 : cca::dimension<"q1"> {};
struct q2 : cca::dimension<"q2"> {};
struct q3 : cca::dimension<"q3"> {};
struct quad : cca::space<cca::number, cca::axes<q0, q1, q2, q3>> {};
struct gain : cca::space<cca::amplitude, cca::axes<cca::x>> {};

constexpr double dt = 1'000'000 / 1e9;

template <class Space, int Number = 0>
struct ramp {
  typename Space::vector_type value = Space::vector_type::Constant(Number);
  auto process(cca::beat now) -> cca::out<"y", Space> {
    return value = (value.array() + now.dt()).matrix().eval();
  }
};
struct now_and_then {
  Eigen::Vector2d value{0, 0};
  int count = 0;
  auto process(cca::beat) -> cca::maybe<"y", plane> {
    value[0] += 0.5;
    if (++count % 3 != 0) return {};
    return value;
  }
};
struct sum_of {
  Eigen::Vector2d sum{0, 0};
};
template <class Space>
struct ending : sum_of {
  void process(cca::in<"x", Space> x) { sum += x.vector().template head<2>(); }
};

// ---- splitter and collector ----

struct splitter_collector : cca::graph<cca::rate<1000>,
                                       cca::node<"source", source>,
                                       cca::node<"split", cca::splitter<"whole", plane>>,
                                       cca::node<"join", cca::collector<"whole", plane>, cca::moderate>,
                                       cca::node<"end", ending<plane>>,
                                       cca::wire<"source.y", "split.whole">,
                                       cca::wire<"split.x", "join.x">,
                                       cca::wire<"split.y", "join.y">,
                                       cca::wire<"join.whole", "end.x">> {};
struct moving {  // the source, by hand
  Eigen::Vector2d at{0, 1}, sum{0, 0};
  void move() { at[0] += dt, at[1] -= dt; }
  Eigen::Vector2d result() const { return sum; }
};
struct splitter_collector_by_hand : moving {
  void step() { move(), sum += at; }
};

// ---- pipeline, farm ----

template <class Skeleton,
          class Source,
          class In = plane,
          class When = cca::detail::by_default,
          class... Policy>
struct through : cca::graph<cca::rate<1000>,
                            Source,
                            cca::node<"skeleton", Skeleton, When>,
                            cca::node<"end", ending<In>>,
                            cca::wire<"source.y", "skeleton.input", Policy...>,
                            cca::wire<"skeleton.output", "end.x">> {};

struct pipeline : through<cca::pipeline<filter, filter, filter>, cca::node<"source", source>> {};
struct pipeline_by_hand : moving {
  filter f[3];
  void step() {
    move();
    const Eigen::Vector2d* x = &at;
    for (auto& one : f) one.state += one.gain * (*x - one.state), x = &one.state;
    sum += *x;
  }
};

struct pipeline_delayed
    : through<cca::pipeline_over<cca::delayed<1>, filter, filter, filter>, cca::node<"source", source>> {};
struct pipeline_delayed_by_hand : moving {
  filter f[3];
  void step() {
    move();
    for (int i = 2; i >= 0; --i) f[i].state += f[i].gain * ((i > 0 ? f[i - 1].state : at) - f[i].state);
    sum += f[2].state;
  }
};

struct farm : through<cca::farm<filter, quad, quad>, cca::node<"source", ramp<quad>>, quad> {};
struct farm_by_hand : sum_of {
  Eigen::Vector4d at{0, 0, 0, 0};
  filter f[2];
  void step() {
    at = (at.array() + dt).matrix();
    for (int i = 0; i < 2; ++i) f[i].state += f[i].gain * (at.segment<2>(2 * i) - f[i].state);
    sum += f[0].state;
  }
  Eigen::Vector2d result() const { return sum; }
};

// One task per beat; the threads finish it before the next beat. So the count is the cost of the loop's
// hand-over, not of the work.
struct farm_threads
    : through<cca::farm_on_threads<filter, quad, quad>, cca::node<"source", ramp<quad>>, quad> {
  static constexpr cca::fixed_string crew = "skeleton.crew";
};
struct farm_threads_by_hand : sum_of {
  struct ring {
    alignas(64) std::atomic<std::uint64_t> written{0};
    alignas(64) std::atomic<std::uint64_t> taken{0};
    alignas(64) Eigen::Vector2d values[4];
    void push(const Eigen::Vector2d& v) {
      const auto n = written.load(std::memory_order_relaxed);
      values[n % 4] = v;
      written.store(n + 1, std::memory_order_release);
    }
    bool empty() const {
      return taken.load(std::memory_order_relaxed) == written.load(std::memory_order_acquire);
    }
    Eigen::Vector2d pop() {
      const auto n = taken.load(std::memory_order_relaxed);
      const Eigen::Vector2d v = values[n % 4];
      taken.store(n + 1, std::memory_order_release);
      return v;
    }
  };
  struct lane {
    filter by;
    ring tasks, results;
    std::thread runs;
  };
  Eigen::Vector4d at{0, 0, 0, 0};
  std::int64_t lost = 0;
  lane lanes[2];
  std::atomic<bool> stops{false};

  farm_threads_by_hand() {
    for (auto& l : lanes)
      l.runs = std::thread([this, &l] {
        while (!stops.load(std::memory_order_relaxed)) {
          if (l.tasks.empty()) {
            std::this_thread::sleep_for(std::chrono::microseconds(50));
            continue;
          }
          const Eigen::Vector2d x = l.tasks.pop();
          l.by.state += l.by.gain * (x - l.by.state);
          l.results.push(l.by.state);
        }
      });
  }
  ~farm_threads_by_hand() {
    stops = true;
    for (auto& l : lanes) l.runs.join();
  }

  void step() {
    at = (at.array() + dt).matrix();
    if (!lanes[0].results.empty() && !lanes[1].results.empty()) {
      Eigen::Vector4d whole;
      for (int i = 0; i < 2; ++i) whole.segment<2>(2 * i) = lanes[i].results.pop();
      sum += whole.head<2>();
    }
    bool room = true;
    for (auto& l : lanes)
      room &=
          l.tasks.written.load(std::memory_order_relaxed) - l.results.taken.load(std::memory_order_relaxed) <
          4;
    if (!room) {
      ++lost;
      return;
    }
    for (int i = 0; i < 2; ++i) lanes[i].tasks.push(at.segment<2>(2 * i));
  }
  void settle() const {
    for (auto& l : lanes)
      while (l.results.written.load() != l.tasks.written.load())
        std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
  Eigen::Vector2d result() const { return sum; }
};

// ---- arbiter ----

template <class Policy>
struct arbitrated : cca::graph<cca::rate<1000>,
                               cca::node<"first", now_and_then>,
                               cca::node<"second", source>,
                               cca::node<"arbiter", cca::arbiter<"y", plane, Policy>>,
                               cca::node<"end", ending<plane>>,
                               cca::wire<"first.y", "arbiter.first">,
                               cca::wire<"second.y", "arbiter.second">,
                               cca::wire<"arbiter.y", "end.x">> {};
struct by_priority : arbitrated<cca::by_priority<"first", "second">> {};
struct by_freshness : arbitrated<cca::by_freshness<"first", "second">> {};
struct either : moving {
  now_and_then first;
  Eigen::Vector2d said{0, 0};
  bool says() {
    first.value[0] += 0.5;
    if (++first.count % 3 != 0) return false;
    said = first.value;
    return true;
  }
};
struct by_priority_by_hand : either {
  double patience = 0;
  std::int64_t k = 0, heard[2] = {-1, -1};
  void step() {
    if (says()) heard[0] = k * 1'000'000;
    move();
    heard[1] = k * 1'000'000;
    const auto waits = static_cast<std::int64_t>(patience * 1e9 + 0.5);
    sum += heard[0] >= 0 && k * 1'000'000 - heard[0] <= waits ? said : at;
    ++k;
  }
};
struct by_freshness_by_hand : either {
  std::int64_t k = 0, origin = -1;
  void step() {
    if (says()) origin = k;
    move();
    sum += origin >= k ? said : at;
    ++k;
  }
};

// ---- switch, blend ----

struct chooser {  // changes its choice every hundred beats
  std::int64_t count = 0;
  auto process(cca::beat) -> cca::out<"y", cca::choice> { return static_cast<double>(count++ / 100 % 2); }
};
template <class Switch>
struct quick : Switch {
  quick() { this->p.duration = 0.05; }
};
template <class Skeleton, class Last, class... More>
struct of_two : cca::graph<cca::rate<1000>,
                           cca::node<"first", ramp<plane>>,
                           cca::node<"second", ramp<plane, 5>>,
                           cca::node<"skeleton", Skeleton>,
                           cca::node<"last", Last>,
                           cca::node<"end", ending<plane>>,
                           cca::wire<"first.y", "skeleton.first">,
                           cca::wire<"second.y", "skeleton.second">,
                           cca::wire<"skeleton.y", "end.x">,
                           More...> {};
struct switched : of_two<quick<cca::switch_between<"y", plane, "first", "second">>,
                         chooser,
                         cca::wire<"last.y", "skeleton.choice">> {};
struct two : sum_of {
  Eigen::Vector2d a{0, 0}, b{5, 5};
  void move() { a = (a.array() + dt).matrix(), b = (b.array() + dt).matrix(); }
  Eigen::Vector2d result() const { return sum; }
  static Eigen::Vector2d between(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double t) {
    if (!(t > 0)) return from;
    if (t >= 1) return to;
    return (1 - t) * from + t * to;
  }
};
struct switched_by_hand : two {
  double duration = 0.05, passed = 0, weights[2] = {1, 0}, begin[2] = {1, 0};
  int chosen = -1;
  std::int64_t count = 0;
  void step() {
    move();
    const int next = static_cast<int>(static_cast<double>(count++ / 100 % 2));
    if (next != chosen) {
      begin[0] = weights[0], begin[1] = weights[1];
      passed = chosen < 0 ? duration : 0;
      chosen = next;
    }
    const double u = passed + dt < duration ? (passed += dt) / duration : 1;
    if (u < 1) {
      const double s = u * u * u * (10 - 15 * u + 6 * u * u);
      for (int i = 0; i < 2; ++i) weights[i] = begin[i] + s * ((i == chosen) - begin[i]);
      const double whole = weights[0] + weights[1];
      sum += between(a, b, whole > 0 ? weights[1] / whole : 0);
    } else {
      weights[0] = chosen == 0, weights[1] = chosen == 1;
      passed = duration;
      sum += chosen == 0 ? a : b;
    }
  }
};

struct swinging {
  double at = 0;
  auto process(cca::beat now) -> cca::out<"y", gain> { return at = at > 1.2 ? -0.2 : at + now.dt(); }
};
struct blended : of_two<cca::blend<"y", plane, gain, "first", "second">,
                        swinging,
                        cca::wire<"last.y", "skeleton.weight">> {};
struct blended_by_hand : two {
  double at = 0, none = 0, full = 1;
  void step() {
    move();
    at = at > 1.2 ? -0.2 : at + dt;
    sum += between(a, b, (at - none) / (full - none));
  }
};

// ---- rates ----

using slow = plane_at<100>;
using fast = plane_at<1000>;

struct held : through<cca::hold<slow, fast>,
                      cca::node<"source", ramp<slow>, cca::timed<10>>,
                      fast,
                      cca::timed<1>,
                      cca::latest> {};
struct slowly : sum_of {
  Eigen::Vector2d at{0, 0};
  std::int64_t k = 0;
  bool due() {
    if (k++ % 10 != 0) return false;
    at = (at.array() + 10 * 1'000'000 / 1e9).matrix();
    return true;
  }
  Eigen::Vector2d result() const { return sum; }
};
struct held_by_hand : slowly {
  void step() { due(), sum += at; }
};

struct decimated : through<cca::decimate<fast, slow>, cca::node<"source", ramp<fast>>, slow> {};
struct ramp_by_hand : sum_of {
  Eigen::Vector2d at{0, 0};
  int count = 0;
  void move() { at = (at.array() + dt).matrix(); }
  Eigen::Vector2d result() const { return sum; }
};
struct decimated_by_hand : ramp_by_hand {
  void step() {
    move();
    if (count == 0) sum += at;
    count = count + 1 == 10 ? 0 : count + 1;
  }
};

struct averaged : through<cca::decimate<fast, slow, cca::averaged>, cca::node<"source", ramp<fast>>, slow> {};
struct averaged_by_hand : ramp_by_hand {
  Eigen::Vector2d mean{0, 0};
  void step() {
    move();
    if (count == 0) mean = at;
    else {
      const double t = 1.0 / (count + 1);
      mean = (1 - t) * mean + t * at;
    }
    if (++count < 10) return;
    count = 0;
    sum += mean;
  }
};

struct interpolated : through<cca::interpolate<slow, fast>,
                              cca::node<"source", ramp<slow>, cca::timed<10>>,
                              fast,
                              cca::timed<1>,
                              cca::latest> {};
struct interpolated_by_hand : slowly {
  Eigen::Vector2d from{0, 0}, last{0, 0};
  int step_ = 10;
  bool begun = false;
  void step() {
    if (due()) {
      from = last;
      step_ = begun ? 0 : 10;
      begun = true;
    }
    if (step_ < 10) ++step_;
    const double t = static_cast<double>(step_) / 10;
    last = step_ < 10 ? Eigen::Vector2d((1 - t) * from + t * at) : at;
    sum += last;
  }
};

}  // namespace bench
