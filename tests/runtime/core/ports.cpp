// Ports: initial values, optional inputs, outputs that publish only sometimes, origins, resource nodes.
#include <doctest/doctest.h>

#include <utility>
#include <vector>

#include <cca/space/record.hpp>

#include "counting.hpp"

using namespace core_test;

namespace {

struct mix {
  auto process(cca::in<"x", reading> x, cca::optional_in<"gain", reading> gain) -> cca::out<"y", reading> {
    wired = static_cast<bool>(gain);
    gain_seen = {0, gain[cca::x{}], gain.origin(), gain.fresh()};
    return gain ? gain[cca::x{}] * x[cca::x{}] : x[cca::x{}];
  }
  bool wired = false;
  seen gain_seen{};
};
struct optional : cca::graph<cca::rate<1000>,
                             cca::node<"counter", counter>,
                             cca::node<"with", mix>,
                             cca::node<"without", mix>,
                             cca::node<"moderate", mix, cca::moderate>,
                             cca::wire<"counter.y", "with.x">,
                             cca::wire<"counter.y", "with.gain">,
                             cca::wire<"counter.y", "without.x">,
                             cca::wire<"counter.y", "moderate.x">> {};

struct tuned {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0, 10>, gain),
                             (cca::quantity<cca::angle, -1, 1>, offset));
  };
  parameters p{3.5, 0.5};
  auto process() const -> cca::out<"y", reading> { return p.gain; }
  auto both() const -> std::tuple<cca::out<"y", reading>, cca::maybe<"z", reading>> {
    return {p.gain, p.offset};
  }
};

struct odd {
  auto process(cca::beat now) -> std::tuple<cca::maybe<"odd", reading>, cca::out<"all", reading>> {
    std::tuple<cca::maybe<"odd", reading>, cca::out<"all", reading>> y;
    if (now.index() % 2 == 1) std::get<0>(y)[cca::x{}] = static_cast<double>(now.index());
    std::get<1>(y)[cca::x{}] = static_cast<double>(now.index());
    return y;
  }
};
struct sometimes : cca::graph<cca::rate<1000>,
                              cca::node<"odd", odd>,
                              cca::node<"restless", journal>,
                              cca::node<"each", journal, cca::full_speed>,
                              cca::node<"late", journal, cca::full_speed>,
                              cca::node<"never", journal, cca::full_speed>,
                              cca::node<"silent", counter, cca::inactive>,
                              cca::wire<"odd.odd", "restless.x">,
                              cca::wire<"odd.odd", "each.x", cca::latest>,
                              cca::wire<"odd.all", "late.x", cca::delayed<2>, cca::initial<7>>,
                              cca::wire<"silent.y", "never.x", cca::latest, cca::initial<-2.5>>> {};

// So many numbers that an input shows them where their writer stored them; of some it does so within a beat.
template <int Count>
struct numbers_of_picture : cca::record<Count> {};
template <int Count>
struct picture : cca::space<numbers_of_picture<Count>, cca::axes<cca::x>> {};
template <int Count>
struct camera {
  auto process(cca::beat now) -> cca::out<"y", picture<Count>> {
    cca::out<"y", picture<Count>> y;
    y.vector().setConstant(static_cast<double>(now.index()));
    return y;
  }
};
template <int Count>
struct album {
  using image = cca::in<"x", picture<Count>>;
  void process(image x, cca::in<"before", picture<Count>> before) {
    shown.emplace_back(x.vector()[Count - 1], before.vector()[Count - 1]);
    kept.push_back(x);
    const image copied = x;
    const cca::sample<picture<Count>> owned = copied;
    first = owned.vector()[Count - 1];
    x = image(picture<Count>::vector_type::Constant(-3), 0, false);
    assigned = x.vector()[Count - 1];
  }
  std::vector<std::pair<double, double>> shown;
  std::vector<cca::sample<picture<Count>>> kept;
  double first = -1, assigned = -1;
};
template <int Count>
struct pictures : cca::graph<cca::rate<1000>,
                             cca::node<"camera", camera<Count>>,
                             cca::node<"earlier", camera<Count>>,
                             cca::node<"album", album<Count>>,
                             cca::wire<"camera.y", "album.x">,
                             cca::wire<"earlier.y", "album.before", cca::delayed<1>, cca::initial<7>>> {};

