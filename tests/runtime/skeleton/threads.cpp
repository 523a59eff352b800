// The farm on threads: late, never in the way, and the same results as the farm in the loop.
#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <string_view>
#include <thread>
#include <utility>

#include <cca/skeleton/farm_on_threads.hpp>

#include "by_hand.hpp"

namespace {

using namespace skeleton_test;

struct spot : cca::space<cca::number, cca::axes<cca::x>> {};
using image = cca::array_of<spot, 2>;
using thoughts = cca::array_of<spot, 2>;

// How many tasks in all may be begun: the tests hold workers up by it.
std::atomic<int> allowed[2];
void allow(int first, int second) { allowed[0] = first, allowed[1] = second; }
constexpr int all = 1'000'000;

struct deep_thought {
  struct parameters { BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain)); };
  parameters p{0.5};
  double sum = 0;
  int done = 0;

  // Which of the two it is it tells from what it is given.
  auto process(cca::in<"x", spot> x, cca::optional_in<"more", spot> more, cca::beat now) -> std::tuple<cca::maybe<"y", spot>, cca::out<"ok", cca::flag>> {
    auto& mine = allowed[x[cca::x{}] >= 1000];
    while (mine <= 0) std::this_thread::sleep_for(std::chrono::microseconds(20));
    --mine;
    ++done;
    sum += p.gain * x[cca::x{}] + now.dt() + (more ? 1 : 0);
    if (done % 5 == 0) return {cca::maybe<"y", spot>{}, 0};  // nothing to say
    return {sum, 1};
  }
};

struct seeing {
  double n = 0;
  int every = 1;
  auto process(cca::beat now) -> cca::maybe<"y", image> {
    if (now.index() % every != 0) return {};
    ++n;
    return Eigen::Vector2d(n, 1000 + n);
  }
};

// [threads]
struct patient : cca::in_order { static constexpr int capacity = 64; };

template <class Farm>
struct thinking : cca::graph<
    cca::rate<1000>,
    cca::node<"eye",   seeing>,
    cca::node<"brain", Farm>,
    cca::node<"act",   listener<thoughts>>,
    cca::wire<"eye.y",        "brain.input">,
    cca::wire<"brain.output", "act.x">> {};

struct at_once   : thinking<cca::farm<deep_thought, image, thoughts>> {};
struct on_threads : thinking<cca::farm_on_threads<deep_thought, image, thoughts, patient>> {};
// [threads end]
struct four_at_most : thinking<cca::farm_on_threads<deep_thought, image, thoughts>> {};
struct newest : thinking<cca::farm_on_threads<deep_thought, image, thoughts, cca::as_they_come>> {};

template <class Graph>
auto& crew(cca::controller<Graph>& c) { return c.template get<"brain">().template get<"crew">(); }

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

TEST_CASE("the picture") {
  CHECK_EQ(cca::describe<on_threads>::mermaid(), picture_of_threads.substr(picture_of_threads.find('\n') + 1));
}

TEST_CASE("the same results, in order, of the same origins") {
  allow(all, all);
  auto inline_ = started<at_once>();
  inline_.run(cca::for_beats<40>{});
  auto c = started<on_threads>();
  c.run(cca::for_beats<40>{});
  crew(c).wait();
  c.get<"eye">().every = 1'000'000;  // nothing more to see
  c.run(cca::for_beats<40>{});
  const auto &a = inline_.get<"act">().all, &b = c.get<"act">().all;
  CHECK_EQ(a.size(), 32);  // of every five one is not published
  CHECK_EQ(b.size(), 32);
  check_same(a, b, 32);
  for (const auto& late : b) CHECK(late.beat * c.period() > late.sample.origin());
}

TEST_CASE("a worker that hangs holds up nobody") {
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
  CHECK(end - begin < std::chrono::seconds(2));  // with the worker still in its task
  // Four under way, all that came later are lost, and counted.
  const auto [output, waiting, dropped] = crew(c).process({Eigen::Vector2d(0, 0), 0, false}, cca::beat(c.beat_index(), c.period(), 1));
  CHECK(!output);
  CHECK_EQ(waiting.vector()[0], 4);
  CHECK_EQ(dropped.vector()[0], 1996);
  allow(all, all);
  crew(c).wait();
  c.get<"eye">().every = 1'000'000;
  c.run(cca::for_beats<10>{});
  const auto& heard = c.get<"act">().all;
  REQUIRE_EQ(heard.size(), 5);  // the fifth of the six published nothing
  CHECK_EQ(heard[2].sample.origin(), 2 * c.period());
  CHECK_EQ(heard[3].sample.origin(), 3 * c.period());
  CHECK_EQ(heard[4].sample.origin(), 5 * c.period());
}

TEST_CASE("as they come") {
  allow(1, 3);  // the first worker hangs in its second task, the second worker in its fourth
  auto c = started<newest>();
  c.run(cca::for_beats<3>{});
  for (int i = 0; i < 1000 && (allowed[0] > 0 || allowed[1] > 0); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  c.run(cca::for_beats<2>{});
  const auto& last = c.get<"act">().last;
  CHECK(last.part<0>().vector()[0] == doctest::Approx(0.5 * 1 + 0.001));
  CHECK(last.part<1>().vector()[0] == doctest::Approx(0.5 * 3006 + 0.003));
  CHECK_EQ(last.origin(), 0);  // the older part
  allow(all, all);
}

TEST_CASE("a copy has threads, workers and results of its own") {
  allow(all, all);
  auto c = started<on_threads>();
  c.run(cca::for_beats<25>{});
  auto copy = c;  // with tasks under way, perhaps, and results that wait
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
  // Each goes on alone.
  c.get<"eye">().every = 1;
  c.run(cca::for_beats<5>{});
  crew(c).wait();
  c.run(cca::for_beats<9>{});
  CHECK(c.get<"act">().all.size() > 20);
  CHECK_EQ(copy.get<"act">().all.size(), 20);
}

TEST_CASE("assigned, moved, and never started") {
  allow(all, all);
  auto a = started<on_threads>(), b = started<on_threads>();
  a.run(cca::for_beats<10>{});
  b = a;
  a = std::move(b);
  crew(a).wait();
  a.get<"eye">().every = 1'000'000;
  a.run(cca::for_beats<20>{});
  CHECK_EQ(a.get<"act">().all.size(), 8);
  cca::controller<on_threads> idle;
  auto copy = idle;
  copy.load();
  copy.start();
  copy.run(cca::for_beats<1>{});
  CHECK(copy.state() == cca::state::started);
}

TEST_CASE("stops and starts; its workers keep what they know, and take their parameters") {
  allow(all, all);
  auto c = started<on_threads>();
  c.run(cca::for_beats<3>{});
  crew(c).wait();
  c.run(cca::for_beats<3>{});
  c.stop();
  const auto heard = c.get<"act">().all.size();
  c.set<"brain.crew">(deep_thought::parameters{0.0});
  c.start();
  c.run(cca::for_beats<20>{});
  crew(c).wait();
  c.run(cca::for_beats<30>{});
  CHECK(c.get<"act">().all.size() > heard);
  c.stop();
}

TEST_CASE("ends in the midst of its work") {
  allow(all, all);
  for (int i = 0; i < 20; ++i) {
    auto c = started<four_at_most>();
    c.run(cca::for_some_beats{i});
  }
}

}
