// How far environments may be apart in a fast run, and who sees it from samples alone.
#include <doctest/doctest.h>

#include <cca/deployment.hpp>

namespace {

struct level : cca::space<cca::number, cca::axes<cca::x>> {};
struct source {
  auto process(cca::optional_in<"back", level> back, cca::beat now) -> cca::out<"y", level> {
    return back[cca::x{}] + static_cast<double>(now.index());
  }
};
struct follower {
  double sum = 0;
  auto process(cca::in<"x", level> x) -> cca::out<"y", level> { return sum += x[cca::x{}]; }
};

template <int Period, class... Back>
struct chain : cca::graph<cca::rate<1000>,
                          cca::node<"source", source, cca::timed<1>>,
                          cca::node<"follower", follower, cca::timed<Period>>,
                          cca::wire<"source.y", "follower.x", cca::delayed<1>>,
                          Back...> {};
template <int Period, int Delay>
struct loop : chain<Period, cca::wire<"follower.y", "source.back", cca::delayed<Delay>>> {};
struct one_way : chain<1> {};

template <class Graph>
struct split : cca::deployment<Graph,
                               cca::environment<"first", cca::nodes<"source">>,
                               cca::environment<"second", cca::other_nodes>> {};

namespace detail = cca::detail;
template <class Graph>
constexpr bool first_sees_second = detail::samples_show_progress<split<Graph>, 1, 0>;
template <class Graph>
constexpr bool second_sees_first = detail::samples_show_progress<split<Graph>, 0, 1>;

}  // namespace

TEST_SUITE("how far ahead") {
  TEST_CASE("as many beats as the longest delay, and four more") {
    CHECK_EQ(detail::most_ahead<split<loop<1, 1>>>, 5);
    CHECK_EQ(detail::most_ahead<split<loop<10, 10>>>, 14);
    CHECK_EQ(detail::most_ahead<split<loop<1, 100>>>, 20);
  }

  TEST_CASE("samples in each beat show how far their writer is") {
    CHECK(first_sees_second<loop<1, 1>>);
    CHECK(second_sees_first<loop<1, 1>>);
    CHECK(detail::samples_show_progress_to_all<split<loop<1, 1>>, 0>);
    CHECK(detail::samples_show_progress_to_all<split<loop<1, 1>>, 1>);
  }

  TEST_CASE("who reads nothing of another one does not see how far that is") {
    CHECK_FALSE(first_sees_second<one_way>);
    CHECK(second_sees_first<one_way>);
    CHECK_FALSE(detail::samples_show_progress_to_all<split<one_way>, 1>);
    CHECK(detail::samples_show_progress_to_all<split<one_way>, 0>);
  }

  TEST_CASE("rare samples do not show it: what comes between two of them may be more than a ring holds") {
    CHECK(first_sees_second<loop<5, 1>>);  // its sample of five beats ago is the oldest that counts
    CHECK_FALSE(first_sees_second<loop<6, 1>>);
    CHECK_FALSE(first_sees_second<loop<10, 10>>);
  }

  TEST_CASE("each kind computes what one loop computes") {
    const auto compare = []<class Graph>(std::type_identity<Graph>) {
      cca::controller<Graph> alone;
      cca::deployed<split<Graph>> apart;
      alone.load();
      apart.load();
      alone.start();
      apart.start();
      alone.run(cca::for_some_beats{2000});
      apart.run(cca::for_some_beats{2000});
      CHECK_EQ(apart.template get<"follower">().sum, alone.template get<"follower">().sum);
      CHECK_NE(alone.template get<"follower">().sum, 0);
    };
    compare(std::type_identity<one_way>());
    compare(std::type_identity<loop<1, 1>>());
    compare(std::type_identity<loop<5, 1>>());
    compare(std::type_identity<loop<6, 1>>());
    compare(std::type_identity<loop<10, 10>>());
    compare(std::type_identity<loop<1, 100>>());
  }
}