struct older {  // sets the origin of its samples itself
  auto process(cca::beat now) -> cca::out<"y", reading> {
    cca::out<"y", reading> y = 1.0;
    y.with_origin(now.time() - 5);
    return y;
  }
};
struct origins : cca::graph<cca::rate<1000>,
                            cca::node<"older", older>,
                            cca::node<"slow", counter, cca::timed<4>>,
                            cca::node<"both", mix, cca::full_speed>,
                            cca::node<"log", journal>,
                            cca::wire<"older.y", "both.x">,
                            cca::wire<"slow.y", "both.gain", cca::latest>,
                            cca::wire<"both.y", "log.x">> {};

// A robot that is a graph: only the bus talks to the device; the joint has its ports.
struct bus {
  auto sense() -> cca::out<"raw", reading> { return device; }
  void act(cca::in<"raw", reading> to) { device = to[cca::x{}]; }
  double device = 3;
};
struct joint {
  auto sense(cca::in<"raw", reading> raw) -> cca::out<"angle", reading> { return 2 * raw[cca::x{}]; }
  auto act(cca::in<"command", reading> to) -> cca::out<"raw", reading> { return to[cca::x{}] / 2; }
};
struct robot : cca::graph<cca::node<"joint", joint>,
                          cca::node<"bus", bus>,
                          cca::wire<"bus.raw", "joint.raw">,
                          cca::wire<"joint.raw", "bus.raw">,
                          cca::expose<"joint.angle", "angle">,
                          cca::expose<"joint.command", "command">> {};
struct moving : cca::graph<cca::rate<1000>,
                           cca::node<"more", mix>,
                           cca::node<"robot", robot>,
                           cca::node<"log", journal>,
                           cca::wire<"robot.angle", "more.x">,
                           cca::wire<"robot.angle", "more.gain">,
                           cca::wire<"more.y", "robot.command">,
                           cca::wire<"robot.angle", "log.x">> {};

struct world : cca::frame<"world"> {};
struct attitude : cca::space<cca::orientation<world>, cca::axes<cca::x, cca::y, cca::z>> {};
struct turning {
  auto process() -> cca::maybe<"q", attitude> { return {}; }
};
struct facing {
  void process(cca::in<"latest", attitude> a,
               cca::in<"late", attitude> b,
               cca::in<"queued", attitude> c,
               cca::optional_in<"unwired", attitude> d) {
    all = {a.vector(), b.vector(), c.vector(), d.vector()};
  }
  std::vector<Eigen::Vector4d> all;
};
struct unturned : cca::graph<cca::rate<1000>,
                             cca::node<"turning", turning>,
                             cca::node<"facing", facing, cca::full_speed>,
                             cca::wire<"turning.q", "facing.latest">,
                             cca::wire<"turning.q", "facing.late", cca::delayed<3>>,
                             cca::wire<"turning.q", "facing.queued", cca::queue<2, cca::drop_oldest>>> {};

