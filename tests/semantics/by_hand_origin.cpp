// Semantics, "Time of origin" and "Faults", sentence by sentence; and a controller as a value.
#include "by_hand.hpp"

using namespace by_hand;

namespace {

using ms1 = cca::rate<1000>;

struct sensor {
  auto sense(cca::beat now) -> cca::out<"y", value> { return static_cast<double>(now.index()); }
  void act(cca::optional_in<"u", value>) {}
};

struct ear {
  auto process(cca::in<"x", value> x, cca::observe<"s.**", cca::delayed<1>>) -> cca::out<"y", value> {
    return x[axis{}];
  }
};

std::vector<std::int64_t> origins(const seen_inputs& all) {
  std::vector<std::int64_t> found;
  for (const auto& s : all) found.push_back(s.origin);
  return found;
}
using times = std::vector<std::int64_t>;

}  // namespace

TEST_SUITE("semantics by hand: time of origin") {
  TEST_CASE("without wired inputs, or from sense: the beat's time") {
    struct lonely {
      auto process(cca::optional_in<"x", value>) -> cca::out<"y", value> { return 1.0; }
    };
    struct g : cca::graph<ms1, cca::node<"s", lonely, cca::timed<2>>, cca::node<"b", sensor, cca::timed<2>>,
                          cca::node<"r", look>, cca::node<"q", look>, cca::wire<"s.y", "r.x">,
                          cca::wire<"b.y", "q.x">> {};
    const auto c = after<g>(5);
    CHECK(origins(c.get<"r">().log) == times{0, 2 * ms, 4 * ms});
    CHECK(origins(c.get<"q">().log) == times{0, 2 * ms, 4 * ms});
  }

  TEST_CASE("any other: the oldest origin among the inputs as they were when it fired") {
    struct g : cca::graph<ms1, cca::node<"a", count, cca::timed<3, 1>>, cca::node<"b", count, cca::timed<2>>,
                          cca::node<"m", sum, cca::timed<1>>, cca::node<"r", look>,
                          cca::wire<"a.y", "m.x", cca::latest>, cca::wire<"b.y", "m.z", cca::latest>,
                          cca::wire<"m.y", "r.x">> {};
    // In beat 0 only b has come; initial values don't count.
    CHECK(origins(after<g>(7).get<"r">().log) == times{0, 0, ms, ms, 4 * ms, 4 * ms, 4 * ms});
  }

  TEST_CASE("where none counts, the beat's time") {
    struct g
        : cca::graph<ms1, cca::node<"a", count, cca::timed<9, 3>>, cca::node<"m", relay, cca::timed<1>>,
                     cca::node<"r", look>, cca::wire<"a.y", "m.x", cca::latest>, cca::wire<"m.y", "r.x">> {};
    CHECK(origins(after<g>(5).get<"r">().log) == times{0, ms, 2 * ms, 3 * ms, 3 * ms});
  }

  TEST_CASE("unless the component sets it") {
    struct set {
      auto process(cca::in<"x", value> x, cca::beat now)
          -> std::tuple<cca::out<"y", value>, cca::maybe<"z", value>> {
        return {cca::out<"y", value>(x[axis{}]).with_origin(now.time() - 5),
                cca::maybe<"z", value>(x[axis{}])};
      }
    };
    struct g
        : cca::graph<ms1, cca::node<"a", count, cca::timed<2>>, cca::node<"m", set, cca::timed<1>>,
                     cca::node<"r", look, cca::timed<1>>, cca::node<"q", look>,
                     cca::wire<"a.y", "m.x", cca::latest>, cca::wire<"m.y", "r.x">, cca::wire<"m.z", "q.x">> {
    };
    const auto c = after<g>(4);
    CHECK(origins(c.get<"r">().log) == times{-5, ms - 5, 2 * ms - 5, 3 * ms - 5});
    CHECK(origins(c.get<"q">().log) == times{0, 0, 2 * ms, 2 * ms});
  }

  TEST_CASE("a delayed input counts, but one whose wire closes a loop does not") {
    struct chain
        : cca::graph<ms1, cca::node<"a", count>, cca::node<"m", relay, cca::timed<1>>, cca::node<"r", look>,
                     cca::wire<"a.y", "m.x", cca::delayed<2>>, cca::wire<"m.y", "r.x">> {};
    CHECK(origins(after<chain>(5).get<"r">().log) == times{0, ms, 0, ms, 2 * ms});
    struct self : cca::graph<ms1, cca::node<"a", count, cca::timed<3>>, cca::node<"m", sum, cca::timed<1>>,
                             cca::node<"r", look>, cca::wire<"a.y", "m.x", cca::latest>,
                             cca::wire<"m.y", "m.z", cca::delayed<1>>, cca::wire<"m.y", "r.x">> {};
    CHECK(origins(after<self>(5).get<"r">().log) == times{0, 0, 0, 3 * ms, 3 * ms});
    // Over other components, and over more than one delayed wire.
    struct wide : cca::graph<ms1, cca::node<"a", count, cca::timed<3>>, cca::node<"m", sum, cca::timed<1>>,
                             cca::node<"n", relay, cca::timed<1>>, cca::node<"r", look>,
                             cca::wire<"a.y", "m.x", cca::latest>, cca::wire<"m.y", "n.x", cca::delayed<1>>,
                             cca::wire<"n.y", "m.z", cca::delayed<1>>, cca::wire<"m.y", "r.x">> {};
    CHECK(origins(after<wide>(5).get<"r">().log) == times{0, 0, 0, 3 * ms, 3 * ms});
  }

  TEST_CASE("what is listened to with a delay counts, but not where it is fed by who listens") {
    struct fed : cca::graph<cca::node<"m", relay, cca::timed<1>>, cca::expose<"m.x", "x">> {};
    struct looped
        : cca::graph<ms1, cca::node<"a", count, cca::timed<3>>, cca::node<"s", fed>,
                     cca::node<"o", ear, cca::timed<1>>, cca::node<"r", look>,
                     cca::wire<"a.y", "o.x", cca::latest>, cca::wire<"o.y", "s.x">, cca::wire<"o.y", "r.x">> {
    };
    CHECK(origins(after<looped>(5).get<"r">().log) == times{0, 0, 0, 3 * ms, 3 * ms});
    struct open : cca::graph<ms1, cca::node<"a", count, cca::timed<3>>, cca::node<"s", fed>,
                             cca::node<"o", ear, cca::timed<1>>, cca::node<"r", look>,
                             cca::wire<"a.y", "o.x", cca::latest>, cca::wire<"a.y", "s.x", cca::latest>,
                             cca::wire<"o.y", "r.x">> {};
    CHECK(origins(after<open>(5).get<"r">().log) == times{0, 0, 0, 0, 3 * ms});
  }

  TEST_CASE("a loop through a resource node is a loop: what it acts on and what it senses are one node") {
    struct g : cca::graph<ms1, cca::node<"b", sensor>, cca::node<"m", relay, cca::timed<1>>,
                          cca::node<"r", look>, cca::wire<"b.y", "m.x", cca::delayed<1>>,
                          cca::wire<"m.y", "b.u">, cca::wire<"m.y", "r.x">> {};
    CHECK(origins(after<g>(3).get<"r">().log) == times{0, ms, 2 * ms});
    struct open
        : cca::graph<ms1, cca::node<"b", sensor>, cca::node<"m", relay, cca::timed<1>>, cca::node<"r", look>,
                     cca::wire<"b.y", "m.x", cca::delayed<1>>, cca::wire<"m.y", "r.x">> {};
    CHECK(origins(after<open>(3).get<"r">().log) == times{0, 0, ms});
  }

  TEST_CASE("a queue's input counts as what it took") {
    struct g
        : cca::graph<ms1, cca::node<"a", count>, cca::node<"m", relay, cca::timed<2>>, cca::node<"r", look>,
                     cca::wire<"a.y", "m.x", cca::queue<8, cca::drop_oldest>>, cca::wire<"m.y", "r.x">> {};
    CHECK(origins(after<g>(7).get<"r">().log) == times{0, ms, 2 * ms, 3 * ms});
  }
}

