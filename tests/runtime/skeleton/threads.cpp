// The farm on threads: results may be late, the loop never waits, and the results equal those of a farm.
#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <string_view>
#include <thread>
#include <utility>

#include <cca/skeleton/farm_on_threads.hpp>

#include "../picture.hpp"
#include "by_hand.hpp"

namespace {

using namespace skeleton_test;

struct spot : cca::space<cca::number, cca::axes<cca::x>> {};
using image = cca::array_of<spot, 2>;
using thoughts = cca::array_of<spot, 2>;

// How many tasks may begin in all: the tests stop workers with it.
std::atomic<int> allowed[2];
void allow(int first, int second) { allowed[0] = first, allowed[1] = second; }
constexpr int all = 1'000'000;

struct deep_thought {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain));
  };
  parameters p{0.5};
  double sum = 0;
  int done = 0, begun = 0;
  static inline std::atomic<int> loads = 0, saves = 0, stops = 0, tasks = 0;

  void on_load() { ++loads; }
  void on_save() { ++saves; }
  void on_start() { ++begun; }
  void on_stop() { ++stops; }

  // It finds out which of the two workers it is from its input.
  auto process(cca::in<"x", spot> x, cca::optional_in<"more", spot> more, cca::beat now)
      -> std::tuple<cca::maybe<"y", spot>, cca::out<"ok", cca::flag>> {
    ++tasks;
    auto& mine = allowed[x[cca::x{}] >= 1000];
    while (mine <= 0) std::this_thread::sleep_for(std::chrono::microseconds(20));
    --mine;
    ++done;
    sum += p.gain * x[cca::x{}] + now.dt() + (more ? 1 : 0) + (x.fresh() ? 0 : 2) + (begun - 1);
    if (done % 5 == 0) return {cca::maybe<"y", spot>{}, 0};  // publishes nothing
    if (done % 7 == 0) return {cca::maybe<"y", spot>(sum).with_origin(x.origin() - 1), 1};
    return {sum, 1};
  }
};

struct seeing {
  double n = 0;
  int every = 1;
  auto process(cca::beat now) -> cca::maybe<"y", image> {
    if (now.index() % every != 0) return {};
    ++n;
    return cca::maybe<"y", image>(Eigen::Vector2d(n, 1000 + n)).with_origin(now.time() - age);
  }
  std::int64_t age = 0;
};

// [threads]
struct patient : cca::in_order {
  static constexpr int capacity = 64;
};

template <class Farm>
struct thinking : cca::graph<cca::rate<1000>,
                             cca::node<"eye", seeing>,
                             cca::node<"brain", Farm>,
                             cca::node<"act", listener<thoughts>>,
                             cca::wire<"eye.y", "brain.input">,
                             cca::wire<"brain.output", "act.x">> {};

struct at_once : thinking<cca::farm<deep_thought, image, thoughts>> {};
struct on_threads : thinking<cca::farm_on_threads<deep_thought, image, thoughts, patient>> {};
// [threads end]
struct four_at_most : thinking<cca::farm_on_threads<deep_thought, image, thoughts>> {};
struct newest : thinking<cca::farm_on_threads<deep_thought, image, thoughts, cca::as_they_come>> {};

template <class Graph>
auto& crew(cca::controller<Graph>& c) {
  return c.template get<"brain">().template get<"crew">();
}

template <class Notes>
void check_same(const Notes& a, const Notes& b, std::size_t count) {
  REQUIRE(a.size() >= count);
  REQUIRE(b.size() >= count);
  for (std::size_t i = 0; i < count; ++i) {
    CHECK_EQ(a[i].sample.vector(), b[i].sample.vector());
    CHECK_EQ(a[i].sample.origin(), b[i].sample.origin());
  }
}

constexpr std::string_view picture_of_threads = R"(// [threads picture]
flowchart LR
  n0["eye<br/><i>1000 Hz</i>"]
  n2["act<br/><i>restless</i>"]
  subgraph g1["brain"]
    n1["crew<br/><i>1000 Hz</i>"]
  end
  n0 -- "y → input<br/>array_of&lt;spot, 2&gt;" --> n1
  n1 -- "output → x<br/>array_of&lt;spot, 2&gt;" --> n2
)";  // [threads picture end]

}  // namespace