// Delays longer than a beat, after writers whose clock is known.
struct ring_reader {
  void process(cca::in<"x", reading> x, cca::in<"slow", reading> slow, cca::beat now) {
    fast.push_back({now.index(), x[cca::x{}], x.origin(), x.fresh()});
    rare.push_back({now.index(), slow[cca::x{}], slow.origin(), slow.fresh()});
  }
  std::vector<seen> fast, rare;
};
struct flawless {  // may fault: then the samples keep the beats in which they were published
  auto process() -> cca::fault { return {}; }
};
template <class... More>
struct rings : cca::graph<cca::rate<1000>,
                          cca::node<"counter", counter>,
                          cca::node<"slow", counter, cca::timed<4>>,
                          cca::node<"reader", ring_reader, cca::full_speed>,
                          cca::node<"often", ring_reader, cca::timed<3>>,
                          cca::wire<"counter.y", "reader.x", cca::delayed<3>, cca::initial<7>>,
                          cca::wire<"slow.y", "reader.slow", cca::delayed<6>>,
                          cca::wire<"counter.y", "often.x", cca::delayed<2>>,
                          cca::wire<"slow.y", "often.slow", cca::delayed<5>>,
                          More...> {};

// Fills what it wants; the stack holds other numbers before.
struct eight : cca::space<cca::record<8>, cca::axes<cca::x>> {};
struct full_of_ones {
  auto process() -> cca::out<"y", eight> {
    cca::out<"y", eight> y;
    for (int i = 0; i < 8; ++i) y.vector()[i] = ++last;
    return y;
  }
  double last = 1;
};
struct forgetful {
  auto process(cca::in<"x", eight> x) -> cca::out<"y", eight> {
    cca::out<"y", eight> y;
    for (int i = first; i < end; ++i) y.vector()[i] = x.vector()[i];
    return y;
  }
  int first = 0, end = 8;
};
struct last_of_all {
  void process(cca::in<"x", eight> x) { seen = x.vector(); }
  eight::vector_type seen;
};
struct forgotten : cca::graph<cca::rate<1000>,
                              cca::node<"ones", full_of_ones>,
                              cca::node<"forgetful", forgetful>,
                              cca::node<"last", last_of_all>,
                              cca::wire<"ones.y", "forgetful.x">,
                              cca::wire<"forgetful.y", "last.x">> {};

}  // namespace

