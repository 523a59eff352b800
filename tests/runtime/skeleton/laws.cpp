// Runs the laws of skeletons over every skeleton.
#include "../../laws/skeleton_laws.hpp"

#include <cca/skeleton/farm_on_threads.hpp>

namespace {

template <int Hz>
struct signal_at : cca::space<cca::number, cca::axes<cca::x, cca::y>, cca::rate<Hz>> {};
using signal = signal_at<1000>;
struct part : cca::space<cca::number, cca::axes<cca::x>> {};

constexpr double constant = 0.75;

template <class Space = signal>
struct always {
  auto process(cca::beat) -> cca::out<"y", Space> { return Space::vector_type::Constant(constant).eval(); }
};
template <int Every>
struct at_times {
  auto process(cca::beat now) -> cca::maybe<"y", signal> {
    if (now.index() % Every != 0) return {};
    return signal::vector_type::Constant(constant).eval();
  }
};
template <class Space = signal>
struct ending {
  std::vector<typename Space::vector_type> values;
  std::vector<std::int64_t> beats, origins;
  void reserve(std::size_t n) { values.reserve(n), beats.reserve(n), origins.reserve(n); }
  void process(cca::in<"x", Space> x, cca::beat now) {
    values.push_back(x.vector());
    beats.push_back(now.index());
    origins.push_back(x.origin());
  }
};
struct same {
  auto process(cca::in<"a", signal> x) -> cca::out<"b", signal> { return x; }
};
struct same_part {
  auto process(cca::in<"a", part> x) -> cca::out<"b", part> { return x; }
};
struct changing_choice {  // chooses one source after the other
  auto process(cca::beat now) -> cca::out<"y", cca::choice> {
    return static_cast<double>(now.index() / 20 % 2);
  }
};
template <class Space>
struct weights {
  auto process(cca::beat now) -> cca::out<"y", Space> {
    return Space::vector_type::Constant(static_cast<double>(now.index() % 10) / 9).eval();
  }
};
struct three : cca::space<cca::amplitude, cca::axes<cca::x, cca::y, cca::z>> {};
struct one : cca::space<cca::amplitude, cca::axes<cca::x>> {};

template <class Graph, int Lag>
struct law_case {
  using graph = Graph;
  static constexpr double value = constant;
  static constexpr auto name = cca::detail::type_name<Graph>();
  static void feed(cca::controller<Graph>&) {}
  static std::int64_t oldest(std::int64_t beat) { return beat - Lag; }
};

// Skeletons with one source.
template <class Skeleton,
          class From = signal,
          class To = signal,
          class When = cca::detail::by_default,
          int Every = 1,
          class... Policy>
struct through : cca::graph<cca::rate<1000>,
                            cca::node<"source", always<From>, cca::timed<Every>>,
                            cca::node<"skeleton", Skeleton, When>,
                            cca::node<"end", ending<To>>,
                            cca::wire<"source.y", "skeleton.input", Policy...>,
                            cca::wire<"skeleton.output", "end.x">> {};
// Skeletons with two sources.
template <class Skeleton, class A, class B, class... More>
struct from_two : cca::graph<cca::rate<1000>,
                             cca::node<"first", A>,
                             cca::node<"second", B>,
                             cca::node<"skeleton", Skeleton>,
                             cca::node<"end", ending<>>,
                             cca::wire<"first.y", "skeleton.a">,
                             cca::wire<"second.y", "skeleton.b">,
                             cca::wire<"skeleton.y", "end.x">,
                             More...> {};

struct split_and_collected : cca::graph<cca::rate<1000>,
                                        cca::node<"source", always<>>,
                                        cca::node<"skeleton", cca::splitter<"whole", signal>>,
                                        cca::node<"again", cca::collector<"whole", signal>, cca::moderate>,
                                        cca::node<"end", ending<>>,
                                        cca::wire<"source.y", "skeleton.whole">,
                                        cca::wire<"skeleton.x", "again.x">,
                                        cca::wire<"skeleton.y", "again.y">,
                                        cca::wire<"again.whole", "end.x">> {};
struct in_a_pipeline : through<cca::pipeline<same, same, same>> {};
struct in_a_slow_pipeline : through<cca::pipeline_over<cca::delayed<2>, same, same, same>> {};
struct on_a_farm : through<cca::farm<same_part, signal, signal>> {};
struct on_threads : through<cca::farm_on_threads<same_part, signal, signal>> {};
struct on_threads_unordered : through<cca::farm_on_threads<same_part, signal, signal, cca::as_they_come>> {};
struct by_priority : from_two<cca::arbiter<"y", signal, cca::by_priority<"a", "b">>, at_times<3>, always<>> {
};
struct by_freshness
    : from_two<cca::arbiter<"y", signal, cca::by_freshness<"a", "b">>, at_times<3>, at_times<2>> {};
struct switched : from_two<cca::switch_between<"y", signal, "a", "b">,
                           always<>,
                           always<>,
                           cca::node<"choice", changing_choice>,
                           cca::wire<"choice.y", "skeleton.choice">> {};
struct blended : from_two<cca::blend<"y", signal, one, "a", "b">,
                          always<>,
                          always<>,
                          cca::node<"weight", weights<one>>,
                          cca::wire<"weight.y", "skeleton.weight">> {};
struct blended_of_three : from_two<cca::blend<"y", signal, three, "a", "b", "c">,
                                   always<>,
                                   always<>,
                                   cca::node<"weight", weights<three>>,
                                   cca::wire<"weight.y", "skeleton.weight">,
                                   cca::wire<"second.y", "skeleton.c">> {};
struct held
    : through<cca::hold<signal_at<100>, signal>, signal_at<100>, signal, cca::timed<1>, 10, cca::latest> {};
struct interpolated : through<cca::interpolate<signal_at<100>, signal>,
                              signal_at<100>,
                              signal,
                              cca::timed<1>,
                              10,
                              cca::latest> {};
struct picked : through<cca::decimate<signal, signal_at<100>>, signal, signal_at<100>> {};
struct averaged : through<cca::decimate<signal, signal_at<100>, cca::averaged>, signal, signal_at<100>> {};

// If all work is done before the next beat, the result is one beat late.
template <class Graph>
struct settled : law_case<Graph, 1> {
  static void settle(cca::controller<Graph>& c) {
    c.template get<"skeleton">().template get<"crew">().wait();
  }
};

}  // namespace