TEST_SUITE("semantics by hand: faults") {
  struct robot {
    std::string* to = nullptr;
    auto sense() -> cca::out<"y", value> {
      *to += 's';
      return 0.0;
    }
    void act() { *to += 'a'; }
    void on_fault() { *to += 'F'; }
  };
  struct failing {
    std::string* to = nullptr;
    auto process(cca::beat now) -> std::tuple<cca::out<"y", value>, cca::fault> {
      *to += 'f';
      return {1.0, now.index() == 1 ? cca::fault{"the motor is hot"} : cca::fault{}};
    }
  };
  struct later {
    std::string* to = nullptr;
    void process(cca::in<"x", value>) { *to += 'l'; }
    void on_fault() { *to += '?'; }
  };
  struct g
      : cca::graph<ms1, cca::node<"robot", robot>, cca::node<"failing", failing>, cca::node<"later", later>,
                   cca::node<"other", robot>, cca::wire<"failing.y", "later.x">> {};

  TEST_CASE(
      "the controller runs every resource node's on_fault in the same beat, is faulted, and stays so until "
      "it is told to go on") {
    cca::controller<g> c;
    std::string order;
    c.get<"robot">().to = c.get<"other">().to = c.get<"failing">().to = c.get<"later">().to = &order;
    c.load();
    c.start();
    c.step();
    CHECK(order == "ssflaa");
    CHECK(c.state() == cca::state::started);
    order.clear();
    c.step();
    CHECK(order == "ssfFF");  // no later component, no act
    CHECK(c.state() == cca::state::faulted);
    CHECK(std::string(c.fault().reason()) == "the motor is hot");
    order.clear();
    CHECK(!c.step());
    CHECK(!c.step());
    CHECK(order.empty());
    CHECK(c.state() == cca::state::faulted);
    c.resume();
    CHECK(c.step());
    CHECK(order == "ssflaa");
  }

  TEST_CASE("an empty fault is none") {
    struct calm {
      int firings = 0;
      auto process() -> cca::fault {
        ++firings;
        return {};
      }
    };
    struct quiet : cca::graph<ms1, cca::node<"c", calm>> {};
    CHECK(after<quiet>(3).get<"c">().firings == 3);
  }
}

TEST_SUITE("semantics by hand: a controller is a value") {
  TEST_CASE("a copy is a snapshot: both go on alike, and neither touches the other") {
    struct g
        : cca::graph<ms1, cca::node<"s", count>, cca::node<"m", sum, cca::timed<1>>, cca::node<"r", look>,
                     cca::wire<"s.y", "m.x", cca::delayed<2>>, cca::wire<"m.y", "m.z", cca::delayed<1>>,
                     cca::wire<"m.y", "r.x", cca::queue<4, cca::drop_oldest>>> {};
    auto c = after<g>(10);
    auto copy = c;
    for (int k = 0; k < 10; ++k) c.step();
    CHECK(copy.get<"r">().log.size() == 10);
    CHECK(copy.beat_index() == 10);
    for (int k = 0; k < 10; ++k) copy.step();
    CHECK(copy.get<"r">().log == c.get<"r">().log);
    CHECK(copy.get<"r">().log.size() == 20);
  }
}
