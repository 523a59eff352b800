// Observing a scope, and what a signature may look like: the order of ports, several outputs, nesting.
#include <algorithm>
#include <string>

#include <Eigen/Geometry>

#include "by_hand.hpp"

using namespace by_hand;

namespace {

using ms1 = cca::rate<1000>;

struct heard {
  std::string path;
  double value;
  std::int64_t origin;
  bool fresh;
  friend bool operator==(const heard&, const heard&) = default;
};

template <class Scope>
struct listener {
  std::vector<std::vector<heard>> log;
  auto process(Scope scope, cca::beat) -> cca::out<"y", value> {
    auto& now = log.emplace_back();
    double sum = 0;
    for (const auto& one : scope) {
      now.push_back({std::string(one.path), one.values[0], one.origin, one.fresh});
      sum += one.values[0];
    }
    std::sort(now.begin(), now.end(), [](const heard& a, const heard& b) { return a.path < b.path; });
    return sum;
  }
};

struct inner : cca::graph<cca::node<"a", count, cca::timed<2>>, cca::node<"b", count, cca::timed<3, 1>>> {};

template <class Scope, class Strategy>
struct listens : cca::graph<ms1,
                            cca::node<"in", inner>,
                            cca::node<"o", listener<Scope>, Strategy>,
                            cca::node<"r", look>,
                            cca::node<"w", look, cca::timed<1>>,
                            cca::wire<"o.y", "r.x">,
                            cca::wire<"o.y", "w.x", cca::latest>> {};

}  // namespace

TEST_SUITE("semantics by hand: listening to a scope") {
  TEST_CASE("every output under the scope, by its path, as a wire without a policy would show it") {
    const auto c = after<listens<cca::observe<"in.**">, cca::timed<1>>>(3);
    const std::vector<std::vector<heard>> expected{{{"in.a.y", 0, 0, true}, {"in.b.y", 0, never, false}},
                                                   {{"in.a.y", 0, 0, false}, {"in.b.y", 1, ms, true}},
                                                   {{"in.a.y", 2, 2 * ms, true}, {"in.b.y", 1, ms, false}}};
    CHECK(c.get<"o">().log == expected);
  }

  TEST_CASE("a delay is that of a wire") {
    const auto c = after<listens<cca::observe<"in.**", cca::delayed<1>>, cca::timed<1>>>(3);
    const std::vector<std::vector<heard>> expected{{{"in.a.y", 0, never, false}, {"in.b.y", 0, never, false}},
                                                   {{"in.a.y", 0, 0, true}, {"in.b.y", 0, never, false}},
                                                   {{"in.a.y", 0, 0, false}, {"in.b.y", 1, ms, true}}};
    CHECK(c.get<"o">().log == expected);
  }

  TEST_CASE("an initial value belongs to a wire: whoever listens sees the zero until a sample has come") {
    struct g : cca::graph<ms1, cca::node<"s", count, cca::timed<9, 2>>, cca::node<"r", look, cca::timed<1>>,
                          cca::node<"o", listener<cca::observe<"s.*">>, cca::timed<1>>,
                          cca::wire<"s.y", "r.x", cca::latest, cca::initial<0.625>>> {};
    const auto c = after<g>(3);
    CHECK(c.get<"r">().log ==
          seen_inputs{{0, 0.625, never, false}, {1, 0.625, never, false}, {2, 2, 2 * ms, true}});
    CHECK(c.get<"o">().log == std::vector<std::vector<heard>>{{{"s.y", 0, never, false}},
                                                              {{"s.y", 0, never, false}},
                                                              {{"s.y", 2, 2 * ms, true}}});
  }

  TEST_CASE("it is an input: fresh if anything under the scope is, and it counts for the origin") {
    const seen_inputs expected{{0, 0, 0, true}, {1, 1, 0, true}, {2, 3, ms, true}, {4, 8, 4 * ms, true}};
    CHECK(after<listens<cca::observe<"in.**">, cca::restless>>(6).get<"r">().log == expected);
    CHECK(after<listens<cca::observe<"in.**">, cca::moderate>>(6).get<"r">().log == expected);
  }
}

