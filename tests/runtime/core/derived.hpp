#pragma once
// Components that take values derived from samples, beside the same computed by themselves.
#include <array>
#include <atomic>
#include <cstdint>

#include <cca/cca.hpp>

namespace derived_test {

struct pair_of : cca::space<cca::number, cca::axes<cca::x, cca::y>> {};

inline std::atomic<int> lengths = 0, areas = 0;  // how often they were computed

// [functions]
struct length_of {
  using value = double;
  static value of(const auto& sample) {
    ++lengths;
    return sample.vector().norm();
  }
};
struct area_of {  // built on the length, which is shared, too
  using value = std::array<double, 2>;
  using from = cca::from<length_of>;
  static value of(double length) {
    ++areas;
    return {3 * length * length, length};
  }
};
// [functions end]

// [reader]
// In each firing it also computes the length itself, and compares.
struct length_reader {
  auto process(cca::in<"x", pair_of> x, cca::derived<length_of, "x"> length) -> cca::out<"y", pair_of> {
    ++fired;
    wrong += length.of(x) != x.vector().norm();
    return pair_of::vector_type(-x.vector());
  }
  int fired = 0, wrong = 0;
};
// [reader end]

struct area_reader {  // the input may stand behind what is derived from it
  void process(const cca::derived<area_of, "x">& area, cca::optional_in<"x", pair_of> x) {
    ++fired;
    const double length = x.vector().norm();
    wrong += area.of(x)[0] != 3 * length * length || area.of(x)[1] != length;
  }
  int fired = 0, wrong = 0;
};

struct source {
  auto process(cca::beat now) -> cca::out<"y", pair_of> {
    const auto k = static_cast<double>(now.index());
    return pair_of::vector_type{k + 1, seed - 2 * k};
  }
  double seed = 1;
};
struct sometimes {  // in two beats of three
  auto process(cca::beat now) -> cca::maybe<"y", pair_of> {
    if (now.index() % 3 == 1) return {};
    return pair_of::vector_type{static_cast<double>(now.index()), 5};
  }
};

// All ways in which a sample reaches a reader.
struct ways : cca::graph<cca::rate<1000>,
                         cca::node<"source", source>,
                         cca::node<"sometimes", sometimes>,
                         cca::node<"slow", source, cca::timed<3>>,
                         cca::node<"a", length_reader>,
                         cca::node<"b", length_reader>,
                         cca::node<"c", area_reader>,
                         cca::node<"behind", area_reader>,
                         cca::node<"late", length_reader>,
                         cca::node<"later", area_reader>,
                         cca::node<"queued", length_reader, cca::timed<2>>,
                         cca::node<"rare", area_reader, cca::timed<4>>,
                         cca::node<"of_rare", length_reader, cca::full_speed>,
                         cca::node<"of_slow", length_reader, cca::timed<1>>,
                         cca::node<"beside_slow", length_reader, cca::timed<3>>,
                         cca::node<"phased", source, cca::timed<3, 2>>,
                         cca::node<"before_3_4", area_reader, cca::full_speed>,
                         cca::node<"before_5_12", area_reader, cca::full_speed>,
                         cca::node<"maybe", length_reader>,
                         cca::node<"maybe_not", area_reader, cca::full_speed>,
                         cca::node<"unwired", area_reader, cca::full_speed>,
                         cca::node<"looped", length_reader, cca::full_speed>,
                         cca::wire<"source.y", "a.x">,
                         cca::wire<"source.y", "b.x">,
                         cca::wire<"source.y", "c.x">,
                         cca::wire<"a.y", "behind.x">,
                         cca::wire<"source.y", "late.x", cca::delayed<1>>,
                         cca::wire<"source.y", "later.x", cca::delayed<2>>,
                         cca::wire<"source.y", "queued.x", cca::queue<4, cca::drop_oldest>>,
                         cca::wire<"source.y", "rare.x", cca::latest>,
                         cca::wire<"sometimes.y", "of_rare.x">,
                         cca::wire<"slow.y", "of_slow.x", cca::latest>,
                         cca::wire<"slow.y", "beside_slow.x">,
                         cca::wire<"phased.y", "before_3_4.x", cca::latest, cca::initial<3, 4>>,
                         cca::wire<"phased.y", "before_5_12.x", cca::latest, cca::initial<5, 12>>,
                         cca::wire<"sometimes.y", "maybe.x">,
                         cca::wire<"sometimes.y", "maybe_not.x">,
                         cca::wire<"looped.y", "looped.x", cca::delayed<1>, cca::initial<3, 4>>> {};

template <class Controller>
void expect_right(Controller& c, int beats) {
  int readers = 0;
  c.for_each_component([&](std::string_view path, auto& one) {
    if (path == "half") return;  // of another mode
    if constexpr (requires { one.wrong; }) {
      INFO(std::string(path));
      CHECK_EQ(one.wrong, 0);
      CHECK_GE(one.fired, beats / 4);
      ++readers;
    }
  });
  CHECK_EQ(readers, 17);
}

}  // namespace derived_test
