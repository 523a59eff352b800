// Two processes compare all facts of their deployments: pairs that differ in exactly one fact, as two
// versions of one source do.
#include <doctest/doctest.h>

#include <string>

#include <cca/deployment.hpp>

namespace {

// Two versions of one source: `facts` in each of the namespaces below changes one of these.
struct common {
  struct pressure {
    double lower, upper;
    static constexpr std::string_view unit = "Pa";
    [[maybe_unused]] static constexpr auto on_nan = cca::nan_policy::hold;
  };
  struct tank : cca::dimension<"tank"> {
    static constexpr cca::limits limits{cca::value{-1, 1.1234567891}};
  };
  struct level : cca::space<cca::number, cca::axes<tank>> {};
  template <class Pressure>
  struct pressures_of : cca::detail::linear_domain {
    using quantity = Pressure;
    template <class Self>
    struct methods : cca::detail::additive<Self> {};
  };
  struct load : cca::space<pressures_of<pressure>, cca::axes<cca::x, cca::y>> {};
  using strategy = cca::timed<5>;
  using initial = cca::initial<0.5>;
  using inner_policy = cca::latest;
  using full = cca::drop_oldest;
  using watched = cca::observe<"source.y">;
  using tolerance = cca::tolerate<3>;
  static constexpr int hz = 1000, delay = 3, capacity = 4, heard_delay = 2;
  static constexpr cca::fixed_string heard{"source.y"};
  static constexpr cca::fixed_string environment{"robot"};
};

template <class F>
struct source {
  auto process(cca::beat) -> std::tuple<cca::out<"y", typename F::level>, cca::out<"p", typename F::load>> {
    return {0.0, Eigen::Vector2d(0, 0)};
  }
};
template <class F>
struct filter {
  auto process(cca::in<"x", typename F::level> x) -> cca::out<"y", typename F::level> { return x; }
};
template <class F>
struct ear {
  void process(cca::in<"x", typename F::level>,
               cca::in<"p", typename F::load>,
               cca::observe<F::heard, cca::delayed<F::heard_delay>>) {}
};
template <class F>
struct heap {
  void process(cca::in<"x", typename F::level>) {}
};

template <class F>
struct graph_of : cca::graph<cca::rate<F::hz>,
                             cca::node<"source", source<F>>,
                             cca::node<"filter", filter<F>>,
                             cca::node<"ear", ear<F>, typename F::strategy>,
                             cca::node<"heap", heap<F>, cca::timed<1>>,
                             cca::wire<"source.y", "filter.x", typename F::inner_policy>,
                             cca::wire<"filter.y", "ear.x", cca::delayed<F::delay>, typename F::initial>,
                             cca::wire<"source.p", "ear.p", cca::delayed<1>>,
                             cca::wire<"filter.y", "heap.x", cca::queue<F::capacity, typename F::full>>,
                             typename F::watched> {};
template <class F>
struct of : cca::deployment<graph_of<F>,
                            cca::environment<F::environment, cca::nodes<"source", "filter", "heap">>,
                            cca::environment<"mind", cca::other_nodes>,
                            typename F::tolerance> {};

namespace same {
struct facts : common {};
}  // namespace same
namespace same_again {
struct facts : common {};
}  // namespace same_again

std::string difference(const std::string& one, const std::string& other) {
  return cca::detail::first_difference(one, other);
}
// In a component's name `facts` stands without the namespace, which two versions have in common.
template <class Facts>
std::string manifest() {
  std::string text = cca::detail::manifest_of<of<Facts>>();
  for (std::size_t end = 0; (end = text.find("::facts>", end)) != text.npos;) {
    const std::size_t begin = text.rfind('<', end) + 1;
    text.erase(begin, end + 2 - begin);
    end = begin;
  }
  return text;
}
template <class Facts>
std::string difference_of() {
  return difference(manifest<same::facts>(), manifest<Facts>());
}

namespace limit {
struct facts : common {
  struct tank : cca::dimension<"tank"> {
    static constexpr cca::limits limits{cca::value{-1, 1.1234567892}};
  };
  struct level : cca::space<cca::number, cca::axes<tank>> {};
};
}  // namespace limit
namespace last_bit {
struct facts : common {
  struct tank : cca::dimension<"tank"> {
    static constexpr cca::limits limits{cca::value{-1.0000000000000002, 1.1234567891}};
  };
  struct level : cca::space<cca::number, cca::axes<tank>> {};
};
}  // namespace last_bit
namespace unit {
struct facts : common {
  struct pressure : common::pressure {
    static constexpr std::string_view unit = "kPa";
  };
  struct load : cca::space<pressures_of<pressure>, cca::axes<cca::x, cca::y>> {};
};
}  // namespace unit
namespace axes {
struct facts : common {
  struct load : cca::space<pressures_of<pressure>, cca::axes<cca::y, cca::x>> {};
};
}  // namespace axes
namespace rate_of_space {
struct facts : common {
  struct level : cca::space<cca::number, cca::axes<tank>, cca::rate<1000>> {};
};
}  // namespace rate_of_space
namespace rate_of_graph {
struct facts : common {
  static constexpr int hz = 500;
};
}  // namespace rate_of_graph
namespace strategy {
struct facts : common {
  using strategy = cca::timed<5, 1>;
};
}  // namespace strategy
namespace initial {
struct facts : common {
  using initial = cca::initial<0.50000000001>;
};
}  // namespace initial
namespace delay {
struct facts : common {
  static constexpr int delay = 4;
};
}  // namespace delay
namespace policy {
struct facts : common {
  using inner_policy = cca::delayed<1>;
};
}  // namespace policy
namespace capacity {
struct facts : common {
  static constexpr int capacity = 5;
};
}  // namespace capacity
namespace full {
struct facts : common {
  using full = cca::drop_newest;
};
}  // namespace full
namespace heard {
struct facts : common {
  static constexpr cca::fixed_string heard{"source.*"};
};
}  // namespace heard
namespace heard_delay {
struct facts : common {
  static constexpr int heard_delay = 1;
};
}  // namespace heard_delay
namespace watched {
struct facts : common {
  using watched = cca::observe<"filter.y">;
};
}  // namespace watched
namespace environment {
struct facts : common {
  static constexpr cca::fixed_string environment{"robots"};
};
}  // namespace environment
namespace tolerance {
struct facts : common {
  using tolerance = cca::tolerate<4>;
};
}  // namespace tolerance

bool has(const std::string& text, const std::string& here, const std::string& there) {
  const auto at = text.find("`, there `");
  return at != std::string::npos && text.substr(0, at).find(here) != std::string::npos &&
         text.substr(at).find(there) != std::string::npos;
}

}  // namespace