TEST_SUITE("semantics by hand: interfaces") {
  TEST_CASE("ports and the beat in any order - several outputs, read by name") {
    struct crossed {
      auto process(cca::in<"z", value> z, cca::beat now, const cca::in<"x", value>& x)
          -> std::tuple<cca::maybe<"b", value>, cca::out<"a", value>> {
        return {now.index() % 2 == 0 ? cca::maybe<"b", value>(z[axis{}]) : cca::maybe<"b", value>(),
                cca::out<"a", value>(x[axis{}])};
      }
    };
    struct ten {
      auto process(cca::beat now) -> cca::out<"y", value> { return 10.0 + static_cast<double>(now.index()); }
    };
    struct g : cca::graph<ms1, cca::wire<"m.b", "rb.x">, cca::wire<"m.a", "ra.x">, cca::node<"m", crossed>,
                          cca::node<"rb", look>, cca::node<"ra", look>, cca::node<"s", count>,
                          cca::node<"t", ten>, cca::wire<"s.y", "m.x">, cca::wire<"t.y", "m.z">> {};
    const auto c = after<g>(3);
    CHECK(c.get<"ra">().log == seen_inputs{{0, 0, 0, true}, {1, 1, ms, true}, {2, 2, 2 * ms, true}});
    CHECK(c.get<"rb">().log == seen_inputs{{0, 10, 0, true}, {2, 12, 2 * ms, true}});
  }

  TEST_CASE("an output filled by axis - a maybe that is filled is published") {
    struct hip : cca::dimension<"hip"> {};
    struct knee : cca::dimension<"knee"> {};
    struct leg : cca::space<cca::number, cca::axes<hip, knee>> {};
    struct filler {
      auto process(cca::beat now) -> std::tuple<cca::out<"y", leg>, cca::maybe<"m", leg>> {
        cca::out<"y", leg> y;
        y[knee{}] = static_cast<double>(now.index());
        cca::maybe<"m", leg> m;
        if (now.index() == 1) m[hip{}] = 7;
        return {y, m};
      }
    };
    struct reader {
      std::vector<std::array<double, 4>> log;
      void process(cca::in<"y", leg> y, cca::in<"m", leg> m) {
        log.push_back({y[hip{}], y[knee{}], m[hip{}], m.vector()[1]});
      }
    };
    struct g
        : cca::graph<ms1, cca::node<"f", filler>, cca::node<"r", reader, cca::timed<1>>,
                     cca::wire<"f.y", "r.y">, cca::wire<"f.m", "r.m", cca::latest, cca::initial<1.0, 2.0>>> {
    };
    CHECK(after<g>(3).get<"r">().log ==
          std::vector<std::array<double, 4>>{{0, 0, 1, 2}, {0, 1, 7, 0}, {0, 2, 7, 0}});
  }

  TEST_CASE("the zero of an orientation is no rotation") {
    struct base {};
    struct turned : cca::space<cca::orientation<base>, cca::axes<cca::x, cca::y, cca::z>> {};
    struct source {
      auto process() -> cca::maybe<"y", turned> { return {}; }
    };
    struct reader {
      Eigen::Vector4d q;
      void process(cca::in<"x", turned> x) { q = x.vector(); }
    };
    struct g : cca::graph<ms1, cca::node<"s", source>, cca::node<"r", reader, cca::timed<1>>,
                          cca::wire<"s.y", "r.x">> {};
    CHECK(after<g>(1).get<"r">().q == Eigen::Quaterniond::Identity().coeffs());
  }

  TEST_CASE("one graph type as two nodes: two states, two sets of paths") {
    struct doubler : cca::graph<cca::node<"m", relay>, cca::node<"n", sum, cca::timed<1>>,
                                cca::wire<"m.y", "n.x">, cca::wire<"n.y", "n.z", cca::delayed<1>>,
                                cca::expose<"m.x", "in">, cca::expose<"n.y", "out">> {};
    struct deep
        : cca::graph<cca::node<"d", doubler>, cca::expose<"d.in", "into">, cca::expose<"d.out", "from">> {};
    struct g : cca::graph<ms1, cca::node<"s", count>, cca::node<"a", deep>, cca::node<"b", deep>,
                          cca::node<"ra", look>, cca::node<"rb", look>, cca::wire<"s.y", "a.into">,
                          cca::wire<"a.from", "b.into">, cca::wire<"a.from", "ra.x">,
                          cca::wire<"b.from", "rb.x">> {};
    const auto c = after<g>(4);
    CHECK(c.get<"ra">().log ==
          seen_inputs{{0, 0, 0, true}, {1, 1, ms, true}, {2, 3, 2 * ms, true}, {3, 6, 3 * ms, true}});
    CHECK(c.get<"rb">().log ==
          seen_inputs{{0, 0, 0, true}, {1, 1, ms, true}, {2, 4, 2 * ms, true}, {3, 10, 3 * ms, true}});
  }
}
