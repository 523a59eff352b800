// The learners of Gaussians stay finite and give models that a file may hold, whatever the examples: one, a
// constant, two points, a line between points that lie very far apart.
#include <cca/motor/gaussian_mixture_learning.hpp>
#include <cca/motor/hidden_markov_learning.hpp>

#include <cmath>
#include <vector>

#include "rig.hpp"

using namespace motor_test;

namespace {

using v2 = Eigen::Vector2d;
using hidden = cca::baum_welch<cca::hidden_markov_function<leg, leg, 5>>;
using mixed = cca::expectation_maximisation<cca::mixture_function<leg, leg, 5>>;

const auto& mixture_of(const hidden::learned& known) { return known.function.mixture; }
const auto& mixture_of(const mixed::learned& known) { return known.function; }

template <class Rule>
void check_finite(const std::vector<v2>& places, const typename Rule::settings& settings) {
  std::vector<cca::example<typename Rule::model>> shown;
  for (std::size_t t = 0; t < places.size(); ++t) {
    cca::example<typename Rule::model> one{};
    one.x = places[t];
    one.y = places[(t + 1) % places.size()];
    if constexpr (requires { one.begins; }) one.begins = t == 0;
    shown.push_back(one);
  }
  const auto known = Rule::batch(shown, settings);
  CHECK_EQ(mixture_of(known).check(), "");
  CHECK(mixture_of(known).means.allFinite());
  CHECK(std::isfinite(known.likelihood));
  for (const auto& one : shown) {
    CHECK(Rule::inside(known, one.x, settings));
    CHECK(Rule::model::answer(known.function, one.x).allFinite());
  }
}

template <class F>
std::vector<v2> places(int count, F at) {
  std::vector<v2> all;
  for (int i = 0; i < count; ++i) all.push_back(at(i));
  return all;
}

}  // namespace

TEST_CASE("examples without width, or very far apart") {
  const std::vector<std::vector<v2>> all{
      places(1, [](int) { return v2(0.3, -0.2); }),
      places(2, [](int i) { return v2(0.1 * i, 0.2); }),
      places(50, [](int) { return v2(0.3, -0.2); }),
      places(50, [](int i) { return i % 2 ? v2(1, 1) : v2(-1, -1); }),
      places(50, [](int i) { return v2(0.02 * i, 0.04 * i); }),
      places(50, [](int i) { return v2(0.9e12 * std::sin(i), 0.3e12 * std::sin(i)); }),
      places(50, [](int i) { return v2(i % 2 ? 0.9e12 : 1e-12, i); }),
  };
  for (const auto& shown : all)
    for (const double floor : {1e-12, 1e-6, 1e12}) {
      check_finite<mixed>(shown, {floor, 0, 50});
      for (const double unseen : {0.0, 1e-3, 1.0}) check_finite<hidden>(shown, {floor, 0, 50, unseen});
    }
}

TEST_CASE("a floor that keeps no Gaussian from collapsing is refused") {
  for (const double floor : {0.0, cca::infinity}) {
    const auto words = [](const auto& settings) {
      try {
        cca::check_parameters(settings);
      } catch (const cca::refused& refusal) { return std::string(refusal.what()); }
      return std::string();
    };
    CHECK_NE(words(hidden::settings(floor)), "");
    CHECK_NE(words(mixed::settings(floor)), "");
  }
}
