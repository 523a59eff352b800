// The examples of the pages in docs/: components, strategies, graphs, the controller.
#include <doctest/doctest.h>

#include <cmath>

#include <cca/runtime/interruption.hpp>

#include "../picture.hpp"
#include "counting.hpp"

namespace {

using namespace core_test;

struct load : cca::space<cca::number, cca::axes<cca::x>> {};
struct contact : cca::space<cca::status, cca::axes<cca::x>> {};

// [component]
// Decides between stance and swing by the load on a foot.
struct touch_down {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (cca::bounded<double, 0.0, 100.0>, threshold));
  };
  parameters p{5.0};

  auto process(cca::in<"load", load> now_on, cca::optional_in<"tare", load> tare)
      -> cca::maybe<"contact", contact> {
    const bool stands = now_on[cca::x{}] - tare[cca::x{}] > p.threshold;  // an unwired input is zero
    if (stands == stood) return {};                                       // no change: publish nothing
    stood = stands;
    return stands ? 1 : 0;
  }

  void on_start() { stood = false; }

private:
  bool stood = false;
};
// [component end]

struct rising {
  auto process(cca::beat now) -> cca::out<"y", load> { return static_cast<double>(now.index()); }
};
struct contacts {
  void process(cca::in<"x", contact> x, cca::beat now) {
    all.push_back({now.index(), x[cca::x{}], x.origin(), x.fresh()});
  }
  std::vector<seen> all;
};
struct standing : cca::graph<cca::rate<1000>,
                             cca::node<"rising", rising>,
                             cca::node<"touch", touch_down>,
                             cca::node<"contacts", contacts>,
                             cca::wire<"rising.y", "touch.load">,
                             cca::wire<"touch.contact", "contacts.x">> {};

// [strategies]
struct pair {
  void process(cca::in<"a", reading>, cca::in<"b", reading>, cca::beat now) { fired.push_back(now.index()); }
  std::vector<std::int64_t> fired;
};

struct every_third_a {  // your own: it may look at the beat, freshness, origins and values
  template <class Inputs>
  static bool fires(cca::beat, const Inputs& in) {
    return in.template get<"a">().fresh() && std::fmod(in.template get<"a">()[cca::x{}], 3) == 0;
  }
};

struct twelve_beats
    : cca::graph<cca::rate<1000>,
                 cca::node<"a", counter, cca::timed<2>>,             // beats 0, 2, 4, 6, 8, 10
                 cca::node<"b", counter, cca::timed<3, 1>>,          // beats 1, 4, 7, 10
                 cca::node<"restless", pair, cca::restless>,         // 0 1 2 4 6 7 8 10
                 cca::node<"moderate", pair, cca::moderate>,         // 1 4 7 10
                 cca::node<"by_b", pair, cca::port_triggered<"b">>,  // 1 4 7 10
                 cca::node<"coordinated", pair, cca::coordinated>,   // 4 10
                 cca::node<"patient", pair, cca::any_of<cca::coordinated, cca::timeout<4>>>,  // 4 8 10
                 cca::node<"both", pair, cca::all_of<cca::timed<4>, cca::restless>>,          // 0 4 8
                 cca::node<"own", pair, every_third_a>,                                       // 4 10
                 // ... and a wire from "a.y" and one from "b.y" to each
                 // [strategies end]
                 cca::wire<"a.y", "restless.a", cca::latest>,
                 cca::wire<"b.y", "restless.b", cca::latest>,
                 cca::wire<"a.y", "moderate.a", cca::latest>,
                 cca::wire<"b.y", "moderate.b", cca::latest>,
                 cca::wire<"a.y", "by_b.a", cca::latest>,
                 cca::wire<"b.y", "by_b.b", cca::latest>,
                 cca::wire<"a.y", "coordinated.a", cca::latest>,
                 cca::wire<"b.y", "coordinated.b", cca::latest>,
                 cca::wire<"a.y", "patient.a", cca::latest>,
                 cca::wire<"b.y", "patient.b", cca::latest>,
                 cca::wire<"a.y", "both.a", cca::latest>,
                 cca::wire<"b.y", "both.b", cca::latest>,
                 cca::wire<"a.y", "own.a", cca::latest>,
                 cca::wire<"b.y", "own.b", cca::latest>> {};

