// A learner for "which step comes next": how good it was to go from one step of a plan to another.
//
//   n = n + 1,  q = q + max(rate, 1 / n) (y - q)         for the pair of steps; y: the judgement of an
//   example
//
// preference_table<Plan> is the model: its input is (from, to), numbers of two steps; its output the value of
// that pair, 0 at first. With `rate` 0 a value is the mean of all judgements; a larger rate forgets. Trained
// region: pairs that were tried at least `least_tried` times. Judgements of bounded size give values of the
// same bounded size.
//
// NaN and infinity don't come here (learner.hpp); a number that is no step counts as the nearest step.
//
// Cost: a few operations. Source: Sutton, Barto, Reinforcement Learning: An Introduction, second edition
// 2018, equations 2.3 and 2.5 (incremental means); with a discount 6.8 (Q-learning).
// Example: tests/runtime/adaptive/learned_sequencer.cpp.
#pragma once

#include <algorithm>
#include <span>
#include <string>

#include <cca/adaptive/learner.hpp>
#include <cca/component/field_types.hpp>

namespace cca {

template <class Plan>
struct preference_table {
  using input = Eigen::Matrix<double, 2, 1>;
  using output = Eigen::Matrix<double, 1, 1>;
  using value_matrix = Eigen::Matrix<double, Plan::count, Plan::count>;  // row: from; column: to
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (value_matrix, values));
    parameters() : values(value_matrix::Zero()) {}
  };
  static int step_of(double number) {
    return static_cast<int>(std::clamp(number, 0.0, static_cast<double>(Plan::count - 1)));
  }
  static output answer(const parameters& p, const input& x) {
    return output(p.values(step_of(x[0]), step_of(x[1])));
  }
  static std::string title() {
    std::string text("preference_table of ");
    for (int i = 0; i < Plan::count; ++i)
      text.append(i ? ", " : "").append(Plan::table[static_cast<std::size_t>(i)].name);
    return text;
  }
};

template <class Model>
struct preference_learning {
  using model = Model;
  using input = typename model::input;
  using output = typename model::output;
  using parameters = typename model::parameters;
  using counts = typename model::value_matrix;
  static constexpr std::string_view name = "preference_learning";

  struct settings {
    BOOST_HANA_DEFINE_STRUCT(settings,
                             (bounded<double, 0, 1>, rate),
                             (bounded<double, 0, infinity>, least_tried));
    constexpr settings(double keep = 0, double least = 1) : rate(keep), least_tried(least) {}
  };
  struct learned {
    BOOST_HANA_DEFINE_STRUCT(learned, (parameters, function), (counts, tried));
    learned() : function(), tried(counts::Zero()) {}
  };

  static bool inside(const learned& known, const input& x, const settings& s) {
    return known.tried(model::step_of(x[0]), model::step_of(x[1])) >= s.least_tried;
  }
  static void step(learned& known, const input& x, const output& y, const settings& s) {
    const int from = model::step_of(x[0]), to = model::step_of(x[1]);
    double &n = known.tried(from, to), &value = known.function.values(from, to);
    n = std::min(n + 1, most_tried);
    value += std::max(s.rate.value(), 1 / n) * (y[0] - value);
  }
  static learned batch(std::span<const example<model>> examples, const settings& s) {
    learned known;
    for (const auto& one : examples) step(known, one.x, one.y, s);
    return known;
  }

private:
  static constexpr double most_tried = 1e9;
};

}  // namespace cca