TEST_SUITE("farm on threads") {
  TEST_CASE("the picture") { test::check_picture<on_threads>(picture_of_threads); }

  TEST_CASE("the same results, in order, with the same origins") {
    allow(all, all);
    auto inline_ = started<at_once>();
    inline_.run(cca::for_beats<40>{});
    auto c = started<on_threads>();
    c.run(cca::for_beats<40>{});
    crew(c).wait();
    c.get<"eye">().every = 1'000'000;  // no more samples
    c.run(cca::for_beats<40>{});
    const auto &a = inline_.get<"act">().all, &b = c.get<"act">().all;
    CHECK_EQ(a.size(), 32);  // one of every five is not published
    CHECK_EQ(b.size(), 32);
    check_same(a, b, 32);
    for (const auto& late : b) CHECK(late.beat * c.period() > late.sample.origin());
  }

  TEST_CASE("a worker sees the time of its task, and the result has the origin of its task") {
    allow(all, all);
    auto inline_ = started<at_once>();
    auto c = started<on_threads>();
    for (auto* eye : {&inline_.get<"eye">(), &c.get<"eye">()}) eye->every = 3, eye->age = 5'000'000;
    inline_.run(cca::for_beats<40>{});
    c.run(cca::for_beats<40>{});
    crew(c).wait();
    c.get<"eye">().every = 1'000'000;
    c.run(cca::for_beats<40>{});
    check_same(inline_.get<"act">().all, c.get<"act">().all, 11);
    CHECK_EQ(c.get<"act">().all.front().sample.origin(), -5'000'000);
  }

  TEST_CASE("the loop does not wait for a worker that hangs") {
    allow(2, 2);
    auto c = started<four_at_most>();
    c.run(cca::for_beats<1>{});
    crew(c).wait();
    c.run(cca::for_beats<1>{});
    crew(c).wait();
    const auto before = c.get<"act">().all.size();
    const auto begin = std::chrono::steady_clock::now();
    c.run(cca::for_beats<2000>{});
    const auto end = std::chrono::steady_clock::now();
    CHECK_EQ(before, 1);
    CHECK_EQ(c.get<"act">().all.size(), 2);
    CHECK(end - begin < std::chrono::seconds(2));  // while the worker is still in its task
    // Four are under way; all later ones are lost and counted.
    const auto [output, waiting, dropped] =
        crew(c).process({Eigen::Vector2d(0, 0), 0, false}, cca::beat(c.beat_index(), c.period(), 1));
    CHECK(!output);
    CHECK_EQ(waiting.vector()[0], 4);
    CHECK_EQ(dropped.vector()[0], 1996);
    allow(all, all);
    crew(c).wait();
    c.get<"eye">().every = 1'000'000;
    c.run(cca::for_beats<10>{});
    const auto& arrived = c.get<"act">().all;
    REQUIRE_EQ(arrived.size(), 5);  // the fifth of six published nothing
    CHECK_EQ(arrived[2].sample.origin(), 2 * c.period());
    CHECK_EQ(arrived[3].sample.origin(), 3 * c.period());
    CHECK_EQ(arrived[4].sample.origin(), 5 * c.period());
  }

  TEST_CASE("results as they come") {
    allow(1, 3);  // the first worker hangs in its second task, the second worker in its fourth
    auto c = started<newest>();
    c.run(cca::for_beats<3>{});
    for (int i = 0; i < 1000 && (allowed[0] > 0 || allowed[1] > 0); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    c.run(cca::for_beats<2>{});
    const auto& last = c.get<"act">().last;
    CHECK(last.part<0>().vector()[0] == doctest::Approx(0.5 * 1 + 0.001));
    CHECK(last.part<1>().vector()[0] == doctest::Approx(0.5 * 3006 + 0.003));
    CHECK_EQ(last.origin(), 0);  // the older part
    const auto [output, waiting, dropped] =
        crew(c).process({Eigen::Vector2d(0, 0), 0, false}, cca::beat(c.beat_index(), c.period(), 1));
    CHECK_EQ(waiting.vector()[0], 4);  // the first worker's; the second one has done nearly all
    allow(all, all);
  }

  TEST_CASE("a copy has its own threads, workers and results") {
    allow(all, all);
    auto c = started<on_threads>();
    c.run(cca::for_beats<25>{});
    auto copy = c;  // there may be tasks under way and results to take
    c.get<"eye">().every = copy.get<"eye">().every = 1'000'000;
    for (auto* one : {&c, &copy}) {
      one->run(cca::for_beats<40>{});
      crew(*one).wait();
      one->run(cca::for_beats<40>{});
    }
    auto inline_ = started<at_once>();
    inline_.run(cca::for_beats<25>{});
    const auto &a = c.get<"act">().all, &b = copy.get<"act">().all;
    CHECK_EQ(a.size(), 20);
    CHECK_EQ(b.size(), 20);
    check_same(a, b, 20);
    check_same(a, inline_.get<"act">().all, 20);
    // Both go on independently.
    c.get<"eye">().every = 1;
    c.run(cca::for_beats<5>{});
    crew(c).wait();
    c.run(cca::for_beats<9>{});
    CHECK(c.get<"act">().all.size() > 20);
    CHECK_EQ(copy.get<"act">().all.size(), 20);
  }

  TEST_CASE("a copy waits for tasks under way") {
    allow(3, 3);
    auto c = started<on_threads>();
    c.run(cca::for_beats<4>{});
    for (int i = 0; i < 1000 && (allowed[0] > 0 || allowed[1] > 0); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::thread later([] {
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      allow(all, all);
    });
    auto copy = c;
    later.join();
    c.get<"eye">().every = copy.get<"eye">().every = 1'000'000;
    crew(c).wait();
    for (auto* one : {&c, &copy}) {
      one->run(cca::for_beats<20>{});
      CHECK_EQ(one->get<"act">().all.size(), 4);
    }
  }

  TEST_CASE("a result that is not published yet counts as waiting") {
    allow(0, 0);
    auto c = started<on_threads>();
    c.run(cca::for_beats<3>{});
    allow(all, all);
    crew(c).wait();
    const auto [output, waiting, dropped] =
        crew(c).process({Eigen::Vector2d(0, 0), 0, false}, cca::beat(3, c.period(), 1));
    CHECK(output);  // one per beat
    CHECK_EQ(waiting.vector()[0], 2);
  }

  TEST_CASE("assigned, moved, and never started") {
    allow(all, all);
    auto a = started<on_threads>(), b = started<on_threads>(), d = started<on_threads>();
    a.run(cca::for_beats<10>{});
    d.run(cca::for_beats<3>{});
    b = a;
    d = std::move(a);
    for (auto* one : {&b, &d}) {
      crew(*one).wait();
      one->get<"eye">().every = 1'000'000;
      one->run(cca::for_beats<20>{});
      CHECK_EQ(one->get<"act">().all.size(), 8);
    }
    auto inline_ = started<at_once>();
    inline_.run(cca::for_beats<10>{});
    check_same(b.get<"act">().all, inline_.get<"act">().all, 8);
    check_same(d.get<"act">().all, inline_.get<"act">().all, 8);
    cca::controller<on_threads> idle;
    auto copy = idle;
    copy.load();
    copy.start();
    copy.run(cca::for_beats<1>{});
    CHECK(copy.state() == cca::state::started);
  }

  TEST_CASE("an assigned controller goes on with the results, tasks and losses of the other") {
    allow(all, 1);
    auto a = started<newest>();
    a.run(cca::for_beats<9>{});  // the second worker hangs in its second task, so at most five of nine
                                 // were handed out
    for (int i = 0; i < 1000 && allowed[1] > 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    a.get<"eye">().every = 1'000'000;
    a.run(cca::for_beats<5>{});  // takes the first worker's results
    allow(all, all);
    auto b = started<newest>();
    b = a;
    crew(a).wait();
    const auto check_alike = [&] {
      REQUIRE_EQ(a.get<"act">().all.size(), b.get<"act">().all.size());
      CHECK_EQ(a.get<"act">().last.vector(), b.get<"act">().last.vector());
      CHECK_EQ(a.get<"act">().last.origin(), b.get<"act">().last.origin());
    };
    a.step(), b.step();
    check_alike();
    a.get<"eye">().every = b.get<"eye">().every = 4;
    for (auto* one : {&a, &b}) {
      one->run(cca::for_beats<4>{});
      crew(*one).wait();
      one->run(cca::for_beats<1>{});
    }
    check_alike();
    const auto dropped = [](auto& c) {
      return std::get<2>(crew(c).process({Eigen::Vector2d(0, 0), 0, false}, cca::beat(99, c.period(), 1)))
          .vector()[0];
    };
    CHECK(dropped(a) > 0);
    CHECK_EQ(dropped(a), dropped(b));
  }

  TEST_CASE("after a restart workers keep their state and take the new parameters") {
    allow(all, all);
    const int loads = deep_thought::loads, saves = deep_thought::saves, stops = deep_thought::stops;
    auto c = started<four_at_most>();
    CHECK_EQ(deep_thought::loads - loads, 2);  // one per worker
    allow(0, 0);
    c.run(cca::for_beats<6>{});  // four are under way, two are lost
    allow(all, all);
    crew(c).wait();
    c.get<"eye">().every = 1'000'000;
    c.run(cca::for_beats<5>{});
    const auto dropped = [&] {
      return std::get<2>(crew(c).process({Eigen::Vector2d(0, 0), 0, false}, cca::beat(99, c.period(), 1)))
          .vector()[0];
    };
    CHECK_EQ(dropped(), 2);
    const Eigen::Vector2d known = c.get<"act">().last.vector();
    c.stop();
    CHECK_EQ(deep_thought::stops - stops, 2);
    c.set<"brain.crew">(deep_thought::parameters{0.0});
    c.start();
    CHECK_EQ(dropped(), 0);
    c.get<"eye">().every = 1;
    for (int k = 0; k < 2; ++k) {  // the first one is a worker's fifth, which publishes nothing
      c.step();
      crew(c).wait();
    }
    c.step();
    // Each start adds 1 to a worker's sum; for the first two tasks after a start dt is one beat.
    CHECK((c.get<"act">().last.vector() - known - Eigen::Vector2d::Constant(2 * (0.001 + 1))).norm() < 1e-12);
    c.stop();
    c.save();
    CHECK_EQ(deep_thought::saves - saves, 2);
  }

  TEST_CASE("stop does not wait for busy workers - they are back when the farm starts again") {
    allow(0, 0);
    const int stops = deep_thought::stops, tasks = deep_thought::tasks;
    auto c = started<four_at_most>();
    c.run(cca::for_beats<2>{});
    while (deep_thought::tasks - tasks < 2) std::this_thread::yield();  // each worker hangs in its first
    std::atomic<bool> has_stopped{false};
    std::thread rescue([&] {
      for (int ms = 0; ms < 5000 && !has_stopped; ++ms)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      allow(all, all);
    });
    c.stop();
    CHECK_EQ(allowed[0], 0);  // nobody had to help
    CHECK_FALSE(c.step());
    has_stopped = true;
    rescue.join();
    const auto wait_for_stops = [&](int count) {
      for (int ms = 0; ms < 5000 && deep_thought::stops - stops < count; ++ms)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      CHECK_EQ(deep_thought::stops - stops, count);
      std::this_thread::sleep_for(std::chrono::milliseconds(200));  // until their threads have said so
    };
    wait_for_stops(2);
    c.start();
    c.run(cca::for_beats<1>{});
    crew(c).wait();
    c.get<"eye">().every = 1'000'000;
    c.run(cca::for_beats<1>{});
    // Tasks 1 and 3; the second start adds 1.
    CHECK_EQ(c.get<"act">().last.vector()[0], doctest::Approx(0.5 * (1 + 3) + 2 * 0.001 + 1));
  }

  TEST_CASE("workers that are still busy at the next start are replaced, and end on their own") {
    allow(0, 0);
    auto c = started<four_at_most>();
    for (int i = 0; i < 3; ++i) {
      const int tasks = deep_thought::tasks;
      c.run(cca::for_beats<2>{});
      while (deep_thought::tasks - tasks < 2) std::this_thread::yield();
      c.stop();
      c.start();
    }
    allow(all, all);
    c.run(cca::for_beats<1>{});
    crew(c).wait();
    c.get<"eye">().every = 1'000'000;
    c.run(cca::for_beats<1>{});
    CHECK_EQ(c.get<"act">().last.vector()[0], doctest::Approx(0.5 * 7 + 0.001 + 3));  // only task 7
  }

  TEST_CASE("a controller may end while workers are busy") {
    allow(all, all);
    for (int i = 0; i < 20; ++i) {
      auto c = started<four_at_most>();
      c.run(cca::for_some_beats{i});
    }
  }
}