TEST_SUITE("the manifest of a deployment") {
  TEST_CASE("equal deployments have equal ones") {
    static_assert(cca::well_formed<of<same::facts>>);
    CHECK_EQ(difference_of<same_again::facts>(), "");
  }
  TEST_CASE("one fact of a space") {
    CHECK(has(difference_of<limit::facts>(),
              "output source.y in level: number of tank from -1 to 1.1234567891", "to 1.1234567892"));
    CHECK(has(difference_of<last_bit::facts>(), "from -1 to", "from -1.0000000000000002 to"));
    CHECK(has(difference_of<unit::facts>(), "output source.p in load: ", " kPa"));
    CHECK(has(difference_of<axes::facts>(), " of x ", " of y "));
    CHECK(has(difference_of<rate_of_space::facts>(), "output source.y", " at 1000 Hz"));
  }
  TEST_CASE("one fact of a wire") {
    CHECK(has(difference_of<initial::facts>(), "wire from filter.y to ear.x: delayed 3, initial 0.5,",
              ", initial 0.50000000001,"));
    CHECK(has(difference_of<delay::facts>(), "wire from filter.y to ear.x: delayed 3", "delayed 4"));
    CHECK(has(difference_of<policy::facts>(), "wire from source.y to filter.x: latest", "delayed 1"));
    CHECK(has(difference_of<capacity::facts>(), "wire from filter.y to heap.x: queue of 4", "queue of 5"));
    CHECK(has(difference_of<full::facts>(), "queue of 4, drop_oldest", "queue of 4, drop_newest"));
  }
  TEST_CASE("what an observer hears, and when") {
    CHECK(has(difference_of<heard::facts>(), "observer ear.source.y of source.y",
              "observer ear.source.* of source.y"));
    CHECK(has(difference_of<heard_delay::facts>(), "observer ear.source.y of source.y, delayed 2",
              "delayed 1"));
    CHECK(has(difference_of<watched::facts>(), "output source.y", "output source.y"));
  }
  TEST_CASE("beats, clocks and placement") {
    CHECK(has(difference_of<rate_of_graph::facts>(), ", 1000000 ns a beat", ", 2000000 ns a beat"));
    CHECK(has(difference_of<strategy::facts>(), "node ear: ", "node ear: "));
    CHECK(has(difference_of<environment::facts>(), "environment robot", "environment robots"));
    CHECK(has(difference_of<tolerance::facts>(), "3 late beats tolerated", "4 late beats tolerated"));
    CHECK(difference("cca 1.2.3\nx", "cca 1.2.4\nx") == "here `cca 1.2.3`, there `cca 1.2.4`");
  }
}
