// Runs in steps: the bits of plain runs, however many a thread makes at once, and however they end.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <cca/cca.hpp>
#include <cca/robots/arm/description.hpp>
#include <cca/sim/compiled/together/side_by_side.hpp>
#include <cca/sim/compiled/robot.hpp>
#include <cca/sim/robot.hpp>
#include <cca/sim/rollouts.hpp>

#include "waving.hpp"

using namespace cca;

namespace {

namespace arm = robots::arm;

using rollouts_test::waving;
template <class World>
struct waved : graph<node<"targets", waving>,
                     node<"limits", limiter<arm::angles>>,
                     node<"robot", sim::robot<arm::description, World>>,
                     wire<"targets.angles", "limits.command">,
                     wire<"robot.angles", "limits.measured">,
                     wire<"limits.safe", "robot.position">> {};
struct alone : waved<sim::compiled> {};
struct in_engine : waved<sim::robot_world> {};

// [runs_in_steps]
// The same graph, with a world that goes beside others.
struct beside : waved<sim::side_by_side<sim::compiled>> {};

// Half a second of a wave; then how fast the tip is.
struct wave_run {
  controller<beside> c;
  std::size_t left = 500;

  auto& world() { return c.get<"robot.simulator">().world(); }
  bool step() { return left-- > 0 && !world().trouble() && c.step(); }
  double result() { return world().end("arm").velocity.norm(); }
};

std::vector<double> speeds(const std::vector<double>& widths, unsigned threads) {
  wave_run start;
  start.c.load();
  return sim::rollouts(widths.size(),
                       [&](std::size_t i) {
                         wave_run one = start;
                         one.c.get<"targets">().wide = widths[i];
                         one.c.start();
                         return one;
                       },
                       {.threads = threads});
}
// [runs_in_steps end]

struct kept {
  std::size_t number = 0;
  std::vector<double> path{};
  bool in_trouble = false;
  bool operator==(const kept&) const = default;
};

// Runs of unequal length. In one of them something may happen besides.
struct plan {
  std::function<void(std::size_t run, std::size_t beat)> meanwhile = [](std::size_t, std::size_t) {};
  std::optional<std::size_t> in_trouble{}, was_in_trouble{};  // in its first beat; before it
};
std::size_t beats_of(std::size_t i) { return 5 + 17 * i % 40; }

constexpr std::array<double, 7> racing{0, 0, 1e9};  // rad/s

template <class Graph>
struct path_run {
  const plan* p;
  std::size_t number, made = 0;
  controller<Graph> c{};
  kept all{number};

  path_run(const plan& of, std::size_t i) : p(&of), number(i) {
    c.template get<"targets">().wide = 0.2 + 0.05 * static_cast<double>(i);
    c.load();
    c.start();
    if (p->in_trouble == i) world().pull("arm", {1e14, 0, 0});
    if (p->was_in_trouble == i) world().place(arm::description::start, racing);
  }
  auto& world() { return c.template get<"robot.simulator">().world(); }
  bool step() {
    if (made > 0) all.path.push_back(world().end("arm").velocity[0]);
    if (made == beats_of(number) || world().trouble()) return false;
    p->meanwhile(number, made++);
    return c.step();
  }
  kept result() {
    all.in_trouble = bool(world().trouble());
    return all;
  }
};

template <class Graph>
std::vector<kept> paths(std::size_t count, const plan& p, const sim::rollout_settings& s = {}) {
  return sim::rollouts(count, [&](std::size_t i) { return path_run<Graph>(p, i); }, s);
}
// By a plain function, with worlds that nothing advances with.
std::vector<kept> paths_alone(std::size_t count, const plan& p = {}) {
  return sim::rollouts(count, [&](std::size_t i) {
    path_run<alone> one(p, i);
    while (one.step()) {}
    return one.result();
  });
}

// Counts how many there are at once.
struct counted_run {
  std::atomic<std::size_t>* living;
  std::size_t left;
  sim::side_by_side<sim::compiled_world<arm::description>> w{};
  bool told = (++*living, true);
  explicit counted_run(std::atomic<std::size_t>& all, std::size_t beats) : living(&all), left(beats) {}
  counted_run(const counted_run&) = delete;
  ~counted_run() { --*living; }
  auto& world() { return w; }
  bool step() { return left-- > 0; }
  std::unique_ptr<std::size_t> result() { return std::make_unique<std::size_t>(living->load()); }
};

}  // namespace