struct camera {
  auto process() -> cca::out<"seen", reading> { return ++frames; }
  double frames = 0;
};
struct wish {
  auto process() -> cca::out<"wanted", reading> { return 100; }
};
struct controlled {
  auto process(cca::in<"wanted", reading> wanted, cca::in<"is", reading> is) -> cca::out<"y", reading> {
    return wanted[cca::x{}] - is[cca::x{}];
  }
};
struct smoothed {
  auto process(cca::in<"x", reading> x, cca::in<"before", reading> before) -> cca::out<"y", reading> {
    return 0.5 * (x[cca::x{}] + before[cca::x{}]);
  }
};

// [graph]
struct low_pass
    : cca::graph<cca::node<"mean", smoothed, cca::port_triggered<"x">>,
                 cca::wire<"mean.y", "mean.before", cca::delayed<1>, cca::initial<1.0>>,  // its own output, a
                                                                                          // beat later
                 cca::expose<"mean.x", "x">,
                 cca::expose<"mean.y", "y">> {};

struct following
    : cca::graph<cca::rate<100>,
                 cca::node<"camera", camera, cca::timed<2>>,  // 50 Hz
                 cca::node<"wish", wish>,
                 cca::node<"filter", low_pass>,  // a graph is a component
                 cca::node<"follow", controlled, cca::port_triggered<"is">>,
                 cca::node<"log", journal>,
                 cca::wire<"camera.seen", "filter.x", cca::latest>,
                 cca::wire<"wish.wanted", "follow.wanted", cca::latest>,  // 100 Hz, read at 50 Hz: state it
                 cca::wire<"filter.y", "follow.is">,
                 cca::wire<"follow.y", "log.x", cca::queue<4, cca::drop_oldest>>,
                 cca::require<cca::latency<"camera.seen", "follow.is">, cca::beats<2>>> {};
// [graph end]

// [state]
// Fires with every N-th sample that arrives at an input.
template <cca::fixed_string Input, int N>
struct every_nth {
  int come = 0;

  template <class Inputs>
  bool fires(cca::beat, const Inputs& in) {
    come += in.template arrivals<Input>();
    if (come < N) return false;
    come -= N;
    return true;
  }
};

struct thinned_out : cca::graph<cca::rate<1000>,
                                cca::node<"a", counter, cca::timed<2>>,
                                cca::node<"third", journal, every_nth<"x", 3>>,  // beats 4, 10, 16, ...
                                cca::wire<"a.y", "third.x", cca::latest>> {};
// [state end]

// [merged]
struct diary : cca::graph<cca::rate<100>,
                          cca::node<"speech", counter, cca::timed<4>>,
                          cca::node<"touch", counter, cca::timed<4>>,
                          cca::node<"log", journal>,
                          cca::wire<"speech.y", "log.x", cca::merged<8>>,  // drops the oldest when it is full
                          cca::wire<"touch.y", "log.x", cca::merged<8>, cca::delayed<1>>> {};
// [merged end]

constexpr std::string_view picture = R"(// [graph picture]
flowchart LR
  n0["camera<br/><i>50 Hz</i>"]
  n1["wish<br/><i>100 Hz</i>"]
  n3["follow<br/><i>50 Hz</i>"]
  n4["log<br/><i>50 Hz</i>"]
  subgraph g1["filter"]
    n2["mean<br/><i>50 Hz</i>"]
  end
  n0 -- "seen → x<br/>reading, 50 Hz" --> n2
  n2 -. "y → before<br/>reading, 50 Hz<br/>delayed 1" .-> n2
  n1 -- "wanted<br/>reading, 100 Hz" --> n3
  n2 -- "y → is<br/>reading, 50 Hz" --> n3
  n3 -- "y → x<br/>reading, 50 Hz<br/>queue 4" --> n4
)";  // [graph picture end]

}  // namespace