TEST_SUITE("laws of skeletons") {
  TEST_CASE("splitter and collector") { laws::skeleton<law_case<split_and_collected, 0>>(); }
  TEST_CASE("pipeline") {
    laws::skeleton<law_case<in_a_pipeline, 0>>();
    laws::skeleton<law_case<in_a_slow_pipeline, 4>>();
  }
  TEST_CASE("farm") { laws::skeleton<law_case<on_a_farm, 0>>(); }
  TEST_CASE("farm on threads") {
    laws::skeleton<settled<on_threads>>();
    laws::skeleton<settled<on_threads_unordered>>();
  }
  TEST_CASE("arbiter") {
    laws::skeleton<law_case<by_priority, 0>>();
    laws::skeleton<law_case<by_freshness, 1>>();
  }
  TEST_CASE("switch") { laws::skeleton<law_case<switched, 0>>(); }
  TEST_CASE("blend") {
    laws::skeleton<law_case<blended, 0>>();
    laws::skeleton<law_case<blended_of_three, 0>>();
  }
  TEST_CASE("hold, decimate, interpolate") {
    laws::skeleton<law_case<held, 9>>();
    laws::skeleton<law_case<interpolated, 18>>();
    laws::skeleton<law_case<picked, 0>>();
    laws::skeleton<law_case<averaged, 9>>();
  }
}