TEST_SUITE("rollouts in steps") {
  TEST_CASE("the page's runs have the same bits on any number of threads, and those of plain runs") {
    std::vector<double> widths;
    for (int i = 0; i < 10; ++i) widths.push_back(0.02 * i);
    controller<alone> start;
    start.load();
    const auto plain = sim::rollouts(widths.size(), [&](std::size_t i) {
      auto c = start;
      c.get<"targets">().wide = widths[i];
      c.start();
      c.run(for_beats<500>{});
      return c.get<"robot.simulator">().world().end("arm").velocity.norm();
    });
    CHECK_GT(plain[9], 0.1);
    for (const unsigned threads : {1u, 2u}) CHECK_EQ(speeds(widths, threads), plain);
  }

  TEST_CASE("runs of unequal length have the bits of plain runs, and each is told") {
    for (const std::size_t count : {0u, 1u, 3u, 4u, 5u, 23u}) {
      const auto right = paths_alone(count);
      for (std::size_t i = 0; i < right.size(); ++i) CHECK_EQ(right[i].path.size(), beats_of(i));
      for (const unsigned threads : {1u, 2u, 3u, 40u}) {
        std::vector<std::size_t> told, each;
        for (std::size_t n = 1; n <= count; ++n) each.push_back(n);
        const auto all =
            paths<beside>(count, {}, {.threads = threads, .over = [&](std::size_t n) { told.push_back(n); }});
        CHECK_MESSAGE(all == right, count << " runs on " << threads << " threads");
        CHECK_EQ(told, each);
      }
    }
  }

  TEST_CASE("a world in trouble ends its run only") {
    const plan third{.in_trouble = 3, .was_in_trouble = 6};
    const auto right = paths_alone(9, third);
    for (std::size_t i = 0; i < right.size(); ++i) CHECK_EQ(right[i].in_trouble, i == 3 || i == 6);
    CHECK_EQ(right[3].path.size(), 1);
    CHECK(right[6].path.empty());
    CHECK(paths<beside>(9, third, {.threads = 1}) == right);
    CHECK(paths<beside>(9, third, {.threads = 2}) == right);
  }

  TEST_CASE("worlds of the engine go one at a time") {
    std::size_t last = 0;
    bool in_order = true;
    const plan watched{.meanwhile = [&](std::size_t run, std::size_t) {
      in_order = in_order && run >= last;
      last = run;
    }};
    const auto all = paths<in_engine>(3, watched, {.threads = 1});
    CHECK(in_order);
    REQUIRE_EQ(all.size(), 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK_EQ(all[i].path.size(), beats_of(i));
      CHECK(all[i] == paths<in_engine>(i + 1, {}, {.threads = 2})[i]);
    }
  }

  TEST_CASE("a thread makes as many as share a vector, and no thread takes what another one could begin") {
    const auto most = [](std::size_t count, unsigned threads) {
      std::atomic<std::size_t> living = 0;
      std::size_t most_at_end = 0;
      for (const auto& each :
           sim::rollouts(count, [&](std::size_t) { return counted_run(living, 10); }, {.threads = threads}))
        most_at_end = std::max(most_at_end, *each);
      CHECK_EQ(living, 0);
      return most_at_end;
    };
    CHECK_EQ(most(1, 1), 1);
    constexpr std::size_t at_once = sim::detail::runs_at_once<counted_run>;
    static_assert(at_once == 2 || at_once == 4);
    CHECK_EQ(most(3, 1), std::min<std::size_t>(3, at_once));
    CHECK_EQ(most(23, 1), at_once);
    // Each of two runs goes on until both threads have one.
    struct waiting : counted_run {
      std::set<std::thread::id>* seen;
      std::mutex* at_hand;
      std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();
      waiting(std::atomic<std::size_t>& all, std::set<std::thread::id>& threads, std::mutex& m)
          : counted_run(all, 0), seen(&threads), at_hand(&m) {}
      bool step() {
        const std::lock_guard lock(*at_hand);
        seen->insert(std::this_thread::get_id());
        return seen->size() < 2 && std::chrono::steady_clock::now() - begun < std::chrono::seconds(20);
      }
    };
    std::atomic<std::size_t> living = 0;
    std::set<std::thread::id> seen;
    std::mutex at_hand;
    sim::rollouts(2, [&](std::size_t) { return waiting(living, seen, at_hand); }, {.threads = 2});
    CHECK_EQ(seen.size(), 2);
    CHECK_EQ(sim::detail::places_of_thread<counted_run>(0, 2), 1);
    CHECK_EQ(sim::detail::places_of_thread<counted_run>(2, 2), 1);
    CHECK_EQ(sim::detail::places_of_thread<counted_run>(5, 2), std::min<std::size_t>(3, at_once));
    CHECK_EQ(sim::detail::places_of_thread<counted_run>(9, 2), at_once);
    CHECK_EQ(sim::detail::places_of_thread<path_run<in_engine>>(9, 2), 1);
  }

  TEST_CASE("runs whose first step says no begin no beat") {
    std::atomic<std::size_t> living = 0;
    const auto all = sim::rollouts(9, [&](std::size_t i) { return counted_run(living, i % 3 == 0 ? 4 : 0); },
                                   {.threads = 1});
    CHECK_EQ(all.size(), 9);
    CHECK_EQ(living, 0);
  }

  TEST_CASE("no beat is lost: neither before the first step, nor of a step that makes one and says no") {
    struct counting {
      std::size_t left;
      sim::side_by_side<sim::compiled_world<arm::description>> w{};
      explicit counting(std::size_t beats) : left(beats) { w.advance({}), w.advance({}); }
      auto& world() { return w; }
      bool step() {
        w.advance({});
        return --left > 0;
      }
      double result() { return w.time(); }
    };
    const auto times = sim::rollouts(5, [](std::size_t i) { return counting(3 * i + 1); }, {.threads = 1});
    for (std::size_t i = 0; i < 5; ++i)
      CHECK_EQ(times[i], doctest::Approx(1e-3 * static_cast<double>(3 * i + 3)));
  }

  TEST_CASE("a thread may wait for a run only where it has none") {
    std::atomic<std::size_t> living = 0;
    std::size_t given = 0, refused = 0;
    bool is_right = true;
    std::vector<std::size_t> ended;
    // Every other time none is given to a thread that could not wait for it.
    const auto next = [&](bool is_idle) -> std::optional<std::size_t> {
      is_right = is_right && is_idle == (living == 0);
      if (given == 17 || (!is_idle && ++refused % 2 == 0)) return {};
      return given++;
    };
    const auto begin = [&](std::size_t i) { return counted_run(living, 1 + i * 5 % 11); };
    sim::detail::make_runs(
        begin, 4, next, [&](std::size_t i, const std::unique_ptr<std::size_t>&) { ended.push_back(i); },
        [&](std::size_t) { is_right = false; });
    CHECK(is_right);
    CHECK_GT(refused, 4);
    std::ranges::sort(ended);
    std::vector<std::size_t> each(17);
    std::iota(each.begin(), each.end(), std::size_t{0});
    CHECK_EQ(ended, each);
  }

  TEST_CASE("an exception anywhere in a run ends all: the lowest number is thrown, and others end") {
    enum class where { begin, step, world, result };
    struct failing : counted_run {
      std::function<void(where)> act;
      failing(std::atomic<std::size_t>& all, std::size_t beats, std::function<void(where)> what)
          : counted_run(all, beats), act(std::move(what)) {
        act(where::begin);
      }
      bool step() {
        act(where::step);
        return counted_run::step();
      }
      auto& world() {
        act(where::world);
        return counted_run::world();
      }
      std::size_t result() {
        act(where::result);
        return 0;
      }
    };
    for (const where place : {where::begin, where::step, where::world, where::result})
      for (const unsigned threads : {1u, 3u}) {
        std::atomic<std::size_t> living = 0, ended = 0;
        // On one thread 0 to 3 are under way when 3 fails; 2 fails later, and 0 and 1 come to their end.
        const auto run = [&](std::size_t i) {
          return failing(living, i == 3 ? 5 : 20, [&, i, place, beat = 0](where now) mutable {
            if (now == where::step) ++beat;
            if (now == where::result && (i < 2 || i > 3)) ++ended;
            if ((i == 3 || (i == 2 && (beat >= 20 || place == where::begin))) && now == place)
              throw std::runtime_error("run " + std::to_string(i));
          });
        };
        if (threads == 1 || place == where::begin) {
          CHECK_THROWS_WITH_AS(sim::rollouts(100, run, {.threads = threads}), "run 2", std::runtime_error);
        } else {
          CHECK_THROWS_AS(sim::rollouts(100, run, {.threads = threads}), std::runtime_error);
        }
        CHECK_EQ(living, 0);
        if (threads == 1) CHECK_EQ(ended, 2);
        CHECK_LE(ended, 12);
      }
  }

  TEST_CASE("what the settings have may throw while runs are under way") {
    for (const unsigned threads : {1u, 3u}) {
      std::atomic<std::size_t> living = 0;
      const auto run = [&](std::size_t i) { return counted_run(living, 3 + i); };
      const auto over = [](std::size_t n) { n > 5 ? throw std::runtime_error("told") : void(); };
      CHECK_THROWS_WITH_AS(sim::rollouts(50, run, {.threads = threads, .over = over}), "told",
                           std::runtime_error);
      std::atomic<int> asked = 0;
      const auto stops = [&]() -> bool { return ++asked > 7 ? throw std::runtime_error("asked") : false; };
      CHECK_THROWS_WITH_AS(sim::rollouts(50, run, {.threads = threads, .stops = stops}), "asked",
                           std::runtime_error);
      CHECK_EQ(living, 0);
    }
  }

  TEST_CASE("once it is to stop, nothing begins, and what is under way is not kept") {
    const auto right = paths_alone(100);
    for (const unsigned threads : {1u, 3u}) {
      std::atomic<bool> stop = false;
      std::atomic<std::size_t> begun = 0;
      const plan stopping{.meanwhile = [&](std::size_t run, std::size_t beat) {
        if (beat == 0) ++begun;
        if (run == 20 && beat == 2) stop = true;
      }};
      const auto all =
          paths<beside>(100, stopping, {.threads = threads, .stops = [&] { return stop.load(); }});
      CHECK_LE(begun, 21 + 4 * threads);
      CHECK_LE(all.size(), 20);
      if (threads == 1) CHECK_GE(all.size(), 16);
      CHECK(std::equal(all.begin(), all.end(), right.begin()));
    }
  }

  TEST_CASE("a stop holds, also where it is taken back") {
    std::atomic<int> asked = 0;
    std::atomic<std::size_t> begun = 0, living = 0;
    const auto stops = [&] { return ++asked == 6; };
    sim::rollouts(100, [&](std::size_t) { return ++begun, counted_run(living, 3); },
                  {.threads = 1, .stops = stops});
    CHECK_LE(begun, 5);
  }
}
