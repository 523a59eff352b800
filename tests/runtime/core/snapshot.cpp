// A controller is a value: a copy is a snapshot, and two copies with the same steps stay equal to the bit.
#include <doctest/doctest.h>

#include <bit>
#include <memory>
#include <optional>
#include <random>

#include "counting.hpp"

using namespace core_test;

namespace {

// [snapshot]
struct noise {  // the snapshot includes the state of a random generator
  auto process() -> cca::maybe<"y", reading> {
    if (random() % 3 == 0) return {};
    return std::uniform_real_distribution<double>(-1, 1)(random);
  }
  std::mt19937_64 random{7};
};
// [snapshot end]

struct brave {  // a strategy of the test's own that depends on values
  template <class Inputs>
  static bool fires(cca::beat now, const Inputs& in) {
    return in.template get<"x">()[cca::x{}] > 0 || now.index() % 7 == 0;
  }
};
struct oscillator {
  auto process(cca::in<"x", reading> x, cca::beat now) -> cca::out<"y", reading> {
    velocity += now.dt() * (x[cca::x{}] - 40 * angle);
    return angle += now.dt() * velocity;
  }
  double angle = 1, velocity = 0;
};
struct sum {
  auto process(cca::in<"a", reading> a, cca::in<"b", reading> b) -> cca::out<"y", reading> {
    return a[cca::x{}] + 0.5 * b[cca::x{}];
  }
};

// Queues, delays, occasional samples and strategies decided at run time: all have a state.
struct rich : cca::graph<cca::rate<500>,
                         cca::node<"noise", noise>,
                         cca::node<"counter", counter, cca::timed<3>>,
                         cca::node<"queued", adder, cca::timed<2>>,
                         cca::node<"late", adder>,
                         cca::node<"brave", oscillator, brave>,
                         cca::node<"both", sum, cca::moderate>,
                         cca::node<"either", sum, cca::any_of<cca::moderate, cca::timeout<5>>>,
                         cca::node<"matched", sum, cca::coordinated>,
                         cca::node<"feedback", sum, cca::restless>,
                         cca::node<"log1", journal>,
                         cca::node<"log2", journal>,
                         cca::node<"log3", journal>,
                         cca::node<"log4", journal>,
                         cca::node<"log5", journal>,
                         cca::node<"log6", journal>,
                         cca::wire<"noise.y", "queued.x", cca::queue<4, cca::drop_oldest>>,
                         cca::wire<"noise.y", "late.x", cca::delayed<3>>,
                         cca::wire<"noise.y", "brave.x", cca::latest>,
                         cca::wire<"noise.y", "both.a">,
                         cca::wire<"counter.y", "both.b", cca::queue<3, cca::drop_newest>>,
                         cca::wire<"late.y", "either.a">,
                         cca::wire<"counter.y", "either.b", cca::delayed<2>>,
                         cca::wire<"noise.y", "matched.a", cca::delayed<1>>,
                         cca::wire<"noise.y", "matched.b", cca::queue<2, cca::drop_oldest>>,
                         cca::wire<"brave.y", "feedback.a">,
                         cca::wire<"feedback.y", "feedback.b", cca::delayed<4>>,
                         cca::wire<"queued.y", "log1.x">,
                         cca::wire<"brave.y", "log2.x">,
                         cca::wire<"both.y", "log3.x">,
                         cca::wire<"either.y", "log4.x">,
                         cca::wire<"matched.y", "log5.x">,
                         cca::wire<"feedback.y", "log6.x">> {};

// Everything that was logged, as bits.
std::vector<std::uint64_t> bits_of(const cca::controller<rich>& c) {
  std::vector<std::uint64_t> bits;
  c.for_each_component([&]<class C>(std::string_view, const C& component) {
    if constexpr (std::is_same_v<C, journal>)
      for (const seen& one : component.all)
        bits.insert(bits.end(),
                    {std::bit_cast<std::uint64_t>(one.value), static_cast<std::uint64_t>(one.beat),
                     static_cast<std::uint64_t>(one.origin), one.fresh});
  });
  return bits;
}

struct plain : cca::graph<cca::rate<1000>,
                          cca::node<"counter", counter>,
                          cca::node<"adder", adder>,
                          cca::wire<"counter.y", "adder.x", cca::delayed<2>>> {};
static_assert(std::is_trivially_copyable_v<cca::controller<plain>>,
              "a controller of trivial components is one too");

struct holder {  // can be moved but not copied, and so can a controller that holds it
  auto process() -> cca::out<"y", reading> { return ++*value; }
  std::unique_ptr<double> value = std::make_unique<double>(0);
};
struct holding : cca::graph<cca::rate<1000>, cca::node<"holder", holder>> {};
static_assert(!std::is_copy_constructible_v<cca::controller<holding>> &&
              std::is_move_constructible_v<cca::controller<holding>>);
static_assert(std::is_copy_constructible_v<cca::controller<rich>> &&
              std::is_copy_assignable_v<cca::controller<rich>>);

}  // namespace

TEST_SUITE("snapshots") {
  TEST_CASE("two copies with the same steps, from any beat on") {
    auto c = started<rich>();
    for (const int beats : {0, 1, 2, 3, 7, 50, 100}) {
      c.run(cca::for_some_beats{beats});
      auto copy = c;
      auto original = c;
      for (int i = 0; i < 100; ++i) {
        original.step();
        copy.step();
      }
      REQUIRE_EQ(bits_of(original), bits_of(copy));
      CHECK_EQ(original.beat_index(), copy.beat_index());
    }
    c.for_each_component([]<class C>(std::string_view path, const C& component) {
      CAPTURE(std::string(path));
      if constexpr (std::is_same_v<C, journal>) CHECK_GT(component.all.size(), 3);  // each logged something
    });
  }

  TEST_CASE("going back to a snapshot") {
    auto c = started<rich>();
    c.run(cca::for_beats<33>{});
    const auto snapshot = c;
    c.run(cca::for_beats<60>{});
    const auto first = bits_of(c);
    c = snapshot;
    CHECK_EQ(c.beat_index(), 33);
    c.run(cca::for_beats<60>{});
    CHECK_EQ(bits_of(c), first);
  }

  TEST_CASE("a snapshot from within a run goes on, and the run, too") {
    auto c = started<rich>();
    std::optional<cca::controller<rich>> ahead;
    c.run(cca::for_beats<90>{}, cca::as_fast_as_possible{}, [&](auto& running) {
      if (running.beat_index() != 33) return true;
      CHECK_THROWS_AS(cca::controller<rich>(running).run(cca::for_beats<1>{}),
                      cca::refused);  // a mere copy is running
      ahead = running.snapshot();
      CHECK_EQ(running.state(), cca::state::running);
      return true;
    });
    REQUIRE(ahead);
    CHECK_EQ(ahead->state(), cca::state::started);
    CHECK_EQ(ahead->beat_index(), 33);
    CHECK_EQ(ahead->run(cca::for_beats<57>{}), cca::state::started);
    CHECK_EQ(bits_of(*ahead), bits_of(c));
    CHECK_EQ(cca::controller<rich>().snapshot().state(), cca::state::created);
  }

  TEST_CASE("a component that can't be copied can be moved") {
    auto c = started<holding>();
    c.run(cca::for_beats<3>{});
    cca::controller<holding> moved = std::move(c);
    moved.step();
    CHECK_EQ(*moved.get<"holder">().value, 4);
  }
}