TEST_SUITE("ports") {
  TEST_CASE("the initial value is the space's zero") {
    auto c = started<unturned>();
    c.step();
    const cca::sample<attitude> zero;
    CHECK_EQ(zero.vector().norm(), 1);  // the identity
    REQUIRE_EQ(c.get<"facing">().all.size(), 4);
    for (const auto& q : c.get<"facing">().all) CHECK_EQ(q, zero.vector());
  }

  TEST_CASE("a parameter with a range or a unit is published as it is") {
    tuned t;
    CHECK(t.process().vector()[0] == 3.5);
    t.p.gain = 4.5;
    t.p.offset = 0.25;
    CHECK(t.process().vector()[0] == 4.5);
    const auto [y, z] = t.both();
    CHECK(y.vector()[0] == 4.5);
    CHECK(z.vector()[0] == 0.25);
    CHECK(static_cast<bool>(z));
  }

  TEST_CASE("an optional input") {
    auto c = started<optional>();
    c.run(cca::for_beats<3>{});
    CHECK(c.get<"with">().wired);
    CHECK_EQ(c.get<"with">().gain_seen, seen{0, 3, 2'000'000, true});
    CHECK_FALSE(c.get<"without">().wired);
    CHECK_EQ(c.get<"without">().gain_seen, seen{0, 0, cca::never, false});
    CHECK_FALSE(c.get<"moderate">().wired);  // but it fired
    CHECK_EQ(c.get<"moderate">().gain_seen.origin, cca::never);
  }

  TEST_CASE("a maybe output, and initial values") {
    auto c = started<sometimes>();
    c.run(cca::for_beats<4>{});
    constexpr std::int64_t ms = 1'000'000;
    CHECK_EQ(c.get<"restless">().all, std::vector<seen>{{1, 1, ms, true}, {3, 3, 3 * ms, true}});
    CHECK_EQ(c.get<"each">().all,
             std::vector<seen>{
                 {0, 0, cca::never, false}, {1, 1, ms, true}, {2, 1, ms, false}, {3, 3, 3 * ms, true}});
    CHECK_EQ(c.get<"late">().all,
             std::vector<seen>{
                 {0, 7, cca::never, false}, {1, 7, cca::never, false}, {2, 0, 0, true}, {3, 1, ms, true}});
    CHECK_EQ(c.get<"never">().all.back(), seen{3, -2.5, cca::never, false});
  }

  TEST_CASE_TEMPLATE("a sample of many numbers can be kept: a copy is its own", graph, pictures<100>,
                     pictures<8>) {
    auto c = started<graph>();
    c.run(cca::for_beats<3>{});
    const auto& album = c.template get<"album">();
    CHECK_EQ(album.shown, std::vector<std::pair<double, double>>{{0, 7}, {1, 0}, {2, 1}});
    for (std::size_t k = 0; k < 3; ++k) CHECK_EQ(album.kept[k].vector().tail(1)[0], static_cast<double>(k));
    CHECK_EQ(album.first, 2);
    CHECK_EQ(album.assigned, -3);
    const auto snapshot = c;
    c.run(cca::for_beats<2>{});
    CHECK_EQ(snapshot.template get<"album">().kept[2].vector().tail(1)[0], 2);
  }

  TEST_CASE("a ring without beats tells what one with beats tells") {
    using with_beats = rings<cca::node<"flawless", flawless>>;
    auto c = started<rings<>>();
    auto other = started<with_beats>();
    CHECK_LT(sizeof(c), sizeof(other));
    c.run(cca::for_beats<20>{});
    other.run(cca::for_beats<20>{});
    CHECK_EQ(c.get<"reader">().fast, other.get<"reader">().fast);
    CHECK_EQ(c.get<"reader">().rare, other.get<"reader">().rare);
    CHECK_EQ(c.get<"often">().fast, other.get<"often">().fast);
    CHECK_EQ(c.get<"often">().rare, other.get<"often">().rare);
    constexpr std::int64_t ms = 1'000'000;
    const auto& rare = c.get<"reader">().rare;
    CHECK_EQ(c.get<"reader">().fast[2], seen{2, 7, cca::never, false});
    CHECK_EQ(c.get<"reader">().fast[3], seen{3, 1, 0, true});
    CHECK_EQ(rare[5], seen{5, 0, cca::never, false});
    CHECK_EQ(rare[6], seen{6, 1, 0, true});
    CHECK_EQ(rare[9], seen{9, 1, 0, false});
    CHECK_EQ(rare[10], seen{10, 2, 4 * ms, true});
    CHECK_EQ(c.get<"often">().rare[3], seen{9, 2, 4 * ms, true});
  }

  TEST_CASE("what a component does not fill is zero") {
    auto c = started<forgotten>();
    for (const auto& [first, end] : {std::pair{0, 8}, {3, 5}, {0, 0}, {7, 8}}) {
      c.get<"forgetful">().first = first;
      c.get<"forgetful">().end = end;
      c.step();
      const auto& seen_now = c.get<"last">().seen;
      for (int i = 0; i < 8; ++i) CHECK_EQ(seen_now[i] != 0, i >= first && i < end);
    }
  }

  TEST_CASE("a sample takes the oldest origin of the inputs") {
    auto c = started<origins>();
    c.run(cca::for_beats<6>{});
    std::vector<std::int64_t> all;
    for (const auto& one : c.get<"log">().all) all.push_back(one.origin);
    CHECK_EQ(all, std::vector<std::int64_t>{-5, 0, 0, 0, 4'000'000 - 5, 4'000'000});
  }

  TEST_CASE("a robot that is a graph of resource nodes") {
    auto c = started<moving>();
    c.step();
    CHECK_EQ(c.get<"log">().all.back(), seen{0, 6, 0, true});
    CHECK_EQ(c.get<"robot.bus">().device, 18);  // in the same beat: 6 * 6 / 2
    c.step();
    CHECK_EQ(c.get<"log">().all.back(), seen{1, 36, 1'000'000, true});
    CHECK_EQ(c.get<"robot.bus">().device, 648);
  }
}