TEST_SUITE("pages") {
  TEST_CASE("components") {
    auto c = started<standing>();
    c.run(cca::for_beats<20>{});
    CHECK_EQ(c.get<"contacts">().all, std::vector<seen>{{6, 1, 6'000'000, true}});
  }

  TEST_CASE("strategies") {
    auto c = started<twelve_beats>();
    c.run(cca::for_beats<12>{});
    using beats = std::vector<std::int64_t>;
    CHECK_EQ(c.get<"restless">().fired, beats{0, 1, 2, 4, 6, 7, 8, 10});
    CHECK_EQ(c.get<"moderate">().fired, beats{1, 4, 7, 10});
    CHECK_EQ(c.get<"by_b">().fired, beats{1, 4, 7, 10});
    CHECK_EQ(c.get<"coordinated">().fired, beats{4, 10});
    CHECK_EQ(c.get<"patient">().fired, beats{4, 8, 10});
    CHECK_EQ(c.get<"both">().fired, beats{0, 4, 8});
    CHECK_EQ(c.get<"own">().fired, beats{4, 10});
  }

  TEST_CASE("a strategy with a state") {
    auto c = started<thinned_out>();
    c.run(cca::for_beats<17>{});
    CHECK_EQ(
        c.get<"third">().all,
        std::vector<seen>{{4, 3, 4'000'000, true}, {10, 6, 10'000'000, true}, {16, 9, 16'000'000, true}});
  }

  TEST_CASE("graphs") {
    test::check_picture<following>(picture);
    auto c = started<following>();
    c.run(cca::for_beats<5>{});
    CHECK_EQ(c.get<"log">().all.size(), 3);
    CHECK_EQ(c.get<"log">().all[0].value, 100 - 1);
  }

  TEST_CASE("merged") {
    test::check_picture<diary>(R"(
flowchart LR
  n0["speech<br/><i>25 Hz</i>"]
  n1["touch<br/><i>25 Hz</i>"]
  n2["log<br/><i>restless</i>"]
  n0 -- "y → x<br/>reading, 25 Hz<br/>merged 8" --> n2
  n1 -. "y → x<br/>reading, 25 Hz<br/>delayed 1<br/>merged 8" .-> n2
)");
    auto c = started<diary>();
    c.run(cca::for_beats<6>{});
    CHECK_EQ(c.get<"log">().all,
             std::vector<seen>{
                 {0, 1, 0, true}, {1, 1, 0, true}, {4, 2, 40'000'000, true}, {5, 2, 40'000'000, true}});
    CHECK_EQ(c.dropped<"log.x">(), 0);
  }

  TEST_CASE("controller") {
    // [controller]
    cca::controller<following> c;
    c.load();                 // created -> loaded: parameters
    c.start();                // loaded -> started
    c.step();                 // one beat
    c.run(cca::for_<0.5>{});  // half a second of virtual time, in a fast run
    c.run(cca::for_beats<4>{}, cca::at_wall_clock(), [](auto& running) {
      if (running.beat_index() == 52) running.template get<"camera">().frames = 0;  // between two beats
    });

    const cca::controller<following> snapshot = c;  // a controller is a value: a copy is a snapshot
    c.run(cca::for_<10>{});
    c = snapshot;  // back to beat 55
    // [controller end]
    CHECK_EQ(c.beat_index(), 55);
    CHECK_EQ(c.get<"camera">().frames, 2);
  }

  TEST_CASE("interruption") {
    const auto main = [] {
      // [interruption]
      const cca::interruption interrupted;  // notes signals from here on
      cca::controller<following> c;
      c.load();
      c.start();
      c.run(cca::for_<0.01>{}, cca::at_wall_clock(), interrupted);
      c.stop();
      return interrupted.exit_code();  // 130 after SIGINT, 143 after SIGTERM, 129 after SIGHUP, otherwise 0
      // [interruption end]
    };
    CHECK_EQ(main(), 0);
  }
}
